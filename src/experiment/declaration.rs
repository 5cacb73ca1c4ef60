//! The declarations of an experiment and its methods.

use crate::error::Error;
use crate::mesh::Mesh;
use crate::scene::Scene;
use serde::Serialize;

/// A comparison of methods on the same problem.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Experiment {
    /// Its name on the command line.
    pub id: &'static str,
    /// Its name on the page.
    pub label: &'static str,
    /// The comparison in one sentence.
    pub summary: &'static str,
    /// The ids of the examples that it is made for.
    pub examples: &'static [&'static str],
    /// The quantities measured after every iteration.
    pub quantities: &'static [Quantity],
    /// The plots.
    pub plots: &'static [Plot],
    /// The methods, in the order in which they run.
    pub methods: &'static [MethodInfo],
    /// When a method is stopped that has not ended by itself.
    pub limits: Limits,
}

/// Something that is measured after every iteration.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Quantity {
    /// Its name in files.
    pub id: &'static str,
    /// Its name on the page.
    pub label: &'static str,
    /// Its unit.
    pub unit: Unit,
}

/// The unit of a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Unit {
    /// The square of the unit of the mesh.
    Energy,
    /// The unit of the mesh.
    Length,
    /// A plain number.
    None,
}

/// A quantity over iterations or over time.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Plot {
    /// The index of the quantity.
    pub quantity: usize,
    /// The quantity along the horizontal axis.
    pub over: Over,
    /// Whether the lowest value that any method has found is taken off all values.
    pub above_lowest: bool,
}

/// The horizontal axis of a plot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Over {
    /// Iterations of the method.
    Iterations,
    /// Seconds that the method has taken.
    Seconds,
}

/// One of the methods that are compared.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct MethodInfo {
    /// Its name in files.
    pub id: &'static str,
    /// Its name on the page.
    pub label: &'static str,
    /// A description in one sentence.
    pub summary: &'static str,
    /// The largest mesh that it can take, in vertices; none where any will do.
    pub most_vertices: Option<usize>,
    #[serde(skip)]
    pub(super) start: Start,
}

/// Sets a method up on a scene.
pub(super) type Start = fn(&Scene, &Mesh) -> Result<Box<dyn Method>, Error>;

/// When a method is stopped that has not ended by itself.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Limits {
    /// Iterations of each method.
    pub iterations: u32,
    /// Seconds of each method.
    pub seconds: f64,
}

/// A method that is under way.
pub(super) trait Method {
    /// Seconds that it took before its first iteration.
    fn set_up_seconds(&self) -> f64 {
        0.0
    }

    /// One iteration.
    fn step(&mut self) -> Result<Step, Error>;

    /// The quantities of the experiment, now.
    fn values(&self) -> Vec<f64>;
}

/// The outcome of an iteration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    /// There is more to do.
    Going,
    /// The method has reached what was asked for.
    Reached,
    /// The method finds no better point.
    Stalled,
}
