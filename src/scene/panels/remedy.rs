//! Changes of a mesh for panels of one shape: after one the offered kinds apply, or the mesh moves
//! less for them.

use super::request::is_of_triangles;
use crate::constraint::KINDS;
use crate::mesh::{MESH_OPERATIONS, Mesh};
use serde::Serialize;

/// A change of the mesh for panels of one shape.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct MeshRemedy {
    /// Why it helps.
    pub words: String,
    /// The id of one of the [`MESH_OPERATIONS`].
    pub operation: &'static str,
    /// Its label.
    pub label: &'static str,
}

impl MeshRemedy {
    /// Creates a remedy from the id of an operation; none if there is no such operation.
    pub(super) fn new(operation: &str, words: String) -> Option<MeshRemedy> {
        let operation = MESH_OPERATIONS.iter().find(|one| one.id == operation)?;
        Some(MeshRemedy { words, operation: operation.id, label: operation.label })
    }
}

/// Returns the change of the mesh after which the offered kinds apply, if there is one: none applies
/// to triangles, which can be joined to quads.
pub fn panel_remedy(mesh: &Mesh) -> Option<MeshRemedy> {
    let can_join = mesh.faces.len() > 1 && mesh.tets.is_empty() && is_of_triangles(mesh);
    let adjectives: Vec<&str> = KINDS.iter().filter_map(|info| info.panels).collect();
    let words = format!(
        "All panels are triangles, which are always {}. Pairs of them can be joined to quads.",
        adjectives.join(" and ")
    );
    can_join.then(|| MeshRemedy::new("quads", words)).flatten()
}
