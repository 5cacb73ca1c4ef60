//! Comparison of the kept variants in numbers.

use super::Session;
use super::state::SceneState;
use crate::math::twice_vector_area;
use crate::scene::{Variant, Variants};
use crate::session::Error;
use crate::solve::Moved;
use serde::Serialize;

/// The numbers of a variant.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
#[serde(rename_all = "camelCase")]
pub struct VariantRow {
    /// Its name.
    pub name: String,
    /// Whether it is the design.
    pub is_design: bool,
    /// Whether it is the current shape.
    pub is_current: bool,
    /// The largest distance of a vertex to a hard constraint, in the unit of the mesh, if any.
    pub distance: Option<f64>,
    /// Displacements from the original, in the unit of the mesh.
    pub moved: Moved,
    /// The area of all faces, in the squared unit of the mesh.
    pub area: f64,
    /// Number of panels with a required shape.
    pub panels: usize,
    /// Number of these panels beyond the tolerance.
    pub beyond: usize,
}

impl Session {
    /// Returns the numbers of every variant, with a count of the panels beyond `tolerance`.
    ///
    /// # Errors
    /// Never in practice: positions alone do not make the system singular.
    pub fn variant_table(&self, tolerance: f64) -> Result<Vec<VariantRow>, Error> {
        let Variants { kept, design } = self.document().variants.clone();
        if kept.is_empty() {
            return Ok(Vec::new());
        }
        // This session may be running, and what was measured of its shape stays.
        let mut copy = Session::open(self.scene(), self.mesh().clone())?;
        let rows = kept.into_iter().enumerate().map(|(index, Variant { name, positions })| {
            let is_current = *positions == **self.scene.positions();
            let state = SceneState { positions, ..copy.scene.state() };
            copy.scene.go_to(&copy.rest, state)?;
            let [within, panels] = copy.panels_within(tolerance).unwrap_or_default();
            Ok(VariantRow {
                name,
                is_design: design == Some(index),
                is_current,
                distance: copy.hard_distance().map(|(most, _, _)| most),
                moved: copy.moved(),
                area: copy.area(),
                panels,
                beyond: panels - within,
            })
        });
        rows.collect()
    }

    fn area(&self) -> f64 {
        let now = self.scene.positions();
        let faces = self.mesh().faces.iter();
        let twice =
            faces.map(|face| twice_vector_area(face.iter().map(|&v| now[v as usize].into())));
        twice.map(|area| 0.5 * area.length()).sum()
    }
}
