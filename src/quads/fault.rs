//! What is wrong with a result, and why there is no map.

use crate::words::{count, group_digits};
use std::fmt;

/// Why a part of the surface has no map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MapFault {
    /// A matrix is not positive definite to working precision: coordinates are out of proportion.
    Numerical,
    /// Each opening and each irregular vertex has to be at whole panels from all others, and there are
    /// too many.
    TooManyIntegers,
    /// The map exceeds the range of fixed-point coordinates.
    OutOfRange,
}

impl fmt::Display for MapFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            MapFault::Numerical => "the coordinates of the surface are out of proportion",
            MapFault::TooManyIntegers => {
                "the surface has too many openings and irregular vertices for panels laid out together: keep some faces as they are"
            }
            MapFault::OutOfRange => "the surface is too large for panels of this size",
        })
    }
}

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
    /// The number of connected parts is not that of the input.
    Parts {
        /// Of the input.
        expected: usize,
        /// Of the result.
        found: usize,
    },
}

impl fmt::Display for ResultFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ResultFault::Face { count: found } => {
                write!(f, "{}", count(*found, "face is not a quad", "faces are not quads"))
            }
            ResultFault::Edge { count: found } => {
                let many = "edges have faces that do not fit together";
                write!(f, "{}", count(*found, "edge has faces that do not fit together", many))
            }
            ResultFault::Vertex { count: found } => {
                let [one, many] = ["vertex joins", "vertices join"];
                write!(f, "{} parts that touch", count(*found, one, many))
            }
            ResultFault::Loops { expected, found } => {
                let [found, expected] = [found, expected].map(|count| group_digits(*count));
                write!(f, "the new mesh would have {found} boundary loops instead of {expected}")
            }
            // The numbers would mean nothing to most readers.
            ResultFault::Euler { .. } | ResultFault::Parts { .. } => {
                f.write_str("the new mesh would have other openings or parts")
            }
        }
    }
}
