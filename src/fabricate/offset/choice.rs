//! The errors of one kind of offset.

use super::axes::Axes;
use super::check::OffsetCheck;
use crate::scene::OffsetKind;
use serde::Serialize;

/// The errors that one kind of offset would have, to choose between kinds.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Choice {
    /// The kind.
    pub kind: OffsetKind,
    /// Whether it is exact.
    pub exact: bool,
    /// The beam warp in mm of the building.
    pub warp_mm: f64,
    /// The distance error in mm of the building.
    pub distance_error_mm: f64,
}

impl Choice {
    /// The errors of these axes; `building` is in mm of the building per unit of the mesh.
    pub(in crate::fabricate) fn of(axes: &Axes, check: &OffsetCheck, building: f64) -> Choice {
        Choice {
            kind: axes.kind,
            exact: axes.exact,
            warp_mm: check.warp * building,
            distance_error_mm: check.distance_error * building,
        }
    }
}
