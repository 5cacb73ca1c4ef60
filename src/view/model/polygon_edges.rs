//! The edges of polygons, each once, with boundary flags.

use super::lists::Lists;
use crate::math::polygon_sides;

/// A side of one or more faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PolygonEdge {
    /// The two vertices, the smaller index first.
    pub ends: [u32; 2],
    /// Whether only one face has this side.
    pub boundary: bool,
}

/// Returns every edge of `faces` once, sorted by vertices, without sides of zero length.
pub fn polygon_edges(faces: &Lists) -> Vec<PolygonEdge> {
    sides_by_edge(faces)
        .chunk_by(|a, b| a.0 == b.0)
        .map(|same| PolygonEdge { ends: same[0].0, boundary: same.len() == 1 })
        .collect()
}

/// Returns every side of every face, the smaller vertex first, with its face. Sides of the same
/// edge are adjacent, edges in the order of [`polygon_edges`].
pub fn sides_by_edge(faces: &Lists) -> Vec<([u32; 2], u32)> {
    let mut sides = Vec::new();
    for (index, face) in (0..).zip(faces.iter()) {
        let own = undirected_sides(face).filter(|[a, b]| a != b);
        sides.extend(own.map(|ends| (ends, index)));
    }
    sides.sort_unstable();
    sides
}

/// Returns the sides of a face, each with the smaller vertex first.
pub fn undirected_sides(corners: &[u32]) -> impl Iterator<Item = [u32; 2]> + '_ {
    polygon_sides(corners).map(|[a, b]| [a.min(b), a.max(b)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shared_sides_come_once_and_the_rim_is_marked() {
        let faces = Lists::new("faces", vec![0, 4, 7], vec![0, 1, 4, 3, 1, 2, 4], 5).unwrap();
        let edges = polygon_edges(&faces);
        assert_eq!(edges.len(), 6);
        let inner: Vec<_> = edges.iter().filter(|e| !e.boundary).collect();
        assert_eq!(inner.len(), 1);
        assert_eq!(inner[0].ends, [1, 4]);
    }
}
