//! Hinges between two triangles.
//!
//! Independent of cotangents: when unfolded, the four rest points have one affine dependency, and
//! each of its coefficients is the area of the triangle of the other three.

use super::{Shape, Vertex, at};
use crate::support::random::{Points, Random, in_frame, size};
use shape_up::math::Vec3;

/// See [`super::shapes`].
pub(super) fn shapes(id: &str) -> Option<Vec<Shape>> {
    if id != "bending" {
        return None;
    }
    let shapes = vec![
        Shape {
            residual: |v, rest| residual(v, rest, [0.0; 2]),
            closest: |p, _, vertex| bent(p, [0.0; 2], vertex),
            ..hinges()
        },
        Shape {
            params: r#"{ "bend": 1 }"#,
            sample: |random, rest| sample(random, rest, 1.0),
            residual: |v, rest| residual(v, rest, [1.0; 2]),
            closest: |p, _, vertex| bent(p, [1.0; 2], vertex),
            ..hinges()
        },
        Shape {
            params: r#"{ "bend": [0.5, 2] }"#,
            sample: |random, rest| {
                let times = 1.2 + 0.6 * random.uniform();
                sample(random, rest, times)
            },
            residual: |v, rest| residual(v, rest, [0.5, 2.0]),
            closest: |p, _, vertex| bent(p, [0.5, 2.0], vertex),
            ..hinges()
        },
        Shape {
            params: r#"{ "bend": [null, 1] }"#,
            sample: |random, rest| {
                let times = 0.5 + 0.4 * random.uniform();
                sample(random, rest, times)
            },
            residual: |v, rest| residual(v, rest, [0.0, 1.0]),
            closest: |p, _, vertex| bent(p, [0.0, 1.0], vertex),
            ..hinges()
        },
    ];
    Some(shapes)
}

fn hinges() -> Shape {
    Shape {
        rest: |_, _| REST.map(Vec3::from).to_vec(),
        sample: |random, rest| sample(random, rest, 0.0),
        // Swapped ends, swapped corners, both.
        relabellings: |_, _| vec![vec![1, 0, 2, 3], vec![0, 1, 3, 2], vec![1, 0, 3, 2]],
        parameters: 12,
        ..Shape::ANY
    }
}

/// One rest shape for all, since brute force handles one vertex at a time: the edge along z, a
/// corner on each side.
const REST: [[f64; 3]; 4] = [[0.1, 0.0, -0.6], [0.1, 0.0, 0.9], [0.8, 0.5, 0.2], [-0.7, 0.6, -0.4]];

/// The affine dependency of the unfolded hinge, normalised, negative at the corners.
fn dependency(v: &[Vec3<f64>]) -> [f64; 4] {
    let edge = v[1] - v[0];
    let length = edge.length();
    let unfolded = |corner: usize, side: f64| {
        let to = v[corner] - v[0];
        let along = to.dot(edge) / length;
        [along, side * (to - edge * (along / length)).length()]
    };
    let flat = [[0.0, 0.0], [length, 0.0], unfolded(2, 1.0), unfolded(3, -1.0)];
    let area = |i: usize, j: usize, k: usize| {
        let ([a, b], [c, d], [e, f]) = (flat[i], flat[j], flat[k]);
        (c - a) * (f - b) - (e - a) * (d - b)
    };
    let w = [area(1, 2, 3), -area(0, 2, 3), area(0, 1, 3), -area(0, 1, 2)];
    let sign = if w[2] > 0.0 { -1.0 } else { 1.0 };
    let size = w.iter().map(|w| w * w).sum::<f64>().sqrt();
    w.map(|w| w * sign / size)
}

/// The bending vector of the hinge.
fn bending(v: &[Vec3<f64>], rest: &[Vec3<f64>]) -> Vec3<f64> {
    dependency(rest).iter().zip(v).fold(Vec3::zero(), |sum, (w, v)| sum + *v * *w)
}

fn residual(v: &[Vec3<f64>], rest: &[Vec3<f64>], [least, greatest]: [f64; 2]) -> f64 {
    let (now, at_rest) = (bending(v, rest).length(), bending(rest, rest).length());
    (now - now.clamp(least * at_rest, greatest * at_rest)).abs() / size(v)
}

/// The rest shape flattened by an affine map, rotated, and bent to `times` the rest vector.
fn sample(random: &mut Random, rest: &[Vec3<f64>], times: f64) -> Points {
    let w = dependency(rest);
    let frame = random.frame();
    let (direction, offset) = (random.direction(), random.vector());
    let (now, at_rest) = (bending(rest, rest), bending(rest, rest).length());
    rest.iter()
        .zip(w)
        .map(|(r, w)| offset + in_frame(frame, *r - now * w) + direction * (times * at_rest * w))
        .collect()
}

/// A vertex of four free points, whose bending vector is brought within the limits, as multiples of
/// the rest length, by moving the first corner.
fn bent(p: &[f64], [least, greatest]: [f64; 2], vertex: Vertex) -> Vec3<f64> {
    let rest = REST.map(Vec3::from);
    let points = [at(p, 0), at(p, 3), at(p, 6), at(p, 9)];
    let (now, at_rest) = (bending(&points, &rest), bending(&rest, &rest).length());
    let (length, direction) = now.length_and_direction();
    let target = length.clamp(least * at_rest, greatest * at_rest);
    let excess = direction.unwrap_or(Vec3::new(1.0, 0.0, 0.0)) * (length - target);
    let corner = dependency(&rest)[2];
    let moved = if vertex.index == 2 { excess * (1.0 / corner) } else { Vec3::zero() };
    points[vertex.index] - moved
}
