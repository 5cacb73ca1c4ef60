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

/// Numbers the classes of corners that are joined over sides, which are those of one vertex that triangles
/// around it connect: `#T by 3`, from 0 in the order of their first corners.
pub(in crate::quads) fn corner_classes(neighbours: &[[Option<Side>; 3]]) -> Vec<[u32; 3]> {
    const NONE: u32 = u32::MAX;
    let mut classes = vec![[NONE; 3]; neighbours.len()];
    let mut count = 0;
    for first in 0..3 * neighbours.len() {
        if classes[first / 3][first % 3] != NONE {
            continue;
        }
        let mut queue = vec![(first / 3, first % 3)];
        while let Some((t, k)) = queue.pop() {
            classes[t][k] = count;
            // Over the side that starts here and the one that ends here.
            let ahead = neighbours[t][k].map(|next| (next.triangle, (next.side + 1) % 3));
            let behind = neighbours[t][(k + 2) % 3].map(|next| (next.triangle, next.side));
            let around = [ahead, behind].into_iter().flatten();
            queue.extend(around.filter(|&(u, l)| classes[u][l] == NONE));
        }
        count += 1;
    }
    classes
}
