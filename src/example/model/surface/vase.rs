//! A vase of triangles, not quite round.

use crate::example::model::tool::{Rings, rounded};
use crate::math::{cosine, sine};
use crate::mesh::{Mesh, Ragged};

/// A vase, open at the bottom and the top. Its belly is pressed in from two sides, its neck is
/// oval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vase {
    /// Vertices of each ring.
    pub meridians: u32,
    /// Rows of triangles from the ground up.
    pub rows: u32,
    /// Height of the rim above the ground.
    pub height: f64,
    /// Ovality of the neck, and of the belly in the other direction, as a fraction of the radius.
    pub ovality: f64,
}

impl Default for Vase {
    fn default() -> Self {
        Vase { meridians: 36, rows: 30, height: 10.0, ovality: 0.16 }
    }
}

impl Vase {
    /// The mesh. Vertex `i` of ring `k`, counted from the x axis towards the y axis and from the
    /// ground up, has index `k * meridians + i`. Odd rings are turned by half a step.
    pub fn mesh(&self) -> Mesh {
        let rings = self.rings();
        let half_step = 0.5 / f64::from(self.meridians);
        let positions = rings.positions(|k, up, turn| {
            // Widest below the middle, narrowest at the neck; the rim flares.
            let flare = (up - 0.72).max(0.0);
            let radius = 1.75 + 1.05 * sine(0.9 * up - 0.02) + 9.0 * flare * flare;
            let oval = self.ovality * sine(0.55 * up - 0.28) * up.min(0.2) / 0.2;
            let turn = if is_odd(k) { turn + half_step } else { turn };
            let [x, y] = [(1.0 + oval) * radius, (1.0 - oval) * radius];
            [x * cosine(turn), y * sine(turn), self.height * up]
        });
        // The vertices of an odd ring lie between those of the even ones.
        let triangles = rings.quads().flat_map(|[a, b, c, d]| {
            if is_odd(a / self.meridians) { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] }
        });
        rounded(Mesh { positions, faces: Ragged::from_iter(triangles), ..Mesh::default() })
    }

    /// The vertices of ring `k`, from 0 on the ground to `rows` at the rim.
    pub fn ring(&self, k: u32) -> std::ops::Range<u32> {
        self.rings().ring(k)
    }

    fn rings(&self) -> Rings {
        Rings { meridians: self.meridians, rows: self.rows }
    }
}

fn is_odd(k: u32) -> bool {
    k % 2 == 1
}
