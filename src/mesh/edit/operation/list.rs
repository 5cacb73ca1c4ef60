//! The list of operations.

use super::declaration::{MeshOperation, OperationError, Picks};
use super::{
    diagonal, dual, extrude, faces, holes, orientation, strips, triangle_pairs, triangles, vertices,
};
use crate::mesh::edit::size::{Size, SizeOf};
use crate::mesh::edit::subdivide::KEPT_TURN;

/// Every operation, in the order in which hosts list them.
pub const MESH_OPERATIONS: &[MeshOperation] = &[
    MeshOperation {
        id: "quads",
        label: "Triangles to quads",
        summary: "Pairs triangles whose union is nearest to a flat rectangle; the others stay.",
        picks: Picks::Nothing,
        sizes: &[Size {
            id: "corner",
            label: "Largest corner of a quad",
            of: SizeOf::Degrees,
            default: 160.0,
            least: 90.0,
            most: 180.0,
        }],
        apply: triangle_pairs::apply,
    },
    MeshOperation {
        id: "dual",
        label: "Dual",
        summary: "A face for each vertex, with its corners in the middles of the faces: hexagons from triangles. The outline keeps its corners.",
        picks: Picks::Nothing,
        sizes: &[Size {
            id: "keep",
            label: "Keep corners that turn by more than",
            of: SizeOf::Degrees,
            default: KEPT_TURN,
            least: 0.0,
            most: 180.0,
        }],
        apply: dual::apply,
    },
    MeshOperation {
        id: "diagonal",
        label: "Diagonal quads",
        summary: "A quad for each edge, between its ends and the middles of its faces; triangles along the boundary.",
        picks: Picks::Nothing,
        sizes: &[],
        apply: diagonal::apply,
    },
    MeshOperation {
        id: "triangles",
        label: "Faces to triangles",
        summary: "Cuts quads along the shorter diagonal, and larger faces from a new vertex in their middle.",
        picks: Picks::Nothing,
        sizes: &[],
        apply: triangles::apply,
    },
    MeshOperation {
        id: "insert-strip",
        label: "Insert a strip",
        summary: "Cuts in two all quads of the strip across the selected edge: select its two ends.",
        picks: Picks::Vertices,
        sizes: &[],
        apply: strips::insert,
    },
    MeshOperation {
        id: "remove-strip",
        label: "Remove a strip",
        summary: "Closes the strip of quads across the selected edge: select its two ends.",
        picks: Picks::Vertices,
        sizes: &[],
        apply: strips::remove,
    },
    MeshOperation {
        id: "extrude",
        label: "Extrude the boundary",
        summary: "A row of quads along the boundary, or along what is selected of it: outward as the surface runs, and up or down.",
        picks: Picks::AnyVertices,
        sizes: &[
            Size {
                id: "outward",
                label: "Outward",
                of: SizeOf::Length,
                default: 1.0,
                least: 0.0,
                most: 1e6,
            },
            Size {
                id: "up",
                label: "Up",
                of: SizeOf::Length,
                default: 0.0,
                least: -1e6,
                most: 1e6,
            },
        ],
        apply: extrude::apply,
    },
    MeshOperation {
        id: "fill",
        label: "Fill holes",
        summary: "Closes every boundary but the longest with a face, or those that have a selected vertex.",
        picks: Picks::AnyVertices,
        sizes: &[],
        apply: holes::apply,
    },
    MeshOperation {
        id: "delete",
        label: "Delete faces",
        summary: "Takes the selected faces away, with the vertices that only they have.",
        picks: Picks::Faces,
        sizes: &[],
        apply: faces::delete,
    },
    MeshOperation {
        id: "merge-faces",
        label: "Merge faces",
        summary: "Makes one face of selected faces that lie side by side.",
        picks: Picks::Faces,
        sizes: &[],
        apply: faces::merge,
    },
    MeshOperation {
        id: "split-face",
        label: "Split a face",
        summary: "Cuts a face between two selected corners of it.",
        picks: Picks::Vertices,
        sizes: &[],
        apply: faces::split,
    },
    MeshOperation {
        id: "weld",
        label: "Weld",
        summary: "Makes one vertex of those that are nearer to each other than a distance.",
        picks: Picks::AnyVertices,
        sizes: &[Size {
            id: "distance",
            label: "Distance",
            of: SizeOf::Length,
            default: 0.01,
            least: 1e-12,
            most: 1e6,
        }],
        apply: vertices::weld,
    },
    MeshOperation {
        id: "merge-vertices",
        label: "Merge vertices",
        summary: "Makes one vertex of the selected ones, in their middle.",
        picks: Picks::Vertices,
        sizes: &[],
        apply: vertices::merge,
    },
    MeshOperation {
        id: "snap",
        label: "Snap to a grid",
        summary: "Rounds the coordinates of all vertices, or of the selected ones, to multiples of a length.",
        picks: Picks::AnyVertices,
        sizes: &[Size {
            id: "step",
            label: "Length",
            of: SizeOf::Length,
            default: 0.1,
            least: 1e-12,
            most: 1e6,
        }],
        apply: vertices::snap,
    },
    MeshOperation {
        id: "unify",
        label: "Unify orientation",
        summary: "Turns over as few faces as are needed for neighbours to face the same side.",
        picks: Picks::Nothing,
        sizes: &[],
        apply: orientation::unify,
    },
    MeshOperation {
        id: "flip",
        label: "Flip faces",
        summary: "Turns all faces over: front becomes back.",
        picks: Picks::Nothing,
        sizes: &[],
        apply: orientation::flip,
    },
];

impl MeshOperation {
    /// Returns the operation with this id.
    ///
    /// # Errors
    /// If there is none.
    pub fn of(id: &str) -> Result<&'static MeshOperation, OperationError> {
        let found = MESH_OPERATIONS.iter().find(|operation| operation.id == id);
        found.ok_or_else(|| OperationError::Unknown(id.to_owned()))
    }
}
