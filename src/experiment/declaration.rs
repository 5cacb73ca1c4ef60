//! The declarations of an experiment and its methods.

use crate::mesh::Mesh;
use crate::scene::Scene;
use crate::session::Error;

/// A comparison of methods on the same problem.
#[derive(Clone, Copy, Debug)]
pub struct Experiment {
    /// Its name on the command line.
    pub id: &'static str,
    /// Its name in tables and plots.
    pub label: &'static str,
    /// The comparison in one sentence.
    pub summary: &'static str,
    /// Ids of the examples that it is meant for.
    pub examples: &'static [&'static str],
    /// The quantities measured after every iteration.
    pub quantities: &'static [Quantity],
    /// The plots.
    pub plots: &'static [Plot],
    /// The methods, in the order in which they run.
    pub methods: &'static [MethodInfo],
    /// Limits at which a method is stopped.
    pub limits: Limits,
}

/// A quantity measured after every iteration.
#[derive(Clone, Copy, Debug)]
pub struct Quantity {
    /// Its name in CSV files.
    pub id: &'static str,
    /// Its name in tables and plots.
    pub label: &'static str,
    /// Its unit.
    pub unit: Unit,
}

/// The unit of a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// The square of the unit of the mesh.
    Energy,
    /// The unit of the mesh.
    Length,
    /// A plain number.
    None,
}

/// A plot of a quantity over iterations or time.
#[derive(Clone, Copy, Debug)]
pub struct Plot {
    /// The index of the quantity.
    pub quantity: usize,
    /// The horizontal axis.
    pub over: Over,
    /// Whether the lowest value found by any method is subtracted from all values.
    pub above_lowest: bool,
}

/// The horizontal axis of a plot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Over {
    /// Iterations of the method.
    Iterations,
    /// Seconds taken by the method.
    Seconds,
}

/// One of the compared methods.
#[derive(Clone, Copy, Debug)]
pub struct MethodInfo {
    /// Its name in CSV files.
    pub id: &'static str,
    /// Its name in tables and plots.
    pub label: &'static str,
    /// A description in one sentence.
    pub summary: &'static str,
    /// The largest mesh that it accepts, in vertices; none if there is no limit.
    pub most_vertices: Option<usize>,
    pub(super) start: Start,
}

/// Sets a method up on a scene.
pub(super) type Start = fn(&Scene, &Mesh) -> Result<Box<dyn Method>, Error>;

/// Limits at which a method is stopped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Maximum number of iterations of each method.
    pub iterations: u32,
    /// Maximum time of each method, in seconds.
    pub seconds: f64,
}

/// A running method.
pub(super) trait Method {
    /// Returns the seconds of set-up before the first iteration.
    fn set_up_seconds(&self) -> f64 {
        0.0
    }

    /// Runs one iteration.
    fn step(&mut self) -> Result<Step, Error>;

    /// Returns the current quantities of the experiment.
    fn values(&self) -> Vec<f64>;
}

/// The outcome of an iteration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    /// The method can continue.
    Going,
    /// The method has reached its goal.
    Reached,
    /// The method cannot find a better point.
    Stalled,
}
