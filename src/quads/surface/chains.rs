//! Feature edges in chains, and their tangents over the length of a panel.
//!
//! The direction of one edge of a zigzag boundary says nothing; that of chords over half a panel
//! does. A chain ends where it branches, and has corners, which its tangents do not round off.

use super::edges::Edges;
use crate::math::{Vec3, angle_between};
use crate::mesh::Polyline;

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
    line: Polyline,
}

/// The feature chains of a surface.
pub(super) struct Chains(Vec<Chain>);

impl Chains {
    /// Follows the feature edges, `is_feature` of each edge.
    pub(super) fn new(positions: &[Vec3<f64>], edges: &Edges, is_feature: &[bool]) -> Chains {
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
            let closed = v == first && at_vertex[v].len() == 2;
            let line = Polyline::new(vertices.iter().map(|&v| positions[v].into()), closed);
            Chain { vertices, edges: chain, closed, line }
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
        Chains(chains)
    }

    /// Sets the tangent of each feature edge, from its lower to its higher vertex, `#E`. `size` is the
    /// side of a panel.
    pub(super) fn tangents(&self, edges: &Edges, size: f64, tangents: &mut [Vec3<f64>]) {
        for chain in &self.0 {
            let reach = (REACH * size).min(0.25 * chain.total());
            let own = chain.corners(reach);
            for (k, &e) in chain.edges.iter().enumerate() {
                let middle = 0.5 * (chain.line.length_to(k) + chain.line.length_to(k + 1));
                let [from, to] = chain.clip(middle, reach, &own);
                let tangent = chain.at(to) - chain.at(from);
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
        for (c, chain) in self.0.iter().enumerate().filter(|(_, chain)| !chain.closed) {
            for at_end in [false, true] {
                let reach = (REACH * size).min(chain.total());
                let (from, to) =
                    if at_end { (chain.total(), chain.total() - reach) } else { (0.0, reach) };
                let (_, direction) = (chain.at(to) - chain.at(from)).length_and_direction();
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
                let chain = &self.0[c];
                if !is_crease(chain.edges[0])
                    || !others.clone().any(|other| direction.dot(other.3) > TOO_CLOSE)
                {
                    continue;
                }
                for (k, &e) in chain.edges.iter().enumerate() {
                    let to = match at_end {
                        true => chain.total() - chain.line.length_to(k + 1),
                        false => chain.line.length_to(k),
                    };
                    if to <= size {
                        dropped.push(e);
                    }
                }
            }
        }
        dropped
    }

    /// The length and the vertices of each chain; a closed one lists its first vertex once.
    pub(super) fn all(&self) -> impl Iterator<Item = (f64, &[usize])> {
        self.0.iter().map(|chain| {
            let last = chain.vertices.len() - usize::from(chain.closed);
            (chain.total(), &chain.vertices[..last])
        })
    }
}

impl Chain {
    fn total(&self) -> f64 {
        self.line.length_to(self.edges.len())
    }

    /// The position at a length along the chain.
    fn at(&self, along: f64) -> Vec3<f64> {
        self.line.point(along).into()
    }

    /// The corners of a chain, as indices of its vertices, ascending: the strongest first, none
    /// closer than `reach` to another.
    fn corners(&self, reach: f64) -> Vec<usize> {
        let first = usize::from(!self.closed);
        let mut candidates: Vec<(f64, usize)> = (first..self.edges.len())
            .filter_map(|k| {
                let along = self.line.length_to(k);
                let here = self.at(along);
                let before = here - self.at(along - reach);
                let after = self.at(along + reach) - here;
                let turn = angle_between(before, after)?;
                (turn > CORNER).then_some((turn, k))
            })
            .collect();
        candidates.sort_unstable_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        let mut corners: Vec<usize> = Vec::new();
        for (_, k) in candidates {
            let apart = |&other: &usize| {
                let distance = (self.line.length_to(k) - self.line.length_to(other)).abs();
                let around = if self.closed { self.total() - distance } else { f64::INFINITY };
                distance.min(around) > reach
            };
            if corners.iter().all(apart) {
                corners.push(k);
            }
        }
        corners.sort_unstable();
        corners
    }

    /// The part of a chain within `reach` of the middle of an edge, up to corners and ends.
    fn clip(&self, middle: f64, reach: f64, corners: &[usize]) -> [f64; 2] {
        let (mut from, mut to) = (middle - reach, middle + reach);
        if !self.closed {
            (from, to) = (from.max(0.0), to.min(self.total()));
        }
        for &k in corners {
            let mut back = middle - self.line.length_to(k);
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
