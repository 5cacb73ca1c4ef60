//! Circles and spheres.

use super::{Shape, at, on_circle, round_residual, singular_values};
use crate::support::random::{Random, size};
use shape_up::math::Vec3;

/// See [`super::shapes`].
pub(super) fn shapes(id: &str) -> Option<Vec<Shape>> {
    let shapes = match id {
        "circle" => vec![
            circle(),
            Shape {
                params: r#"{ "radius": 0.7 }"#,
                sample: |random, rest| ring(random, rest.len(), 0.7),
                residual: |v, _| circle_off(v).max(radius_off(v, triangles(v), [0.7, 0.7])),
                parameters: 6,
                closest: |p, v, _| closest_on_circle(p, 0.7, v),
                excess: [2e-4, 0.02, 1.0],
                ..circle()
            },
            Shape {
                params: r#"{ "radius": [0.5, 0.9] }"#,
                sample: |random, rest| {
                    let radius = 0.7 + 0.2 * random.uniform();
                    ring(random, rest.len(), radius)
                },
                residual: |v, _| circle_off(v).max(radius_off(v, triangles(v), [0.5, 0.9])),
                closest: |p, v, _| closest_on_circle(p, between(0.5, 0.9, p[6]), v),
                excess: [1e-3, 0.1, 1.5],
                ..circle()
            },
        ],
        "sphere" => vec![
            sphere(),
            Shape {
                params: r#"{ "radius": 0.7 }"#,
                sample: |random, rest| ball(random, rest.len(), 0.7),
                residual: |v, _| round_residual(v, 3).max(radius_off(v, tetrahedra(v), [0.7, 0.7])),
                parameters: 3,
                closest: |p, v, _| closest_on_sphere(p, 0.7, v),
                excess: [1e-9, 1e-4, 0.1],
                ..sphere()
            },
            Shape {
                params: r#"{ "radius": [0.5, 0.9] }"#,
                sample: |random, rest| {
                    let radius = 0.7 + 0.2 * random.uniform();
                    ball(random, rest.len(), radius)
                },
                residual: |v, _| round_residual(v, 3).max(radius_off(v, tetrahedra(v), [0.5, 0.9])),
                closest: |p, v, _| closest_on_sphere(p, between(0.5, 0.9, p[3]), v),
                excess: [1e-3, 0.1, 2.0],
                ..sphere()
            },
        ],
        _ => return None,
    };
    Some(shapes)
}

fn circle() -> Shape {
    Shape {
        sample: |random, rest| ring(random, rest.len(), 1.0),
        residual: |v, _| circle_off(v),
        parameters: 7,
        closest: |p, v, _| closest_on_circle(p, p[6], v),
        exact: false,
        excess: [5e-4, 0.05, 0.3],
        ..Shape::ANY
    }
}

fn sphere() -> Shape {
    Shape {
        sample: |random, rest| ball(random, rest.len(), 1.0),
        residual: |v, _| round_residual(v, 3),
        parameters: 4,
        closest: |p, v, _| closest_on_sphere(p, p[3], v),
        exact: false,
        excess: [1e-3, 0.1, 1.0],
        ..Shape::ANY
    }
}

fn ring(random: &mut Random, n: usize, radius: f64) -> Vec<Vec3<f64>> {
    let (centre, [e, f, _]) = (random.vector(), random.frame());
    (0..n).map(|_| centre + on_circle(random, e * radius, f * radius)).collect()
}

fn ball(random: &mut Random, n: usize, radius: f64) -> Vec<Vec3<f64>> {
    let centre = random.vector();
    (0..n).map(|_| centre + random.direction() * radius).collect()
}

/// Closest point of a circle; the parameters are its centre and normal.
fn closest_on_circle(p: &[f64], radius: f64, v: Vec3<f64>) -> Vec3<f64> {
    let (c, n) = (at(p, 0), at(p, 3));
    let d = v - c;
    let d = d - n * (d.dot(n) / n.length_squared());
    c + d * (radius / d.length())
}

/// Closest point of a sphere; the parameters are its centre.
fn closest_on_sphere(p: &[f64], radius: f64, v: Vec3<f64>) -> Vec3<f64> {
    let d = v - at(p, 0);
    at(p, 0) + d * (radius / d.length())
}

/// Maps any number into the limits.
fn between(least: f64, greatest: f64, x: f64) -> f64 {
    0.5 * (least + greatest + (greatest - least) * x / (1.0 + x * x).sqrt())
}

fn circle_off(v: &[Vec3<f64>]) -> f64 {
    (singular_values(v)[2] / size(v)).max(round_residual(v, 2))
}

/// For each triangle of points, four times its area, and that times its circumradius; both times a
/// length, as for tetrahedra.
fn triangles(v: &[Vec3<f64>]) -> impl Iterator<Item = [f64; 2]> {
    let (n, size) = (v.len(), size(v));
    (0..n).flat_map(move |i| (i + 1..n).map(move |j| (i, j))).flat_map(move |(i, j)| {
        (j + 1..n).map(move |k| {
            let (a, b, c) = (v[j] - v[i], v[k] - v[i], v[k] - v[j]);
            [2.0 * a.cross(b).length(), a.length() * b.length() * c.length()].map(|x| x * size)
        })
    })
}

/// The same for tetrahedra at the first point, with twelve times their volumes.
fn tetrahedra(v: &[Vec3<f64>]) -> impl Iterator<Item = [f64; 2]> {
    let n = v.len();
    (1..n).flat_map(move |i| (i + 1..n).map(move |j| (i, j))).flat_map(move |(i, j)| {
        (j + 1..n).map(move |k| {
            let [a, b, c] = [v[i] - v[0], v[j] - v[0], v[k] - v[0]];
            let sum = b.cross(c) * a.length_squared()
                + c.cross(a) * b.length_squared()
                + a.cross(b) * c.length_squared();
            [2.0 * a.dot(b.cross(c)).abs(), sum.length()]
        })
    })
}

/// How far circumradii are beyond the limits, relative to the size of the points or to the limit,
/// whichever is greater.
fn radius_off(
    v: &[Vec3<f64>],
    simplices: impl Iterator<Item = [f64; 2]>,
    [least, greatest]: [f64; 2],
) -> f64 {
    let size = size(v);
    let relative = |off: f64, limit: f64| off / (size * size * size.max(limit).powi(2));
    simplices
        .map(|[one, radius]| {
            relative(one * least - radius, least).max(relative(radius - one * greatest, greatest))
        })
        .fold(0.0, f64::max)
}
