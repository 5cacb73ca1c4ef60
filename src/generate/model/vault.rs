//! A free-form vault as it comes from a modeller or a scan: irregular triangles, which follow nothing.

use crate::generate::finish::rounded;
use crate::math::{cosine, sine};
use crate::mesh::{Mesh, Point};
use std::f64::consts::TAU;

/// Cells along the axis and across; each has two triangles.
const CELLS: [usize; 2] = [44, 26];
/// Angle of the axis as an arc, in radians.
const BEND: f64 = 0.9;
/// Length of the axis.
const LENGTH: f64 = 30.0;
/// Half the width at the middle of the axis, and how much more it is at the ends.
const HALF_WIDTH: [f64; 2] = [5.2, 2.6];
/// Height at the middle of the axis, how much more it is at the ends, and how much the roof falls from
/// the first end to the last.
const RISE: [f64; 3] = [4.2, 1.6, 0.8];
/// How far vertices are moved over the surface, as a fraction of a cell.
const SHIFT: f64 = 0.3;
/// Half the angle of the arc across, in radians.
const ACROSS: f64 = 1.5;

/// A vault over a bent axis, wide at its ends and open on all sides, in irregular triangles. Vertices
/// are numbered across, from the first end of the axis on; those of the boundary lie on that of the
/// surface.
pub fn vault() -> Mesh {
    let [along, across] = CELLS;
    let mut random = Random::default();
    let mut shifted = |k: usize, most: usize| {
        let by = if k == 0 || k == most { 0.0 } else { 2.0 * SHIFT * random.next() };
        (k as f64 + by) / most as f64
    };
    let mut mesh = Mesh::default();
    for i in 0..=along {
        for j in 0..=across {
            let u = shifted(i, along);
            mesh.positions.push(point(u, 2.0 * shifted(j, across) - 1.0));
        }
    }
    let width = across as u32 + 1;
    for i in 0..along as u32 {
        for j in 0..across as u32 {
            let a = i * width + j;
            let [b, c, d] = [a + width, a + width + 1, a + 1];
            let triangles = match random.next() < 0.0 {
                true => [[a, b, c], [a, c, d]],
                false => [[a, b, d], [b, c, d]],
            };
            triangles.iter().for_each(|triangle| mesh.faces.push(triangle));
        }
    }
    rounded(mesh)
}

/// The point at `u` from 0 to 1 along the axis and `v` from -1 to 1 across.
fn point(u: f64, v: f64) -> Point {
    let flare = (2.0 * u - 1.0) * (2.0 * u - 1.0);
    let half = HALF_WIDTH[0] + HALF_WIDTH[1] * flare;
    let rise = RISE[0] + RISE[1] * flare - RISE[2] * u;
    let [side, height] = [half * sine(ACROSS * v / TAU), rise * cosine(ACROSS * v / TAU)];
    let radius = LENGTH / BEND;
    let turns = BEND * (u - 0.5) / TAU;
    [(radius - side) * sine(turns), radius - (radius - side) * cosine(turns), height]
}

/// Pseudo-random numbers from -1/2 to 1/2, of few digits, so that scripts can make the same ones
/// (Park and Miller 1988).
pub(super) struct Random {
    state: u64,
}

impl Default for Random {
    fn default() -> Random {
        Random { state: 7 }
    }
}

impl Random {
    /// The next number.
    pub(super) fn next(&mut self) -> f64 {
        const MODULUS: u64 = 2_147_483_647;
        self.state = self.state * 16_807 % MODULUS;
        self.state as f64 / MODULUS as f64 - 0.5
    }
}
