//! A dome with an oval hole.

use crate::math::{cosine, sine};
use crate::mesh::{Mesh, Point};

/// A dome over a square with round corners, open on its four sides, with an oval hole off centre.
/// Half of the meridians end partway up, in a row of pentagons.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dome {
    /// Meridians around the hole; twice as many start at the eaves.
    pub meridians: usize,
    /// Rows of quads below and above the row of pentagons.
    pub rows: [usize; 2],
    /// Half the width of the square.
    pub half_width: f64,
    /// Mean radius of the hole.
    pub hole: f64,
    /// How much longer the hole is along x and shorter along y, as a fraction of `hole`.
    pub oval: f64,
    /// Distance along x from the centre of the square to the centre of the hole.
    pub shift: f64,
    /// Height of the hole above the corners of the eaves.
    pub rise: f64,
    /// Height of the eaves at the middle of a side above the corners.
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
    /// The mesh. Vertices are numbered ring by ring from the eaves up, see [`Dome::ring`].
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
    fn point(&self, turn: f64, up: f64) -> Point {
        let (c, s) = (cosine(turn), sine(turn));
        let (cc, ss) = (c * c, s * s);
        // The curve `x^4 + y^4 = half_width^4`, a square with round corners.
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
