//! A surface of revolution: each of its panels has a circle through its corners.

use super::rounded;
use crate::math::{cosine, sine};
use crate::mesh::{Mesh, Ragged};

/// A lantern, open below and above, whose outline swells and draws in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lantern {
    /// Panels round it.
    pub meridians: u32,
    /// Panels from the ground up.
    pub rows: u32,
    /// Height of the rim over the ground.
    pub height: f64,
    /// Mean radius.
    pub radius: f64,
    /// How much the radius swells and draws in.
    pub swelling: f64,
}

impl Default for Lantern {
    fn default() -> Self {
        Lantern { meridians: 48, rows: 26, height: 18.0, radius: 8.0, swelling: 2.6 }
    }
}

impl Lantern {
    /// The mesh. Vertex `i` of ring `k`, counted from the x axis towards the y axis and from the
    /// ground up, is number `k * meridians + i`.
    pub fn mesh(&self) -> Mesh {
        let mut mesh = Mesh::default();
        for k in 0..=self.rows {
            let up = f64::from(k) / f64::from(self.rows);
            // Widest at a third of the height, narrowest below the rim, which flares.
            let radius = self.radius + self.swelling * sine(0.95 * up - 0.08) - up * up;
            for i in 0..self.meridians {
                let turn = f64::from(i) / f64::from(self.meridians);
                mesh.positions.push([radius * cosine(turn), radius * sine(turn), self.height * up]);
            }
        }
        let mut faces = Ragged::new();
        for k in 0..self.rows {
            for i in 0..self.meridians {
                let next = (i + 1) % self.meridians;
                let [low, high] = [k, k + 1].map(|k| k * self.meridians);
                faces.push(&[low + i, low + next, high + next, high + i]);
            }
        }
        rounded(Mesh { faces, ..mesh })
    }

    /// The vertices of ring `k`, from 0 on the ground to `rows` at the rim.
    pub fn ring(&self, k: u32) -> std::ops::Range<u32> {
        k * self.meridians..(k + 1) * self.meridians
    }
}
