//! Lines and planes.

use super::{Shape, at, cloud, singular_values};
use crate::random::size;

/// See [`super::shapes`].
pub(super) fn shapes(id: &str) -> Option<Vec<Shape>> {
    let shapes = match id {
        "line" => vec![Shape {
            sample: |random, rest| {
                let (p, e) = (random.vector(), random.direction());
                rest.iter().map(|_| p + e * random.uniform()).collect()
            },
            residual: |v, _| singular_values(v)[1] / size(v),
            parameters: 6,
            closest: |p, v, _| {
                let (o, e) = (at(p, 0), at(p, 3));
                o + e * ((v - o).dot(e) / e.length_squared())
            },
            ..Shape::ANY
        }],
        "plane" => vec![Shape {
            sample: |random, rest| cloud(random, rest.len(), 0.0),
            residual: |v, _| singular_values(v)[2] / size(v),
            parameters: 4,
            closest: |p, v, _| {
                let n = at(p, 0);
                v - n * ((v.dot(n) - p[3]) / n.length_squared())
            },
            ..Shape::ANY
        }],
        _ => return None,
    };
    Some(shapes)
}
