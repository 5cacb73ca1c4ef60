//! The paper's comparisons (section 5), run live: the same problem solved by several methods, one after
//! another, with the numbers of every iteration. Nothing is stored: what is shown is what was measured
//! on this machine.
//!
//! | file | holds |
//! |---|---|
//! | `recovery` | Fig. 10: back from a collapsed start, by five methods |
//! | `penalty` | Fig. 11: circular panels whose edges collapse, against a penalty method |
//! | `run` | one experiment under way: a method after another, an iteration at a time |
//! | `two_step` | the project's own solver as a method |
//! | `descent`, `line_search` | gradient descent and L-BFGS, on the gradient of Appendix A |
//! | `circularity`, `gauss_newton` | the penalty method: angle sums, and Gauss-Newton on them |
//! | `continuation` | the weight of the circles that meets a given circularity error |
//!
//! An experiment and its methods are declarations: hosts show what is in the list and name none of it.

mod circularity;
mod continuation;
mod descent;
mod gauss_newton;
mod line_search;
mod penalty;
mod recovery;
mod run;
mod two_step;

pub use circularity::Circularity;
pub use run::{EndedBy, Run, Sample, Series};

use crate::error::Error;
use crate::mesh::Mesh;
use crate::scene::Scene;
use serde::Serialize;

/// All experiments.
pub const EXPERIMENTS: &[Experiment] = &[recovery::RECOVERY, penalty::PENALTY];

/// A comparison of methods on the same problem.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Experiment {
    /// Its name on the command line.
    pub id: &'static str,
    /// Its name on the page.
    pub label: &'static str,
    /// What is compared and what to look for.
    pub summary: &'static str,
    /// The ids of the examples that it can be run on.
    pub examples: &'static [&'static str],
    /// What is measured after every iteration.
    pub quantities: &'static [Quantity],
    /// What is drawn.
    pub plots: &'static [Plot],
    /// What is compared, in the order in which it is run.
    pub methods: &'static [MethodInfo],
    /// When a method is stopped that has not ended by itself.
    pub limits: Limits,
}

impl Experiment {
    /// The one that can be run on an example.
    pub fn of(example: &str) -> Option<&'static Experiment> {
        EXPERIMENTS.iter().find(|experiment| experiment.examples.contains(&example))
    }
}

/// Something that is measured after every iteration.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Quantity {
    /// Its name in files.
    pub id: &'static str,
    /// Its name on the page.
    pub label: &'static str,
    /// What it is measured in.
    pub unit: Unit,
}

/// What a quantity is measured in.
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
    /// What it is drawn over.
    pub over: Over,
}

/// What is counted along a plot.
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
    /// What it does, in one sentence.
    pub summary: &'static str,
    #[serde(skip)]
    start: Start,
}

/// Sets a method up on a scene.
type Start = fn(&Scene, &Mesh) -> Result<Box<dyn Method>, Error>;

/// When a method is stopped that has not ended by itself.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Limits {
    /// Iterations of each method.
    pub iterations: u32,
    /// Seconds of each method.
    pub seconds: f64,
}

/// A method that is under way.
trait Method {
    /// Seconds that it took before its first iteration.
    fn set_up_seconds(&self) -> f64 {
        0.0
    }

    /// One iteration.
    fn step(&mut self) -> Result<Step, Error>;

    /// The quantities of the experiment, now.
    fn values(&self) -> Vec<f64>;
}

/// What became of an iteration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Step {
    /// There is more to do.
    Going,
    /// The method has reached what was asked for.
    Reached,
    /// The method finds no better point.
    Stalled,
}
