//! Freeform roofs, of quads or of hexagons: a hall with a swelling and a waist, and two mounds.

use crate::generate::finish::rounded;
use crate::generate::hexagons::hexagons;
use crate::generate::quads::grid;
use crate::math::{cosine, sine};
use crate::mesh::{Mesh, Point};

/// A hall whose roof comes down to the ground on both long sides. Its spine swings in plan. Its
/// sections are flattened arcs: wide and more than a half circle at the swelling, narrow at the
/// waist; the open ends lean out. The lines of panels run askew, so that no panel is flat.
pub struct Hall;

/// Amplitude of the spine of the hall in plan.
const SWING: f64 = 5.0;
/// Sideways amplitude of its lines of panels, as a fraction of half the girth.
const SKEW: f64 = 0.26;

impl Hall {
    /// Length of the spine in plan.
    pub const LENGTH: f64 = 64.0;

    /// The mesh of 61 by 35 vertices. Vertex `(i, j)` along the spine and across has index `61 j + i`.
    pub fn mesh() -> Mesh {
        rounded(grid([60, 34], |u, v| {
            let [u, v] = Hall::askew(u, v);
            Hall::point(u, v)
        }))
    }

    /// Maps parameters of an even grid to those of the askew one; each side of the border maps to
    /// itself.
    pub fn askew(u: f64, v: f64) -> [f64; 2] {
        let (inside_u, inside_v) = (1.0 - u * u, 1.0 - v * v);
        [u + 0.5 * SKEW * inside_u * sine(0.5 * v), v + SKEW * inside_v * sine(0.75 * u + 0.1)]
    }

    /// A point of the roof: `u` from -1 to 1 along the spine, `v` from -1 to 1 across.
    pub fn point(u: f64, v: f64) -> Point {
        // The ends lean out over their thresholds.
        let along = u * (1.0 + 0.08 * u * u * (1.0 - v * v));
        let (radius, opening) = section(u);
        let phase = 0.3 * along + 0.06;
        let spine = [0.5 * Hall::LENGTH * along, SWING * sine(phase)];
        let slope = SWING * 0.3 * std::f64::consts::TAU * cosine(phase) / (0.5 * Hall::LENGTH);
        let tangent = (1.0 + slope * slope).sqrt();
        let side = [-slope / tangent, 1.0 / tangent];
        let aside = radius * sine(opening * v);
        let up = radius * 0.75 * (cosine(opening * v) - cosine(opening));
        [spine[0] + aside * side[0], spine[1] + aside * side[1], up]
    }

    /// The length of the section at `u`, computed without the flattening.
    pub fn girth(u: f64) -> f64 {
        let (radius, opening) = section(u);
        2.0 * std::f64::consts::TAU * opening * radius
    }
}

/// The radius of the section of the hall at `u`, and half its angle, in turns.
fn section(u: f64) -> (f64, f64) {
    // From 1 at the swelling to -1 at the waist.
    let swell = cosine(0.55 * (u + 0.6));
    (9.5 + 3.0 * swell, 0.29 + 0.045 * swell)
}

/// A roof over a rectangle with two mounds, a wide one towards -x and a narrow one towards x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mounds {
    /// Rows of cells along x.
    pub rows: usize,
    /// Heights of the mounds.
    pub heights: [f64; 2],
}

impl Default for Mounds {
    fn default() -> Self {
        Mounds { rows: 30, heights: [7.0, 4.5] }
    }
}

/// Length of the roof with mounds along x and along y.
const SPAN: [f64; 2] = [40.0, 26.0];

impl Mounds {
    /// Centres of the mounds in plan.
    pub const MIDDLES: [[f64; 2]; 2] = [[-8.0, 1.0], [11.0, -2.0]];

    /// The mesh.
    pub fn mesh(&self) -> Mesh {
        // Cells are as wide as their rows are apart, up to the slant of hexagons.
        let width = SPAN[0] / (0.866 * self.rows as f64);
        let across = (SPAN[1] / width) as usize;
        honeycomb(self.rows, |_| across, |u, v| self.point(u, v))
    }

    fn point(&self, u: f64, v: f64) -> Point {
        let (x, y) = (0.5 * SPAN[0] * u, 0.5 * SPAN[1] * v);
        let mound = |k: usize, width: f64| {
            let [dx, dy] = [x - Self::MIDDLES[k][0], y - Self::MIDDLES[k][1]];
            let far = 1.0 + (dx * dx + dy * dy) / (width * width);
            self.heights[k] / (far * far)
        };
        // The long sides are curved inwards between the corners.
        [x, y * (0.86 + 0.14 * u * u), mound(0, 11.0) + mound(1, 6.5)]
    }
}

/// Hexagons and other polygons over the square from -1 to 1 in `u` and `v`, mapped by `point`, with
/// few digits. There are `rows + 1` rows of triangle corners along `u`, of which every second has
/// `across(u)`; the polygons are the dual of the triangles.
pub fn honeycomb(
    rows: usize,
    across: impl Fn(f64) -> usize,
    point: impl Fn(f64, f64) -> Point,
) -> Mesh {
    rounded(hexagons(rows, across, point))
}
