//! A face in relief, of uneven triangles.

use crate::generate::finish::rounded;
use crate::math::{cosine, sine};
use crate::mesh::{Mesh, Point, Ragged};

/// Rings of triangles around the middle.
const RINGS: u32 = 30;

/// A bump of the face: its position in x and z, its widths along x and z, and its height.
type Bump = ([f64; 2], [f64; 2], f64);

/// Bumps on the middle line, and bumps on both sides of it.
const MIDDLE: [Bump; 6] = [
    // Nose: the tip and the bridge.
    ([0.0, -0.45], [0.7, 0.75], 0.85),
    ([0.0, 0.45], [0.5, 1.0], 0.5),
    // Lips, the line between them, chin, forehead.
    ([0.0, -1.75], [0.85, 0.32], 0.42),
    ([0.0, -1.78], [1.0, 0.10], -0.16),
    ([0.0, -3.0], [0.8, 0.6], 0.45),
    ([0.0, 2.5], [2.0, 1.2], 0.25),
];
const SIDES: [Bump; 4] = [
    // Eye sockets, eyeballs, brows, cheekbones.
    ([1.15, 0.75], [0.75, 0.5], -0.75),
    ([1.12, 0.70], [0.42, 0.28], 0.42),
    ([1.15, 1.4], [1.0, 0.32], 0.30),
    ([1.7, -0.35], [0.8, 0.7], 0.28),
];

/// A mask that leans back: the front of an egg with a nose, brows, eyes, lips and a chin. It is
/// open at the back, and its triangles are uneven. Vertices are ring by ring from the middle.
pub fn mask() -> Mesh {
    let mut positions = vec![point(0.0, 0.0)];
    for ring in 1..=RINGS {
        for i in 0..6 * ring {
            // The rim stays even.
            let jitter = if ring < RINGS { 0.5 } else { 0.0 };
            let [a, b] = [0, 1].map(|k| jitter * scattered(ring, i, k));
            let out = (f64::from(ring) + a) / f64::from(RINGS);
            positions.push(point(out, (f64::from(i) + b) / f64::from(6 * ring)));
        }
    }
    let mut faces = Ragged::new();
    for ring in 0..RINGS {
        for side in 0..6 {
            // One of six sectors, with `ring` edges inside and one more outside.
            let inner = |k: u32| vertex(ring, side * ring + k);
            let outer = |k: u32| vertex(ring + 1, side * (ring + 1) + k);
            for k in 0..=ring {
                faces.push(&[inner(k), outer(k), outer(k + 1)]);
                if k < ring {
                    faces.push(&[inner(k), outer(k + 1), inner(k + 1)]);
                }
            }
        }
    }
    rounded(Mesh { positions, faces, ..Mesh::default() })
}

/// The point at radius `out`, from 0 in the middle to 1 on the rim, in a direction in turns.
fn point(out: f64, direction: f64) -> Point {
    let [width, height, depth] = [3.1, 4.2, 3.4];
    let tilt = 0.25 * out;
    let (across, along) = (sine(tilt), cosine(tilt));
    // The jaw is narrower than the skull.
    let up = across * sine(direction);
    let x = width * across * cosine(direction) * (1.0 + 0.16 * up);
    let z = height * up;
    // The relief fades out towards the back.
    let front = along.clamp(0.0, 0.5) * 2.0;
    posed([x, -(depth * along + front * relief(x, z)), z])
}

/// Leans the point back about the x axis, then turns it about the z axis from -y towards x.
fn posed([x, y, z]: Point) -> Point {
    let [turn, lean] = [0.05, 0.07].map(|turns| [cosine(turns), sine(turns)]);
    let [y, z] = [lean[0] * y + lean[1] * z, lean[0] * z - lean[1] * y];
    [turn[0] * x - turn[1] * y, turn[1] * x + turn[0] * y, z]
}

/// Index of vertex `i` of a ring, modulo its length.
fn vertex(ring: u32, i: u32) -> u32 {
    if ring == 0 { 0 } else { 1 + 3 * ring * (ring - 1) + i % (6 * ring) }
}

/// A pseudo-random number from -1/2 to 1/2.
fn scattered(ring: u32, i: u32, k: u32) -> f64 {
    let mixed = (ring * 7919 + i * 104_729 + k * 1_299_709) % 1009;
    f64::from(mixed) / 1009.0 - 0.5
}

fn relief(x: f64, z: f64) -> f64 {
    let bump = |x: f64, (at, widths, height): &Bump| {
        let (dx, dz) = ((x - at[0]) / widths[0], (z - at[1]) / widths[1]);
        let far = 1.0 + dx * dx + dz * dz;
        height / (far * far)
    };
    let middle: f64 = MIDDLE.iter().map(|of| bump(x, of)).sum();
    middle + SIDES.iter().map(|of| bump(x, of) + bump(-x, of)).sum::<f64>()
}
