//! The numbers of a build that a lesson can limit. They are declared here for hosts that do not
//! build.

use super::build::Build;
use serde::Serialize;

/// The unit of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum NumberUnit {
    /// The unit of the mesh.
    Length,
    /// Degrees.
    Degrees,
    /// A number of items.
    Count,
}

/// A number of a build: never negative, 0 is best.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct BuildNumber {
    /// Identifier in files.
    pub id: &'static str,
    /// Display name.
    pub label: &'static str,
    /// What it measures.
    pub description: &'static str,
    /// Its unit.
    pub unit: NumberUnit,
}

pub(super) const BEAM_WARP: BuildNumber = BuildNumber {
    id: "beam_warp",
    label: "Beam out of plane",
    description: "largest distance of a beam's corners to its plane",
    unit: NumberUnit::Length,
};
pub(super) const DISTANCE_ERROR: BuildNumber = BuildNumber {
    id: "distance_error",
    label: "Offset error",
    description: "largest difference of the offset from its distance",
    unit: NumberUnit::Length,
};
pub(super) const LEAN: BuildNumber = BuildNumber {
    id: "lean",
    label: "Lean of nodes",
    description: "largest angle between an inner node axis and the surface normal",
    unit: NumberUnit::Degrees,
};
pub(super) const PANEL_FLATNESS: BuildNumber = BuildNumber {
    id: "panel_flatness",
    label: "Panel flatness",
    description: "largest distance of a panel's corners to its plane",
    unit: NumberUnit::Length,
};

/// All numbers.
pub const BUILD_NUMBERS: [BuildNumber; 6] = [
    BEAM_WARP,
    DISTANCE_ERROR,
    LEAN,
    PANEL_FLATNESS,
    BuildNumber {
        id: "types",
        label: "Types of panels",
        description: "number of types of panels that are alike within the tolerance of the build",
        unit: NumberUnit::Count,
    },
    BuildNumber {
        id: "sheets",
        label: "Sheets",
        description: "number of sheets needed for all parts",
        unit: NumberUnit::Count,
    },
];

impl Build {
    /// The values of [`BUILD_NUMBERS`], lengths in the unit of the mesh; none if one does not
    /// apply. Sheets are counted only if there are parts and every part is on one.
    pub fn numbers(&self) -> [Option<f64>; BUILD_NUMBERS.len()] {
        let rows = self.check_rows();
        let placed: usize = self.layout.sheets.iter().map(|sheet| sheet.places.len()).sum();
        let is_whole = placed > 0 && placed == self.parts.len() && self.missing_parts() == 0;
        BUILD_NUMBERS.map(|number| match number.id {
            "types" => Some(self.types.leaders.len() as f64),
            "sheets" => is_whole.then_some(self.layout.sheets.len() as f64),
            id => {
                let value = rows.iter().find(|row| row.id == id)?.value?;
                let is_length = number.unit == NumberUnit::Length;
                Some(if is_length { value / self.mm_of_building() } else { value })
            }
        })
    }
}
