//! Mirrors and axes.

use super::{Points, Random, Shape, at};
use crate::support::random::size;
use shape_up::math::Vec3;

/// See [`super::shapes`].
pub(super) fn shapes(id: &str) -> Option<Vec<Shape>> {
    let shapes = match id {
        "symmetry" => vec![
            Shape {
                rest: |random, n| orbits::<2>(random, n, |v| mirrored(v, X)),
                sample: |random, rest| orbits::<2>(random, rest.len(), |v| mirrored(v, X)),
                residual: |v, _| asymmetry::<2>(v, |v| mirrored(v, X)),
                // A point for each pair, and the position of the plane.
                parameters: 13,
                closest: |p, v, vertex| {
                    let place = X * p[12];
                    let own = at(p, 3 * (vertex.index / 2));
                    match vertex.index {
                        i if i % 2 == 1 => place + mirrored(own, X),
                        i if i + 1 == vertex.of => place + (v + mirrored(v, X)) * 0.5,
                        _ => place + own,
                    }
                },
                ..Shape::ANY
            },
            Shape {
                params: r#"{ "mirror": [0, -3, 4] }"#,
                rest: |random, n| orbits::<2>(random, n, |v| mirrored(v, TILTED)),
                sample: |random, rest| orbits::<2>(random, rest.len(), |v| mirrored(v, TILTED)),
                residual: |v, _| asymmetry::<2>(v, |v| mirrored(v, TILTED)),
                parameters: 13,
                closest: |p, v, vertex| {
                    let place = TILTED * p[12];
                    let own = at(p, 3 * (vertex.index / 2));
                    match vertex.index {
                        i if i % 2 == 1 => place + mirrored(own, TILTED),
                        i if i + 1 == vertex.of => place + (v + mirrored(v, TILTED)) * 0.5,
                        _ => place + own,
                    }
                },
                ..Shape::ANY
            },
            Shape {
                params: r#"{ "axis": [0, -3, 4], "fold": 3 }"#,
                rest: |random, n| orbits::<3>(random, n, third_of_a_turn),
                sample: |random, rest| orbits::<3>(random, rest.len(), third_of_a_turn),
                residual: |v, _| asymmetry::<3>(v, third_of_a_turn),
                // A point for each three, and the position of the axis.
                parameters: 12,
                closest: |p, v, vertex| {
                    let place = at(p, 9);
                    if vertex.index >= vertex.of / 3 * 3 {
                        return place + TILTED * TILTED.dot(v - place);
                    }
                    let own = at(p, 3 * (vertex.index / 3));
                    place + (0..vertex.index % 3).fold(own, |v, _| third_of_a_turn(v))
                },
                ..Shape::ANY
            },
        ],
        _ => return None,
    };
    Some(shapes)
}

const X: Vec3<f64> = Vec3 { x: 1.0, y: 0.0, z: 0.0 };
const TILTED: Vec3<f64> = Vec3 { x: 0.0, y: -0.6, z: 0.8 };

fn mirrored(v: Vec3<f64>, normal: Vec3<f64>) -> Vec3<f64> {
    v - normal * (2.0 * v.dot(normal))
}

/// Rotated by 120 degrees about the tilted axis, by Rodrigues' formula.
fn third_of_a_turn(v: Vec3<f64>) -> Vec3<f64> {
    let along = TILTED * TILTED.dot(v);
    along - (v - along) * 0.5 + TILTED.cross(v) * 0.75f64.sqrt()
}

/// Points, each followed by its images; points that are left over at the end are their own images.
fn orbits<const N: usize>(
    random: &mut Random,
    n: usize,
    image: impl Fn(Vec3<f64>) -> Vec3<f64>,
) -> Points {
    let mut points = Points::new();
    while points.len() + N <= n {
        let mut v = random.vector();
        for _ in 0..N {
            points.push(v);
            v = image(v);
        }
    }
    while points.len() < n {
        let v = random.vector();
        let mut images = v;
        let sum = (1..N).fold(v, |sum, _| {
            images = image(images);
            sum + images
        });
        points.push(sum * (1.0 / N as f64));
    }
    points
}

/// Greatest error of an image. The points are centred, and so is the symmetry.
fn asymmetry<const N: usize>(v: &[Vec3<f64>], image: impl Fn(Vec3<f64>) -> Vec3<f64>) -> f64 {
    let in_orbits = v.len() / N * N;
    let off = (0..v.len()).map(|i| {
        let next = if i >= in_orbits { i } else { i / N * N + (i + 1) % N };
        (image(v[i]) - v[next]).length()
    });
    off.fold(0.0, f64::max) / size(v)
}
