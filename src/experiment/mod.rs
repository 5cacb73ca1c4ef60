//! The paper's comparisons (section 5), run live: the same problem solved by several methods, one
//! after another, with the numbers of every iteration. No results are stored: all numbers shown
//! were measured on this machine.
//!
//! | file | holds |
//! |---|---|
//! | `declaration` | the declarations of an experiment and its methods |
//! | `penalty` | Fig. 11: circular panels whose edges collapse, against a penalty method |
//! | `comparison` | Fig. 10: recovery from a collapsed start, by five methods; all methods on any scene |
//! | `run` | a running experiment: one method after another, one iteration at a time |
//! | `methods` | the methods that lower the energy of a scene |
//! | `two_step` | the project's own solver as a method |
//! | `descent`, `line_search` | gradient descent, L-BFGS and BFGS, on the gradient of Appendix A |
//! | `curvature` | curvature estimates of L-BFGS and BFGS |
//! | `circularity`, `gauss_newton` | the penalty method: angle sums, and Gauss-Newton on them |
//! | `continuation` | the weight of the circles for a given circularity error |
//! | `figure` | the plots of a run as SVG |
//!
//! Experiments and their methods are declared in lists, and hosts show whatever is in them.

mod circularity;
mod comparison;
mod continuation;
mod curvature;
mod declaration;
mod descent;
mod figure;
mod gauss_newton;
mod line_search;
mod methods;
mod penalty;
mod run;
mod two_step;

pub use circularity::AngleSums;
pub use comparison::COMPARISON;
pub use declaration::{Experiment, Limits, MethodInfo, Over, Plot, Quantity, Unit};
pub use run::{EndedBy, Run, Sample, Series};

/// The experiments on examples of their own; [`COMPARISON`] runs on any scene.
pub const EXPERIMENTS: &[Experiment] = &[comparison::RECOVERY, penalty::PENALTY];

impl Experiment {
    /// Returns the experiment that is meant for an example.
    pub fn of(example: &str) -> Option<&'static Experiment> {
        EXPERIMENTS.iter().find(|experiment| experiment.examples.contains(&example))
    }
}
