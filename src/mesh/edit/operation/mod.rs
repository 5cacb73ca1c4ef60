//! The list of editing operations: each makes a new mesh and records the origins of its elements.

mod declaration;
mod dual;
mod extrude;
mod faces;
mod strips;
mod triangles;
mod vertices;

pub use declaration::{MeshOperation, OperationError, Picks, Task};

use crate::mesh::LARGEST_COORDINATE;
use crate::mesh::edit::size::Size;
use crate::mesh::edit::subdivide::KEPT_TURN;

/// Lengths are in any unit, so that their limits are those of coordinates.
const SHORTEST: f64 = 1.0 / LARGEST_COORDINATE;

/// Every operation, in the order in which hosts list them.
pub const MESH_OPERATIONS: &[MeshOperation] = &[
    MeshOperation {
        id: "quads",
        label: "Triangles to quads",
        summary: "Merges pairs of triangles whose union is closest to a flat rectangle; other triangles stay.",
        picks: Picks::Nothing,
        sizes: &[Size::degrees("corner", "Largest angle of a quad", 160.0, [90.0, 180.0])],
        apply: triangles::to_quads,
    },
    MeshOperation {
        id: "dual",
        label: "Dual",
        summary: "Makes a face for each vertex of the mesh, with corners at the centres of the old faces: triangles become hexagons. The outline keeps its corners.",
        picks: Picks::Nothing,
        sizes: &[Size::degrees(
            "keep",
            "Keep corners that turn by more than",
            KEPT_TURN,
            [0.0, 180.0],
        )],
        apply: dual::dual,
    },
    MeshOperation {
        id: "diagonal",
        label: "Diagonal quads",
        summary: "Makes a quad for each edge of the mesh, from its ends and the centres of its faces; triangles along the boundary.",
        picks: Picks::Nothing,
        sizes: &[],
        apply: dual::diagonal,
    },
    MeshOperation {
        id: "triangles",
        label: "Faces to triangles",
        summary: "Cuts all quads along the shorter diagonal, and all larger faces from a new vertex at their centre or, with a notch, along diagonals.",
        picks: Picks::Nothing,
        sizes: &[],
        apply: triangles::from_faces,
    },
    MeshOperation {
        id: "insert-strip",
        label: "Insert a strip",
        summary: "Halves all quads of the strip that crosses an edge. Select the two ends of the edge.",
        picks: Picks::Vertices,
        sizes: &[],
        apply: strips::insert,
    },
    MeshOperation {
        id: "remove-strip",
        label: "Remove a strip",
        summary: "Collapses the strip of quads that crosses an edge. Select the two ends of the edge.",
        picks: Picks::Vertices,
        sizes: &[],
        apply: strips::remove,
    },
    MeshOperation {
        id: "extrude",
        label: "Extrude the boundary",
        summary: "Adds a row of quads along the boundary or its selected part: outward, in the direction of the surface, and up or down.",
        picks: Picks::AnyVertices,
        sizes: &[
            Size::length("outward", "Outward", 1.0, [0.0, LARGEST_COORDINATE]),
            Size::length("up", "Up", 0.0, [-LARGEST_COORDINATE, LARGEST_COORDINATE]),
        ],
        apply: extrude::apply,
    },
    MeshOperation {
        id: "fill",
        label: "Fill holes",
        summary: "Closes every boundary of a piece but its longest with a face, or only those with a selected vertex.",
        picks: Picks::AnyVertices,
        sizes: &[],
        apply: faces::fill_holes,
    },
    MeshOperation {
        id: "delete",
        label: "Delete faces",
        summary: "Removes the selected faces, and the vertices that only they use.",
        picks: Picks::Faces,
        sizes: &[],
        apply: faces::delete,
    },
    MeshOperation {
        id: "merge-faces",
        label: "Merge faces",
        summary: "Merges neighbouring selected faces into one.",
        picks: Picks::Faces,
        sizes: &[],
        apply: faces::merge,
    },
    MeshOperation {
        id: "split-face",
        label: "Split a face",
        summary: "Cuts a face between two of its corners. Select both.",
        picks: Picks::Vertices,
        sizes: &[],
        apply: faces::split,
    },
    MeshOperation {
        id: "weld",
        label: "Weld",
        summary: "Merges vertices that are closer to each other than a distance.",
        picks: Picks::AnyVertices,
        sizes: &[Size::length("distance", "Distance", 0.01, [SHORTEST, LARGEST_COORDINATE])],
        apply: vertices::weld,
    },
    MeshOperation {
        id: "join",
        label: "Join seams",
        summary: "Merges boundary vertices that lie on each other without being joined, as between two patches. A seam that has opened since is closed.",
        picks: Picks::Nothing,
        sizes: &[],
        apply: vertices::join,
    },
    MeshOperation {
        id: "merge-vertices",
        label: "Merge vertices",
        summary: "Merges the selected vertices into one at their centre.",
        picks: Picks::Vertices,
        sizes: &[],
        apply: vertices::merge,
    },
    MeshOperation {
        id: "snap",
        label: "Snap to a grid",
        summary: "Rounds the coordinates of all vertices, or of the selected ones, to multiples of a length.",
        picks: Picks::AnyVertices,
        sizes: &[Size::length("step", "Length", 0.1, [SHORTEST, LARGEST_COORDINATE])],
        apply: vertices::snap,
    },
    MeshOperation {
        id: "unify",
        label: "Unify orientation",
        summary: "Flips as few faces as possible so that all have the same orientation.",
        picks: Picks::Nothing,
        sizes: &[],
        apply: faces::unify,
    },
    MeshOperation {
        id: "flip",
        label: "Flip faces",
        summary: "Flips all faces: front becomes back.",
        picks: Picks::Nothing,
        sizes: &[],
        apply: faces::flip,
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
