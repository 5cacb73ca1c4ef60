//! Shapes that stay in their place. Their rest points depend on nothing but how many there are, so
//! that the account of one vertex can know those of the others.

use super::{Shape, Vertex, in_turn_or_back, turned};
use crate::random::{Points, Random, size};
use shape_up::math::Vec3;
use std::ops::Range;

/// See [`super::shapes`].
pub(super) fn shapes(id: &str) -> Option<Vec<Shape>> {
    let shapes = match id {
        "on-curve" => vec![
            Shape {
                rest: |_, n| ring(n),
                sample: |random, rest| match rest.len() {
                    // A corner turns by more than 45 degrees.
                    ..8 => rest.to_vec(),
                    n => rest.iter().map(|_| between(random, rest, 0..n)).collect(),
                },
                residual: |v, rest| match rest.len() {
                    ..8 => off(v, |i, _| rest[i]),
                    n => off(v, |_, v| closest_on(rest, 0..n, v)),
                },
                relabellings: in_turn_or_back,
                closest: |_, v, vertex| match vertex.of {
                    ..8 => vertex.rest,
                    n => closest_on(&ring(n), 0..n, v),
                },
                ..Shape::ANY
            },
            Shape {
                params: r#"{ "corners": 180, "closed": "yes" }"#,
                rest: |_, n| ring(n),
                sample: |random, rest| {
                    rest.iter().map(|_| between(random, rest, 0..rest.len())).collect()
                },
                residual: |v, rest| off(v, |_, v| closest_on(rest, 0..rest.len(), v)),
                relabellings: in_turn_or_back,
                closest: |_, v, vertex| closest_on(&ring(vertex.of), 0..vertex.of, v),
                ..Shape::ANY
            },
            Shape {
                params: r#"{ "corners": 80, "closed": "no" }"#,
                rest: |_, n| bent(n),
                sample: |random, rest| {
                    let pieces = (0..rest.len()).map(|i| piece(i, rest.len()));
                    pieces.map(|piece| between(random, rest, piece)).collect()
                },
                residual: |v, rest| off(v, |i, v| closest_on(rest, piece(i, rest.len()), v)),
                relabellings: |_, n| vec![(0..n).rev().collect()],
                closest: |_, v, vertex| {
                    closest_on(&bent(vertex.of), piece(vertex.index, vertex.of), v)
                },
                ..Shape::ANY
            },
        ],
        _ => return None,
    };
    Some(shapes)
}

/// The corners of a regular polygon in space.
fn ring(n: usize) -> Points {
    let (e, f) = (Vec3::new(0.8, 0.0, 0.6), Vec3::new(-0.48, 0.6, 0.64));
    let vertices = (0..n).map(|index| Vertex { index, of: n, rest: e });
    vertices.map(|vertex| Vec3::new(0.3, 0.1, -0.2) + turned(e, f, vertex)).collect()
}

/// Two sides of a rectangle that is not quite flat.
fn bent(n: usize) -> Points {
    let middle = n / 2;
    (0..n)
        .map(|i| {
            let (x, y) = (i.min(middle) as f64, i.saturating_sub(middle) as f64);
            Vec3::new(x, 1.5 * y, 0.2 * ((i * i) % 3) as f64) * (2.0 / n as f64)
        })
        .collect()
}

/// The segments on which vertex `i` of [`bent`] glides; none where it stays.
fn piece(i: usize, n: usize) -> Range<usize> {
    let middle = n / 2;
    match i {
        0 => 0..0,
        i if i == middle || i == n - 1 => i..i,
        i if i < middle => 0..middle,
        _ => middle..n - 1,
    }
}

/// A point on one of the segments, which begin at these points.
fn between(random: &mut Random, points: &[Vec3<f64>], segments: Range<usize>) -> Vec3<f64> {
    let n = segments.len();
    let k =
        segments.start + (((random.uniform() + 1.0) / 2.0 * n as f64) as usize).min(n.max(1) - 1);
    if n == 0 {
        return points[k];
    }
    let t = (random.uniform() + 1.0) / 2.0;
    points[k] * (1.0 - t) + points[(k + 1) % points.len()] * t
}

/// The closest point to `v` on the segments, or the point where they would begin if there are none.
fn closest_on(points: &[Vec3<f64>], segments: Range<usize>, v: Vec3<f64>) -> Vec3<f64> {
    let start = points[segments.start];
    let closest = segments.map(|k| {
        let (a, b) = (points[k], points[(k + 1) % points.len()]);
        let t = (v - a).dot(b - a) / (b - a).length_squared();
        a + (b - a) * t.clamp(0.0, 1.0)
    });
    closest.fold(start, |best, p| if (v - p).length() < (v - best).length() { p } else { best })
}

/// The greatest distance of a vertex from where it should be.
fn off(v: &[Vec3<f64>], closest: impl Fn(usize, Vec3<f64>) -> Vec3<f64>) -> f64 {
    let off = v.iter().enumerate().map(|(i, v)| (*v - closest(i, *v)).length());
    off.fold(0.0, f64::max) / size(v)
}
