//! What hosts show of a row of constraints: its members, and the measure that it is about; and how
//! many vertices are held otherwise than the rest.

use super::constraint_map::ConstraintCoverage;
use crate::constraint::{Element, Selector};
use crate::session::state::Session;

impl Session {
    /// What row `index` asks of single faces, as the id of a measure: that of its kind, if each of
    /// its constraints is on one face.
    pub fn asked_measure(&self, index: usize) -> Option<&'static str> {
        let row = self.document.constraints.get(index)?;
        let of_faces = matches!(row.on, Selector::Each { element: Element::Face, radius: 0, .. });
        row.kind.info().measure.filter(|_| of_faces)
    }

    /// How many vertices are kept close more or less than the others.
    pub fn held_otherwise(&self) -> usize {
        let closeness = &self.document.closeness;
        if closeness.weights.is_empty() {
            return 0;
        }
        let factors = closeness.factors(&self.mesh, &self.topology, &self.document.sets);
        let factors = factors.expect("the document was resolved when it was taken over");
        factors.iter().filter(|&&factor| factor != 1.0).count()
    }

    /// The faces and the vertices that row `index` acts on, ascending; a face counts when one of the
    /// row's constraints has all its corners.
    pub fn members(&self, index: usize) -> [Vec<u32>; 2] {
        let mut cover = ConstraintCoverage::new(&self.mesh, &self.topology);
        let [mut faces, mut vertices] = [Vec::new(), Vec::new()];
        if let Some(row) = self.rows.get(index) {
            let members = &row.constraints.members;
            members.iter().for_each(|set| faces.extend(cover.faces(set)));
            vertices.extend(members.indices());
        }
        for indices in [&mut faces, &mut vertices] {
            indices.sort_unstable();
            indices.dedup();
        }
        [faces, vertices]
    }
}
