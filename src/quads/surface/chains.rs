//! Feature edges in chains, and their tangents over the length of a panel.
//!
//! The direction of one edge of a zigzag boundary says nothing; that of chords over half a panel
//! does. A chain ends where it branches, and has corners, which its tangents do not round off.

use super::edges::Edges;
use crate::math::{Vec3, angle_between};

/// Half the length of a chord, in panels; at most a quarter of the chain.
const REACH: f64 = 0.5;
/// Turn of chords at a corner, in radians.
const CORNER: f64 = std::f64::consts::FRAC_PI_4;
/// Cosine of the angle to another chain below which the end of a crease is dropped.
const TOO_CLOSE: f64 = 0.5;

/// A run of feature edges between branches, or a closed loop, which repeats its first vertex.
struct Chain {
    vertices: Vec<usize>,
    edges: Vec<usize>,
    closed: bool,
    /// Length up to each vertex.
    length: Vec<f64>,
}

/// The feature chains of a surface.
pub(super) struct Chains<'a> {
    positions: &'a [Vec3<f64>],
    chains: Vec<Chain>,
}

impl<'a> Chains<'a> {
    /// Follows the feature edges, `is_feature` of each edge.
    pub(super) fn new(
        positions: &'a [Vec3<f64>],
        edges: &Edges,
        is_feature: &[bool],
    ) -> Chains<'a> {
        let mut at_vertex: Vec<Vec<usize>> = vec![Vec::new(); positions.len()];
        for e in (0..is_feature.len()).filter(|&e| is_feature[e]) {
            edges.ends[e].iter().for_each(|&v| at_vertex[v].push(e));
        }
        let mut used = vec![false; is_feature.len()];
        let follow = |first: usize, edge: usize, used: &mut Vec<bool>| {
            let (mut vertices, mut chain) = (vec![first], Vec::new());
            let (mut v, mut e) = (first, edge);
            loop {
                used[e] = true;
                chain.push(e);
                let [a, b] = edges.ends[e];
                v = if a == v { b } else { a };
                vertices.push(v);
                if v == first || at_vertex[v].len() != 2 {
                    break;
                }
                e = if at_vertex[v][0] == e { at_vertex[v][1] } else { at_vertex[v][0] };
            }
            let mut length = vec![0.0];
            for ends in vertices.windows(2) {
                let before = length[length.len() - 1];
                length.push(before + (positions[ends[1]] - positions[ends[0]]).length());
            }
            let closed = v == first && at_vertex[v].len() == 2;
            Chain { vertices, edges: chain, closed, length }
        };
        let mut chains = Vec::new();
        for v in 0..positions.len() {
            for &e in at_vertex[v].iter().filter(|_| at_vertex[v].len() != 2) {
                if !used[e] {
                    chains.push(follow(v, e, &mut used));
                }
            }
        }
        for e in 0..is_feature.len() {
            if is_feature[e] && !used[e] {
                chains.push(follow(edges.ends[e][0], e, &mut used));
            }
        }
        Chains { positions, chains }
    }

    /// Sets the tangent of each feature edge, from its lower to its higher vertex, `#E`. `size` is the
    /// side of a panel.
    pub(super) fn tangents(&self, edges: &Edges, size: f64, tangents: &mut [Vec3<f64>]) {
        for chain in &self.chains {
            let reach = (REACH * size).min(0.25 * chain.total());
            let own = self.corners(chain, reach);
            for (k, &e) in chain.edges.iter().enumerate() {
                let middle = 0.5 * (chain.length[k] + chain.length[k + 1]);
                let [from, to] = chain.clip(middle, reach, &own);
                let tangent = self.at(chain, to) - self.at(chain, from);
                let ascends = chain.vertices[k] == edges.ends[e][0];
                tangents[e] = if ascends { tangent } else { -tangent };
            }
        }
    }

    /// Returns the edges of creases that meet another chain at an acute angle, within the length
    /// `size` of it. `is_crease` tells those off the boundary.
    pub(super) fn too_close(&self, size: f64, is_crease: impl Fn(usize) -> bool) -> Vec<usize> {
        // Both ends of each open chain: vertex, chain, whether at its end, direction.
        let mut ends = Vec::new();
        for (c, chain) in self.chains.iter().enumerate().filter(|(_, chain)| !chain.closed) {
            for at_end in [false, true] {
                let reach = (REACH * size).min(chain.total());
                let (from, to) =
                    if at_end { (chain.total(), chain.total() - reach) } else { (0.0, reach) };
                let (_, direction) =
                    (self.at(chain, to) - self.at(chain, from)).length_and_direction();
                let vertex = chain.vertices[if at_end { chain.edges.len() } else { 0 }];
                if let Some(direction) = direction {
                    ends.push((vertex, c, at_end, direction));
                }
            }
        }
        ends.sort_by_key(|&(vertex, c, at_end, _)| (vertex, c, at_end));
        let mut dropped = Vec::new();
        for same in ends.chunk_by(|a, b| a.0 == b.0) {
            for &(_, c, at_end, direction) in same {
                let others = same.iter().filter(|other| (other.1, other.2) != (c, at_end));
                let chain = &self.chains[c];
                if !is_crease(chain.edges[0])
                    || !others.clone().any(|other| direction.dot(other.3) > TOO_CLOSE)
                {
                    continue;
                }
                for (k, &e) in chain.edges.iter().enumerate() {
                    let to =
                        if at_end { chain.total() - chain.length[k + 1] } else { chain.length[k] };
                    if to <= size {
                        dropped.push(e);
                    }
                }
            }
        }
        dropped
    }

    /// The length and the vertices of each chain; of a closed one the first vertex is once there.
    pub(super) fn all(&self) -> impl Iterator<Item = (f64, &[usize])> {
        self.chains.iter().map(|chain| {
            let last = chain.vertices.len() - usize::from(chain.closed);
            (chain.total(), &chain.vertices[..last])
        })
    }

    /// The position at a length along a chain.
    fn at(&self, chain: &Chain, along: f64) -> Vec3<f64> {
        let total = chain.total();
        let along = if chain.closed { along - total * (along / total).floor() } else { along };
        let along = along.clamp(0.0, total);
        let k = chain.length.partition_point(|&length| length <= along);
        let k = k.clamp(1, chain.edges.len()) - 1;
        let step = chain.length[k + 1] - chain.length[k];
        let t = if step > 0.0 { (along - chain.length[k]) / step } else { 0.0 };
        let [a, b] = [chain.vertices[k], chain.vertices[k + 1]].map(|v| self.positions[v]);
        a * (1.0 - t) + b * t
    }

    /// The corners of a chain, as indices of its vertices, ascending: the strongest first, none
    /// closer than `reach` to another.
    fn corners(&self, chain: &Chain, reach: f64) -> Vec<usize> {
        let first = usize::from(!chain.closed);
        let mut candidates: Vec<(f64, usize)> = (first..chain.edges.len())
            .filter_map(|k| {
                let (along, here) = (chain.length[k], self.positions[chain.vertices[k]]);
                let before = here - self.at(chain, along - reach);
                let after = self.at(chain, along + reach) - here;
                let turn = angle_between(before, after)?;
                (turn > CORNER).then_some((turn, k))
            })
            .collect();
        candidates.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        let mut corners: Vec<usize> = Vec::new();
        for (_, k) in candidates {
            let apart = |&other: &usize| {
                let distance = (chain.length[k] - chain.length[other]).abs();
                let around = if chain.closed { chain.total() - distance } else { f64::INFINITY };
                distance.min(around) > reach
            };
            if corners.iter().all(apart) {
                corners.push(k);
            }
        }
        corners.sort_unstable();
        corners
    }
}

impl Chain {
    fn total(&self) -> f64 {
        self.length[self.length.len() - 1]
    }

    /// The part of a chain within `reach` of the middle of an edge, up to corners and ends.
    fn clip(&self, middle: f64, reach: f64, corners: &[usize]) -> [f64; 2] {
        let (mut from, mut to) = (middle - reach, middle + reach);
        if !self.closed {
            (from, to) = (from.max(0.0), to.min(self.total()));
        }
        for &k in corners {
            let mut back = middle - self.length[k];
            let mut ahead = -back;
            if self.closed {
                back -= self.total() * (back / self.total()).floor();
                ahead -= self.total() * (ahead / self.total()).floor();
            }
            if back > 0.0 && back < reach {
                from = from.max(middle - back);
            }
            if ahead > 0.0 && ahead < reach {
                to = to.min(middle + ahead);
            }
        }
        [from, to]
    }
}
