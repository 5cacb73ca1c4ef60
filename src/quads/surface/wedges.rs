//! Sharp wedges between features. An angle below 45 degrees rounds to no quarter turn at all, and no
//! grid could follow both of its sides; the field inside is turned so that the wedge becomes one
//! corner of a quad.

use crate::math::{Vec3, angle_between, cosine, sine};
use crate::quads::{Side, Triangulation};
use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Wedges below this angle, in radians, are opened: 55 degrees.
const SHARP: f64 = 55.0 / 360.0 * TAU;

/// A wedge at a vertex: its triangles, counterclockwise, and the vectors along its sides.
struct Wedge {
    triangles: Vec<usize>,
    sides: [Vec3<f64>; 2],
    angle: f64,
}

/// Returns the direction of the field in the triangles of sharp wedges within the length `size` of
/// their vertex, `#T`.
pub(super) fn wedges(surface: &Triangulation, size: f64) -> Vec<Option<Vec3<f64>>> {
    let mut directions = vec![None; surface.triangles.len()];
    for side in surface.sides().filter(|&side| surface.is_feature(side)) {
        let Some(wedge) = wedge(surface, side) else { continue };
        if wedge.angle < SHARP && wedge.angle > 0.0 {
            open(surface, side, &wedge, size, &mut directions);
        }
    }
    directions
}

/// The wedge that begins at a feature side, around its first vertex; `None` if it does not end at a
/// feature.
fn wedge(surface: &Triangulation, first: Side) -> Option<Wedge> {
    let (mut here, mut sum) = (first, 0.0);
    let mut triangles = Vec::new();
    loop {
        let ahead = surface.along(here);
        let last = Side { triangle: here.triangle, side: (here.side + 2) % 3 };
        let back = -surface.along(last);
        sum += angle_between(ahead, back).unwrap_or(0.0);
        triangles.push(here.triangle);
        if surface.is_feature(last) {
            let sides = [surface.along(first), back];
            return Some(Wedge { triangles, sides, angle: sum });
        }
        here = surface.across(last)?;
    }
}

/// Turns the field from one side of the wedge to the other by its angle less a quarter turn.
fn open(
    surface: &Triangulation,
    first: Side,
    wedge: &Wedge,
    size: f64,
    directions: &mut [Option<Vec3<f64>>],
) {
    let apex = surface.at(first.triangle, first.side);
    let [Some(a), Some(b)] = wedge.sides.map(|side| side.length_and_direction().1) else { return };
    let mut queue = wedge.triangles.clone();
    let mut seen: BTreeSet<usize> = queue.iter().copied().collect();
    while let Some(t) = queue.pop() {
        let centre = (surface.at(t, 0) + surface.at(t, 1) + surface.at(t, 2)) * (1.0 / 3.0) - apex;
        let (distance, Some(d)) = centre.length_and_direction() else { continue };
        if distance > size && !wedge.triangles.contains(&t) {
            continue;
        }
        let [from_a, from_b] = [a, b].map(|side| angle_between(side, d).unwrap_or(0.0));
        let part = from_a / (from_a + from_b).max(1e-9);
        let turn = part * (wedge.angle - FRAC_PI_2) / TAU;
        let (_, Some(normal)) = surface.area_vector(t).length_and_direction() else { continue };
        let flat = a - normal * a.dot(normal);
        directions[t] = Some(flat * cosine(turn) + normal.cross(flat) * sine(turn));
        for side in (0..3).map(|side| Side { triangle: t, side }) {
            let Some(next) = surface.across(side) else { continue };
            if !surface.is_feature(side) && seen.insert(next.triangle) {
                queue.push(next.triangle);
            }
        }
    }
}
