//! The solver (paper section 2.2): assembly, ordering, factorisation, the two-step iteration.
//!
//! | file | holds |
//! |---|---|
//! | `shape`, `close`, `smooth`, `hold` | the energies of Eq. 13, each with its gradient and its part of the matrix |
//! | `energy` | their weighted total |
//! | `problem` | what is solved |
//! | `centred` | positions relative to the centre of the model |
//! | `assemble` | the normal matrix `Q^T Q` in compressed columns |
//! | `elimination_tree`, `order`, `symbolic`, `ordered` | the order of elimination, and what follows from the pattern |
//! | `dense`, `supernodal`, `factor` | `L D L^T` |
//! | `panels`, `scalar` | the triangular sweeps in single or double precision |
//! | `rank_one` | the factor after one more vertex is held |
//! | `metric` | the inverse in single precision, for accelerated steps |
//! | `system` | these together: the linear system of the global step |
//! | `solver`, `kept` | the iteration, and what one solver leaves to the next |
//! | `at_rest` | projections at the rest shape, apart from any iteration |
//! | `clock` | the time, for reports |
//! | `accelerate`, `quasi_newton`, `anderson` | steps that learn from the steps before |
//! | `conformal`, `subspace` | conformal parametrisation (Eq. 14), and its eigenvector |

mod accelerate;
mod anderson;
mod assemble;
mod at_rest;
mod centred;
pub mod clock;
mod close;
mod conformal;
mod dense;
mod elimination_tree;
mod energy;
mod factor;
mod hold;
mod kept;
mod metric;
mod order;
mod ordered;
mod panels;
mod problem;
mod quasi_newton;
mod rank_one;
mod scalar;
mod shape;
mod smooth;
mod solver;
mod subspace;
mod supernodal;
mod symbolic;
mod system;

pub use assemble::Terms;
pub use at_rest::projections_at_rest;
pub use conformal::{ConformalNorm, ConformalSeconds, ConformalWeights, Parametrization};
pub use energy::{Energy, IterateSeconds};
pub use hold::{Handle, HandlePlaces};
pub use kept::Kept;
pub use problem::Problem;
pub use shape::Constraints;
pub use solver::Solver;
pub use system::{SetUpSeconds, System};

use std::fmt;

/// Why a valid scene cannot be solved as it stands.
#[derive(Clone, Debug, PartialEq)]
pub enum SolveError {
    /// The normal matrix is not positive definite although every component is held.
    NotPositiveDefinite {
        /// The vertex whose pivot failed.
        vertex: u32,
    },
    /// A part of a surface that is to be flattened has no area, or so little that its matrix is singular.
    NoArea {
        /// A vertex of it.
        vertex: u32,
    },
    /// The flat map of a surface puts it onto a line or into a point.
    Collapsed,
    /// A position became NaN or infinite; the last good state stays.
    NotFinite {
        /// The first such vertex.
        vertex: u32,
    },
}

impl fmt::Display for SolveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SolveError::NotPositiveDefinite { vertex } => write!(
                f,
                "the system is singular at vertex {vertex}: its weights are too small against those of the rest"
            ),
            SolveError::NoArea { vertex } => write!(
                f,
                "the part with vertex {vertex} has no area, or next to none, expected a surface"
            ),
            SolveError::Collapsed => write!(
                f,
                "its flat map collapses, expected a surface whose faces do not contradict each other"
            ),
            SolveError::NotFinite { vertex } => {
                write!(f, "vertex {vertex} left the finite numbers; the last good shape is kept")
            }
        }
    }
}

impl std::error::Error for SolveError {}
