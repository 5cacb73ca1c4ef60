//! A surface of revolution of triangles, out of the round.

use super::rounded;
use crate::math::{cosine, sine};
use crate::mesh::{Mesh, Ragged};

/// A vase, open above and below. Its belly is pressed in from two sides, and its neck is oval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vase {
    /// Vertices of each ring.
    pub meridians: u32,
    /// Rows of triangles from the ground up.
    pub rows: u32,
    /// Height of the rim over the ground.
    pub height: f64,
    /// How much longer than wide the neck is, and the other way round the belly.
    pub ovality: f64,
}

impl Default for Vase {
    fn default() -> Self {
        Vase { meridians: 36, rows: 30, height: 10.0, ovality: 0.16 }
    }
}

impl Vase {
    /// The mesh. Vertex `i` of ring `k`, counted from the x axis towards the y axis and from the
    /// ground up, is number `k * meridians + i`. Odd rings are turned by half a step.
    pub fn mesh(&self) -> Mesh {
        let mut mesh = Mesh::default();
        for k in 0..=self.rows {
            let up = f64::from(k) / f64::from(self.rows);
            // Widest below the middle, narrowest at the neck; the rim flares.
            let flare = (up - 0.72).max(0.0);
            let radius = 1.75 + 1.05 * sine(0.9 * up - 0.02) + 9.0 * flare * flare;
            let oval = self.ovality * sine(0.55 * up - 0.28) * up.min(0.2) / 0.2;
            for i in 0..self.meridians {
                let shift = if k % 2 == 1 { 0.5 } else { 0.0 };
                let turn = (f64::from(i) + shift) / f64::from(self.meridians);
                let [x, y] = [(1.0 + oval) * radius, (1.0 - oval) * radius];
                mesh.positions.push([x * cosine(turn), y * sine(turn), self.height * up]);
            }
        }
        let mut faces = Ragged::new();
        for k in 0..self.rows {
            let [low, high] = [k, k + 1].map(|k| k * self.meridians);
            for i in 0..self.meridians {
                let next = (i + 1) % self.meridians;
                // The vertices of an odd ring lie between those of the even ones.
                let pair = if k % 2 == 0 {
                    [[low + i, low + next, high + i], [low + next, high + next, high + i]]
                } else {
                    [[low + i, low + next, high + next], [low + i, high + next, high + i]]
                };
                pair.iter().for_each(|triangle| faces.push(triangle));
            }
        }
        rounded(Mesh { faces, ..mesh })
    }

    /// The vertices of ring `k`, from 0 on the ground to `rows` at the rim.
    pub fn ring(&self, k: u32) -> std::ops::Range<u32> {
        k * self.meridians..(k + 1) * self.meridians
    }
}
