//! The surface between two curves: straight lines from each point of one to a point of the other.

use super::{SpanCurve, SpanError, evenly, length_of};
use crate::generate::quads::{check_face_count, quads};
use crate::math::{Vec3, twice_vector_area};
use crate::mesh::{Mesh, Point};

/// Curves whose points are nearer to each other than this fraction of their length are the same.
const NO_LENGTH: f64 = 1e-9;
/// Number of points, and of shifts, among which the pairing of closed curves is first looked for.
const COARSE: usize = 1000;

/// Quads of about `size` between two open or two closed curves, counterclockwise seen from `up`.
/// Curves with equally many points are joined point by point; else both get equal steps, and keep
/// their corners. The directions of curves and the first points of closed ones do not matter: the
/// pairing with the shortest connections is used.
///
/// # Errors
/// A size that is not a positive length, twice the same curve, only one closed curve, or too many faces.
pub fn loft(
    first: &SpanCurve,
    second: &SpanCurve,
    size: f64,
    up: Point,
) -> Result<Mesh, SpanError> {
    if !(size > 0.0 && size.is_finite()) {
        return Err(SpanError::Size(size));
    }
    if first.closed != second.closed {
        return Err(SpanError::OneClosed);
    }
    let closed = first.closed;
    let rings = [first.ring(), second.ring()];
    let same = rings[0].len() == rings[1].len() && rings[0].len() > 2;
    let along = match same {
        true => rings[0].len() - 1,
        false => {
            let mean = 0.5 * (length_of(&rings[0]) + length_of(&rings[1]));
            ((mean / size).round() as usize).max(if closed { 3 } else { 1 })
        }
    };
    check_face_count(along as f64).map_err(SpanError::TooManyFaces)?;
    let sides = [(first, &rings[0]), (second, &rings[1])].map(|(curve, ring)| {
        let corners: Vec<usize> = curve.corners().into_iter().map(|(k, _)| k).collect();
        let mut points = if same { ring.clone() } else { evenly(ring, &corners, along).0 };
        points.truncate(along + usize::from(!closed));
        points
    });
    let other = joined(&sides[0], &sides[1], closed);
    let distances = sides[0].iter().zip(&other).map(|(&a, &b)| (b - a).length());
    let mean = distances.sum::<f64>() / other.len() as f64;
    if mean <= NO_LENGTH * length_of(&rings[0]) {
        return Err(SpanError::Same);
    }
    let across = (mean / size).round().max(1.0);
    check_face_count(along as f64 * across).map_err(SpanError::TooManyFaces)?;
    let rows = across as usize;
    let mut mesh = Mesh::default();
    for row in 0..=rows {
        let part = row as f64 / rows as f64;
        let point = |(&a, &b): (&Vec3<f64>, &Vec3<f64>)| match row {
            0 => Point::from(a),
            row if row == rows => Point::from(b),
            _ => Point::from(a * (1.0 - part) + b * part),
        };
        mesh.positions.extend(sides[0].iter().zip(&other).map(point));
    }
    mesh.faces = quads([along, rows], closed).collect();
    turn_up(&mut mesh, up);
    Ok(mesh)
}

/// The points of the second curve, reordered to minimise the sum of squared distances to the first. Of
/// closed curves with very many points the best order is looked for among few, then refined.
fn joined(first: &[Vec3<f64>], second: &[Vec3<f64>], closed: bool) -> Vec<Vec3<f64>> {
    let n = second.len();
    let index = |k: usize, (shift, back): (usize, bool)| {
        let k = (k + shift) % n;
        if back { n - 1 - k } else { k }
    };
    let best = |orders: &mut dyn Iterator<Item = (usize, bool)>, step: usize| {
        let distance = |order: (usize, bool)| -> f64 {
            let some = (0..n).step_by(step);
            some.map(|k| (second[index(k, order)] - first[k]).length_squared()).sum()
        };
        let all = orders.map(|order| (order, distance(order)));
        all.min_by(|(_, a), (_, b)| a.total_cmp(b)).map_or((0, false), |(order, _)| order)
    };
    let step = if closed { n.div_ceil(COARSE) } else { 1 };
    let shifts = (0..if closed { n } else { 1 }).step_by(step);
    let mut order = best(&mut shifts.flat_map(|shift| [(shift, false), (shift, true)]), step);
    if step > 1 {
        let (shift, back) = order;
        let near = (shift + n - step..=shift + n + step).map(|shift| (shift % n, back));
        order = best(&mut near.into_iter(), 1);
    }
    (0..n).map(|k| second[index(k, order)]).collect()
}

/// Reverses all faces if their total area, seen from `up`, is negative.
pub(super) fn turn_up(mesh: &mut Mesh, up: Point) {
    let area = |face: &[u32]| {
        let corners = face.iter().map(|&v| Vec3::from(mesh.positions[v as usize]));
        twice_vector_area(corners).dot(Vec3::from(up))
    };
    if mesh.faces.iter().map(area).sum::<f64>() < 0.0 {
        let turned = mesh.faces.iter().map(|face| face.iter().rev().copied().collect::<Vec<_>>());
        mesh.faces = turned.collect();
    }
}
