//! Lengths.

use super::{Shape, any_order, at, cloud};
use crate::support::random::size;
use shape_up::math::Vec3;

/// See [`super::shapes`].
pub(super) fn shapes(id: &str) -> Option<Vec<Shape>> {
    let shapes = match id {
        "line-segment" => vec![
            segment(),
            Shape {
                params: r#"{ "length": 0.7 }"#,
                sample: |random, _| vec![Vec3::zero(), random.direction() * 0.7],
                residual: |v, _| ((v[1] - v[0]).length() - 0.7).abs() / size(v),
                closest: |p, _, vertex| ends(at(p, 0), 0.7)[vertex.index],
                ..segment()
            },
            Shape {
                params: r#"{ "length": [0.5, 0.9] }"#,
                sample: |random, _| {
                    let length = 0.7 + 0.15 * random.uniform();
                    vec![Vec3::zero(), random.direction() * length]
                },
                residual: |v, _| {
                    let length = (v[1] - v[0]).length();
                    (length - length.clamp(0.5, 0.9)).abs() / size(v)
                },
                parameters: 4,
                closest: |p, v, vertex| {
                    // The position along the direction is free, within half of the limits.
                    let side = [-1.0, 1.0][vertex.index];
                    let direction = direction(at(p, 0)) * side;
                    direction * v.dot(direction).clamp(0.25, 0.45)
                },
                ..segment()
            },
            Shape {
                params: r#"{ "strain": [0.9, 1.1] }"#,
                sample: |random, rest| {
                    let length = (rest[1] - rest[0]).length() * (1.0 + 0.05 * random.uniform());
                    vec![Vec3::zero(), random.direction() * length]
                },
                residual: |v, rest| {
                    let strain = (v[1] - v[0]).length() / (rest[1] - rest[0]).length();
                    (strain - strain.clamp(0.9, 1.1)).abs()
                },
                closest: |p, v, vertex| {
                    let side = [-1.0, 1.0][vertex.index];
                    let direction = direction(at(p, 0)) * side;
                    let half = vertex.rest.length();
                    direction * v.dot(direction).clamp(0.9 * half, 1.1 * half)
                },
                ..segment()
            },
        ],
        "equal-length" => vec![Shape {
            rest: |random, n| cloud(random, n, 1.0),
            sample: |random, rest| {
                let half = 0.6 + 0.3 * random.uniform();
                let ends = rest.chunks(2).flat_map(|_| {
                    let (middle, half) = (random.vector(), random.direction() * half);
                    [middle - half, middle + half]
                });
                ends.collect()
            },
            residual: |v, _| {
                let lengths = || v.chunks(2).map(|ends| (ends[1] - ends[0]).length());
                let (least, most) =
                    (lengths().fold(f64::MAX, f64::min), lengths().fold(0.0, f64::max));
                (most - least) / size(v)
            },
            relabellings: |random, n| {
                // Edges in another order, some of them reversed.
                let pairs = any_order(random, n / 2).remove(0).into_iter();
                vec![pairs.flat_map(|k| [2 * k + k % 2, 2 * k + 1 - k % 2]).collect()]
            },
            // A common length, and directions of up to three edges.
            parameters: 10,
            closest: |p, _, vertex| ends(at(p, 3 * (vertex.index / 2)), p[9])[vertex.index % 2],
            ..Shape::ANY
        }],
        _ => return None,
    };
    Some(shapes)
}

/// A segment that keeps its rest length.
fn segment() -> Shape {
    Shape {
        rest: |random, n| cloud(random, n, 1.0),
        sample: |random, rest| {
            let start = random.vector();
            vec![start, start + random.direction() * (rest[1] - rest[0]).length()]
        },
        residual: |v, rest| ((v[1] - v[0]).length() - (rest[1] - rest[0]).length()).abs() / size(v),
        parameters: 3,
        closest: |p, _, vertex| ends(at(p, 0), 2.0 * vertex.rest.length())[vertex.index],
        ..Shape::ANY
    }
}

/// The ends of the centred segment with this direction and length.
fn ends(along: Vec3<f64>, length: f64) -> [Vec3<f64>; 2] {
    let half = direction(along) * (0.5 * length);
    [-half, half]
}

/// Unit direction of a vector of any length.
fn direction(v: Vec3<f64>) -> Vec3<f64> {
    v.length_and_direction().1.unwrap_or(Vec3::new(1.0, 0.0, 0.0))
}
