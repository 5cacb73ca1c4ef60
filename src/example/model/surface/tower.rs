//! A tower whose floors are wavy.

use crate::example::model::tool::{Rings, rounded};
use crate::math::{cosine, sine};
use crate::mesh::Mesh;

/// A tower, open at the bottom and the top, whose plan is a rounded triangle that twists on the way
/// up, and whose rings of edges rise and fall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tower {
    /// Panels around it.
    pub meridians: u32,
    /// Panels from the ground up.
    pub rows: u32,
    /// Height.
    pub height: f64,
    /// Deviation of the plan from a circle, as a fraction of its radius.
    pub bulge: f64,
    /// Amplitude of the rings in height.
    pub wave: f64,
}

impl Default for Tower {
    fn default() -> Self {
        Tower { meridians: 48, rows: 28, height: 44.0, bulge: 0.1, wave: 0.55 }
    }
}

impl Tower {
    /// The mesh. Vertex `i` of ring `k`, counted from the x axis towards the y axis and from the
    /// ground up, has index `k * meridians + i`.
    pub fn mesh(&self) -> Mesh {
        let rings = self.rings();
        let positions = rings.positions(|_, up, turn| {
            // The foot is level and round.
            let off_ground = up.min(0.1) / 0.1;
            let radius = 7.6 + 1.6 * cosine(0.7 * up + 0.05);
            let plan = 1.0 + self.bulge * off_ground * cosine(3.0 * turn - 0.5 * up);
            let wave = self.wave * off_ground * sine(2.0 * turn + 1.3 * up);
            let [x, y] = [radius * plan * cosine(turn), radius * plan * sine(turn)];
            [x, y, self.height * up + wave]
        });
        rounded(Mesh { positions, faces: rings.faces(), ..Mesh::default() })
    }

    /// The vertices of ring `k`, from 0 on the ground to `rows` at the top.
    pub fn ring(&self, k: u32) -> std::ops::Range<u32> {
        self.rings().ring(k)
    }

    fn rings(&self) -> Rings {
        Rings { meridians: self.meridians, rows: self.rows }
    }
}
