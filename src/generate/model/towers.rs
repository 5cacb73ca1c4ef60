//! Surfaces around the z axis, open at the bottom and the top: a vase, a tower, a lantern.

use super::finish::rounded;
use crate::generate::quads::Rings;
use crate::math::{cosine, sine};
use crate::mesh::{Mesh, Ragged};
use std::ops::Range;

/// A vase, open at the bottom and the top. Its belly is pressed in from two sides, its neck is
/// oval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vase {
    /// Vertices of each ring.
    pub meridians: u32,
    /// Rows of triangles from the ground up.
    pub rows: u32,
    /// Height of the rim above the ground.
    pub height: f64,
    /// Ovality of the neck, and of the belly in the other direction, as a fraction of the radius.
    pub ovality: f64,
}

impl Default for Vase {
    fn default() -> Self {
        Vase { meridians: 36, rows: 30, height: 10.0, ovality: 0.16 }
    }
}

impl Vase {
    /// The mesh. Vertex `i` of ring `k`, counted from the x axis towards the y axis and from the
    /// ground up, has index `k * meridians + i`. Odd rings are turned by half a step.
    pub fn mesh(&self) -> Mesh {
        let rings = self.rings();
        let half_step = 0.5 / f64::from(self.meridians);
        let positions = rings.positions(|k, up, turn| {
            // Widest below the middle, narrowest at the neck; the rim flares.
            let flare = (up - 0.72).max(0.0);
            let radius = 1.75 + 1.05 * sine(0.9 * up - 0.02) + 9.0 * flare * flare;
            let oval = self.ovality * sine(0.55 * up - 0.28) * up.min(0.2) / 0.2;
            let turn = if is_odd(k) { turn + half_step } else { turn };
            let [x, y] = [(1.0 + oval) * radius, (1.0 - oval) * radius];
            [x * cosine(turn), y * sine(turn), self.height * up]
        });
        // The vertices of an odd ring lie between those of the even ones.
        let triangles = rings.quads().flat_map(|[a, b, c, d]| {
            if is_odd(a / self.meridians) { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] }
        });
        rounded(Mesh { positions, faces: Ragged::from_iter(triangles), ..Mesh::default() })
    }

    /// The vertices of ring `k`, from 0 on the ground to `rows` at the rim.
    pub fn ring(&self, k: u32) -> Range<u32> {
        self.rings().ring(k)
    }

    fn rings(&self) -> Rings {
        Rings { meridians: self.meridians, rows: self.rows }
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
    /// Height.
    pub height: f64,
    /// Deviation of the plan from a circle, as a fraction of its radius.
    pub bulge: f64,
    /// Amplitude of the rings in height.
    pub wave: f64,
}

impl Default for Tower {
    fn default() -> Self {
        Tower { meridians: 48, rows: 28, height: 44.0, bulge: 0.1, wave: 0.55 }
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
            let plan = 1.0 + self.bulge * off_ground * cosine(3.0 * turn - 0.5 * up);
            let wave = self.wave * off_ground * sine(2.0 * turn + 1.3 * up);
            let [x, y] = [radius * plan * cosine(turn), radius * plan * sine(turn)];
            [x, y, self.height * up + wave]
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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lantern {
    /// Panels around it.
    pub meridians: u32,
    /// Panels from the ground up.
    pub rows: u32,
    /// Height of the rim above the ground.
    pub height: f64,
    /// Mean radius.
    pub radius: f64,
    /// Amplitude of the radius.
    pub swelling: f64,
}

impl Default for Lantern {
    fn default() -> Self {
        Lantern { meridians: 48, rows: 26, height: 18.0, radius: 8.0, swelling: 2.6 }
    }
}

impl Lantern {
    /// The mesh. Vertex `i` of ring `k`, counted from the x axis towards the y axis and from the
    /// ground up, has index `k * meridians + i`.
    pub fn mesh(&self) -> Mesh {
        let rings = self.rings();
        let positions = rings.positions(|_, up, turn| {
            // Widest at a third of the height, narrowest below the rim, which flares.
            let radius = self.radius + self.swelling * sine(0.95 * up - 0.08) - up * up;
            [radius * cosine(turn), radius * sine(turn), self.height * up]
        });
        rounded(Mesh { positions, faces: rings.faces(), ..Mesh::default() })
    }

    /// The vertices of ring `k`, from 0 on the ground to `rows` at the rim.
    pub fn ring(&self, k: u32) -> Range<u32> {
        self.rings().ring(k)
    }

    fn rings(&self) -> Rings {
        Rings { meridians: self.meridians, rows: self.rows }
    }
}
