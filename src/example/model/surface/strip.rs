//! A strip between two rails that swing differently.

use crate::example::model::tool::{grid, rounded};
use crate::math::sine;
use crate::mesh::Mesh;

/// A ruled strip along x whose two long sides swing up and down, out of step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strip {
    /// Panels along x and along y.
    pub panels: [usize; 2],
    /// Length along x, and width along y.
    pub size: [f64; 2],
    /// Amplitude of the whole strip, over one and a half periods.
    pub swing: f64,
    /// Amplitude of its sides against each other, over one period.
    pub twist: f64,
}

impl Default for Strip {
    fn default() -> Self {
        Strip { panels: [42, 5], size: [10.0, 3.0], swing: 1.2, twist: 1.0 }
    }
}

impl Strip {
    /// The mesh of `(panels[0] + 1) * (panels[1] + 1)` vertices. Vertex `(i, j)` along x and y has
    /// index `j * (panels[0] + 1) + i`.
    pub fn mesh(&self) -> Mesh {
        let Strip { panels, size, swing, twist } = *self;
        rounded(grid(panels, |x, y| {
            let along = 0.5 + 0.5 * x;
            let z = swing * sine(1.5 * along) + 0.5 * twist * y * sine(along);
            [0.5 * size[0] * x, 0.5 * size[1] * y, z]
        }))
    }

    /// The vertices of its two long sides.
    pub fn rails(&self) -> Vec<u32> {
        let [nx, ny] = self.panels.map(|n| n as u32);
        let last = ny * (nx + 1);
        (0..=nx).chain(last..=last + nx).collect()
    }
}
