//! A hyperbolic paraboloid.

use crate::example::model::tool::grid;
use crate::math::sine;
use crate::mesh::Mesh;

/// A hyperbolic paraboloid over a square, with edges along its two families of rulings, that sags
/// in waves between its straight sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hypar {
    /// Panels along each side.
    pub panels: usize,
    /// Length of a side in plan.
    pub span: f64,
    /// Height of the two high corners above the two low ones.
    pub rise: f64,
    /// Depth of the sag.
    pub sag: f64,
}

impl Default for Hypar {
    fn default() -> Self {
        Hypar { panels: 16, span: 20.0, rise: 8.0, sag: 1.2 }
    }
}

impl Hypar {
    /// The mesh of `(panels + 1)^2` vertices. Vertex `(i, j)` along x and y has index
    /// `j * (panels + 1) + i`.
    pub fn mesh(&self) -> Mesh {
        let half = 0.5 * self.span;
        grid([self.panels; 2], |x, y| {
            let inside = (1.0 - x * x) * (1.0 - y * y);
            let wave = 0.6 + 0.4 * sine(0.75 * (x - y)) + 0.4 * sine(0.5 * x + 0.9 * y);
            // Also sideways: lines already straight in plan would be too easy to straighten.
            let sway = 0.5 * self.sag * inside;
            [
                half * x + sway * sine(0.7 * y),
                half * y + sway * sine(0.6 * x + 0.1),
                0.5 * self.rise * (1.0 + x * y) - self.sag * inside * wave,
            ]
        })
    }

    /// The vertices of the four sides, in ascending order.
    pub fn sides(&self) -> Vec<u32> {
        let n = self.panels;
        let on_side = |v: &usize| {
            let (i, j) = (v % (n + 1), v / (n + 1));
            i == 0 || j == 0 || i == n || j == n
        };
        (0..(n + 1) * (n + 1)).filter(on_side).map(|v| v as u32).collect()
    }
}
