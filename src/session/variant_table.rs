//! Comparison of the kept variants in numbers.

use super::Session;
use crate::math::twice_vector_area;
use crate::mesh::Point;
use crate::scene::{Variant, Variants};
use crate::session::Error;
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
    ///
    /// # Errors
    /// Never in practice: positions alone do not make the system singular.
    pub fn variant_table(&mut self, tolerance: f64) -> Result<Vec<VariantRow>, Error> {
        let here = Rc::clone(self.scene.positions());
        let Variants { kept, design } = self.document().variants.clone();
        let rows = kept.into_iter().enumerate().map(|(index, Variant { name, positions })| {
            let is_current = *positions == *here;
            self.at(positions, |session| {
                let verdict = session.verdict(tolerance);
                let (panels, within) = verdict.map_or((0, 0), |it| (it.of, it.within));
                VariantRow {
                    name,
                    is_design: design == Some(index),
                    is_current,
                    distance: session.hard_distance().map(|(most, _, _)| most),
                    moved: session.moved(),
                    area: session.area(),
                    panels,
                    beyond: panels - within,
                }
            })
        });
        rows.collect()
    }

    /// Evaluates `ask` at other positions, `#V by 3`, and restores the current ones.
    fn at<T>(
        &mut self,
        positions: Rc<[Point]>,
        ask: impl FnOnce(&mut Session) -> T,
    ) -> Result<T, Error> {
        let (mut change, generation) = (self.scene.snapshot(), self.generation());
        change.positions = positions;
        self.scene.exchange(&self.rest, &mut change)?;
        let answer = ask(self);
        self.scene.exchange(&self.rest, &mut change)?;
        self.scene.restored(generation);
        Ok(answer)
    }

    fn area(&self) -> f64 {
        let now = self.scene.positions();
        let faces = self.mesh().faces.iter();
        let twice =
            faces.map(|face| twice_vector_area(face.iter().map(|&v| now[v as usize].into())));
        twice.map(|area| 0.5 * area.length()).sum()
    }
}
