//! The unknowns of a seamless map: u and v of each corner, of which those joined over a side are one,
//! shifts over the cut, and the equations between them (Bommes, Zimmer and Kobbelt 2009).

use super::elimination::{Elimination, Row};
use crate::math::sort_by_number;
use crate::quads::field::{Combed, Frames, argument};
use crate::quads::surface::{Prepared, corner_classes};
use crate::quads::{Side, Transition};
use std::f64::consts::FRAC_PI_2;

const NONE: u32 = u32::MAX;

/// Coordinates of corners as sums of free unknowns, some of them integers.
pub(crate) struct Seams {
    /// `#T by 3`: the class of each corner, whose u and v are the sums 2 c and 2 c + 1.
    pub classes: Vec<[u32; 3]>,
    /// Each coordinate as a sum of free unknowns. Coefficients are multiples of a quarter.
    pub sums: Vec<Row>,
    /// Whether a free unknown is an integer.
    pub is_integer: Vec<bool>,
    /// The cut sides, each from its first to its second triangle.
    pub cut: Vec<[Side; 2]>,
    /// The quarter turns from the first to the second triangle of each cut edge.
    pub quarter_turns: Vec<u8>,
    /// `#T by 3`: for feature sides the quarter turns from the first axis of the map to their
    /// direction.
    pub runs: Vec<[Option<u8>; 3]>,
    /// A pair of free unknowns that, given, takes the two translations away that leave the map as
    /// it is; fewer if nothing is free.
    pub pinned: Vec<u32>,
}

impl Seams {
    /// Sets up and eliminates the equations.
    pub(crate) fn new(
        prepared: &Prepared,
        frames: &Frames,
        combed: &Combed,
        cut: Vec<[Side; 2]>,
    ) -> Seams {
        let surface = &prepared.surface;
        let n = surface.triangles.len();
        let mut joined = surface.neighbours.clone();
        cut.iter().flatten().for_each(|side| joined[side.triangle][side.side] = None);
        let classes = corner_classes(&joined);
        let count = classes.iter().flatten().max().map_or(0, |&last| last as usize + 1);
        let coordinate = |triangle: usize, corner: usize, axis: usize| {
            2 * classes[triangle][corner % 3] + axis as u32
        };
        let mut is_integer = vec![false; 2 * count];
        // A feature runs along one axis; the other coordinate is the same integer along it.
        let mut runs = vec![[None; 3]; n];
        let aligned: Vec<(Side, usize)> = surface
            .sides()
            .filter(|&side| surface.is_feature(side))
            .map(|side| {
                let turn = argument(frames.tangent(prepared, side)) - combed.angles[side.triangle];
                let quarters = ((turn / FRAC_PI_2 + 0.5).floor() as i64).rem_euclid(4);
                runs[side.triangle][side.side] = Some(quarters as u8);
                (side, if quarters % 2 == 0 { 1 } else { 0 })
            })
            .collect();
        for &(Side { triangle, side }, axis) in &aligned {
            is_integer[coordinate(triangle, side, axis) as usize] = true;
            is_integer[coordinate(triangle, side + 1, axis) as usize] = true;
        }
        for (triangle, corners) in surface.triangles.iter().enumerate() {
            for (corner, &v) in corners.iter().enumerate() {
                if combed.indices[v] != 0 {
                    is_integer[coordinate(triangle, corner, 0) as usize] = true;
                    is_integer[coordinate(triangle, corner, 1) as usize] = true;
                }
            }
        }
        let first_shift = is_integer.len() as u32;
        is_integer.resize(is_integer.len() + 2 * cut.len(), true);
        let mut elimination = Elimination::new(is_integer);
        let mut quarter_turns = Vec::with_capacity(cut.len());
        for (e, &[side, back]) in cut.iter().enumerate() {
            let jump = combed.jumps[side.triangle][side.side];
            let turns = (4 - jump) % 4;
            quarter_turns.push(turns);
            for (near, far) in [(side.side, back.side + 1), (side.side + 1, back.side)] {
                for axis in 0..2 {
                    let (from, sign) = turned(turns, axis);
                    elimination.impose(&[
                        (coordinate(back.triangle, far, axis), 1.0),
                        (coordinate(side.triangle, near, from), -sign),
                        (first_shift + 2 * e as u32 + axis as u32, -1.0),
                    ]);
                }
            }
        }
        for &(Side { triangle, side }, axis) in &aligned {
            let ends = [side, side + 1].map(|corner| coordinate(triangle, corner, axis));
            elimination.impose(&[(ends[0], 1.0), (ends[1], -1.0)]);
        }
        let mut sums = Vec::with_capacity(2 * count);
        let mut number: Vec<u32> = Vec::new();
        let mut free: Vec<u32> = Vec::new();
        for c in 0..2 * count as u32 {
            let mut row = elimination.value(c);
            for (unknown, _) in &mut row {
                let v = *unknown as usize;
                if number.len() <= v {
                    number.resize(v + 1, NONE);
                }
                if number[v] == NONE {
                    number[v] = free.len() as u32;
                    free.push(*unknown);
                }
                *unknown = number[v];
            }
            sort_by_number(&mut row, |&(unknown, _)| unknown.into());
            sums.push(row);
        }
        // How the two translations of the plane move each free unknown: a coordinate, since
        // directions agree where the surface is not cut, or a shift `x_g - R x_f`.
        let of_free = |&v: &u32| -> [f64; 2] {
            let unit = |axis: usize| [f64::from(1 - axis as u32), f64::from(axis as u32)];
            if v < first_shift {
                return unit(v as usize % 2);
            }
            let (e, axis) = ((v - first_shift) as usize / 2, (v - first_shift) as usize % 2);
            let Some(&turns) = quarter_turns.get(e) else { return [f64::NAN; 2] };
            let (from, sign) = turned(turns, axis);
            [0, 1].map(|k| unit(axis)[k] - sign * unit(from)[k])
        };
        let moves: Vec<[f64; 2]> = free.iter().map(of_free).collect();
        let is_integer: Vec<bool> = free.iter().map(|&v| elimination.is_integer(v)).collect();
        let pinned = pins(&moves, &is_integer);
        Seams { classes, sums, is_integer, cut, quarter_turns, runs, pinned }
    }

    /// A coordinate of a corner, counted modulo three, as a sum of free unknowns.
    pub(super) fn corner(&self, triangle: usize, corner: usize, axis: usize) -> &[(u32, f64)] {
        &self.sums[2 * self.classes[triangle][corner % 3] as usize + axis]
    }
}

/// Coordinate `axis` of a point turned by quarters is `sign` times the coordinate `from` before.
pub(super) fn turned(quarter_turns: u8, axis: usize) -> (usize, f64) {
    let unit = [[1, 0], [0, 1]].map(|e| Transition { quarter_turns, shift: [0; 2] }.turn(e)[axis]);
    if unit[0] != 0 { (0, unit[0] as f64) } else { (1, unit[1] as f64) }
}

/// Chooses two unknowns whose moves are independent, integers with a determinant of one if possible,
/// so that giving them loses no solution.
fn pins(moves: &[[f64; 2]], is_integer: &[bool]) -> Vec<u32> {
    let both = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
    let mut order: Vec<usize> = (0..moves.len()).collect();
    sort_by_number(&mut order, |&k| (!is_integer[k]).into());
    let primitive = |m: [f64; 2]| m[0].abs() + m[1].abs() == 1.0;
    let first = order.iter().copied().find(|&k| primitive(moves[k]));
    let moved = |&k: &usize| moves[k][0].abs() + moves[k][1].abs() > 0.0;
    let first = first.or_else(|| order.iter().copied().find(moved));
    let Some(first) = first else { return Vec::new() };
    let second = order.iter().copied().find(|&k| both(moves[first], moves[k]).abs() == 1.0);
    let nonzero = |k: &usize| both(moves[first], moves[*k]).abs() > 0.0;
    let second = second.or_else(|| order.iter().copied().find(nonzero));
    [Some(first), second].into_iter().flatten().map(|k| k as u32).collect()
}
