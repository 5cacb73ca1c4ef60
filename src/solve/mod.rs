//! The solver (paper section 2.2): assembly, ordering, factorisation, the two-step iteration.

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
