//! An operation on the mesh, and what it would make of it.

use crate::json::indices;
use crate::mesh::{MESH_OPERATIONS, Mesh, MeshOperation, Size, SizeOf};
use serde::{Deserialize, Serialize};

/// An operation on the mesh with what it is applied to: see [`crate::mesh::MeshOperation`].
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(deny_unknown_fields)]
pub struct Remeshing {
    /// The id of the operation.
    pub operation: String,
    /// Its sizes, in the order in which it declares them.
    #[serde(default)]
    pub sizes: Vec<f64>,
    /// The vertices that are picked.
    #[serde(default, deserialize_with = "indices::deserialize")]
    pub vertices: Vec<u32>,
    /// The faces that are picked.
    #[serde(default, deserialize_with = "indices::deserialize")]
    pub faces: Vec<u32>,
}

/// An operation with the sizes that it has where nobody says others.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct OfferedOperation {
    /// The operation.
    #[serde(flatten)]
    pub operation: MeshOperation,
    /// In the order of its sizes; lengths in the unit of the mesh, round.
    pub defaults: Vec<f64>,
}

/// All operations, on a mesh with edges of that mean length.
pub(crate) fn offered(mean_edge: f64) -> Vec<OfferedOperation> {
    let default = |size: &Size| match size.of {
        SizeOf::Length => two_digits(size.default * mean_edge),
        SizeOf::Count | SizeOf::Degrees => size.default,
    };
    let offered = |operation: &MeshOperation| OfferedOperation {
        operation: *operation,
        defaults: operation.sizes.iter().map(default).collect(),
    };
    MESH_OPERATIONS.iter().map(offered).collect()
}

fn two_digits(number: f64) -> f64 {
    format!("{number:.1e}").parse().unwrap_or(number)
}

/// What refining makes of the mesh.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Refinement {
    /// `#V`
    pub vertices: usize,
    /// `#F`
    pub faces: usize,
    /// About the mean length of an edge, in the unit of the mesh.
    pub edge: f64,
}

/// A preview of an operation on the mesh.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct RemeshingPreview {
    /// `#V` before and after.
    pub vertices: [usize; 2],
    /// `#F` before and after.
    pub faces: [usize; 2],
    /// How many of the faces are triangles, quads, and larger, after.
    pub corners: [usize; 3],
    /// A sentence for each thing that cannot be carried over.
    pub lost: Vec<String>,
}

impl RemeshingPreview {
    /// Of the meshes before and after it.
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
