//! What is wrong with a result.

use std::fmt;

/// What is wrong with a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ResultFault {
    /// A face has a corner twice, or another number of corners than it may have.
    Face {
        /// Number of such faces.
        count: usize,
    },
    /// An edge has more than two faces, or two that run along it in the same direction.
    Edge {
        /// Number of such edges.
        count: usize,
    },
    /// The faces at a vertex are more than one fan.
    Vertex {
        /// Number of such vertices.
        count: usize,
    },
    /// The number of boundary loops is not that of the input.
    Loops {
        /// Of the input.
        expected: usize,
        /// Of the result.
        found: usize,
    },
    /// The Euler characteristic, vertices minus edges plus faces, is not that of the input.
    Euler {
        /// Of the input.
        expected: i64,
        /// Of the result.
        found: i64,
    },
}

impl fmt::Display for ResultFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ResultFault::Face { count } => write!(f, "{count} faces are not quads"),
            ResultFault::Edge { count } => write!(f, "{count} edges have three or more faces"),
            ResultFault::Vertex { count } => write!(f, "{count} vertices join parts that touch"),
            ResultFault::Loops { expected, found } => {
                write!(f, "there are {found} boundary loops instead of {expected}")
            }
            // The numbers would mean nothing to most readers.
            ResultFault::Euler { .. } => {
                f.write_str("the new mesh would have other openings or parts")
            }
        }
    }
}
