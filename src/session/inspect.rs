//! What hosts show of a session: members of constraints.

use super::Session;
use super::acting::Cover;

impl Session {
    /// The faces and the vertices that row `index` acts on, ascending; a face counts when one of the
    /// row's constraints has all its corners.
    pub fn members(&self, index: usize) -> [Vec<u32>; 2] {
        let mut cover = Cover::new(&self.mesh, &self.topology);
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
