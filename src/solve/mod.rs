//! The solver: energies, their normal matrix, the two-step iteration and its acceleration (paper
//! section 2), conformal maps (section 4.3). Its input is a [`Problem`], independent of file
//! formats.
//!
//! | file | holds |
//! |---|---|
//! | `problem`, `settings` | the input of the solver |
//! | `error` | the reasons why a problem cannot be solved |
//! | `energy` | the energies of Eq. 13, each with its gradient and its part of the matrix |
//! | `local_frame` | coordinates relative to the centre of the model |
//! | `rows` | vector operations on rows of numbers |
//! | `assemble` | the normal matrix `Q^T Q` in compressed columns |
//! | `system` | the linear system of the global step: matrix, factor, and when each is computed |
//! | `gliding` | boundary vertices that stay exactly on their curve |
//! | `parts` | the components of a solver, built from a problem, and what the next solver can take over |
//! | `descent` | the steps of the iteration and of the approach to hard constraints |
//! | `solver` | the iteration |
//! | `exact` | hard constraints: met exactly or within a tolerance |
//! | `variation` | changes of a shape that keep its hard constraints met |
//! | `accelerate` | steps that use previous steps |
//! | `conformal` | conformal parametrisation (Eq. 14) |
//! | `clock` | the clock for reports |
//!
#![doc = include_str!("performance.md")]

mod accelerate;
mod assemble;
pub mod clock;
mod conformal;
mod descent;
mod energy;
mod error;
mod exact;
mod gliding;
mod local_frame;
mod parts;
mod problem;
mod rows;
mod settings;
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
    Exact, ExactAnswer, Improved, Moved, Require, Requirements, Stage, Unmet, coordinate_rounding,
    exact_tolerance, farthest, least_move, projections_at,
};
pub use parts::SetupCache;
pub use problem::Problem;

pub use settings::{
    Accelerator, BoundaryCloseness, BoundaryRequire, ClosenessTo, SHORTEST_EDGE, Smoothness,
    SmoothnessOf, SolverSettings, Weighting, Weights,
};
pub use solver::Solver;
pub use system::{SetUpSeconds, System};
pub use variation::{Reached, SLIDE, ShapeSpace, Variation};
