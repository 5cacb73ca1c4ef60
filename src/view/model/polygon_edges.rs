//! The edges of polygons, each once, with the mark that only one face uses it.

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

/// Every edge of `faces` once, in the order of its vertices. Sides that start and end at the same
/// vertex are left out.
pub fn polygon_edges(faces: &Lists) -> Vec<PolygonEdge> {
    let mut sides: Vec<[u32; 2]> = Vec::new();
    for face in faces.iter() {
        for [from, to] in polygon_sides(face) {
            if from != to {
                sides.push([from.min(to), from.max(to)]);
            }
        }
    }
    sides.sort_unstable();
    sides
        .chunk_by(|a, b| a == b)
        .map(|same| PolygonEdge { ends: same[0], boundary: same.len() == 1 })
        .collect()
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
