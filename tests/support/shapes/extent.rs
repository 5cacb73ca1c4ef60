//! Areas of triangles and volumes of tetrahedra.

use super::{Shape, Vertex, at, cloud};
use crate::support::random::{Points, Random, size};
use shape_up::math::Vec3;

/// See [`super::shapes`].
pub(super) fn shapes(id: &str) -> Option<Vec<Shape>> {
    let shapes = match id {
        "area" => vec![
            triangles(),
            Shape {
                params: r#"{ "area": 0.4 }"#,
                sample: |random, _| triangle(random, 0.4),
                residual: |v, _| beyond(area(v), 0.4, 0.4) / size(v).powi(2),
                closest: |p, _, vertex| resized_triangle(p, [0.4; 2], vertex),
                ..triangles()
            },
            Shape {
                params: r#"{ "area": [0.3, 0.6] }"#,
                sample: |random, _| {
                    let area = 0.45 + 0.14 * random.uniform();
                    triangle(random, area)
                },
                residual: |v, _| beyond(area(v), 0.3, 0.6) / size(v).powi(2),
                closest: |p, _, vertex| resized_triangle(p, [0.3, 0.6], vertex),
                ..triangles()
            },
            Shape {
                params: r#"{ "strain": [0.9, 1.2] }"#,
                sample: |random, _| {
                    let area = 1.05 + 0.14 * random.uniform();
                    triangle(random, area)
                },
                residual: |v, _| beyond(area(v), 0.9, 1.2) / size(v).powi(2),
                closest: |p, _, vertex| resized_triangle(p, [0.9, 1.2], vertex),
                ..triangles()
            },
            Shape {
                params: r#"{ "area": 0 }"#,
                sample: |random, rest| {
                    let direction = random.direction();
                    rest.iter().map(|_| direction * random.uniform()).collect()
                },
                residual: |v, _| area(v) / size(v).powi(2),
                parameters: 3,
                closest: |p, v, _| {
                    let direction = at(p, 0);
                    direction * (v.dot(direction) / direction.length_squared())
                },
                ..triangles()
            },
        ],
        "volume" => vec![
            tetrahedra(),
            Shape {
                params: r#"{ "volume": 0.02 }"#,
                sample: |random, _| tetrahedron(random, 0.02),
                residual: |v, _| beyond(volume(v), 0.02, 0.02) / size(v).powi(3),
                closest: |p, _, vertex| resized_tetrahedron(p, [0.02; 2], vertex),
                ..tetrahedra()
            },
            Shape {
                params: r#"{ "volume": [0.1, 0.4] }"#,
                sample: |random, _| {
                    let volume = 0.25 + 0.14 * random.uniform();
                    tetrahedron(random, volume)
                },
                residual: |v, _| beyond(volume(v), 0.1, 0.4) / size(v).powi(3),
                closest: |p, _, vertex| resized_tetrahedron(p, [0.1, 0.4], vertex),
                ..tetrahedra()
            },
            Shape {
                params: r#"{ "strain": [0.5, null] }"#,
                sample: |random, _| {
                    let volume = 0.3 + 0.1 * random.uniform();
                    tetrahedron(random, volume)
                },
                residual: |v, _| beyond(volume(v), 0.1, f64::MAX) / size(v).powi(3),
                closest: |p, _, vertex| resized_tetrahedron(p, [0.1, f64::MAX], vertex),
                ..tetrahedra()
            },
        ],
        _ => return None,
    };
    Some(shapes)
}

/// Triangles with a rest area of one, which they keep.
fn triangles() -> Shape {
    Shape {
        rest: |random, _| triangle(random, 1.0),
        sample: |random, _| triangle(random, 1.0),
        residual: |v, _| beyond(area(v), 1.0, 1.0) / size(v).powi(2),
        parameters: 6,
        closest: |p, _, vertex| resized_triangle(p, [1.0; 2], vertex),
        ..Shape::ANY
    }
}

/// Tetrahedra with a rest volume of 0.2, which they keep.
fn tetrahedra() -> Shape {
    Shape {
        rest: |random, _| tetrahedron(random, 0.2),
        sample: |random, _| tetrahedron(random, 0.2),
        residual: |v, _| beyond(volume(v), 0.2, 0.2) / size(v).powi(3),
        // Even permutations.
        relabellings: |_, _| vec![vec![1, 2, 0, 3], vec![1, 0, 3, 2]],
        parameters: 9,
        closest: |p, _, vertex| resized_tetrahedron(p, [0.2; 2], vertex),
        ..Shape::ANY
    }
}

fn beyond(x: f64, least: f64, greatest: f64) -> f64 {
    (x - x.clamp(least, greatest)).abs()
}

/// Half of the length of the sum of the cross products along the sides.
fn area(v: &[Vec3<f64>]) -> f64 {
    0.5 * (v[0].cross(v[1]) + v[1].cross(v[2]) + v[2].cross(v[0])).length()
}

fn volume(v: &[Vec3<f64>]) -> f64 {
    (v[1] - v[0]).cross(v[2] - v[0]).dot(v[3] - v[0]) / 6.0
}

fn triangle(random: &mut Random, of: f64) -> Points {
    loop {
        let v = cloud(random, 3, 1.0);
        let factor = (of / area(&v)).sqrt();
        if factor < 3.0 {
            return v.iter().map(|v| *v * factor).collect();
        }
    }
}

fn tetrahedron(random: &mut Random, of: f64) -> Points {
    loop {
        let v = cloud(random, 4, 1.0);
        let factor = (of / volume(&v)).cbrt();
        if factor.abs() < 2.0 {
            return v.iter().map(|v| *v * factor).collect();
        }
    }
}

/// The points 0, `p[0..3]`, `p[3..6]` and so on, centred.
fn points<const N: usize>(p: &[f64]) -> [Vec3<f64>; N] {
    let corners: [Vec3<f64>; N] =
        std::array::from_fn(|k| if k == 0 { Vec3::zero() } else { at(p, 3 * k - 3) });
    // Only ratios count; NaN stops brute force if the parameters diverge.
    let extent = size(&corners);
    if !(1e-20..1e20).contains(&extent) {
        return [Vec3::zero() * f64::NAN; N];
    }
    let sum = corners.iter().fold(Vec3::zero(), |sum, v| sum + *v);
    corners.map(|v| v - sum * (1.0 / N as f64))
}

/// A vertex of the triangle with the shape `p`, resized to an area within the limits.
fn resized_triangle(p: &[f64], [least, greatest]: [f64; 2], vertex: Vertex) -> Vec3<f64> {
    let v = points::<3>(p);
    let own = area(&v);
    v[vertex.index] * (own.clamp(least, greatest) / own).sqrt()
}

/// The same for a tetrahedron; an inverted one is reflected.
fn resized_tetrahedron(p: &[f64], [least, greatest]: [f64; 2], vertex: Vertex) -> Vec3<f64> {
    let v = points::<4>(p);
    let own = volume(&v);
    v[vertex.index] * (own.abs().clamp(least, greatest) / own).cbrt()
}
