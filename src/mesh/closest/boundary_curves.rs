//! The boundary of the rest shape as curves on which vertices glide, and its corners (boundary
//! preservation, paper section 4).

use crate::math::Vec3;
use crate::mesh::{Mesh, Point, Ragged, Surface, Topology};

/// The boundary loops of a mesh as curves, and their corners. Each boundary vertex is either a
/// corner or on exactly one curve.
#[derive(Clone, Debug)]
pub struct BoundaryCurves {
    /// One curve per loop of [`Topology::boundary_loops`].
    pub curves: Vec<BoundaryCurve>,
    /// The corners, ascending.
    pub corners: Vec<u32>,
}

/// One boundary loop.
#[derive(Clone, Debug)]
pub struct BoundaryCurve {
    /// The loop as a polyline, including the corners.
    pub curve: Surface,
    /// The vertices along the loop, without the corners.
    pub vertices: Vec<u32>,
    /// The pieces between corners, in order.
    pub pieces: Vec<BoundaryPiece>,
}

/// A part of a boundary loop from corner to corner, or the whole loop if it has no corner.
#[derive(Clone, Debug)]
pub struct BoundaryPiece {
    /// The vertices including both ends; a closed piece repeats its first vertex at the end.
    pub vertices: Vec<u32>,
    /// Whether the piece is a loop without a corner.
    pub closed: bool,
}

impl BoundaryCurves {
    /// Extracts the boundary of a mesh with its vertices at `positions` (`#V by 3`).
    ///
    /// A vertex is a corner if the boundary turns there by more than the angle with the cosine
    /// `corner_cosine`, if it is on several loops, or if it is an end of a loop that is not closed.
    /// Edges of zero length are skipped in measuring the turn.
    pub fn new(positions: &[Point], topology: &Topology, corner_cosine: f64) -> BoundaryCurves {
        let loops = topology.boundary_loops();
        let mut on_loops = vec![0_u32; positions.len()];
        loops.indices().iter().for_each(|&v| on_loops[v as usize] += 1);
        let mut is_corner: Vec<bool> = on_loops.iter().map(|&count| count > 1).collect();
        for one in loops.iter() {
            for (k, &v) in one.iter().enumerate() {
                is_corner[v as usize] |= turn_cosine(one, k, positions) < corner_cosine;
            }
            if !topology.is_closed_loop(one) {
                is_corner[one[0] as usize] = true;
                is_corner[one[one.len() - 1] as usize] = true;
            }
        }
        let curves = loops.iter().map(|one| {
            let mut polyline = one.to_vec();
            if topology.is_closed_loop(one) {
                polyline.push(one[0]);
            }
            let curve = Mesh { curves: Ragged::from_iter([polyline]), ..Mesh::default() };
            BoundaryCurve {
                curve: Surface::for_iterations(positions, &curve),
                pieces: pieces(one, topology.is_closed_loop(one), &is_corner),
                vertices: one.iter().copied().filter(|&v| !is_corner[v as usize]).collect(),
            }
        });
        let curves = curves.collect();
        let corners = (0..).zip(&is_corner).filter(|(_, corner)| **corner).map(|(v, _)| v);
        BoundaryCurves { curves, corners: corners.collect() }
    }
}

/// Splits a loop at its corners.
fn pieces(one: &[u32], closed: bool, is_corner: &[bool]) -> Vec<BoundaryPiece> {
    let n = one.len();
    let corners: Vec<usize> = (0..n).filter(|&k| is_corner[one[k] as usize]).collect();
    let part = |from: usize, to: usize, closed: bool| BoundaryPiece {
        vertices: (from..=to).map(|k| one[k % n]).collect(),
        closed,
    };
    let Some(&first) = corners.first() else { return vec![part(0, n, true)] };
    let mut ends = corners;
    if closed {
        ends.push(first + n);
    }
    ends.windows(2).map(|ends| part(ends[0], ends[1], false)).collect()
}

/// Returns the cosine of the turning angle of a loop at its vertex `k`; 1 if all its vertices
/// coincide.
fn turn_cosine(one: &[u32], k: usize, positions: &[Point]) -> f64 {
    let n = one.len();
    let at = |k: usize| Vec3::from(positions[one[k % n] as usize]);
    let here = at(k);
    let first_away = |step: usize| {
        let away = (1..n).map(|i| at(k + i * step) - here);
        away.into_iter().find(|edge| edge.length() > 0.0)
    };
    match (first_away(n - 1), first_away(1)) {
        (Some(back), Some(on)) => -back.dot(on) / (back.length() * on.length()),
        _ => 1.0,
    }
}
