//! Free-form surfaces as they come from a modeller or a scan, in irregular triangles: a roof with two
//! bulges, a pavilion around a court, a column that widens to a roof.

use super::vault::Random;
use crate::generate::finish::rounded;
use crate::math::{cosine, sine};
use crate::mesh::{Mesh, Point};

/// A surface in rings of triangles around a point or an opening, which follow nothing.
#[derive(Clone, Copy, Debug)]
pub struct FreeForm {
    /// Rows of triangles from the middle to the outer edge.
    rows: usize,
    /// The most vertices of a ring.
    around: usize,
    /// Whether the middle is an opening; else it is a point, and the rings around it grow.
    open: bool,
    /// The point that is `out` of the way, from 0 to 1, to the outer edge, and in the direction `turn`.
    point: fn(out: f64, turn: f64) -> Point,
}

/// Vertices that each ring around a point has more than the one inside it.
const GROWTH: usize = 6;
/// How far vertices are moved over the surface, as a fraction of the distance between them.
const SHIFT: f64 = 0.3;

impl FreeForm {
    /// The roof of a station, 68 m long: two bulges over a plan with a waist, and a free edge that
    /// rises over the entrances.
    pub const STATION: FreeForm = FreeForm { open: false, ..FreeForm::of(18, 84, station) };
    /// A pavilion around a court: an arch that is wide and high on one side, stands on the ground
    /// outside, and ends with a free edge over the court.
    pub const PAVILION: FreeForm = FreeForm::of(12, 84, pavilion);
    /// A column that widens to a roof of 24 m with four raised corners.
    pub const CHALICE: FreeForm = FreeForm::of(20, 60, chalice);

    const fn of(rows: usize, around: usize, point: fn(f64, f64) -> Point) -> FreeForm {
        FreeForm { rows, around, open: true, point }
    }

    /// The mesh, ring by ring from the middle; faces are counterclockwise seen from outside.
    pub fn mesh(&self) -> Mesh {
        let mut random = Random::default();
        let mut shifted = |k: usize| k as f64 + 2.0 * SHIFT * random.next();
        let mut mesh = Mesh::default();
        let mut inner: Vec<u32> = Vec::new();
        for k in 0..=self.rows {
            let count = if self.open { self.around } else { (GROWTH * k).clamp(1, self.around) };
            let first = mesh.positions.len() as u32;
            for j in 0..count {
                let is_edge = k == 0 || k == self.rows;
                let out = if is_edge { k as f64 } else { shifted(k) } / self.rows as f64;
                mesh.positions.push((self.point)(out, shifted(j) / count as f64));
            }
            let outer: Vec<u32> = (first..first + count as u32).collect();
            between(&inner, &outer, &mut mesh);
            inner = outer;
        }
        rounded(mesh)
    }
}

/// Adds the triangles between two rings, of which the inner one may be a point or empty.
fn between(inner: &[u32], outer: &[u32], mesh: &mut Mesh) {
    let [a, b] = [inner, outer].map(<[u32]>::len);
    let sides = if a > 1 { a } else { 0 };
    let (mut i, mut j) = (0, 0);
    while a > 0 && i + j < sides + b {
        // The next side is the one whose middle comes first.
        let is_inner = i < sides && (j == b || (2 * i + 1) * b < (2 * j + 1) * a);
        let [p, q] = [inner[i % a], outer[j % b]];
        if is_inner {
            i += 1;
            mesh.faces.push(&[p, q, inner[i % a]]);
        } else {
            j += 1;
            mesh.faces.push(&[p, q, outer[j % b]]);
        }
    }
}

fn station(out: f64, turn: f64) -> Point {
    let [x, y] = [out * cosine(turn), out * sine(turn)];
    let [xx, yy] = [x * x, y * y];
    let width = 17.0 * (0.62 + 1.3 * xx - 0.7 * xx * xx);
    let rise = 8.0 + 1.5 * x + 16.0 * xx;
    // Around the edge it is highest four times, at the ends and the middles of the sides.
    let lift = xx * xx - 6.0 * xx * yy + yy * yy;
    [34.0 * x, width * y, 4.0 + rise * (1.0 - out * out) + lift]
}

fn pavilion(out: f64, turn: f64) -> Point {
    let [c, s] = [cosine(turn), sine(turn)];
    // The middle line of the arch in plan, and a normal of it.
    let [x, y] = [16.0 * c, 10.5 * s + 3.5 * c * c];
    let across = [10.5 * c - 7.0 * c * s, 16.0 * s];
    let length = (across[0] * across[0] + across[1] * across[1]).sqrt();
    let swell = cosine(turn - 0.06);
    let arc = 0.3 * (1.0 - out);
    let side = (4.7 + 1.2 * swell) * cosine(arc) / length;
    [x + side * across[0], y + side * across[1], (5.4 + 1.8 * swell) * sine(arc)]
}

fn chalice(out: f64, turn: f64) -> Point {
    let square = cosine(4.0 * turn + 0.5);
    let radius = (2.0 + 9.0 * out * (1.25 * out - 0.25)) * (1.0 + 0.08 * out * out * square);
    let edge = out * out * out * (square + 0.5 * cosine(2.0 * turn));
    [radius * cosine(turn), radius * sine(turn), 9.0 * out * (1.9 - 0.9 * out) + edge]
}
