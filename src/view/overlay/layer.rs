//! A layer beside the surface, joined to it by posts at the vertices, and where it cannot be built.

use glam::DVec3;

/// A layer; nothing is drawn without points.
#[derive(Clone, Debug, Default)]
pub struct ShownLayer {
    /// #V in file coordinates, or empty.
    pub(in crate::view) points: Vec<DVec3>,
    /// Edges that fail, by their ends: drawn on the surface and in the layer, with their posts.
    pub(in crate::view) failed_edges: Vec<[u32; 2]>,
    pub(in crate::view) failed_vertices: Vec<u32>,
    /// Whether it has changed since the last picture.
    pub(in crate::view) changed: bool,
}
