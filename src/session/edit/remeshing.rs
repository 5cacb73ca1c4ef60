//! Operations on the mesh, and their previews.

use crate::json::indices;
use crate::mesh::{MESH_OPERATIONS, Mesh, MeshOperation, Size, SizeOf};
use crate::words::rounded;
use serde::{Deserialize, Serialize};

/// An operation on the mesh and what it is applied to: see [`crate::mesh::MeshOperation`].
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(deny_unknown_fields)]
pub struct Remeshing {
    /// The id of the operation.
    pub operation: String,
    /// Its sizes, in the order of its declaration.
    #[serde(default)]
    pub sizes: Vec<f64>,
    /// The selected vertices.
    #[serde(default, deserialize_with = "indices::deserialize")]
    pub vertices: Vec<u32>,
    /// The selected faces.
    #[serde(default, deserialize_with = "indices::deserialize")]
    pub faces: Vec<u32>,
}

/// An operation with the default values of its sizes.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct OfferedOperation {
    /// The operation.
    #[serde(flatten)]
    pub operation: MeshOperation,
    /// The defaults, in the order of its sizes; lengths are rounded and in the unit of the mesh.
    pub defaults: Vec<f64>,
}

/// Returns all operations, for a mesh with this mean edge length.
pub(crate) fn offered(mean_edge: f64) -> Vec<OfferedOperation> {
    let default = |size: &Size| match size.of {
        SizeOf::Length => rounded(size.default * mean_edge, 2),
        SizeOf::Count | SizeOf::Degrees => size.default,
    };
    let offered = |operation: &MeshOperation| OfferedOperation {
        operation: *operation,
        defaults: operation.sizes.iter().map(default).collect(),
    };
    MESH_OPERATIONS.iter().map(offered).collect()
}

/// The size of the mesh after refining.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Refinement {
    /// `#V`
    pub vertices: usize,
    /// `#F`
    pub faces: usize,
    /// Approximate mean edge length, in the unit of the mesh.
    pub edge: f64,
}

/// Preview of an operation on the mesh.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct RemeshingPreview {
    /// `#V` before and after.
    pub vertices: [usize; 2],
    /// `#F` before and after.
    pub faces: [usize; 2],
    /// Number of triangles, quads and larger faces after the operation.
    pub corners: [usize; 3],
    /// A sentence for each item that cannot be carried over.
    pub lost: Vec<String>,
}

impl RemeshingPreview {
    /// Compares the meshes before and after the operation.
    pub(crate) fn of(meshes: [&Mesh; 2], lost: &[String]) -> RemeshingPreview {
        let mut corners = [0; 3];
        for face in meshes[1].faces.iter() {
            corners[face.len().clamp(3, 5) - 3] += 1;
        }
        RemeshingPreview {
            vertices: meshes.map(|mesh| mesh.positions.len()),
            faces: meshes.map(|mesh| mesh.faces.len()),
            corners,
            lost: lost.to_vec(),
        }
    }
}
