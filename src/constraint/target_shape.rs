//! The shape of a selection, which determines the usual kind of constraint for it.

/// The shape of a selection. A kind lists those for which it is the usual choice in
/// [`Projection::DEFAULT_FOR`](super::Projection::DEFAULT_FOR); hosts preselect it there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TargetShape {
    /// Faces of four or more corners, one constraint each.
    Panels,
    /// Triangles, one constraint each.
    Triangles,
    /// Edges, one constraint each.
    Edges,
    /// Closed loops of edges.
    Loop,
    /// Open chains of edges.
    Chain,
    /// Several faces together, but not the whole mesh.
    Patch,
    /// Several vertices not joined by edges to one of the above.
    Points,
}
