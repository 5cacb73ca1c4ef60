//! What is asked once: scale, sheet, joint, distance; and the presets that have answers.

use super::offset::OffsetKind;
use super::panel::Names;
use super::sheet::Order;
use serde::{Deserialize, Serialize};

/// The settings of a build: the key `build` of a scene. Lengths of the building are in the unit of the mesh, those
/// of the sheet and of the material in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct BuildSettings {
    /// What keeps its distance in the offset; null proposes the kind with the smaller errors.
    pub kind: Option<OffsetKind>,
    /// The distance of the offset and the depth of beams, positive outwards; null takes a fifth of the mean edge.
    pub distance: Option<f64>,
    /// The weight of following the surface when axes are fitted.
    pub follow: f64,
    /// The gap between neighbouring panels.
    pub joint: f64,
    /// The scale of the model, one to so many.
    pub scale: f64,
    /// The name of the material, printed on the sheets.
    pub material: String,
    /// The thickness of the material.
    pub thickness: f64,
    /// Width and height of a sheet.
    pub sheet: [f64; 2],
    /// What stays free at the edges of a sheet.
    pub margin: f64,
    /// What stays free between parts.
    pub gap: f64,
    /// What the tool takes away: outlines are moved out by half of it.
    pub kerf: f64,
    /// In which order parts are laid out.
    pub order: Order,
    /// How panels are named.
    pub names: Names,
    /// Panels whose corner distances differ by no more are of one type, in mm of the building.
    pub alike: f64,
    /// Whether mirror images are of one type: the sheet may be turned over.
    pub mirror: bool,
    /// Outlines alone, without names, on layer 0: some shops ask for that.
    pub outlines_only: bool,
    /// Which DXF is written.
    pub dxf: Dxf,
    /// Limits of the build check.
    pub limits: CheckLimits,
}

/// A version of DXF.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub enum Dxf {
    /// AC1015: closed light polylines, units in the header.
    #[default]
    R2000,
    /// AC1009, for old machines.
    R12,
}

/// Above which a number of the build check is not met. Lengths in mm of the building.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct CheckLimits {
    /// Of the corners of a beam to its plane.
    pub warp: f64,
    /// Of the distance of the offset from what is asked for.
    pub distance: f64,
    /// Of the angle between a node axis and the surface, in degrees.
    pub lean: f64,
    /// Of the corners of a panel to its plane.
    pub flatness: f64,
}

impl Default for CheckLimits {
    fn default() -> CheckLimits {
        CheckLimits { warp: 1.0, distance: 1.0, lean: 20.0, flatness: 1.0 }
    }
}

impl Default for BuildSettings {
    /// Card models at 1:50 on A3.
    fn default() -> BuildSettings {
        let BuildPreset { material, thickness, scale, sheet, .. } = PRESETS[0];
        BuildSettings {
            kind: None,
            distance: None,
            follow: 0.01,
            joint: 0.0,
            scale,
            material: material.to_owned(),
            thickness,
            sheet,
            margin: 5.0,
            gap: 3.0,
            kerf: 0.0,
            order: Order::Size,
            names: Names::Index,
            alike: 1.0,
            mirror: false,
            outlines_only: false,
            dxf: Dxf::R2000,
            limits: CheckLimits::default(),
        }
    }
}

/// Settings that belong together.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct BuildPreset {
    /// Its name.
    pub label: &'static str,
    /// See [`BuildSettings`].
    pub material: &'static str,
    /// See [`BuildSettings`].
    pub thickness: f64,
    /// See [`BuildSettings`].
    pub scale: f64,
    /// See [`BuildSettings`].
    pub sheet: [f64; 2],
}

/// What people build with most often.
pub const PRESETS: [BuildPreset; 4] = [
    BuildPreset {
        label: "Card model 1:50, A3",
        material: "card",
        thickness: 0.5,
        scale: 50.0,
        sheet: [420.0, 297.0],
    },
    BuildPreset {
        label: "3 mm plywood 1:20, 600 x 400",
        material: "plywood",
        thickness: 3.0,
        scale: 20.0,
        sheet: [600.0, 400.0],
    },
    BuildPreset {
        label: "4 mm acrylic 1:50, 1200 x 600",
        material: "acrylic",
        thickness: 4.0,
        scale: 50.0,
        sheet: [1200.0, 600.0],
    },
    BuildPreset {
        label: "Glass 1:1, 3210 x 2250",
        material: "glass",
        thickness: 10.0,
        scale: 1.0,
        sheet: [3210.0, 2250.0],
    },
];

impl BuildSettings {
    /// Checks that every number is finite and in its range: the key, and what is wrong with it.
    ///
    /// # Errors
    /// The first that is not.
    pub fn check(&self) -> Result<(), (&'static str, String)> {
        let above = |value: f64| value > 0.0 && value.is_finite();
        let from_zero = |value: f64| value >= 0.0 && value.is_finite();
        let numbers = [
            ("follow", self.follow, true),
            ("scale", self.scale, true),
            ("sheet[0]", self.sheet[0], true),
            ("sheet[1]", self.sheet[1], true),
            ("joint", self.joint, false),
            ("thickness", self.thickness, false),
            ("margin", self.margin, false),
            ("gap", self.gap, false),
            ("kerf", self.kerf, false),
            ("alike", self.alike, false),
            ("limits.warp", self.limits.warp, false),
            ("limits.distance", self.limits.distance, false),
            ("limits.lean", self.limits.lean, false),
            ("limits.flatness", self.limits.flatness, false),
        ];
        for (key, value, positive) in numbers {
            if positive && !above(value) {
                return Err((key, format!("found {value}, expected a number above 0")));
            }
            if !from_zero(value) {
                return Err((key, format!("found {value}, expected a number from 0")));
            }
        }
        if let Some(distance) = self.distance
            && (!distance.is_finite() || distance == 0.0)
        {
            return Err(("distance", format!("found {distance}, expected a length that is not 0")));
        }
        if self.sheet.iter().any(|size| *size <= 2.0 * self.margin) {
            let [width, height] = self.sheet;
            let margin = self.margin;
            let message = format!(
                "found {margin}, which leaves nothing of a sheet of {width} x {height} mm, expected less than half of it"
            );
            return Err(("margin", message));
        }
        Ok(())
    }
}
