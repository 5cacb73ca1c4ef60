//! A sheet with two mounds, of hexagons and other polygons.

use super::honeycomb;
use crate::mesh::{Mesh, Point};

/// A roof over a rectangle with two mounds, a wide one towards -x and a narrow one towards x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mounds {
    /// Rows of cells along x.
    pub rows: usize,
    /// Length along x and along y.
    pub span: [f64; 2],
    /// Heights of the mounds.
    pub heights: [f64; 2],
}

impl Default for Mounds {
    fn default() -> Self {
        Mounds { rows: 30, span: [40.0, 26.0], heights: [7.0, 4.5] }
    }
}

impl Mounds {
    /// Centres of the mounds in plan.
    pub const MIDDLES: [[f64; 2]; 2] = [[-8.0, 1.0], [11.0, -2.0]];

    /// The mesh.
    pub fn mesh(&self) -> Mesh {
        // Cells are as wide as their rows are apart, up to the slant of hexagons.
        let width = self.span[0] / (0.866 * self.rows as f64);
        let across = (self.span[1] / width) as usize;
        honeycomb(self.rows, |_| across, |u, v| self.point(u, v))
    }

    fn point(&self, u: f64, v: f64) -> Point {
        let (x, y) = (0.5 * self.span[0] * u, 0.5 * self.span[1] * v);
        let mound = |k: usize, width: f64| {
            let [dx, dy] = [x - Self::MIDDLES[k][0], y - Self::MIDDLES[k][1]];
            let far = 1.0 + (dx * dx + dy * dy) / (width * width);
            self.heights[k] / (far * far)
        };
        // The long sides are curved inwards between the corners.
        [x, y * (0.86 + 0.14 * u * u), mound(0, 11.0) + mound(1, 6.5)]
    }
}
