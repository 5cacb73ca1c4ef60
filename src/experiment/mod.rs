//! The paper's comparisons (section 5), run live: the same problem solved by several methods, one after
//! another, with the numbers of every iteration. Nothing is stored: what is shown is what was measured
//! on this machine.
//!
//! | file | holds |
//! |---|---|
//! | `declaration` | what an experiment and its methods declare |
//! | `recovery` | Fig. 10: back from a collapsed start, by five methods |
//! | `penalty` | Fig. 11: circular panels whose edges collapse, against a penalty method |
//! | `comparison` | the same on any scene |
//! | `run` | one experiment under way: a method after another, an iteration at a time |
//! | `methods` | the methods that lower the energy of a scene |
//! | `two_step` | the project's own solver as a method |
//! | `descent`, `line_search` | gradient descent, L-BFGS and BFGS, on the gradient of Appendix A |
//! | `curvature` | what L-BFGS and BFGS learn from their steps |
//! | `circularity`, `gauss_newton` | the penalty method: angle sums, and Gauss-Newton on them |
//! | `continuation` | the weight of the circles that meets a given circularity error |
//!
//! An experiment and its methods are declarations: hosts show what is in the list and name none of it.

mod circularity;
mod comparison;
mod continuation;
mod curvature;
mod declaration;
mod descent;
mod gauss_newton;
mod line_search;
mod methods;
mod penalty;
mod recovery;
mod run;
mod two_step;

pub use circularity::AngleSums;
pub use comparison::COMPARISON;
pub use declaration::{Experiment, Limits, MethodInfo, Over, Plot, Quantity, Unit};
pub use run::{EndedBy, Run, Sample, Series};

/// The experiments on examples of their own; [`COMPARISON`] can be run on any scene.
pub const EXPERIMENTS: &[Experiment] = &[recovery::RECOVERY, penalty::PENALTY];

impl Experiment {
    /// The one that is made for an example.
    pub fn of(example: &str) -> Option<&'static Experiment> {
        EXPERIMENTS.iter().find(|experiment| experiment.examples.contains(&example))
    }
}
