//! What is wished of new panels.

use crate::mesh::Mesh;
use crate::quads::{Boundary, MapOptions, PanelSize, direction_weight, follow_weight};
use crate::scene::is_mostly_triangles;
use serde::Deserialize;

/// The number of panels of a mesh mostly of triangles without a wish: half its faces, within these.
const PANELS: [usize; 2] = [60, 500];
/// The same of other meshes, whose faces are panels.
const FACES: [usize; 2] = [60, 2000];

/// What is wished of new panels.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
#[serde(deny_unknown_fields)]
pub struct LayoutSettings {
    /// Their number. Without it and without a size, a number that suits the mesh.
    #[serde(default)]
    pub count: Option<usize>,
    /// The length of their sides, in the unit of the mesh, which goes before their number.
    #[serde(default)]
    pub size: Option<f64>,
    /// From 0, few irregular points, to 1, a small move to circular panels.
    pub follow: f64,
    /// From 0, a small move, to 1, panels of even size.
    pub even: f64,
    /// Whether the boundary is followed or cuts panels; without a wish, what moves less.
    #[serde(default)]
    pub boundary: Option<Boundary>,
}

impl LayoutSettings {
    /// The settings of the map of `mesh`, but for the choice at the boundary.
    pub(super) fn options(&self, mesh: &Mesh) -> MapOptions {
        let size = match (self.size, self.count) {
            (Some(length), _) => PanelSize::Length(length),
            (None, Some(count)) => PanelSize::Count(count),
            (None, None) => PanelSize::Count(usual_count(mesh)),
        };
        MapOptions {
            follow: follow_weight(self.follow),
            direction: direction_weight(self.even),
            ..MapOptions::of_size(size)
        }
    }
}

/// The number of panels that suits a mesh.
fn usual_count(mesh: &Mesh) -> usize {
    let faces = mesh.faces.len();
    match is_mostly_triangles(mesh) {
        true => (faces / 2).clamp(PANELS[0], PANELS[1]),
        false => faces.clamp(FACES[0], FACES[1]),
    }
}
