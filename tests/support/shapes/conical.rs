//! Conical vertices.

use super::{Shape, at};
use crate::support::random::size;
use shape_up::math::Vec3;

/// See [`super::shapes`].
pub(super) fn shapes(id: &str) -> Option<Vec<Shape>> {
    let shapes = match id {
        "conical" => vec![Shape {
            sample: |random, _| {
                let parameters: Vec<f64> = (0..15).map(|_| random.uniform()).collect();
                let first = at(&parameters, 12) + ray(&parameters);
                vec![
                    at(&parameters, 12),
                    first,
                    corner(&parameters, 1),
                    corner(&parameters, 2),
                    corner(&parameters, 3),
                ]
            },
            residual: |v, _| {
                let edges: Vec<_> = v[1..].iter().map(|p| *p - v[0]).collect();
                if edges.iter().any(|e| e.length() <= 1e-12 * size(v)) {
                    return 0.0;
                }
                let angle = |k: usize| angle(edges[k], edges[(k + 1) % 4]);
                (angle(0) - angle(1) + angle(2) - angle(3)).abs()
            },
            relabellings: |_, _| vec![vec![0, 2, 3, 4, 1], vec![0, 4, 3, 2, 1]],
            closest: |p, _, vertex| match vertex.index {
                0 => at(p, 12),
                1 => at(p, 12) + ray(p),
                k => corner(p, k - 1),
            },
            parameters: 15,
            exact: false,
            excess: [1e-9, 0.05, 0.01],
            ..Shape::ANY
        }],
        _ => return None,
    };
    Some(shapes)
}

/// One of the three neighbours whose position is free.
fn corner(p: &[f64], k: usize) -> Vec3<f64> {
    at(p, 12) + at(p, 3 * k)
}

#[expect(clippy::disallowed_methods, reason = "independent of the operator")]
fn angle(a: Vec3<f64>, b: Vec3<f64>) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}

/// Direction of the edge to the first neighbour: its angles with the second and fourth edges differ
/// as much as the angles of these with the third, so it is on one sheet of a quadratic cone.
#[expect(clippy::disallowed_methods, reason = "independent of the operator")]
fn ray(p: &[f64]) -> Vec3<f64> {
    let [second, third, fourth] =
        [3, 6, 9].map(|i| at(p, i).length_and_direction().1.unwrap_or(Vec3::new(1.0, 0.0, 0.0)));
    let direction = |v: Vec3<f64>| v.length_and_direction().1.unwrap_or(Vec3::new(0.0, 1.0, 0.0));
    // From the second to the fourth, and the bisector.
    let (along, between) = (direction(fourth - second), direction(fourth + second));
    let across = between.cross(along);
    let sine_between = 0.5 * (fourth - second).length();
    let half = 0.5 * (angle(second, third) - angle(third, fourth));
    let (y, z) = (at(p, 0).dot(across), at(p, 0).dot(between));
    let room = (sine_between * sine_between - half.sin() * half.sin()).max(1e-12);
    let x = half.sin() * (y * y / room + z * z / (half.cos() * half.cos())).sqrt();
    along * x + across * y + between * z
}
