//! What hosts show of a session: errors of faces, members of constraints, previews.

use super::acting::Cover;
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
