//! Roofs over a plan: a dome with an oval hole, a canopy on four feet, a roof around a court.

use crate::generate::finish::rounded;
use crate::generate::quads::{Rings, grid};
use crate::math::{cosine, sine};
use crate::mesh::{Mesh, Point, Ragged};
use std::ops::Range;

/// A dome over a square with round corners, open on its four sides, with an oval hole off centre.
/// Half of the meridians end partway up, in a row of pentagons.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dome {
    /// Meridians around the hole; twice as many start at the eaves.
    pub meridians: usize,
    /// Rows of quads below and above the row of pentagons.
    pub rows: [usize; 2],
}

impl Default for Dome {
    fn default() -> Self {
        Dome { meridians: 24, rows: [5, 3] }
    }
}

impl Dome {
    /// The mesh. Vertices are numbered ring by ring from the eaves up, see [`Dome::ring`].
    pub fn mesh(&self) -> Mesh {
        let mut mesh = Mesh::default();
        for k in 0..self.rings() {
            let (first, count) = self.ring(k);
            debug_assert_eq!(first as usize, mesh.positions.len());
            let up = k as f64 / (self.rings() - 1) as f64;
            mesh.positions
                .extend((0..count).map(|i| Dome::point(f64::from(i) / f64::from(count), up)));
        }
        for k in 0..self.rings() - 1 {
            let ((low, below), (high, above)) = (self.ring(k), self.ring(k + 1));
            for i in 0..above {
                let next = (i + 1) % above;
                if below == above {
                    mesh.faces.push(&[low + i, low + next, high + next, high + i]);
                } else {
                    let [a, b, c] = [2 * i, 2 * i + 1, 2 * next].map(|j| low + j);
                    mesh.faces.push(&[a, b, c, high + next, high + i]);
                }
            }
        }
        mesh
    }

    /// Number of rings of vertices; the first is at the eaves, the last around the hole.
    pub fn rings(&self) -> usize {
        self.rows[0] + self.rows[1] + 2
    }

    /// The first vertex of ring `k` and the number of its vertices, in order from the x axis
    /// towards the y axis.
    pub fn ring(&self, k: usize) -> (u32, u32) {
        let few = self.meridians as u32;
        let doubled = self.rows[0] + 1;
        let before = 2 * few * k.min(doubled) as u32 + few * k.saturating_sub(doubled) as u32;
        (before, if k < doubled { 2 * few } else { few })
    }

    /// A point of the surface: `turn` from 0 to 1 goes around, `up` from 0 at the eaves to 1 at the
    /// hole.
    fn point(turn: f64, up: f64) -> Point {
        let (c, s) = (cosine(turn), sine(turn));
        let (cc, ss) = (c * c, s * s);
        // The curve `x^4 + y^4 = 14^4`, a square with round corners.
        let square = 14.0 / (cc * cc + ss * ss).sqrt().sqrt();
        let down = 1.0 - up;
        let hole = 3.2 * (1.0 + 0.15 * cosine(2.0 * turn));
        let radius = down * square + up * hole;
        // Of the eaves, above their corners.
        let arch = 0.5 * 2.4 * (1.0 + cosine(4.0 * turn));
        [radius * c + 3.0 * up, radius * s, 8.0 * (1.0 - down * down) + arch * down * down * down]
    }
}

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

/// A ring-shaped roof with an egg-shaped inner rim that rises and falls. Panels crowd on one side.
pub struct Court;

impl Court {
    /// Rows of panels from the rim to the eaves.
    pub const ROWS: u32 = 9;
    const RINGS: Rings = Rings { meridians: 28, rows: Court::ROWS };

    /// The mesh. Vertex `i` of ring `k`, from 0 at the rim to [`Court::ROWS`] at the eaves, has index
    /// `28 k + i`.
    pub fn mesh() -> Mesh {
        let positions = Court::RINGS.positions(|_, out, turn| {
            let turn = turn + 0.55 * sine(turn) / std::f64::consts::TAU;
            let inner = 6.0 * (1.0 + 0.25 * cosine(turn) - 0.1 * cosine(2.0 * turn));
            let radius = inner + (15.0 - inner) * out;
            let height = 4.0 + 1.2 * cosine(2.0 * turn) * (1.0 - out) - 2.5 * out * out;
            [radius * cosine(turn), radius * sine(turn), height]
        });
        // Counterclockwise seen from above.
        let faces = Court::RINGS.quads().map(|[a, b, c, d]| [a, d, c, b]);
        rounded(Mesh { positions, faces: Ragged::from_iter(faces), ..Mesh::default() })
    }

    /// The vertices of ring `k`.
    pub fn ring(k: u32) -> Range<u32> {
        Court::RINGS.ring(k)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rings_of_the_dome_follow_each_other() {
        let dome = Dome::default();
        let mut next = 0;
        for k in 0..dome.rings() {
            let (first, count) = dome.ring(k);
            assert_eq!(first, next);
            next = first + count;
        }
        assert_eq!(dome.mesh().positions.len(), next as usize);
    }
}
