//! Selecting by number of sides, by valence, by error, by name.

use super::elements::{Elements, Marks};
use super::request::{Selection, error};
use crate::constraint::{Selector, Sets, resolve};
use crate::scene::SceneError;
use crate::session::report::{Measuring, Shape, face_values};
use crate::session::state::RestMesh;

impl Elements<'_> {
    /// Returns the faces with this number of corners.
    pub(super) fn with_sides(&self, sides: f64) -> Marks {
        self.mesh.faces.iter().map(|face| face.len() as f64 == sides).collect()
    }

    /// Returns the vertices with this number of edges.
    pub(super) fn with_valence(&self, edges: f64) -> Marks {
        self.topology.neighbours().iter().map(|row| row.len() as f64 == edges).collect()
    }
}

/// Returns the faces of the current shape whose error is above `tolerance`; `measure` is one of
/// [`crate::session::FACE_MEASURES`], and the tolerance is in its unit.
pub(super) fn with_error_above(
    model: &mut Measuring<'_>,
    measure: String,
    tolerance: f64,
) -> Result<Selection, SceneError> {
    let errors = face_values(model, &measure, Shape::Now)
        .ok_or_else(|| error("measure", format!("unknown measure of faces `{measure}`")))?;
    let above = (0..).zip(errors).filter(|&(_, error)| error > tolerance);
    Ok(Selection { faces: above.map(|(face, _)| face).collect(), ..Selection::default() })
}

/// Returns the members of a set or, if there is none of that name, of a group: its faces, and the
/// vertices of its curves.
pub(super) fn named(name: String, sets: &Sets, rest: &RestMesh) -> Result<Selection, SceneError> {
    if let Some(set) = sets.get(&name) {
        let (vertices, faces) = (set.vertices.clone(), set.faces.clone());
        return Ok(Selection { vertices, faces, ..Selection::default() });
    }
    let mesh = rest.mesh();
    let mut found = Selection::default();
    for group in mesh.groups.iter().filter(|group| group.name == name) {
        found.faces.extend(&group.faces);
        let curves = group.curves.iter().map(|&curve| mesh.curves.row(curve as usize));
        found.vertices.extend(curves.flatten());
    }
    if found == Selection::default() {
        let selected = resolve(&Selector::Set(name), mesh, rest.topology(), sets);
        selected.map_err(|problem| error("name", problem.to_string()))?;
    }
    Ok(found)
}
