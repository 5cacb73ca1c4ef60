//! The numbers of the shapes that were kept, side by side.

use super::Session;
use crate::error::Error;
use crate::math::twice_vector_area;
use crate::solve::Moved;
use serde::Serialize;
use std::rc::Rc;

/// The numbers of a shape that was kept.
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
    /// The greatest distance of a vertex to what is hard, in the unit of the mesh; none where nothing is.
    pub distance: Option<f64>,
    /// The way of the vertices from the original, in the unit of the mesh.
    pub moved: Moved,
    /// The area of all faces, in the square of the unit.
    pub area: f64,
    /// How many panels are asked to have a shape.
    pub panels: usize,
    /// How many of them are beyond the tolerance.
    pub beyond: usize,
}

impl Session {
    /// The numbers of every variant, with panels beyond `tolerance` counted. What is shown and not kept is left.
    ///
    /// # Errors
    /// Never in practice: positions alone do not make the system singular.
    pub fn variant_table(&mut self, tolerance: f64) -> Result<Vec<VariantRow>, Error> {
        self.end_transaction();
        let variants = self.document().variants.clone();
        let here = Rc::clone(self.scene.positions());
        let mut table = Vec::new();
        for (index, variant) in variants.kept.into_iter().enumerate() {
            let mut change = self.scene.way_back();
            change.positions = variant.positions;
            self.scene.exchange(&self.rest, &mut change)?;
            let now = self.scene.positions();
            let is_current = **now == *here;
            let corners = |face: &[u32]| face.iter().map(|&v| now[v as usize].into()).collect();
            let area = |face: &[u32]| {
                let corners: Vec<_> = corners(face);
                0.5 * twice_vector_area(corners).length()
            };
            let area = self.mesh().faces.iter().map(area).sum();
            let verdict = self.verdict(tolerance);
            let (panels, within) = verdict.map_or((0, 0), |it| (it.panels, it.within));
            table.push(VariantRow {
                name: variant.name,
                is_design: variants.design == Some(index),
                is_current,
                distance: self.hard_distance().map(|(most, _, _)| most),
                moved: self.moved(),
                area,
                panels,
                beyond: panels - within,
            });
            self.scene.exchange(&self.rest, &mut change)?;
        }
        Ok(table)
    }
}
