//! One of the four directions of each cross, chosen so that they agree from triangle to triangle
//! along a spanning tree, and the indices of vertices.

use super::frames::{Complex, Frames, argument};
use crate::math::angle_between;
use crate::quads::{Side, Triangulation};
use std::collections::VecDeque;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A combed field.
pub(crate) struct Combed {
    /// The angle of the first direction in each triangle, in radians.
    pub angles: Vec<f64>,
    /// `#T by 3`: by how many quarter turns the direction of the neighbour is ahead of that of the
    /// triangle, 0 to 3.
    pub jumps: Vec<[u8; 3]>,
    /// `#T by 3`: whether the tree crosses the side.
    pub tree: Vec<[bool; 3]>,
    /// `#V`: the index of an inner vertex in quarters, 1 where three quads meet; 0 on the boundary.
    pub indices: Vec<i32>,
}

impl Combed {
    /// Combs a field, in breadth first from the first triangle.
    pub(crate) fn new(surface: &Triangulation, frames: &Frames, crosses: &[Complex]) -> Combed {
        let n = surface.triangles.len();
        let mut angles: Vec<f64> = crosses.iter().map(|&u| 0.25 * argument(u)).collect();
        let mut tree = vec![[false; 3]; n];
        let mut seen = vec![false; n];
        seen[0] = true;
        let mut queue = VecDeque::from([0]);
        while let Some(triangle) = queue.pop_front() {
            for side in (0..3).map(|side| Side { triangle, side }) {
                let Some(back) = surface.across(side) else { continue };
                if std::mem::replace(&mut seen[back.triangle], true) {
                    continue;
                }
                let (quarters, _) = jump(frames, &angles, side, back);
                angles[back.triangle] -= f64::from(quarters) * FRAC_PI_2;
                tree[side.triangle][side.side] = true;
                tree[back.triangle][back.side] = true;
                queue.push_back(back.triangle);
            }
        }
        let mut jumps = vec![[0; 3]; n];
        let mut turns = vec![[0.0; 3]; n];
        for side in surface.sides() {
            let Some(back) = surface.across(side).filter(|&back| side < back) else { continue };
            let (quarters, rest) = jump(frames, &angles, side, back);
            jumps[side.triangle][side.side] = quarters.rem_euclid(4) as u8;
            jumps[back.triangle][back.side] = (-quarters).rem_euclid(4) as u8;
            turns[side.triangle][side.side] = rest;
            turns[back.triangle][back.side] = -rest;
        }
        Combed { angles, jumps, tree, indices: indices(surface, &turns) }
    }
}

/// The number of quarter turns nearest to the turn of the field over a side, and the rest of it.
fn jump(frames: &Frames, angles: &[f64], side: Side, back: Side) -> (i32, f64) {
    let turn = angles[back.triangle] - angles[side.triangle]
        + frames.angles[side.triangle][side.side]
        - frames.angles[back.triangle][back.side]
        - PI;
    let quarters = (turn / FRAC_PI_2 + 0.5).floor();
    (quarters as i32, turn - quarters * FRAC_PI_2)
}

/// The index of each inner vertex: the turn of the field around it, less that of the frames.
fn indices(surface: &Triangulation, turns: &[[f64; 3]]) -> Vec<i32> {
    let mut defect = vec![TAU; surface.positions.len()];
    for Side { triangle, side } in surface.sides() {
        let ahead = surface.along(Side { triangle, side });
        let back = surface.at(triangle, side + 2) - surface.at(triangle, side);
        let vertex = surface.corner(triangle, side);
        defect[vertex] -= angle_between(ahead, back).unwrap_or(0.0);
        // Counterclockwise around the vertex the neighbour comes before.
        defect[vertex] -= turns[triangle][side];
    }
    let on_boundary = surface.boundary_vertices();
    let quarters = |(defect, boundary): (f64, bool)| {
        if boundary { 0 } else { (defect / FRAC_PI_2 + 0.5).floor() as i32 }
    };
    defect.into_iter().zip(on_boundary).map(quarters).collect()
}
