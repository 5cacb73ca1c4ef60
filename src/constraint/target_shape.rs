//! The role of the vertices of a place in the mesh, as far as it decides which kind is usually wanted
//! there.

/// The role of the vertices of a place in the mesh. A kind names those that it is the usual choice for
/// in [`Projection::USUAL_FOR`](super::Projection::USUAL_FOR); hosts choose it beforehand there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TargetShape {
    /// Faces of four or more corners, each for itself.
    Panels,
    /// Triangles, each for itself.
    Triangles,
    /// Edges, each for itself.
    Edges,
    /// Closed loops of edges.
    Loop,
    /// Open chains of edges.
    Chain,
    /// Several faces together that are not the whole mesh.
    Patch,
    /// Several vertices that no edges join to one of the above.
    Points,
}
