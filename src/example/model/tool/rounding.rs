//! Coordinates with few digits.

use crate::mesh::Mesh;

/// Rounds coordinates to tenths of a millimetre, so that the file is short.
pub(crate) fn rounded(mut mesh: Mesh) -> Mesh {
    for x in mesh.positions.as_flattened_mut() {
        *x = (*x * 1e4).round() / 1e4;
    }
    mesh
}
