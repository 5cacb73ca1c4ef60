//! A sheet of skew, uneven panels.

use crate::example::model::tool::{Noise, grid, rounded};
use crate::mesh::Mesh;

/// A gently arched sheet whose panels are sheared to one side and uneven in size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Patch {
    /// Panels along x and along y.
    pub panels: [usize; 2],
    /// Mean width of a panel.
    pub width: f64,
    /// Shift of each row relative to the one before, as a fraction of the width.
    pub shear: f64,
    /// Largest displacement of vertices along x and along y, as a fraction of the width.
    pub jitter: f64,
    /// Height of the middle above the corners.
    pub rise: f64,
}

impl Default for Patch {
    fn default() -> Self {
        Patch { panels: [24, 16], width: 1.0, shear: 0.3, jitter: 0.22, rise: 2.5 }
    }
}

impl Patch {
    /// The mesh of `(panels[0] + 1) * (panels[1] + 1)` vertices. Vertex `(i, j)` along x and y has
    /// index `j * (panels[0] + 1) + i`.
    pub fn mesh(&self) -> Mesh {
        let half = self.panels.map(|n| 0.5 * self.width * n as f64);
        let mut noise = Noise { state: 1 };
        let mut mesh = grid(self.panels, |x, y| [half[0] * x, half[1] * y, 0.0]);
        for p in &mut mesh.positions {
            let [x, y, _] = *p;
            let (x, y) = (
                x + self.shear * y + self.jitter * self.width * noise.next(),
                y + self.jitter * self.width * noise.next(),
            );
            let (across, along) = (x / (half[0] + self.shear * half[1]), y / half[1]);
            *p = [x, y, self.rise * (1.0 - 0.5 * (across * across + along * along))];
        }
        rounded(mesh)
    }
}
