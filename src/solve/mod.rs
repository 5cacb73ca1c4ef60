//! The solver (paper section 2.2): assembly, ordering, factorisation, the two-step iteration.
//!
//! | file | holds |
//! |---|---|
//! | `shape`, `close`, `smooth`, `hold` | the energies of Eq. 13, each with its gradient and its part of the matrix |
//! | `energy` | their weighted total |
//! | `assemble` | the normal matrix `Q^T Q` in compressed columns |
//! | `order` | the order of elimination |
//! | `factor`, `panels`, `scalar` | `L D L^T`, and the triangular sweeps in single or double precision |
//! | `metric` | the inverse in single precision, for accelerated steps |
//! | `system` | these together: the linear system of the global step |
//! | `solver` | the iteration |
//! | `accelerate`, `quasi_newton`, `anderson` | steps that learn from the steps before |
//! | `conformal`, `subspace` | conformal parametrisation (Eq. 14), and its eigenvector |

mod accelerate;
mod anderson;
mod assemble;
pub mod clock;
mod close;
mod conformal;
mod energy;
mod factor;
mod hold;
mod metric;
mod order;
mod panels;
mod quasi_newton;
mod scalar;
mod shape;
mod smooth;
mod solver;
mod subspace;
mod system;

pub use assemble::Terms;
pub use conformal::{ConformalNorm, ConformalSeconds, ConformalWeights, Parametrization};
pub use energy::{Energy, IterateSeconds};
pub use hold::Handle;
pub use shape::Constraints;
pub use solver::{Problem, Solver};
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
            SolveError::NotFinite { vertex } => {
                write!(f, "vertex {vertex} left the finite numbers; the last good shape is kept")
            }
        }
    }
}

impl std::error::Error for SolveError {}
