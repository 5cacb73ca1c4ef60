//! The settings of a build: scale, sheet, joint, distance.

use super::choice::{Dxf, Fold, Join, Names, OffsetKind, Order, Pieces, Product};
use super::page::Page;
use crate::json::{fixed, object, pairs, word, word_or_null};
use serde::{Deserialize, Serialize};
use std::rc::Rc;

/// The settings of a build: the key `build` of a scene. Lengths of the building are in the unit of
/// the mesh; lengths of the sheet and the material are in mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct BuildSettings {
    /// The product.
    #[serde(deserialize_with = "word")]
    pub product: Product,
    /// The elements that keep their distance in the offset; null chooses the kind that meets
    /// the limits, or else has the smallest errors.
    #[serde(deserialize_with = "word_or_null")]
    pub kind: Option<OffsetKind>,
    /// Distance of the offset and depth of beams, positive outwards; null for a fifth of the mean
    /// edge.
    pub distance: Option<f64>,
    /// Weight of following the surface normals when axes are fitted.
    pub follow: f64,
    /// The gap between neighbouring panels.
    pub joint: f64,
    /// How far panels are from the boundary of the model; null for half the joint.
    pub setback: Option<f64>,
    /// The denominator of the scale.
    pub scale: f64,
    /// The name of the material, printed on the sheets.
    pub material: String,
    /// Thickness of the material.
    pub thickness: f64,
    /// The least radius, in thicknesses, to which panels are bent; those that need a smaller one are cut as
    /// two triangles. 0 for any.
    pub bend: f64,
    /// Width and height of a sheet.
    #[serde(deserialize_with = "fixed")]
    pub sheet: [f64; 2],
    /// The margin at the edges of a sheet.
    pub margin: f64,
    /// The gap between parts.
    pub gap: f64,
    /// Width of the cut: outlines are moved outwards by half of it.
    pub kerf: f64,
    /// Diameter of a milling tool, for which inner corners get reliefs; 0 for none.
    pub tool: f64,
    /// Diameter of holes along the edges between panels, and at the ends of fins; 0 for none.
    pub hole: f64,
    /// Width of the plates that join the pieces of panels larger than the sheet; 0 for no pieces.
    pub splice: f64,
    /// Width of the strips that cover the joints between panels; 0 for none.
    pub strip: f64,
    /// Diameter of the node discs that fins are joined by; 0 for none, null for the smallest that has
    /// room at each node.
    pub disc: Option<f64>,
    /// Play between a node disc and a fin, or a tongue and its slot, on each side.
    pub clearance: f64,
    /// The order in which parts are laid out.
    #[serde(deserialize_with = "word")]
    pub order: Order,
    /// How panels are named.
    #[serde(deserialize_with = "word")]
    pub names: Names,
    /// Tolerance of panel types: difference of distances between corners, in mm of the building.
    pub alike: f64,
    /// Whether mirror images have the same type: the sheet may be turned over.
    pub mirror: bool,
    /// Whether to write only outlines, on layer 0 and without names, as some shops require.
    pub outlines_only: bool,
    /// Whether to write each part as files of its own too, without the sheet.
    pub one_file_each: bool,
    /// Width of prisms; null for a twentieth of the mean edge.
    pub beam_width: Option<f64>,
    /// Tolerance of node types: difference of angles, in degrees.
    pub alike_deg: f64,
    /// The kind of pieces of a paper model.
    #[serde(deserialize_with = "word")]
    pub pieces: Pieces,
    /// The edges along which a paper model is cut and never folded, each by its two vertices in any order.
    #[serde(with = "pairs")]
    #[cfg_attr(target_arch = "wasm32", tsify(type = "[number, number][]"))]
    pub seams: Rc<[[u32; 2]]>,
    /// How the folds of a paper model are made.
    #[serde(deserialize_with = "word")]
    pub fold: Fold,
    /// How the cut edges of creased paper are joined.
    #[serde(deserialize_with = "word")]
    pub join: Join,
    /// Height of tabs, tongues and flanges on creased paper; 0 for none.
    pub tab: f64,
    /// Whether panels or paper are printed on the side that will be inside: mirrored, with readable names.
    pub print_inside: bool,
    /// Page size of the PDF: larger sheets are tiled.
    #[serde(deserialize_with = "word")]
    pub page: Page,
    /// The version of DXF.
    #[serde(deserialize_with = "word")]
    pub dxf: Dxf,
    /// Limits of the build check.
    #[serde(deserialize_with = "object")]
    pub limits: CheckLimits,
}

/// Limits of the build check and of parts. Lengths are in mm of the building, except for `part`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct CheckLimits {
    /// Distance of the corners of a beam from its plane.
    pub warp: f64,
    /// Deviation of the offset from the requested distance.
    pub distance: f64,
    /// Angle between a node axis and the surface normal, in degrees.
    pub lean: f64,
    /// Distance of the corners of a panel from its plane.
    pub flatness: f64,
    /// The least width of parts, in mm of the sheet.
    pub part: f64,
}

impl Default for CheckLimits {
    fn default() -> CheckLimits {
        CheckLimits { warp: 1.0, distance: 1.0, lean: 20.0, flatness: 1.0, part: 3.5 }
    }
}

impl Default for BuildSettings {
    /// Card models at 1:50 on A3.
    fn default() -> BuildSettings {
        BuildSettings {
            product: Product::Panels,
            kind: None,
            distance: None,
            follow: 0.01,
            joint: 0.0,
            setback: None,
            scale: 50.0,
            material: "card".to_owned(),
            thickness: 0.5,
            bend: 0.0,
            sheet: [420.0, 297.0],
            margin: 5.0,
            gap: 3.0,
            kerf: 0.0,
            tool: 0.0,
            hole: 0.0,
            splice: 0.0,
            strip: 0.0,
            disc: Some(0.0),
            clearance: 0.1,
            order: Order::Size,
            names: Names::Index,
            alike: 1.0,
            mirror: false,
            outlines_only: false,
            one_file_each: false,
            beam_width: None,
            alike_deg: 0.5,
            pieces: Pieces::Nets,
            seams: Rc::default(),
            fold: Fold::Crease,
            join: Join::Tabs,
            tab: 8.0,
            print_inside: false,
            page: Page::Sheet,
            dxf: Dxf::R2000,
            limits: CheckLimits::default(),
        }
    }
}

impl BuildSettings {
    /// Checks that every number is finite and in its range, and every edge is listed once; whether the mesh
    /// has these edges is checked by [`BuildSettings::check_edges`].
    ///
    /// # Errors
    /// The path of the first invalid setting, and a message.
    pub fn check(&self) -> Result<(), (String, String)> {
        self.check_numbers().map_err(|(id, message)| (id.to_owned(), message))?;
        self.check_seams()?;
        if self.sheet.iter().any(|size| *size <= 2.0 * self.margin) {
            let [width, height] = self.sheet;
            let margin = self.margin;
            let message = format!(
                "found {margin}, expected less than half of each side of the sheet ({width} x {height} mm)"
            );
            return Err(("margin".to_owned(), message));
        }
        Ok(())
    }
}
