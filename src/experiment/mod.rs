//! The paper's comparisons (section 5), run live: the same problem solved by several methods, one
//! after another, with the numbers of every iteration. No results are stored: all numbers shown
//! were measured on this machine.
//!
//! | file | holds |
//! |---|---|
//! | `declaration` | the declarations of an experiment and its methods |
//! | `penalty` | Fig. 11: circular panels whose edges collapse, against a penalty method |
//! | `methods` | Fig. 10: recovery from a collapsed start; the methods that lower the energy of a scene |
//! | `run` | a run of an experiment: its methods, one after another |
//! | `descent`, `line_search` | gradient descent, L-BFGS and BFGS, on the gradient of Appendix A |
//! | `curvature` | curvature estimates of L-BFGS and BFGS |
//! | `gauss_newton` | the penalty method: angle sums, and Gauss-Newton on them |
//! | `figure` | the plots of a run as SVG |
//!
//! Experiments and their methods are declared in lists, and hosts show whatever is in them.

mod curvature;
mod declaration;
mod descent;
mod figure;
mod gauss_newton;
mod line_search;
mod methods;
mod penalty;
mod run;

pub use declaration::{Experiment, Limits, MethodInfo, Over, Plot, Quantity, Unit};
pub use methods::COMPARISON;
pub use run::{EndedBy, Run, Sample, Series};

/// The experiments on examples of their own; [`COMPARISON`] runs on any scene.
pub const EXPERIMENTS: &[Experiment] = &[methods::RECOVERY, penalty::PENALTY];

impl Experiment {
    /// Returns the experiment that is meant for an example.
    pub fn of(example: &str) -> Option<&'static Experiment> {
        EXPERIMENTS.iter().find(|experiment| experiment.examples.contains(&example))
    }
}
