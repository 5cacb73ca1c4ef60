//! Comparison of the kept variants in numbers.

use super::Session;
use super::report::Shape;
use crate::math::{Vec3, twice_vector_area};
use crate::scene::{Variant, Variants};
use crate::solve::Moved;
use serde::Serialize;
use std::rc::Rc;

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
    pub fn variant_table(&mut self, tolerance: f64) -> Vec<VariantRow> {
        let Variants { kept, design } = self.document().variants.clone();
        let row = |(index, Variant { name, positions }): (usize, Variant)| {
            let shape = Shape::At(Rc::clone(&positions));
            let [beyond, panels] = self.panels_beyond(tolerance, &shape).unwrap_or_default();
            let at = |&v: &u32| Vec3::from(positions[v as usize]);
            let faces = self.mesh().faces.iter();
            let areas = faces.map(|face| 0.5 * twice_vector_area(face.iter().map(at)).length());
            VariantRow {
                name,
                is_design: design == Some(index),
                is_current: positions == *self.scene.positions(),
                distance: self.hard_distance_at(&positions),
                moved: self.rest.moved_by(&positions),
                area: areas.sum(),
                panels,
                beyond,
            }
        };
        kept.into_iter().enumerate().map(row).collect()
    }
}
