//! What hosts show of a session: errors of faces, members of constraints, previews.

use super::{NewConstraint, ResolvedRow, Session, resolve};
use crate::mesh::Measures;
use crate::scene::SceneError;

impl Session {
    /// How planar and circular the faces are now.
    pub fn measures(&self) -> Measures {
        Measures::new(&self.positions(), &self.mesh.faces, self.diameter)
    }

    /// The row that adding `new` would make, without adding it.
    ///
    /// # Errors
    /// When it would be empty.
    pub fn preview(&self, new: &NewConstraint) -> Result<ResolvedRow, SceneError> {
        let mut document = self.document.clone();
        new.clone().add_to(&mut document);
        document.validate(&self.mesh)?;
        let spec = document.constraints.last().expect("a row was just added");
        resolve::row(spec, &document, &self.mesh, &self.topology)
            .map_err(|message| SceneError { path: String::new(), message })
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
