//! The solver: energies, their normal matrix, the two-step iteration and its acceleration (paper section
//! 2), conformal maps (section 4.3). Knows no file format: it takes a [`Problem`].
//!
//! | file | holds |
//! |---|---|
//! | `problem`, `settings` | what is solved, and how |
//! | `error` | why it cannot be solved |
//! | `energy` | the energies of Eq. 13, each with its gradient and its part of the matrix |
//! | `local_frame` | coordinates relative to the centre of the model |
//! | `rows` | rows of numbers as vectors |
//! | `assemble` | the normal matrix `Q^T Q` in compressed columns |
//! | `system` | the linear system of the global step: matrix, factor, and when each is made |
//! | `gliding` | boundary vertices that are on their curve exactly |
//! | `parts` | what solvers are made of, made from a problem |
//! | `solver` | the iteration |
//! | `exact` | constraints that are met, not weighed |
//! | `variation` | ways to change a shape while they stay met |
//! | `accelerate` | steps that learn from the steps before |
//! | `setup_cache` | what one solver leaves to the next |
//! | `rest_projections` | projections at the rest shape, apart from any iteration |
//! | `conformal` | conformal parametrisation (Eq. 14) |
//! | `clock` | the time, for reports |

mod accelerate;
mod assemble;
pub mod clock;
mod conformal;
mod energy;
mod error;
mod exact;
mod gliding;
mod local_frame;
mod parts;
mod problem;
mod rest_projections;
mod rows;
mod settings;
mod setup_cache;
mod solver;
mod system;
mod variation;

pub use assemble::Terms;
pub use conformal::{
    ConformalNorm, ConformalSeconds, ConformalWeights, FewerFlips, Parametrization,
};
pub use energy::{Constraints, Energy, Handle, HandleIndex, Hold, IterateSeconds};
pub use error::SolveError;
pub use exact::{
    Exact, ExactAnswer, Improved, Moved, Require, Requirements, Stage, Unmet, exact_tolerance,
    farthest, least_move,
};
pub use problem::Problem;
pub use rest_projections::rest_projections;
pub use settings::{
    Accelerator, BoundaryCloseness, BoundaryRequire, ClosenessTo, SHORTEST_EDGE, Smoothness,
    SmoothnessOf, SolverSettings, Weighting, Weights,
};
pub use setup_cache::SetupCache;
pub use solver::Solver;
pub use system::{SetUpSeconds, System};
pub use variation::{Reached, SLIDE, ShapeSpace, Variation};
