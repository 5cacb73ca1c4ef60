//! Why a surface cannot be remeshed, with the place.

use super::fault::ResultFault;
use crate::math::Vec3;
use crate::words;
use std::fmt;

/// Why a surface, or a part of it, cannot be remeshed.
#[derive(Clone, Debug, PartialEq)]
pub enum RemeshError {
    /// There are no faces of positive area.
    Empty,
    /// A part of the surface has too few triangles to have a curvature.
    TooFewTriangles {
        /// A point of the part.
        at: Vec3<f64>,
    },
    /// Three or more faces meet in an edge.
    BranchingEdge {
        /// The middle of the edge.
        at: Vec3<f64>,
        /// The number of such edges.
        count: usize,
    },
    /// A part of the surface has one side only, as a Moebius strip.
    OneSided {
        /// A point where orientations disagree.
        at: Vec3<f64>,
    },
    /// The panel size is not positive and finite, or so small that panels would number more than
    /// 100,000.
    SizeTooSmall {
        /// The least size, in the unit of the mesh.
        least: f64,
    },
    /// The panel size exceeds half the length of a boundary loop, or a quarter of a closed surface.
    SizeTooLarge {
        /// The greatest size, in the unit of the mesh.
        greatest: f64,
        /// A point of the loop.
        at: Vec3<f64>,
    },
    /// A matrix is not positive definite to working precision: coordinates are out of proportion.
    Numerical,
    /// The map exceeds the range of fixed-point coordinates.
    OutOfRange,
    /// No attempt gave a surface like the input.
    NotFollowed {
        /// What was wrong with the first attempt.
        fault: ResultFault,
    },
    /// The observer asked to stop.
    Cancelled,
}

impl RemeshError {
    /// The place of the fault, in the unit of the mesh.
    pub fn place(&self) -> Option<Vec3<f64>> {
        match *self {
            RemeshError::TooFewTriangles { at }
            | RemeshError::BranchingEdge { at, .. }
            | RemeshError::OneSided { at }
            | RemeshError::SizeTooLarge { at, .. } => Some(at),
            _ => None,
        }
    }
}

impl RemeshError {
    /// Whether the fault is that of one part, so that others can be covered.
    pub(super) fn is_of_part(&self) -> bool {
        !matches!(
            self,
            RemeshError::Empty | RemeshError::SizeTooSmall { .. } | RemeshError::Cancelled
        )
    }
}

impl fmt::Display for RemeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RemeshError::Empty => write!(f, "there are no faces with an area"),
            RemeshError::TooFewTriangles { .. } => {
                write!(f, "a part of the surface has fewer than ten triangles")
            }
            RemeshError::BranchingEdge { count: 1, .. } => {
                write!(f, "three or more faces meet in an edge: split the surface there")
            }
            RemeshError::BranchingEdge { count, .. } => {
                write!(f, "three or more faces meet in {count} edges: split the surface there")
            }
            RemeshError::OneSided { .. } => {
                write!(f, "a part of the surface has one side only: cut it open")
            }
            RemeshError::SizeTooSmall { least } => {
                let least = words::brief(words::rounded(*least, 2));
                write!(
                    f,
                    "panels of this size are more than 100 000, expected sides of {least} or more"
                )
            }
            RemeshError::SizeTooLarge { greatest, .. } => {
                let greatest = words::brief(words::rounded(*greatest, 2));
                write!(
                    f,
                    "panels of this size are too large for the surface, expected sides of {greatest} or less"
                )
            }
            RemeshError::Numerical => {
                write!(f, "the coordinates of the surface are out of proportion")
            }
            RemeshError::OutOfRange => {
                write!(f, "the surface is too large for panels of this size")
            }
            RemeshError::NotFollowed { fault } => {
                write!(
                    f,
                    "panels of this size cannot follow the surface ({fault}): try smaller ones"
                )
            }
            RemeshError::Cancelled => write!(f, "cancelled"),
        }
    }
}

impl std::error::Error for RemeshError {}
