//! A canopy on four feet.

use crate::example::model::tool::grid;
use crate::math::sine;
use crate::mesh::Mesh;

/// A vault of quads on four feet, with a wave across, over a plan whose sides are curved inwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Canopy {
    /// Panels along x and along y.
    pub panels: [usize; 2],
    /// Distances between the feet along x and along y.
    pub span: [f64; 2],
    /// Height of the middle of each side above the feet.
    pub rise: f64,
    /// Height of the middle of the vault above the middle of its sides.
    pub crown: f64,
    /// How far the middle of each side is drawn in, as a fraction of half the span.
    pub waist: f64,
    /// Height of the wave.
    pub wave: f64,
}

impl Default for Canopy {
    fn default() -> Self {
        Canopy {
            panels: [24, 18],
            span: [36.0, 26.0],
            rise: 5.0,
            crown: 2.0,
            waist: 0.1,
            wave: 0.8,
        }
    }
}

impl Canopy {
    /// The mesh of `(panels[0] + 1) * (panels[1] + 1)` vertices. Vertex `(i, j)` along x and y has
    /// index `j * (panels[0] + 1) + i`.
    pub fn mesh(&self) -> Mesh {
        grid(self.panels, |x, y| {
            let (xx, yy) = (x * x, y * y);
            // One along the middle lines, zero at the feet.
            let over_feet = 1.0 - xx * yy;
            let ripple = sine(0.6 * x + 0.3 * y);
            [
                0.5 * self.span[0] * x * (1.0 - self.waist * (1.0 - yy)),
                0.5 * self.span[1] * y * (1.0 - self.waist * (1.0 - xx)),
                self.rise * over_feet
                    + self.crown * (1.0 - xx) * (1.0 - yy)
                    + self.wave * over_feet * ripple,
            ]
        })
    }
}
