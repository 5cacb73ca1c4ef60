//! A flowing roof: a hall with a swelling and a waist.

use crate::example::model::tool::{grid, rounded};
use crate::math::{cosine, sine};
use crate::mesh::{Mesh, Point};

/// A hall whose roof comes down to the ground on both long sides. Its spine swings in plan. Its
/// sections are flattened arcs: wide and more than a half circle at the swelling, narrow at the
/// waist; the open ends lean out. The lines of panels run askew, so that no panel is flat.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hall {
    /// Panels along the spine and across.
    pub panels: [usize; 2],
    /// Length of the spine in plan.
    pub length: f64,
    /// Mean radius of the sections.
    pub radius: f64,
    /// How much larger the radius is at the swelling, and smaller at the waist.
    pub swelling: f64,
    /// Amplitude of the spine in plan.
    pub swing: f64,
    /// Height of a section relative to a round one.
    pub flatness: f64,
    /// Sideways amplitude of the lines of panels along the spine, as a fraction of half the girth.
    pub skew: f64,
}

impl Default for Hall {
    fn default() -> Self {
        Hall {
            panels: [60, 34],
            length: 64.0,
            radius: 9.5,
            swelling: 3.0,
            swing: 5.0,
            flatness: 0.75,
            skew: 0.26,
        }
    }
}

impl Hall {
    /// The mesh of `(panels[0] + 1) * (panels[1] + 1)` vertices. Vertex `(i, j)` along the spine
    /// and across has index `j * (panels[0] + 1) + i`.
    pub fn mesh(&self) -> Mesh {
        rounded(grid(self.panels, |u, v| {
            let [u, v] = self.askew(u, v);
            self.point(u, v)
        }))
    }

    /// Maps parameters of an even grid to those of the askew one; each side of the border maps to
    /// itself.
    pub fn askew(&self, u: f64, v: f64) -> [f64; 2] {
        let (inside_u, inside_v) = (1.0 - u * u, 1.0 - v * v);
        [
            u + 0.5 * self.skew * inside_u * sine(0.5 * v),
            v + self.skew * inside_v * sine(0.75 * u + 0.1),
        ]
    }

    /// A point of the roof: `u` from -1 to 1 along the spine, `v` from -1 to 1 across.
    pub fn point(&self, u: f64, v: f64) -> Point {
        // The ends lean out over their thresholds.
        let along = u * (1.0 + 0.08 * u * u * (1.0 - v * v));
        let swell = self.swell(u);
        let radius = self.radius + self.swelling * swell;
        let opening = opening(swell);
        let phase = 0.3 * along + 0.06;
        let spine = [0.5 * self.length * along, self.swing * sine(phase)];
        let slope = self.swing * 0.3 * std::f64::consts::TAU * cosine(phase) / (0.5 * self.length);
        let tangent = (1.0 + slope * slope).sqrt();
        let side = [-slope / tangent, 1.0 / tangent];
        let aside = radius * sine(opening * v);
        let up = radius * self.flatness * (cosine(opening * v) - cosine(opening));
        [spine[0] + aside * side[0], spine[1] + aside * side[1], up]
    }

    /// The length of the section at `u`, computed without the flattening.
    pub fn girth(&self, u: f64) -> f64 {
        let swell = self.swell(u);
        2.0 * std::f64::consts::TAU * opening(swell) * (self.radius + self.swelling * swell)
    }

    /// Runs from 1 at the swelling to -1 at the waist.
    fn swell(&self, u: f64) -> f64 {
        cosine(0.55 * (u + 0.6))
    }
}

/// Half the angle of a section, in turns.
fn opening(swell: f64) -> f64 {
    0.29 + 0.045 * swell
}
