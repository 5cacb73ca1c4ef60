//! Meshes of the examples, computed: a canopy, a dome with a hole, a hypar. Lengths are in metres, z
//! points up. Only `+ - * / sqrt` are used, so every machine makes the same bits.

use super::{Mesh, Point, Ragged};
use crate::math::{cosine, sine};

/// A canopy on four feet: a vault of quads over a plan whose sides are drawn in, with a wave across.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Canopy {
    /// Panels along x and along y.
    pub panels: [usize; 2],
    /// Distances of the feet along x and along y.
    pub span: [f64; 2],
    /// Height of the middle of each side over the feet.
    pub rise: f64,
    /// Height of the middle of the vault over the middle of its sides.
    pub crown: f64,
    /// How far the middle of each side is drawn in, as a part of half the span.
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
    /// The mesh, `(panels[0] + 1) * (panels[1] + 1)` vertices. Vertex `(i, j)`, counted along x and
    /// y, is number `j * (panels[0] + 1) + i`.
    pub fn mesh(&self) -> Mesh {
        grid(self.panels, |x, y| {
            let (xx, yy) = (x * x, y * y);
            // One at the middle, zero at the feet.
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

/// A dome over a square with round corners, open on its four sides, with an oval hole away from its
/// middle. Half of the meridians end on the way up, in a row of pentagons.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dome {
    /// Meridians round the hole; twice as many start at the eaves.
    pub meridians: usize,
    /// Rows of quads below and above the row of pentagons.
    pub rows: [usize; 2],
    /// Half the width of the square.
    pub half_width: f64,
    /// Mean radius of the hole.
    pub hole: f64,
    /// How much longer than this the hole is along x, and shorter along y, as a part of it.
    pub oval: f64,
    /// How far the middle of the hole is from the middle of the square, along x.
    pub shift: f64,
    /// Height of the hole over the corners of the eaves.
    pub rise: f64,
    /// Height of the eaves at the middle of a side over those at the corners.
    pub arch: f64,
}

impl Default for Dome {
    fn default() -> Self {
        Dome {
            meridians: 24,
            rows: [5, 3],
            half_width: 14.0,
            hole: 3.2,
            oval: 0.15,
            shift: 3.0,
            rise: 8.0,
            arch: 2.4,
        }
    }
}

impl Dome {
    /// The mesh. Vertices are numbered ring by ring from the eaves up, as [`Dome::ring`] says.
    pub fn mesh(&self) -> Mesh {
        let mut mesh = Mesh::default();
        for k in 0..self.rings() {
            let (first, count) = self.ring(k);
            debug_assert_eq!(first as usize, mesh.positions.len());
            let up = k as f64 / (self.rings() - 1) as f64;
            mesh.positions
                .extend((0..count).map(|i| self.point(f64::from(i) / f64::from(count), up)));
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

    /// How many rings of vertices there are; the first is the eaves, the last goes round the hole.
    pub fn rings(&self) -> usize {
        self.rows[0] + self.rows[1] + 2
    }

    /// The first vertex of ring `k`, and how many vertices it has. They go round from the x axis
    /// towards the y axis.
    pub fn ring(&self, k: usize) -> (u32, u32) {
        let few = self.meridians as u32;
        let doubled = self.rows[0] + 1;
        let before = 2 * few * k.min(doubled) as u32 + few * k.saturating_sub(doubled) as u32;
        (before, if k < doubled { 2 * few } else { few })
    }

    /// A point of the surface: `turn` from 0 to 1 goes round, `up` from 0 at the eaves to 1 at the
    /// hole.
    fn point(&self, turn: f64, up: f64) -> Point {
        let (c, s) = (cosine(turn), sine(turn));
        let (cc, ss) = (c * c, s * s);
        // The curve x^4 + y^4 = 1, a square with round corners.
        let square = self.half_width / (cc * cc + ss * ss).sqrt().sqrt();
        let down = 1.0 - up;
        let hole = self.hole * (1.0 + self.oval * cosine(2.0 * turn));
        let radius = down * square + up * hole;
        let arch = 0.5 * self.arch * (1.0 + cosine(4.0 * turn));
        [
            radius * c + self.shift * up,
            radius * s,
            self.rise * (1.0 - down * down) + arch * down * down * down,
        ]
    }
}

/// A hyperbolic paraboloid over a square, ruled along its two families of straight lines, that sags
/// in waves between its straight sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hypar {
    /// Panels along each side.
    pub panels: usize,
    /// Length of a side in plan.
    pub span: f64,
    /// Height of the two high corners over the two low ones.
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
    /// The mesh, `(panels + 1)^2` vertices. Vertex `(i, j)`, counted along x and y, is number
    /// `j * (panels + 1) + i`.
    pub fn mesh(&self) -> Mesh {
        let half = 0.5 * self.span;
        grid([self.panels; 2], |x, y| {
            let inside = (1.0 - x * x) * (1.0 - y * y);
            let wave = 0.6 + 0.4 * sine(0.75 * (x - y)) + 0.4 * sine(0.5 * x + 0.9 * y);
            // Sideways too: lines that are straight in plan already would have less to do.
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

/// A grid of quads over the square from -1 to 1 in x and y, seen from above counter-clockwise.
fn grid(panels: [usize; 2], point: impl Fn(f64, f64) -> Point) -> Mesh {
    let [nx, ny] = panels;
    let at = |k: usize, n: usize| (2.0 * k as f64 - n as f64) / n as f64;
    let positions = (0..=ny).flat_map(|j| (0..=nx).map(move |i| (i, j)));
    let positions = positions.map(|(i, j)| point(at(i, nx), at(j, ny))).collect();
    let row = nx + 1;
    let quads = (0..ny).flat_map(|j| (0..nx).map(move |i| j * row + i));
    let faces = quads.map(|v| [v, v + 1, v + row + 1, v + row].map(|v| v as u32));
    Mesh { positions, faces: Ragged::from_iter(faces), ..Mesh::default() }
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
