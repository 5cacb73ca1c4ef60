//! Angles at corners.

use super::{Shape, Vertex, at};
use crate::support::random::{Points, Random, size};
use shape_up::math::Vec3;

/// See [`super::shapes`].
pub(super) fn shapes(id: &str) -> Option<Vec<Shape>> {
    if id != "angle" {
        return None;
    }
    let shapes = vec![
        Shape {
            sample: |random, _| sample(random, 90.0),
            residual: |v, _| beyond(v, 90.0, 90.0),
            closest: |p, _, vertex| corner(p, 90.0, vertex),
            ..corners()
        },
        Shape {
            params: r#"{ "angle": 60 }"#,
            sample: |random, _| sample(random, 60.0),
            residual: |v, _| beyond(v, 60.0, 60.0),
            closest: |p, _, vertex| corner(p, 60.0, vertex),
            ..corners()
        },
        Shape {
            params: r#"{ "angle": 0 }"#,
            sample: |random, _| sample(random, 0.0),
            residual: |v, _| beyond(v, 0.0, 0.0),
            closest: |p, _, vertex| corner(p, 0.0, vertex),
            ..corners()
        },
        Shape {
            params: r#"{ "angle": 180 }"#,
            sample: |random, _| sample(random, 180.0),
            residual: |v, _| beyond(v, 180.0, 180.0),
            closest: |p, _, vertex| corner(p, 180.0, vertex),
            ..corners()
        },
        Shape {
            params: r#"{ "angle": [80, 100] }"#,
            sample: |random, _| {
                let angle = 90.0 + 9.0 * random.uniform();
                sample(random, angle)
            },
            residual: |v, _| beyond(v, 80.0, 100.0),
            parameters: 9,
            closest: |p, _, vertex| corner(p, between(p[8], 80.0, 100.0), vertex),
            ..corners()
        },
        Shape {
            params: r#"{ "angle": [120, null] }"#,
            sample: |random, _| {
                let angle = 150.0 + 29.0 * random.uniform();
                sample(random, angle)
            },
            residual: |v, _| beyond(v, 120.0, 180.0),
            parameters: 9,
            closest: |p, _, vertex| corner(p, between(p[8], 120.0, 180.0), vertex),
            ..corners()
        },
    ];
    Some(shapes)
}

/// Reversing the order keeps the angle.
fn corners() -> Shape {
    Shape { relabellings: |_, _| vec![vec![2, 1, 0]], parameters: 8, ..Shape::ANY }
}

fn sample(random: &mut Random, degrees: f64) -> Points {
    let parameters: Vec<f64> = (0..6).map(|_| random.uniform()).chain([0.7, 1.2]).collect();
    let offset = random.vector();
    let corner = |index| {
        let vertex = Vertex { index, of: 3, rest: Vec3::zero() };
        offset + corner(&parameters, degrees, vertex)
    };
    (0..3).map(corner).collect()
}

/// A vertex of the centred corner whose first edge has the direction `p[0..3]` and whose plane
/// contains `p[3..6]`; `p[6]` and `p[7]` give the lengths.
fn corner(p: &[f64], degrees: f64, vertex: Vertex) -> Vec3<f64> {
    let direction = |v: Vec3<f64>| v.length_and_direction().1.unwrap_or(Vec3::new(1.0, 0.0, 0.0));
    let (e, aside) = (direction(at(p, 0)), at(p, 3));
    let f = direction(aside - e * e.dot(aside));
    let [c, s] = cosine_and_sine(degrees);
    let x = e * positive(p[6]);
    let y = (e * c + f * s) * positive(p[7]);
    let middle = (x + y) * (1.0 / 3.0);
    [x, Vec3::zero(), y][vertex.index] - middle
}

/// Distance of the angle from the range, as the sine of the difference times both edge lengths, so
/// that an edge of length zero is allowed.
fn beyond(v: &[Vec3<f64>], least: f64, greatest: f64) -> f64 {
    let (x, y) = (v[0] - v[1], v[2] - v[1]);
    let (cross, dot) = (x.cross(y).length(), x.dot(y));
    let degrees = turn(cross, dot).to_degrees();
    let nearest = degrees.clamp(least, greatest);
    let [c, s] = cosine_and_sine(nearest);
    let sine = (cross * c - dot * s).abs();
    // Opposite directions have the same sine.
    let opposite = (-(cross * s + dot * c)).max(0.0);
    if degrees == nearest { 0.0 } else { sine.max(opposite) / size(v).powi(2) }
}

#[expect(clippy::disallowed_methods, reason = "independent of the series of the operator")]
fn cosine_and_sine(degrees: f64) -> [f64; 2] {
    [degrees.to_radians().cos(), degrees.to_radians().sin()]
}

#[expect(clippy::disallowed_methods, reason = "independent of the comparisons of the operator")]
fn turn(y: f64, x: f64) -> f64 {
    y.atan2(x)
}

/// A value within the limits, near a limit for large `|x|`, which brute force reaches in long
/// steps.
fn between(x: f64, least: f64, greatest: f64) -> f64 {
    let part = x / (1.0 + x * x).sqrt();
    0.5 * (least + greatest) + 0.5 * (greatest - least) * part
}

/// Positive for every `x`, and near zero for large negative ones.
fn positive(x: f64) -> f64 {
    0.5 * (x + (x * x + 0.01).sqrt())
}
