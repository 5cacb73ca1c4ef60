//! What each kind means, told a second time and without its operator: rest points, points that have
//! the shape, a measure of how far points are from having it, and its set described by free
//! parameters, for brute force. A new kind adds its row to [`shape`].

use crate::random::{Points, Random, in_frame, size};
use nalgebra::DMatrix;
use shape_up::math::Vec3;

/// See [`Shape::residual`].
pub(crate) type Residual = fn(&[Vec3<f64>], &[Vec3<f64>]) -> f64;

/// See [`Shape::closest`].
pub(crate) type Closest = fn(&[f64], Vec3<f64>, Vertex) -> Vec3<f64>;

/// An independent account of one kind.
pub(crate) struct Shape {
    /// `n` rest points, of size about one.
    pub(crate) rest: fn(&mut Random, usize) -> Points,
    /// Points that have the shape, of size about one, as many as the rest points.
    pub(crate) sample: fn(&mut Random, &[Vec3<f64>]) -> Points,
    /// Zero exactly where the centred points have the shape, given the centred rest points; relative
    /// to their size.
    pub(crate) residual: Residual,
    /// Whether the order of the vertices matters (up to where one begins to count, and which way),
    /// when that of the rest points is the same.
    pub(crate) ordered: bool,
    /// How many free parameters describe the shape.
    pub(crate) parameters: usize,
    /// The point closest to `v` on the shape with these parameters; it may depend on which vertex
    /// `v` is, the last argument.
    pub(crate) closest: Closest,
    /// For kinds that are not exact: how much greater than the least the squared distance may be,
    /// as a fraction, for shapes disturbed by [`NOISE`].
    pub(crate) excess: [f64; 3],
}

/// Which vertex of a constraint it is.
#[derive(Clone, Copy)]
pub(crate) struct Vertex {
    pub(crate) index: usize,
    /// How many vertices there are.
    pub(crate) of: usize,
    pub(crate) rest: Vec3<f64>,
}

/// Disturbance of a shape of size about one, for [`Shape::excess`].
pub(crate) const NOISE: [f64; 3] = [0.01, 0.1, 0.3];

/// The account of the kind named `id`.
pub(crate) fn shape(id: &str) -> Shape {
    match id {
        "line" => Shape {
            rest: any,
            sample: |random, rest| {
                let (p, e) = (random.vector(), random.direction());
                rest.iter().map(|_| p + e * random.uniform()).collect()
            },
            residual: |v, _| singular_values(v)[1] / size(v),
            ordered: false,
            parameters: 6,
            closest: |p, v, _| {
                let (o, e) = (at(p, 0), at(p, 3));
                o + e * ((v - o).dot(e) / e.length_squared())
            },
            excess: [0.0; 3],
        },
        "plane" => Shape {
            rest: any,
            sample: |random, rest| cloud(random, rest.len(), 0.0),
            residual: |v, _| singular_values(v)[2] / size(v),
            ordered: false,
            parameters: 4,
            closest: |p, v, _| {
                let n = at(p, 0);
                v - n * ((v.dot(n) - p[3]) / n.length_squared())
            },
            excess: [0.0; 3],
        },
        "circle" => Shape {
            rest: any,
            sample: |random, rest| {
                let (centre, [e, f, _]) = (random.vector(), random.frame());
                rest.iter().map(|_| centre + on_circle(random, e, f)).collect()
            },
            residual: |v, _| (singular_values(v)[2] / size(v)).max(round_residual(v, 2)),
            ordered: false,
            parameters: 7,
            closest: |p, v, _| {
                let (c, n) = (at(p, 0), at(p, 3));
                let d = v - c;
                let d = d - n * (d.dot(n) / n.length_squared());
                c + d * (p[6] / d.length())
            },
            excess: [5e-4, 0.05, 0.3],
        },
        "sphere" => Shape {
            rest: any,
            sample: |random, rest| {
                let centre = random.vector();
                rest.iter().map(|_| centre + random.direction()).collect()
            },
            residual: |v, _| round_residual(v, 3),
            ordered: false,
            parameters: 4,
            closest: |p, v, _| {
                let c = at(p, 0);
                c + (v - c) * (p[3] / (v - c).length())
            },
            excess: [1e-3, 0.1, 1.0],
        },
        "rigid" => Shape {
            rest: any,
            sample: |random, rest| placed(random, rest, 1.0),
            residual: |v, rest| different(v, rest, 1.0).max(mirrored(v, rest, 1.0)),
            ordered: false,
            parameters: 7,
            closest: |p, _, vertex| {
                let q = [p[0], p[1], p[2], p[3]];
                let square: f64 = q.iter().map(|x| x * x).sum();
                at(p, 4) + turned_and_scaled(q, vertex.rest) * (1.0 / square)
            },
            excess: [0.0; 3],
        },
        "similar" => Shape {
            rest: any,
            sample: |random, rest| {
                let scale = 1.2 + random.uniform();
                placed(random, rest, scale)
            },
            residual: |v, rest| {
                let scale = extent(v) / extent(rest);
                different(v, rest, scale).max(mirrored(v, rest, scale))
            },
            ordered: false,
            parameters: 7,
            closest: |p, _, vertex| {
                at(p, 4) + turned_and_scaled([p[0], p[1], p[2], p[3]], vertex.rest)
            },
            excess: [0.0; 3],
        },
        "planar-similar" => Shape {
            rest: |random, n| cloud(random, n, 0.0),
            sample: |random, rest| {
                let scale = 1.2 + random.uniform();
                placed(random, rest, scale)
            },
            residual: |v, rest| different(v, rest, extent(v) / extent(rest)),
            ordered: false,
            parameters: 7,
            closest: |p, _, vertex| {
                at(p, 4) + turned_and_scaled([p[0], p[1], p[2], p[3]], vertex.rest)
            },
            excess: [5e-4, 0.1, 0.15],
        },
        "parallelogram" => Shape {
            rest: any,
            sample: |random, _| {
                let (centre, a, b) = (random.vector(), random.vector(), random.vector());
                vec![centre + a, centre + b, centre - a, centre - b]
            },
            residual: |v, _| parallel_sides(v),
            ordered: true,
            parameters: 9,
            closest: |p, _, vertex| {
                let (c, a, b) = (at(p, 0), at(p, 3), at(p, 6));
                [c + a, c + b, c - a, c - b][vertex.index]
            },
            excess: [0.0; 3],
        },
        "rectangle" => Shape {
            rest: any,
            sample: |random, _| {
                let (corner, [e, f, _]) = (random.vector(), random.frame());
                let (e, f) = (e * (1.5 + random.uniform()), f * (1.5 + random.uniform()));
                vec![corner, corner + e, corner + e + f, corner + f]
            },
            residual: |v, _| parallel_sides(v).max(right_angles(v)),
            ordered: true,
            parameters: 9,
            closest: |p, _, vertex| {
                let (c, a, b) = (at(p, 0), at(p, 3), at(p, 6));
                let b = b * (a.length() / b.length());
                [c + a, c + b, c - a, c - b][vertex.index]
            },
            excess: [0.0; 3],
        },
        "square" => Shape {
            residual: |v, _| parallel_sides(v).max(right_angles(v)).max(equal_sides(v)),
            ..shape("regular-polygon")
        },
        "regular-polygon" => Shape {
            rest: any,
            sample: |random, rest| {
                let (centre, [e, f, _]) = (random.vector(), random.frame());
                let size = 1.0 + 0.5 * random.uniform();
                (0..rest.len())
                    .map(|index| Vertex { index, of: rest.len(), rest: rest[index] })
                    .map(|vertex| centre + turned(e * size, f * size, vertex))
                    .collect()
            },
            residual: |v, _| in_turn(v).max(equal_sides(v)),
            ordered: true,
            parameters: 9,
            closest: |p, _, vertex| {
                let (c, e, f) = (at(p, 0), at(p, 3), at(p, 6));
                let f = f - e * (f.dot(e) / e.length_squared());
                c + turned(e, f * (e.length() / f.length()), vertex)
            },
            excess: [0.0; 3],
        },
        _ => panic!("the kind '{id}' has no account in tests/support/shapes.rs"),
    }
}

/// Rest points of kinds that do not read them.
fn any(random: &mut Random, n: usize) -> Points {
    cloud(random, n, 1.0)
}

/// The rest points scaled, turned and moved.
fn placed(random: &mut Random, rest: &[Vec3<f64>], scale: f64) -> Points {
    let (offset, frame) = (random.vector(), random.frame());
    rest.iter().map(|r| offset + in_frame(frame, *r) * scale).collect()
}

/// `q r q*` for the quaternion `q`: turned, and scaled by `|q|^2`.
fn turned_and_scaled([w, x, y, z]: [f64; 4], r: Vec3<f64>) -> Vec3<f64> {
    let q = Vec3::new(x, y, z);
    r * (w * w - q.length_squared()) + q * (2.0 * q.dot(r)) + q.cross(r) * (2.0 * w)
}

/// The root of the sum of squares.
fn extent(v: &[Vec3<f64>]) -> f64 {
    v.iter().map(|v| v.length_squared()).sum::<f64>().sqrt()
}

/// How much inner products of pairs of points differ from those of the rest points times `scale`;
/// relative to the size of the points.
fn different(v: &[Vec3<f64>], rest: &[Vec3<f64>], scale: f64) -> f64 {
    let mut worst = 0.0f64;
    for (a, r) in v.iter().zip(rest) {
        for (b, s) in v.iter().zip(rest) {
            worst = worst.max((a.dot(*b) - scale * scale * r.dot(*s)).abs());
        }
    }
    worst / size(v).powi(2)
}

/// The same for the volumes that triples of points span, which have a sign.
fn mirrored(v: &[Vec3<f64>], rest: &[Vec3<f64>], scale: f64) -> f64 {
    let mut worst = 0.0f64;
    let n = v.len();
    for i in 0..n {
        for j in i + 1..n {
            for k in j + 1..n {
                let volume = |p: &[Vec3<f64>]| p[i].dot(p[j].cross(p[k]));
                worst = worst.max((volume(v) - scale.powi(3) * volume(rest)).abs());
            }
        }
    }
    worst / size(v).powi(3)
}

/// `n` points in a box whose sides are up to 1, 1 and `flatness`, turned at random.
pub(crate) fn cloud(random: &mut Random, n: usize, flatness: f64) -> Points {
    let frame = random.frame();
    (0..n)
        .map(|_| {
            let v = random.vector();
            in_frame(frame, Vec3::new(v.x, v.y, v.z * flatness))
        })
        .collect()
}

fn at(p: &[f64], i: usize) -> Vec3<f64> {
    Vec3::new(p[i], p[i + 1], p[i + 2])
}

/// A point of the unit circle spanned by `e` and `f`.
fn on_circle(random: &mut Random, e: Vec3<f64>, f: Vec3<f64>) -> Vec3<f64> {
    loop {
        let (x, y) = (random.uniform(), random.uniform());
        let length = (x * x + y * y).sqrt();
        if length > 0.1 && length <= 1.0 {
            return e * (x / length) + f * (y / length);
        }
    }
}

/// `e` turned towards `f` to the corner of a regular polygon whose first corner is at `e`.
#[expect(clippy::disallowed_methods, reason = "independent of the corners of the operator")]
fn turned(e: Vec3<f64>, f: Vec3<f64>, vertex: Vertex) -> Vec3<f64> {
    let angle = std::f64::consts::TAU * vertex.index as f64 / vertex.of as f64;
    e * angle.cos() + f * angle.sin()
}

/// The side that begins at vertex `i`.
fn side(v: &[Vec3<f64>], i: usize) -> Vec3<f64> {
    v[(i + 1) % v.len()] - v[i % v.len()]
}

/// How far opposite sides of a quad are from being parallel and equally long.
fn parallel_sides(v: &[Vec3<f64>]) -> f64 {
    (side(v, 0) + side(v, 2)).length() / size(v)
}

/// How far the angles are from being right, as products of sides, so that a side may vanish.
fn right_angles(v: &[Vec3<f64>]) -> f64 {
    let products = (0..v.len()).map(|i| side(v, i).dot(side(v, i + 1)).abs());
    products.fold(0.0, f64::max) / size(v).powi(2)
}

fn equal_sides(v: &[Vec3<f64>]) -> f64 {
    let longer = |i| side(v, i).length() - side(v, i + 1).length();
    (0..v.len()).map(longer).fold(0.0, f64::max) / size(v)
}

/// How far centred points are from going around an ellipse in equal turns:
/// `v_(k+1) + v_(k-1) = 2 cos(2 pi / n) v_k`; and how far that is from a circle.
#[expect(clippy::disallowed_methods, reason = "independent of the corners of the operator")]
fn in_turn(v: &[Vec3<f64>]) -> f64 {
    let n = v.len();
    let factor = 2.0 * (std::f64::consts::TAU / n as f64).cos();
    (0..n)
        .map(|k| {
            let (before, here, after) = (v[k], v[(k + 1) % n], v[(k + 2) % n]);
            let off = (before + after - here * factor).length();
            off.max((here.length() - after.length()).abs()) / size(v)
        })
        .fold(0.0, f64::max)
}

/// The three singular values of the points as an n-by-3 matrix, greatest first.
fn singular_values(v: &[Vec3<f64>]) -> [f64; 3] {
    assert!(v.iter().all(|p| p.length_squared().is_finite()), "not finite: {v:?}");
    let rows: Vec<f64> = v.iter().flat_map(|p| [p.x, p.y, p.z]).collect();
    let mut values: Vec<f64> = DMatrix::from_row_slice(v.len(), 3, &rows)
        .svd(false, false)
        .singular_values
        .as_slice()
        .to_vec();
    values.resize(3, 0.0);
    values.sort_by(|a, b| b.total_cmp(a));
    [values[0], values[1], values[2]]
}

/// How far the points are from one circle or line (2 dimensions), one sphere or plane (3): they are
/// on one exactly when `A |x|^2 + b.x + c = 0` has a solution, that is when the rows
/// `(|x|^2, x, 1)` have not full rank.
fn round_residual(v: &[Vec3<f64>], dimensions: usize) -> f64 {
    let columns = dimensions + 2;
    if v.len() < columns {
        return 0.0;
    }
    let rows: Vec<f64> = v.iter().flat_map(|p| [p.x, p.y, p.z]).collect();
    let points = DMatrix::from_row_slice(v.len(), 3, &rows) / size(v);
    let axes = points.clone().svd(false, true).v_t.expect("asked for");
    let x = &points * axes.rows(0, dimensions).transpose();
    let matrix = DMatrix::from_fn(v.len(), columns, |i, j| match j {
        0 => x.row(i).norm_squared(),
        j if j <= dimensions => x[(i, j - 1)],
        _ => 1.0,
    });
    matrix.svd(false, false).singular_values.min()
}
