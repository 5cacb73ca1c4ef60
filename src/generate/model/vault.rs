//! A free-form vault as it comes from a modeller or a scan: irregular triangles, which follow nothing.

use super::finish::rounded;
use crate::math::{cosine, sine};
use crate::mesh::{Mesh, Point};
use std::f64::consts::TAU;

/// A vault over a bent axis, wide at its ends and open on all sides, in irregular triangles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vault {
    /// Cells along the axis and across; each has two triangles.
    pub cells: [usize; 2],
    /// Angle of the axis as an arc, in radians, and its length.
    pub bend: f64,
    /// See `bend`.
    pub length: f64,
    /// Half the width at the middle of the axis, and how much more it is at the ends.
    pub half_width: [f64; 2],
    /// Height at the middle of the axis, how much more it is at the ends, and how much the roof falls
    /// from the first end to the last.
    pub rise: [f64; 3],
    /// How far vertices are moved over the surface, as a fraction of a cell.
    pub shift: f64,
}

/// Half the angle of the arc across, in radians.
const ACROSS: f64 = 1.5;

impl Default for Vault {
    fn default() -> Self {
        Vault {
            cells: [44, 26],
            bend: 0.9,
            length: 30.0,
            half_width: [5.2, 2.6],
            rise: [4.2, 1.6, 0.8],
            shift: 0.3,
        }
    }
}

impl Vault {
    /// The mesh. Vertices are numbered across, from the first end of the axis on; those of the
    /// boundary lie on that of the surface.
    pub fn mesh(&self) -> Mesh {
        let [along, across] = self.cells;
        let mut random = Random::default();
        let mut shifted = |k: usize, most: usize| {
            let by = if k == 0 || k == most { 0.0 } else { 2.0 * self.shift * random.next() };
            (k as f64 + by) / most as f64
        };
        let mut mesh = Mesh::default();
        for i in 0..=along {
            for j in 0..=across {
                let u = shifted(i, along);
                mesh.positions.push(self.point(u, 2.0 * shifted(j, across) - 1.0));
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
    fn point(&self, u: f64, v: f64) -> Point {
        let flare = (2.0 * u - 1.0) * (2.0 * u - 1.0);
        let half = self.half_width[0] + self.half_width[1] * flare;
        let rise = self.rise[0] + self.rise[1] * flare - self.rise[2] * u;
        let [side, height] = [half * sine(ACROSS * v / TAU), rise * cosine(ACROSS * v / TAU)];
        let radius = self.length / self.bend;
        let turns = self.bend * (u - 0.5) / TAU;
        [(radius - side) * sine(turns), radius - (radius - side) * cosine(turns), height]
    }
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
