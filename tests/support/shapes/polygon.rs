//! Polygons.

use super::{
    Shape, Vertex, at, equal_sides, in_turn, in_turn_or_back, parallel_sides, right_angles, turned,
};

/// See [`super::shapes`].
pub(super) fn shapes(id: &str) -> Option<Vec<Shape>> {
    let shapes = match id {
        "parallelogram" => vec![Shape {
            sample: |random, _| {
                let (centre, a, b) = (random.vector(), random.vector(), random.vector());
                vec![centre + a, centre + b, centre - a, centre - b]
            },
            residual: |v, _| parallel_sides(v),
            relabellings: in_turn_or_back,
            parameters: 9,
            closest: |p, _, vertex| {
                let (c, a, b) = (at(p, 0), at(p, 3), at(p, 6));
                [c + a, c + b, c - a, c - b][vertex.index]
            },
            ..Shape::ANY
        }],
        "rectangle" => vec![
            rectangle(),
            Shape {
                params: r#"{ "fit": "lines" }"#,
                exact: false,
                excess: [2e-4, 0.02, 0.2],
                ..rectangle()
            },
        ],
        "square" => vec![Shape {
            residual: |v, _| parallel_sides(v).max(right_angles(v)).max(equal_sides(v)),
            ..regular_polygon()
        }],
        "regular-polygon" => vec![regular_polygon()],
        _ => return None,
    };
    Some(shapes)
}

fn regular_polygon() -> Shape {
    Shape {
        sample: |random, rest| {
            let (centre, [e, f, _]) = (random.vector(), random.frame());
            let size = 1.0 + 0.5 * random.uniform();
            (0..rest.len())
                .map(|index| Vertex { index, of: rest.len(), rest: rest[index] })
                .map(|vertex| centre + turned(e * size, f * size, vertex))
                .collect()
        },
        residual: |v, _| in_turn(v).max(equal_sides(v)),
        relabellings: in_turn_or_back,
        parameters: 9,
        closest: |p, _, vertex| {
            let (c, e, f) = (at(p, 0), at(p, 3), at(p, 6));
            let f = f - e * (f.dot(e) / e.length_squared());
            c + turned(e, f * (e.length() / f.length()), vertex)
        },
        ..Shape::ANY
    }
}

fn rectangle() -> Shape {
    Shape {
        sample: |random, _| {
            let (corner, [e, f, _]) = (random.vector(), random.frame());
            let (e, f) = (e * (1.5 + random.uniform()), f * (1.5 + random.uniform()));
            vec![corner, corner + e, corner + e + f, corner + f]
        },
        residual: |v, _| parallel_sides(v).max(right_angles(v)),
        relabellings: in_turn_or_back,
        parameters: 9,
        closest: |p, _, vertex| {
            let (c, a, b) = (at(p, 0), at(p, 3), at(p, 6));
            let b = b * (a.length() / b.length());
            [c + a, c + b, c - a, c - b][vertex.index]
        },
        ..Shape::ANY
    }
}
