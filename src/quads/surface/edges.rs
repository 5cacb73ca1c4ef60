//! The edges of a list of triangles, and which triangles are neighbours.

use crate::math::{argsort, key_of_pair};
use crate::quads::Side;

/// Edges of triangles, numbered in lexicographic order of their ends.
pub(crate) struct Edges {
    /// `#E by 2`: the ends, the lower first.
    pub ends: Vec<[usize; 2]>,
    /// `#T by 3`: the edge of each side.
    pub of_side: Vec<[usize; 3]>,
    /// The sides of each edge, in order of triangles.
    pub sides: Vec<Vec<Side>>,
}

impl Edges {
    /// Finds the edges.
    pub(crate) fn new(triangles: &[[usize; 3]]) -> Edges {
        let ends_of = |k: usize| {
            let [a, b] = [triangles[k / 3][k % 3], triangles[k / 3][(k + 1) % 3]];
            [a.min(b), a.max(b)]
        };
        let key = |k: usize| key_of_pair(ends_of(k).map(|v| v as u32));
        let order = argsort((0..3 * triangles.len()).map(key));
        let mut edges =
            Edges { ends: Vec::new(), of_side: vec![[0; 3]; triangles.len()], sides: Vec::new() };
        for k in order.into_iter().map(|k| k as usize) {
            if edges.ends.last() != Some(&ends_of(k)) {
                edges.ends.push(ends_of(k));
                edges.sides.push(Vec::with_capacity(2));
            }
            let last = edges.ends.len() - 1;
            edges.of_side[k / 3][k % 3] = last;
            edges.sides[last].push(Side { triangle: k / 3, side: k % 3 });
        }
        edges
    }

    /// The neighbours over each side, `#T by 3`, of triangles of which at most two share an edge.
    pub(crate) fn neighbours(&self) -> Vec<[Option<Side>; 3]> {
        let mut neighbours = vec![[None; 3]; self.of_side.len()];
        for sides in &self.sides {
            if let &[a, b] = sides.as_slice() {
                neighbours[a.triangle][a.side] = Some(b);
                neighbours[b.triangle][b.side] = Some(a);
            }
        }
        neighbours
    }
}
