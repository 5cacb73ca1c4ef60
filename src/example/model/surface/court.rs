//! A roof around a court.

use crate::example::model::tool::{Rings, rounded};
use crate::math::{cosine, sine};
use crate::mesh::{Mesh, Ragged};

/// A ring-shaped roof with an egg-shaped inner rim that rises and falls. Panels crowd on one side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Court {
    /// Panels around the ring.
    pub meridians: u32,
    /// Rows of panels from the rim to the eaves.
    pub rows: u32,
    /// The mean radius of the rim, and the radius of the eaves.
    pub radii: [f64; 2],
    /// Amplitude of the rim's height.
    pub swing: f64,
    /// How unevenly the panels are spaced around: at 1 some would have no width.
    pub crowding: f64,
}

impl Default for Court {
    fn default() -> Self {
        Court { meridians: 28, rows: 9, radii: [6.0, 15.0], swing: 1.2, crowding: 0.55 }
    }
}

impl Court {
    /// The mesh. Vertex `i` of ring `k`, from 0 at the rim to `rows` at the eaves, has index
    /// `k * meridians + i`.
    pub fn mesh(&self) -> Mesh {
        let Court { radii: [rim, eaves], swing, crowding, .. } = *self;
        let positions = self.rings().positions(|_, out, turn| {
            let turn = turn + crowding * sine(turn) / std::f64::consts::TAU;
            let inner = rim * (1.0 + 0.25 * cosine(turn) - 0.1 * cosine(2.0 * turn));
            let radius = inner + (eaves - inner) * out;
            let height = 4.0 + swing * cosine(2.0 * turn) * (1.0 - out) - 2.5 * out * out;
            [radius * cosine(turn), radius * sine(turn), height]
        });
        // Counterclockwise seen from above.
        let faces = self.rings().quads().map(|[a, b, c, d]| [a, d, c, b]);
        rounded(Mesh { positions, faces: Ragged::from_iter(faces), ..Mesh::default() })
    }

    /// The vertices of ring `k`.
    pub fn ring(&self, k: u32) -> std::ops::Range<u32> {
        self.rings().ring(k)
    }

    fn rings(&self) -> Rings {
        Rings { meridians: self.meridians, rows: self.rows }
    }
}
