//! Circles and spheres.

use super::{Shape, at, on_circle, round_residual, singular_values};
use crate::random::size;

/// See [`super::shapes`].
pub(super) fn shapes(id: &str) -> Option<Vec<Shape>> {
    let shapes = match id {
        "circle" => vec![Shape {
            sample: |random, rest| {
                let (centre, [e, f, _]) = (random.vector(), random.frame());
                rest.iter().map(|_| centre + on_circle(random, e, f)).collect()
            },
            residual: |v, _| (singular_values(v)[2] / size(v)).max(round_residual(v, 2)),
            parameters: 7,
            closest: |p, v, _| {
                let (c, n) = (at(p, 0), at(p, 3));
                let d = v - c;
                let d = d - n * (d.dot(n) / n.length_squared());
                c + d * (p[6] / d.length())
            },
            excess: [5e-4, 0.05, 0.3],
            ..Shape::ANY
        }],
        "sphere" => vec![Shape {
            sample: |random, rest| {
                let centre = random.vector();
                rest.iter().map(|_| centre + random.direction()).collect()
            },
            residual: |v, _| round_residual(v, 3),
            parameters: 4,
            closest: |p, v, _| {
                let c = at(p, 0);
                c + (v - c) * (p[3] / (v - c).length())
            },
            excess: [1e-3, 0.1, 1.0],
            ..Shape::ANY
        }],
        _ => return None,
    };
    Some(shapes)
}
