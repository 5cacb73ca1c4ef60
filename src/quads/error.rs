//! Why a surface cannot be remeshed, with the place.

use super::fault::{MapFault, ResultFault};
use super::options::MOST_PANELS;
use crate::math::Vec3;
use crate::words;
use std::fmt;

/// Why a surface, or a part of it, cannot be remeshed.
#[derive(Clone, Debug, PartialEq)]
pub enum RemeshError {
    /// There are no faces of positive area.
    Empty,
    /// All faces with an area are to stay as they are.
    AllStay,
    /// All faces, but those that are to stay, have no area or a vertex whose position is not in the file.
    Unplaced,
    /// The mesh has tetrahedra: with other faces they would have another surface.
    Tetrahedra,
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
    /// The square of the panel size is more than a quarter of a part of the surface.
    SizeTooLarge {
        /// The greatest size, in the unit of the mesh.
        greatest: f64,
        /// A point of the part.
        at: Vec3<f64>,
    },
    /// An opening is less than two panels around, and cannot be covered: the end of a tube, or one
    /// around faces that stay.
    Opening {
        /// The length around it, in the unit of the mesh.
        length: f64,
        /// The greatest size of panels that leaves it open, in the unit of the mesh.
        greatest: f64,
        /// Whether faces that stay are beside it.
        stays: bool,
        /// The mean of its vertices.
        at: Vec3<f64>,
    },
    /// A part of the surface has no map.
    NotMapped {
        /// Why.
        fault: MapFault,
    },
    /// No attempt gave a surface like the input.
    NotFollowed {
        /// What was wrong with the first attempt.
        fault: ResultFault,
        /// A smaller size of panels, in the unit of the mesh, which was not tried; none if it would be
        /// refused.
        smaller: Option<f64>,
        /// The largest place where the map of the first attempt is flipped, if it is anywhere.
        at: Option<Vec3<f64>>,
    },
}

impl RemeshError {
    /// The place of the fault, in the unit of the mesh.
    pub fn place(&self) -> Option<Vec3<f64>> {
        match *self {
            RemeshError::TooFewTriangles { at }
            | RemeshError::BranchingEdge { at, .. }
            | RemeshError::OneSided { at }
            | RemeshError::Opening { at, .. }
            | RemeshError::SizeTooLarge { at, .. } => Some(at),
            RemeshError::NotFollowed { at, .. } => at,
            _ => None,
        }
    }
}

impl RemeshError {
    /// Whether the fault is that of one part, so that others can be covered.
    pub(super) fn is_of_part(&self) -> bool {
        !matches!(
            self,
            RemeshError::Empty
                | RemeshError::AllStay
                | RemeshError::Unplaced
                | RemeshError::Tetrahedra
                | RemeshError::SizeTooSmall { .. }
        )
    }
}

/// Sizes in words are on the safe side of their limit by this fraction, more than rounding takes.
const SAFE: f64 = 0.005;

impl RemeshError {
    /// The sentence, without a full stop; `units` is the symbol of the unit of the mesh, in which sizes
    /// are entered, empty if it is not known.
    pub fn words(&self, units: &str) -> String {
        let side = |size: f64| words::limit_like(words::rounded(size, 3), units, 1.0);
        match self {
            RemeshError::Empty => "there are no faces with an area".to_owned(),
            RemeshError::AllStay => "all faces with an area are to stay as they are".to_owned(),
            RemeshError::Unplaced => {
                "all faces to be covered have no area, or a vertex with a coordinate in the file that is not a number"
                    .to_owned()
            }
            RemeshError::Tetrahedra => "the mesh has tetrahedra, expected a surface".to_owned(),
            RemeshError::TooFewTriangles { .. } => {
                "a part of the surface has fewer than ten triangles".to_owned()
            }
            RemeshError::BranchingEdge { count: 1, .. } => {
                "three or more faces meet in an edge: split the surface there".to_owned()
            }
            RemeshError::BranchingEdge { count, .. } => {
                let count = words::group_digits(*count);
                format!("three or more faces meet in {count} edges: split the surface there")
            }
            RemeshError::OneSided { .. } => {
                "a part of the surface has one side only: cut it open".to_owned()
            }
            RemeshError::SizeTooSmall { least } => {
                let least = side(least * (1.0 + SAFE));
                let most = words::group_digits(MOST_PANELS as usize);
                format!("there would be more than {most} panels, expected sides of {least} or more")
            }
            RemeshError::SizeTooLarge { greatest, .. } => {
                let greatest = side(greatest * (1.0 - SAFE));
                format!(
                    "panels of this size are too large for the surface, expected sides of {greatest} or less"
                )
            }
            RemeshError::NotMapped { fault } => fault.to_string(),
            RemeshError::Opening { length, greatest, stays, .. } => {
                let greatest = side(greatest * (1.0 - SAFE));
                let length = words::limit(words::rounded(*length, 3), units);
                let [beside, mend] = match stays {
                    true => [" beside faces that stay", "expected"],
                    false => ["", "close it, or make"],
                };
                format!(
                    "an opening{beside} is {length} around, less than two panels: {mend} sides of {greatest} or less"
                )
            }
            RemeshError::NotFollowed { fault, smaller, .. } => {
                let such = smaller.map(|size| format!(", perhaps with sides of {}", side(size)));
                let such = such.unwrap_or_default();
                format!(
                    "panels of this size cannot follow the surface ({fault}): expected smaller panels{such}"
                )
            }
        }
    }
}

impl fmt::Display for RemeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.words(""))
    }
}

impl std::error::Error for RemeshError {}
