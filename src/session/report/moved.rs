//! Displacements of the vertices.

use crate::session::state::{RestMesh, SolvedScene};
use crate::solve::Moved;

/// Returns the distances of the vertices from their rest positions, in the unit of the mesh.
pub(crate) fn moved(scene: &SolvedScene, rest: &RestMesh) -> Moved {
    rest.moved_by(scene.positions())
}

/// Returns the distance of each vertex from its rest position, `#V`, in the unit of the mesh.
pub(super) fn displacements(scene: &SolvedScene, rest: &RestMesh) -> Vec<f64> {
    rest.displacements(scene.positions()).collect()
}
