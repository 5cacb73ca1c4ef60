//! Sheets of quads over a square: a hyperbolic paraboloid, skew panels, a strip between two rails,
//! and a piece of a torus.

use crate::generate::finish::{Noise, rounded};
use crate::generate::quads::grid;
use crate::math::{cosine, sine};
use crate::mesh::Mesh;

/// A hyperbolic paraboloid over a square, with edges along its two families of rulings, that sags
/// in waves between its straight sides.
pub struct Hypar;

impl Hypar {
    /// Panels along each side.
    const PANELS: usize = 16;

    /// The mesh of 17 by 17 vertices. Vertex `(i, j)` along x and y has index `17 j + i`.
    pub fn mesh() -> Mesh {
        grid([Hypar::PANELS; 2], |x, y| {
            let inside = (1.0 - x * x) * (1.0 - y * y);
            let wave = 0.6 + 0.4 * sine(0.75 * (x - y)) + 0.4 * sine(0.5 * x + 0.9 * y);
            // Also sideways: lines already straight in plan would be too easy to straighten.
            let sway = 0.5 * 1.2 * inside;
            [
                10.0 * x + sway * sine(0.7 * y),
                10.0 * y + sway * sine(0.6 * x + 0.1),
                0.5 * 8.0 * (1.0 + x * y) - 1.2 * inside * wave,
            ]
        })
    }

    /// The vertices of the four sides, in ascending order.
    pub fn sides() -> Vec<u32> {
        let n = Hypar::PANELS;
        let on_side = |v: &usize| {
            let (i, j) = (v % (n + 1), v / (n + 1));
            i == 0 || j == 0 || i == n || j == n
        };
        (0..(n + 1) * (n + 1)).filter(on_side).map(|v| v as u32).collect()
    }
}

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

/// The upper outer side of an upright torus: a vault.
pub struct Net;

impl Net {
    /// Panels along the torus and around its tube.
    pub const PANELS: [usize; 2] = [36, 22];

    /// The mesh of 37 by 23 vertices. Vertex `(i, j)` along x and y has index `37 j + i`. The corners
    /// are at height 0.
    pub fn mesh() -> Mesh {
        // Radii of the centre circle of the tube, and of the tube; half the angles, in turns.
        let [large, small] = [10.0, 12.0];
        let [along, around] = [0.14, 0.15];
        let corner = (large + small * cosine(around)) * cosine(along);
        rounded(grid(Net::PANELS, |x, y| {
            let radius = large + small * cosine(around * y);
            [
                radius * sine(along * x),
                small * sine(around * y),
                radius * cosine(along * x) - corner,
            ]
        }))
    }
}
