//! The sides of all faces, grouped by edge.

use super::Mesh;
use crate::math::{argsort, key_of_pair, polygon_sides};

/// A side of a face.
#[derive(Clone, Copy)]
pub(super) struct HalfEdge {
    /// Lower vertex first.
    pub(super) ends: [u32; 2],
    pub(super) face: u32,
    /// Whether the face traverses the edge from the lower to the higher vertex.
    pub(super) ascending: bool,
}

/// Returns the half-edges of all faces, grouped by edge and sorted by face within each group.
pub(super) fn half_edges(mesh: &Mesh) -> Vec<HalfEdge> {
    let mut sides: Vec<HalfEdge> = Vec::with_capacity(mesh.faces.indices().len());
    for (face, corners) in mesh.faces.iter().enumerate() {
        for [from, to] in polygon_sides(corners) {
            let ends = [from.min(to), from.max(to)];
            sides.push(HalfEdge { ends, face: face as u32, ascending: from < to });
        }
    }
    let order = argsort(sides.iter().map(|side| key_of_pair(side.ends)));
    order.into_iter().map(|side| sides[side as usize]).collect()
}
