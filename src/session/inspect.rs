//! What hosts show of a session: errors of faces, members of constraints.

use super::Session;
use crate::mesh::Measures;

impl Session {
    /// How planar and circular the faces are now.
    pub fn measures(&self) -> Measures {
        Measures::new(&self.positions(), &self.mesh.faces, self.diameter)
    }

    /// The faces and the vertices that row `index` acts on, ascending; a face counts when all its
    /// corners do.
    pub fn members(&self, index: usize) -> [Vec<u32>; 2] {
        let mut is_member = vec![false; self.mesh.positions.len()];
        if let Some(row) = self.rows.get(index) {
            row.constraints.members.indices().iter().for_each(|&v| is_member[v as usize] = true);
        }
        let all_corners = |face: &[u32]| face.iter().all(|&v| is_member[v as usize]);
        let faces = (0..).zip(self.mesh.faces.iter());
        let faces = faces.filter(|(_, face)| all_corners(face)).map(|(index, _)| index).collect();
        let vertices = (0..).zip(&is_member);
        let vertices = vertices.filter(|(_, member)| **member).map(|(index, _)| index).collect();
        [faces, vertices]
    }
}
