//! Shapes with a fixed position. Their rest points depend only on the number of points, so that the
//! description of one vertex can use the other rest points.

use super::{Shape, Vertex, in_turn_or_back, turned};
use crate::support::random::{Points, Random, size};
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
        "on-surface" => vec![Shape {
            rest: |_, n| zigzag(n),
            sample: |random, rest| rest.iter().map(|_| on_strip(random, rest)).collect(),
            residual: |v, rest| off(v, |_, v| closest_on_strip(rest, v)),
            relabellings: |_, n| vec![(0..n).rev().collect()],
            closest: |_, v, vertex| closest_on_strip(&zigzag(vertex.of), v),
            ..Shape::ANY
        }],
        _ => return None,
    };
    Some(shapes)
}

/// Corners of a regular polygon in space.
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

/// The segments on which vertex `i` of [`bent`] glides; none if it is fixed.
fn piece(i: usize, n: usize) -> Range<usize> {
    let middle = n / 2;
    match i {
        0 => 0..0,
        i if i == middle || i == n - 1 => i..i,
        i if i < middle => 0..middle,
        _ => middle..n - 1,
    }
}

/// A random point on one of the segments, which begin at these points.
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

/// Closest point to `v` on the segments, or their first point if there are none.
fn closest_on(points: &[Vec3<f64>], segments: Range<usize>, v: Vec3<f64>) -> Vec3<f64> {
    let start = points[segments.start];
    let closest = segments.map(|k| {
        let (a, b) = (points[k], points[(k + 1) % points.len()]);
        let t = (v - a).dot(b - a) / (b - a).length_squared();
        a + (b - a) * t.clamp(0.0, 1.0)
    });
    closest.fold(start, |best, p| if (v - p).length() < (v - best).length() { p } else { best })
}

/// Greatest distance of a vertex from its closest point, relative to the size.
fn off(v: &[Vec3<f64>], closest: impl Fn(usize, Vec3<f64>) -> Vec3<f64>) -> f64 {
    let off = v.iter().enumerate().map(|(i, v)| (*v - closest(i, *v)).length());
    off.fold(0.0, f64::max) / size(v)
}

/// A triangle strip between two rows of points at varying heights.
fn zigzag(n: usize) -> Points {
    (0..n)
        .map(|i| {
            let (across, up) = (0.8 * n as f64 * (i % 2) as f64, 0.3 * ((i * i) % 5) as f64);
            Vec3::new(0.2, -0.3, 0.1) + Vec3::new(i as f64, across, up) * (1.5 / n as f64)
        })
        .collect()
}

/// Corners of the triangles: three consecutive points, the last one repeated if there are fewer.
fn triangles(rest: &[Vec3<f64>]) -> impl Iterator<Item = [Vec3<f64>; 3]> {
    let last = rest.len() - 1;
    (0..(rest.len().max(3) - 2)).map(move |k| [k, k + 1, k + 2].map(|k| rest[k.min(last)]))
}

/// A random point of the strip.
fn on_strip(random: &mut Random, rest: &[Vec3<f64>]) -> Vec3<f64> {
    let all: Vec<_> = triangles(rest).collect();
    let k = ((random.uniform() + 1.0) / 2.0 * all.len() as f64) as usize;
    let [a, b, c] = all[k.min(all.len() - 1)];
    let [s, t] = [random.uniform(), random.uniform()].map(|x| (x + 1.0) / 2.0);
    let (s, t) = if s + t > 1.0 { (1.0 - s, 1.0 - t) } else { (s, t) };
    a * (1.0 - s - t) + b * s + c * t
}

/// Closest of the feet of the perpendiculars to the triangles and their sides.
fn closest_on_strip(rest: &[Vec3<f64>], v: Vec3<f64>) -> Vec3<f64> {
    let mut best = rest[0];
    let mut consider = |p: Vec3<f64>| {
        if (v - p).length() < (v - best).length() {
            best = p;
        }
    };
    for [a, b, c] in triangles(rest) {
        for side in [[a, b], [b, c], [c, a]].iter().filter(|[a, b]| a != b) {
            consider(closest_on(side, 0..1, v));
        }
        let normal = (b - a).cross(c - a);
        if normal.length_squared() > 0.0 {
            let foot = v - normal * ((v - a).dot(normal) / normal.length_squared());
            let inside = |p: Vec3<f64>, q: Vec3<f64>| (q - p).cross(foot - p).dot(normal) >= 0.0;
            if inside(a, b) && inside(b, c) && inside(c, a) {
                consider(foot);
            }
        }
    }
    best
}
