//! Lines and planes.

use super::{Shape, at, cloud, singular_values};
use crate::support::random::{in_frame, size};
use shape_up::math::Vec3;

/// See [`super::shapes`].
pub(super) fn shapes(id: &str) -> Option<Vec<Shape>> {
    let shapes = match id {
        "line" => vec![any_line(), given_line()],
        "plane" => vec![any_plane(), plane_with_normal(), plane_along()],
        _ => return None,
    };
    Some(shapes)
}

/// The direction `(2, -1, 2)` of the descriptions below, normalised, and two directions across it.
const FRAME: [Vec3<f64>; 3] = [
    Vec3 { x: 2.0 / 3.0, y: -1.0 / 3.0, z: 2.0 / 3.0 },
    Vec3 { x: 2.0 / 3.0, y: 2.0 / 3.0, z: -1.0 / 3.0 },
    Vec3 { x: -1.0 / 3.0, y: 2.0 / 3.0, z: 2.0 / 3.0 },
];

fn any_line() -> Shape {
    Shape {
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
    }
}

fn given_line() -> Shape {
    Shape {
        params: r#"{ "direction": [2, -1, 2] }"#,
        sample: |random, rest| {
            let p = random.vector();
            rest.iter().map(|_| p + FRAME[0] * random.uniform()).collect()
        },
        residual: |v, _| {
            let off = v.iter().map(|v| v.cross(FRAME[0]).length());
            off.fold(0.0, f64::max) / size(v)
        },
        parameters: 2,
        closest: |p, v, _| in_frame(FRAME, Vec3::new(v.dot(FRAME[0]), p[0], p[1])),
        ..Shape::ANY
    }
}

fn any_plane() -> Shape {
    Shape {
        sample: |random, rest| cloud(random, rest.len(), 0.0),
        residual: |v, _| singular_values(v)[2] / size(v),
        parameters: 4,
        closest: |p, v, _| {
            let n = at(p, 0);
            v - n * ((v.dot(n) - p[3]) / n.length_squared())
        },
        ..Shape::ANY
    }
}

fn plane_with_normal() -> Shape {
    Shape {
        params: r#"{ "normal": [-4, 2, -4] }"#,
        sample: |random, rest| {
            let height = random.uniform();
            let mut point = || Vec3::new(height, random.uniform(), random.uniform());
            rest.iter().map(|_| in_frame(FRAME, point())).collect()
        },
        residual: |v, _| {
            let off = v.iter().map(|v| v.dot(FRAME[0]).abs());
            off.fold(0.0, f64::max) / size(v)
        },
        parameters: 1,
        closest: |p, v, _| v + FRAME[0] * (p[0] - v.dot(FRAME[0])),
        ..Shape::ANY
    }
}

fn plane_along() -> Shape {
    Shape {
        params: r#"{ "along": [0.2, -0.1, 0.2] }"#,
        sample: |random, rest| {
            let (p, [_, e, _]) = (random.vector(), random.frame());
            let mut point = || p + FRAME[0] * random.uniform() + e * random.uniform();
            rest.iter().map(|_| point()).collect()
        },
        residual: |v, _| {
            let seen: Vec<_> = v.iter().map(|v| *v - FRAME[0] * v.dot(FRAME[0])).collect();
            singular_values(&seen)[1] / size(v)
        },
        parameters: 3,
        closest: |p, v, _| {
            let n = FRAME[1] * p[0] + FRAME[2] * p[1];
            v - n * ((v.dot(n) - p[2]) / n.length_squared())
        },
        ..Shape::ANY
    }
}
