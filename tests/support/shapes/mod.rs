//! Independent descriptions of the kinds, without their operators: rest points, points that have
//! the shape, a residual that measures the distance from it, and the set of the shape by free
//! parameters, for brute force.
//!
//! A kind without a description is tested only by the properties that need none. With one, its
//! projection is also compared with the set itself: add it to a file here, or a new file to the
//! list in [`shapes`].

mod conical;
mod corner;
mod extent;
mod flat;
mod hinge;
mod incircles;
mod length;
mod placed;
mod polygon;
mod relative;
mod round;
mod symmetric;

use crate::support::random::{Points, Random, in_frame, size};
use nalgebra::DMatrix;
use shape_up::constraint::Info;
use shape_up::math::Vec3;

/// See [`Shape::residual`].
pub(crate) type Residual = fn(&[Vec3<f64>], &[Vec3<f64>]) -> f64;

/// See [`Shape::closest`].
pub(crate) type Closest = fn(&[f64], Vec3<f64>, Vertex) -> Vec3<f64>;

/// Independent description of a kind with certain parameters. The points are centred as the kind
/// declares; if that is by edge, they come in pairs.
#[derive(Clone, Copy)]
pub(crate) struct Shape {
    /// The parameters as a JSON object.
    pub(crate) params: &'static str,
    /// `n` rest points, of size about one.
    pub(crate) rest: fn(&mut Random, usize) -> Points,
    /// Points that have the shape, of size about one, as many as the rest points.
    pub(crate) sample: fn(&mut Random, &[Vec3<f64>]) -> Points,
    /// Zero exactly if the centred points have the shape, for the centred rest points; relative to
    /// their size.
    pub(crate) residual: Residual,
    /// Permutations of the vertices that keep the meaning, if the rest points are permuted too.
    pub(crate) relabellings: fn(&mut Random, usize) -> Vec<Vec<usize>>,
    /// Number of free parameters of the shape.
    pub(crate) parameters: usize,
    /// The point closest to `v` on the shape with these parameters; it may depend on the vertex,
    /// the last argument.
    pub(crate) closest: Closest,
    /// Whether the projection is the closest point of the set; the kind declares the value of its
    /// first description.
    pub(crate) exact: bool,
    /// Whether the set is described; if not, only properties that need no set are tested.
    pub(crate) tells_the_set: bool,
    /// If not exact: bound on the relative excess of the squared distance over the least one, for
    /// shapes disturbed by [`NOISE`].
    pub(crate) excess: [f64; 3],
}

/// Identifies a vertex of a constraint.
#[derive(Clone, Copy)]
pub(crate) struct Vertex {
    pub(crate) index: usize,
    /// Number of vertices.
    pub(crate) of: usize,
    pub(crate) rest: Vec3<f64>,
}

/// Disturbances of a shape of size about one, for [`Shape::excess`].
pub(crate) const NOISE: [f64; 3] = [0.01, 0.1, 0.3];

impl Shape {
    /// For struct updates: no parameters, any rest points, any order, exact.
    pub(crate) const ANY: Shape = Shape {
        params: "{}",
        rest: any,
        sample: |_, _| unreachable!("every account says what has the shape"),
        residual: |_, _| unreachable!("every account says what has not"),
        relabellings: any_order,
        parameters: 0,
        closest: |_, _, _| unreachable!("every account says what is closest"),
        exact: true,
        tells_the_set: true,
        excess: [0.0; 3],
    };

    /// Placeholder for a kind without a description.
    fn unknown(info: &Info) -> Shape {
        Shape {
            sample: |random, rest| cloud(random, rest.len(), 1.0),
            relabellings: |_, _| Vec::new(),
            exact: info.exact,
            tells_the_set: false,
            ..Shape::ANY
        }
    }
}

/// The descriptions of a kind, the first with its default parameters.
pub(crate) fn shapes(info: &Info) -> Vec<Shape> {
    let accounts = [
        flat::shapes,
        round::shapes,
        relative::shapes,
        polygon::shapes,
        length::shapes,
        corner::shapes,
        extent::shapes,
        hinge::shapes,
        symmetric::shapes,
        placed::shapes,
        incircles::shapes,
        conical::shapes,
    ];
    let account = accounts.iter().find_map(|shapes| shapes(info.id));
    account.unwrap_or_else(|| vec![Shape::unknown(info)])
}

/// Any order of the vertices.
pub(crate) fn any_order(random: &mut Random, n: usize) -> Vec<Vec<usize>> {
    let mut order: Vec<usize> = (0..n).collect();
    for i in (1..n).rev() {
        let j = ((random.uniform() + 1.0) / 2.0 * (i + 1) as f64) as usize;
        order.swap(i, j.min(i));
    }
    vec![order]
}

/// The same cycle with another start, and reversed.
pub(crate) fn in_turn_or_back(_: &mut Random, n: usize) -> Vec<Vec<usize>> {
    vec![(0..n).map(|i| (i + 1) % n).collect(), (0..n).rev().collect()]
}

/// Rest points of kinds that do not read them.
fn any(random: &mut Random, n: usize) -> Points {
    cloud(random, n, 1.0)
}

/// The rest points scaled, rotated and moved.
fn placed(random: &mut Random, rest: &[Vec3<f64>], scale: f64) -> Points {
    let (offset, frame) = (random.vector(), random.frame());
    rest.iter().map(|r| offset + in_frame(frame, *r) * scale).collect()
}

/// `q r q*` for the quaternion `q`: rotated, and scaled by `|q|^2`.
fn turned_and_scaled([w, x, y, z]: [f64; 4], r: Vec3<f64>) -> Vec3<f64> {
    let q = Vec3::new(x, y, z);
    r * (w * w - q.length_squared()) + q * (2.0 * q.dot(r)) + q.cross(r) * (2.0 * w)
}

/// Square root of the sum of squared lengths.
fn extent(v: &[Vec3<f64>]) -> f64 {
    v.iter().map(|v| v.length_squared()).sum::<f64>().sqrt()
}

/// Greatest difference of inner products of pairs of points from those of the rest points times
/// `scale`; relative to the size of the points.
fn different(v: &[Vec3<f64>], rest: &[Vec3<f64>], scale: f64) -> f64 {
    let mut worst = 0.0f64;
    for (a, r) in v.iter().zip(rest) {
        for (b, s) in v.iter().zip(rest) {
            worst = worst.max((a.dot(*b) - scale * scale * r.dot(*s)).abs());
        }
    }
    worst / size(v).powi(2)
}

/// The same for the signed volumes of triples of points.
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

/// `n` points in a box with sides of up to 1, 1 and `flatness`, rotated at random.
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

/// Corner of the regular polygon whose first corner is `e`, in the direction of `f`.
#[expect(clippy::disallowed_methods, reason = "independent of the corners of the operator")]
fn turned(e: Vec3<f64>, f: Vec3<f64>, vertex: Vertex) -> Vec3<f64> {
    let angle = std::f64::consts::TAU * vertex.index as f64 / vertex.of as f64;
    e * angle.cos() + f * angle.sin()
}

/// The side that begins at vertex `i`.
fn side(v: &[Vec3<f64>], i: usize) -> Vec3<f64> {
    v[(i + 1) % v.len()] - v[i % v.len()]
}

/// How far opposite sides of a quad are from parallel and equal length.
fn parallel_sides(v: &[Vec3<f64>]) -> f64 {
    (side(v, 0) + side(v, 2)).length() / size(v)
}

/// How far the angles are from right angles, as inner products of sides, so that a side of length
/// zero is allowed.
fn right_angles(v: &[Vec3<f64>]) -> f64 {
    let products = (0..v.len()).map(|i| side(v, i).dot(side(v, i + 1)).abs());
    products.fold(0.0, f64::max) / size(v).powi(2)
}

fn equal_sides(v: &[Vec3<f64>]) -> f64 {
    let longer = |i| side(v, i).length() - side(v, i + 1).length();
    (0..v.len()).map(longer).fold(0.0, f64::max) / size(v)
}

/// Deviation of centred points from equal steps around an ellipse,
/// `v_(k+1) + v_(k-1) = 2 cos(2 pi / n) v_k`, and of the ellipse from a circle.
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

/// Distance of the points from a common circle or line (2 dimensions), or sphere or plane (3): they
/// are on one exactly if `A |x|^2 + b.x + c = 0` has a solution, that is, if the rows
/// `(|x|^2, x, 1)` are rank-deficient.
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
