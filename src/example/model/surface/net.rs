//! A piece of a torus: both families of its lines of edges are circles.

use crate::example::model::tool::{grid, rounded};
use crate::math::{cosine, sine};
use crate::mesh::Mesh;

/// The upper outer side of an upright torus: a vault.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Net {
    /// Panels along the torus and around its tube.
    pub panels: [usize; 2],
    /// Radii of the centre circle of the tube, and of the tube.
    pub radii: [f64; 2],
    /// Half the angles along the torus and around its tube, in turns.
    pub angles: [f64; 2],
}

impl Default for Net {
    fn default() -> Self {
        Net { panels: [36, 22], radii: [10.0, 12.0], angles: [0.14, 0.15] }
    }
}

impl Net {
    /// The mesh of `(panels[0] + 1) * (panels[1] + 1)` vertices. Vertex `(i, j)` along x and y has
    /// index `j * (panels[0] + 1) + i`. The corners are at height 0.
    pub fn mesh(&self) -> Mesh {
        let [large, small] = self.radii;
        let [along, around] = self.angles;
        let corner = (large + small * cosine(around)) * cosine(along);
        rounded(grid(self.panels, |x, y| {
            let radius = large + small * cosine(around * y);
            [
                radius * sine(along * x),
                small * sine(around * y),
                radius * cosine(along * x) - corner,
            ]
        }))
    }
}
