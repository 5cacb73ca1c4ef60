//! A surface of revolution: the corners of each panel lie on a circle.

use crate::example::model::tool::{Rings, rounded};
use crate::math::{cosine, sine};
use crate::mesh::Mesh;

/// A lantern, open at the bottom and the top, whose profile swells and narrows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lantern {
    /// Panels around it.
    pub meridians: u32,
    /// Panels from the ground up.
    pub rows: u32,
    /// Height of the rim above the ground.
    pub height: f64,
    /// Mean radius.
    pub radius: f64,
    /// Amplitude of the radius.
    pub swelling: f64,
}

impl Default for Lantern {
    fn default() -> Self {
        Lantern { meridians: 48, rows: 26, height: 18.0, radius: 8.0, swelling: 2.6 }
    }
}

impl Lantern {
    /// The mesh. Vertex `i` of ring `k`, counted from the x axis towards the y axis and from the
    /// ground up, has index `k * meridians + i`.
    pub fn mesh(&self) -> Mesh {
        let rings = self.rings();
        let positions = rings.positions(|_, up, turn| {
            // Widest at a third of the height, narrowest below the rim, which flares.
            let radius = self.radius + self.swelling * sine(0.95 * up - 0.08) - up * up;
            [radius * cosine(turn), radius * sine(turn), self.height * up]
        });
        rounded(Mesh { positions, faces: rings.faces(), ..Mesh::default() })
    }

    /// The vertices of ring `k`, from 0 on the ground to `rows` at the rim.
    pub fn ring(&self, k: u32) -> std::ops::Range<u32> {
        self.rings().ring(k)
    }

    fn rings(&self) -> Rings {
        Rings { meridians: self.meridians, rows: self.rows }
    }
}
