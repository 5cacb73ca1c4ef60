//! Surfaces around the z axis, open at the bottom and the top: a vase, a tower, a lantern.

use crate::generate::finish::rounded;
use crate::generate::quads::Rings;
use crate::math::{cosine, sine};
use crate::mesh::{Mesh, Ragged};
use std::ops::Range;

/// A vase, open at the bottom and the top. Its belly is pressed in from two sides, its neck is
/// oval.
pub struct Vase;

impl Vase {
    /// Rows of triangles from the ground up.
    pub const ROWS: u32 = 30;
    const RINGS: Rings = Rings { meridians: 36, rows: Vase::ROWS };

    /// The mesh. Vertex `i` of ring `k`, counted from the x axis towards the y axis and from the
    /// ground up, has index `36 k + i`. Odd rings are turned by half a step.
    pub fn mesh() -> Mesh {
        let rings = Vase::RINGS;
        let half_step = 0.5 / f64::from(rings.meridians);
        let positions = rings.positions(|k, up, turn| {
            // Widest below the middle, narrowest at the neck; the rim flares.
            let flare = (up - 0.72).max(0.0);
            let radius = 1.75 + 1.05 * sine(0.9 * up - 0.02) + 9.0 * flare * flare;
            let oval = 0.16 * sine(0.55 * up - 0.28) * up.min(0.2) / 0.2;
            let turn = if is_odd(k) { turn + half_step } else { turn };
            let [x, y] = [(1.0 + oval) * radius, (1.0 - oval) * radius];
            [x * cosine(turn), y * sine(turn), 10.0 * up]
        });
        // The vertices of an odd ring lie between those of the even ones.
        let triangles = rings.quads().flat_map(|[a, b, c, d]| {
            if is_odd(a / rings.meridians) {
                [[a, b, c], [a, c, d]]
            } else {
                [[a, b, d], [b, c, d]]
            }
        });
        rounded(Mesh { positions, faces: Ragged::from_iter(triangles), ..Mesh::default() })
    }

    /// The vertices of ring `k`, from 0 on the ground to [`Vase::ROWS`] at the rim.
    pub fn ring(k: u32) -> Range<u32> {
        Vase::RINGS.ring(k)
    }
}

fn is_odd(k: u32) -> bool {
    k % 2 == 1
}

/// A tower, open at the bottom and the top, whose plan is a rounded triangle that twists on the way
/// up, and whose rings of edges rise and fall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tower {
    /// Panels around it.
    pub meridians: u32,
    /// Panels from the ground up.
    pub rows: u32,
}

impl Default for Tower {
    fn default() -> Self {
        Tower { meridians: 48, rows: 28 }
    }
}

impl Tower {
    /// The mesh. Vertex `i` of ring `k`, counted from the x axis towards the y axis and from the
    /// ground up, has index `k * meridians + i`.
    pub fn mesh(&self) -> Mesh {
        let rings = self.rings();
        let positions = rings.positions(|_, up, turn| {
            // The foot is level and round.
            let off_ground = up.min(0.1) / 0.1;
            let radius = 7.6 + 1.6 * cosine(0.7 * up + 0.05);
            let plan = 1.0 + 0.1 * off_ground * cosine(3.0 * turn - 0.5 * up);
            let wave = 0.55 * off_ground * sine(2.0 * turn + 1.3 * up);
            let [x, y] = [radius * plan * cosine(turn), radius * plan * sine(turn)];
            [x, y, 44.0 * up + wave]
        });
        rounded(Mesh { positions, faces: rings.faces(), ..Mesh::default() })
    }

    /// The vertices of ring `k`, from 0 on the ground to `rows` at the top.
    pub fn ring(&self, k: u32) -> Range<u32> {
        self.rings().ring(k)
    }

    fn rings(&self) -> Rings {
        Rings { meridians: self.meridians, rows: self.rows }
    }
}

/// A lantern, open at the bottom and the top, whose profile swells and narrows.
pub struct Lantern;

impl Lantern {
    /// Panels from the ground up.
    pub const ROWS: u32 = 26;
    const RINGS: Rings = Rings { meridians: 48, rows: Lantern::ROWS };

    /// The mesh. Vertex `i` of ring `k`, counted from the x axis towards the y axis and from the
    /// ground up, has index `48 k + i`.
    pub fn mesh() -> Mesh {
        let rings = Lantern::RINGS;
        let positions = rings.positions(|_, up, turn| {
            // Widest at a third of the height, narrowest below the rim, which flares.
            let radius = 8.0 + 2.6 * sine(0.95 * up - 0.08) - up * up;
            [radius * cosine(turn), radius * sine(turn), 18.0 * up]
        });
        rounded(Mesh { positions, faces: rings.faces(), ..Mesh::default() })
    }

    /// The vertices of ring `k`, from 0 on the ground to [`Lantern::ROWS`] at the rim.
    pub fn ring(k: u32) -> Range<u32> {
        Lantern::RINGS.ring(k)
    }
}
