//! Relative shapes: displaced rest points.

use super::{Shape, at, cloud, different, extent, mirrored, placed, turned_and_scaled};

/// See [`super::shapes`].
pub(super) fn shapes(id: &str) -> Option<Vec<Shape>> {
    let shapes = match id {
        "rigid" => vec![Shape {
            sample: |random, rest| placed(random, rest, 1.0),
            residual: |v, rest| different(v, rest, 1.0).max(mirrored(v, rest, 1.0)),
            parameters: 7,
            closest: |p, _, vertex| {
                let q = [p[0], p[1], p[2], p[3]];
                let square: f64 = q.iter().map(|x| x * x).sum();
                at(p, 4) + turned_and_scaled(q, vertex.rest) * (1.0 / square)
            },
            ..Shape::ANY
        }],
        "similar" => vec![Shape {
            sample: |random, rest| {
                let scale = 1.2 + random.uniform();
                placed(random, rest, scale)
            },
            residual: |v, rest| {
                let scale = extent(v) / extent(rest);
                different(v, rest, scale).max(mirrored(v, rest, scale))
            },
            parameters: 7,
            closest: |p, _, vertex| {
                at(p, 4) + turned_and_scaled([p[0], p[1], p[2], p[3]], vertex.rest)
            },
            ..Shape::ANY
        }],
        "planar-similar" => vec![Shape {
            rest: |random, n| cloud(random, n, 0.0),
            sample: |random, rest| {
                let scale = 1.2 + random.uniform();
                placed(random, rest, scale)
            },
            residual: |v, rest| different(v, rest, extent(v) / extent(rest)),
            parameters: 7,
            closest: |p, _, vertex| {
                at(p, 4) + turned_and_scaled([p[0], p[1], p[2], p[3]], vertex.rest)
            },
            exact: false,
            excess: [5e-4, 0.1, 0.15],
            ..Shape::ANY
        }],
        _ => return None,
    };
    Some(shapes)
}
