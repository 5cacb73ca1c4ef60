//! The errors of the solver.

use std::fmt;

/// The reason why a valid problem cannot be solved.
#[derive(Clone, Debug, PartialEq)]
pub enum SolveError {
    /// The normal matrix is not positive definite although every component is held.
    NotPositiveDefinite {
        /// The vertex whose pivot failed.
        vertex: u32,
    },
    /// A part of a surface to be flattened has no area, or so little that its matrix is singular.
    NoArea {
        /// A vertex of that part.
        vertex: u32,
    },
    /// The flat map of a surface collapses to a line or a point.
    Collapsed,
    /// The mesh, or one constraint, is too large: the system would take too much memory or time.
    TooLarge,
    /// A position became NaN or infinite; the last good state is kept.
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
                "the weights at vertex {vertex} differ too much from the others: lower the largest weights, or raise the smallest"
            ),
            SolveError::NoArea { vertex } => {
                write!(f, "the part with vertex {vertex} has almost no area, expected a surface")
            }
            SolveError::Collapsed => write!(
                f,
                "its flat map collapses to a line or a point, expected a surface that can be unfolded"
            ),
            SolveError::TooLarge => write!(
                f,
                "the mesh, or one constraint, is too large for that: it would take too much memory or time"
            ),
            SolveError::NotFinite { vertex } => {
                write!(
                    f,
                    "vertex {vertex} became infinite or undefined; the last valid shape is kept"
                )
            }
        }
    }
}

impl std::error::Error for SolveError {}
