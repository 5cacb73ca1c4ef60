//! A small drawing of a kind, made by the operator itself: sample points off the shape and their
//! projection, seen obliquely from above.
//!
//! The sample follows from the declaration, and goes through the same batches as a mesh.

use super::{Arity, Centring, Element, Fitted, Info, Kind, KindVisitor, Projection};
use super::{Reference, Row, batches};
use crate::math::{UnitPolygon, Vec3};
use crate::mesh::{Mesh, Point, Ragged, Surface};
use serde::Serialize;
use std::rc::Rc;

/// A drawing in the unit square, `x` to the right and `y` downwards.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Sketch {
    /// The sample before projection, `#P by 2`.
    pub points: Vec<[f64; 2]>,
    /// Its projection, `#P by 2`.
    pub projected: Vec<[f64; 2]>,
    /// The lines between points, `#L by 2`.
    pub lines: Vec<[usize; 2]>,
    /// The fitted shapes, as closed curves.
    pub outlines: Vec<Vec<[f64; 2]>>,
}

impl Kind {
    /// Returns the drawing of the kind with these parameters; deterministic on every machine.
    pub fn sketch(&self) -> Sketch {
        let sample = Sample::new(self.info(), self.visit(ReadsRest));
        let x = to_rows(&sample.points);
        let mesh = sample.mesh();
        let surface = || Rc::new(Surface::new(&mesh.positions, &mesh));
        let reference = Reference { surface: &surface, pose: None };
        let rest = to_rows(&sample.rest);
        let mut batches = batches(self, &sample.members, &rest, 1.0, false, &reference);

        // With weight one and each point in one constraint, half the gradient is the offset of a
        // point from its projection (Appendix A).
        let mut off = vec![[0.0; 4]; x.len()];
        let mut shapes = Vec::new();
        for batch in &mut batches {
            batch.local_step(&x, &mut off, 1.0);
            batch.fitted(&x, &mut shapes);
        }
        let off = off.iter().map(|&[x, y, z, _]| Vec3::new(x, y, z));
        let projected: Vec<_> = sample.points.iter().zip(off).map(|(v, off)| *v - off).collect();
        let seen = |points: &[Vec3<f64>]| points.iter().map(|p| seen(*p)).collect();
        let sketch = Sketch {
            points: seen(&sample.points),
            projected: seen(&projected),
            lines: sample.lines,
            outlines: shapes.iter().flat_map(outlines).map(|curve| seen(&curve)).collect(),
        };
        sketch.in_unit_square()
    }
}

impl Sketch {
    fn in_unit_square(mut self) -> Sketch {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for point in self.all() {
            for axis in 0..2 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        let size = (high[0] - low[0]).max(high[1] - low[1]);
        for point in self.all() {
            for axis in 0..2 {
                let off_middle = (point[axis] - 0.5 * (low[axis] + high[axis])) / size;
                // Keeps rounded values inside the square.
                point[axis] = (0.5 + off_middle).clamp(0.0, 1.0);
            }
        }
        self
    }

    fn all(&mut self) -> impl Iterator<Item = &mut [f64; 2]> {
        let Sketch { points, projected, outlines, .. } = self;
        points.iter_mut().chain(projected).chain(outlines.iter_mut().flatten())
    }
}

/// Whether an operator reads the rest points.
struct ReadsRest;

impl KindVisitor for ReadsRest {
    type Output = bool;
    fn visit<P: Projection>(self, _: &P) -> bool {
        P::READS_REST
    }
}

/// The sample: a figure of about unit size and a perturbed copy of it.
struct Sample {
    /// `#P`.
    rest: Vec<Vec3<f64>>,
    /// `#P`.
    points: Vec<Vec3<f64>>,
    /// The points of each constraint.
    members: Ragged,
    /// `#L by 2`.
    lines: Vec<[usize; 2]>,
}

/// The number of points for open arities.
const MANY: usize = 8;

/// The perturbation of each point of the figure.
const DISTURBANCE: [[f64; 3]; 8] = [
    [0.12, -0.18, 0.26],
    [-0.24, 0.14, -0.28],
    [0.18, 0.24, 0.22],
    [-0.10, -0.26, -0.18],
    [-0.28, 0.06, 0.30],
    [0.24, -0.12, -0.26],
    [0.08, -0.28, 0.16],
    [-0.26, 0.16, -0.22],
];

impl Sample {
    fn new(info: &Info, reads_rest: bool) -> Sample {
        let n = match (info.arity, info.centring) {
            (Arity::Exactly(n), _) => n,
            // Four edges.
            (Arity::AtLeast(least), Centring::ByEdge) => least.max(8),
            (Arity::AtLeast(least), _) => least.max(MANY),
        };
        let by_edge = info.centring == Centring::ByEdge;
        // For kinds of one point, several constraints make up a figure.
        let all = if n == 1 { MANY } else { n };
        let (rest, lines) = match info.elements.first() {
            _ if by_edge => edges(all),
            Some(Element::Star) => star(all),
            Some(Element::Hinge) if all == 4 => hinge(),
            Some(Element::Tet) if all == 4 => tetrahedron(),
            Some(Element::Corner) => (polygon(all), path(all)),
            _ if all == 2 => (vec![Vec3::new(-0.9, 0.7, 0.0), Vec3::new(0.9, -0.7, 0.0)], path(2)),
            _ if reads_rest && matches!(info.arity, Arity::AtLeast(0..=7)) => arrow(),
            _ => (polygon(all), loop_of(all)),
        };
        // Kinds with a rest shape are shown shrunk, as they keep its size. Characteristic figures
        // and parallel edges get a smaller perturbation, as a larger one would obscure them.
        let scale = if reads_rest { 0.75 } else { 1.0 };
        let is_star = info.elements.first() == Some(&Element::Star);
        let disturbance = if reads_rest || by_edge || is_star { 0.55 } else { 1.0 };
        let all = rest.len();
        let n = n.min(all);
        let disturbed = rest.iter().zip(DISTURBANCE.iter().cycle());
        Sample {
            points: disturbed.map(|(v, by)| *v * scale + Vec3::from(*by) * disturbance).collect(),
            rest,
            members: (0..all as u32).collect::<Vec<_>>().chunks(n).collect(),
            lines,
        }
    }

    /// The figure as a mesh of one face.
    fn mesh(&self) -> Mesh {
        let all: Vec<u32> = (0..self.rest.len() as u32).collect();
        let positions: Vec<Point> = self.rest.iter().map(|v| Point::from(*v)).collect();
        Mesh { positions, faces: std::iter::once(&all[..]).collect(), ..Mesh::default() }
    }
}

type Figure = (Vec<Vec3<f64>>, Vec<[usize; 2]>);

fn loop_of(n: usize) -> Vec<[usize; 2]> {
    (0..n).map(|k| [k, (k + 1) % n]).collect()
}

fn path(n: usize) -> Vec<[usize; 2]> {
    (1..n).map(|k| [k - 1, k]).collect()
}

/// An elongated polygon in the plane; four corners form an axis-aligned rectangle.
fn polygon(n: usize) -> Vec<Vec3<f64>> {
    let corners = UnitPolygon::new(2 * n);
    (0..n).map(|k| corners[2 * k + 1]).map(|[x, y]| Vec3::new(1.2 * x, 0.85 * y, 0.0)).collect()
}

/// An arrow: not regular, but mirror-symmetric.
fn arrow() -> Figure {
    let corners =
        [[-0.4, -1.0], [0.4, -1.0], [0.4, 0.1], [1.0, 0.1], [0.0, 1.2], [-1.0, 0.1], [-0.4, 0.1]];
    (corners.map(|[x, y]| Vec3::new(x, y, 0.0)).to_vec(), loop_of(corners.len()))
}

/// Edges side by side, of different lengths; `n` ends.
fn edges(n: usize) -> Figure {
    let count = n / 2;
    let edge = |k: usize| {
        let along = Vec3::new(0.25, 0.9, 0.0) * [1.0, 0.5, 0.8, 0.35][k % 4];
        let middle = Vec3::new(0.6 * (k as f64 - 0.5 * (count - 1) as f64), 0.0, 0.0);
        [middle - along, middle + along]
    };
    ((0..count).flat_map(edge).collect(), (0..count).map(|k| [2 * k, 2 * k + 1]).collect())
}

/// The centre, then the rim around it, farther down and elongated, so that its angles are unequal.
fn star(n: usize) -> Figure {
    let around = n - 1;
    let mut points = vec![Vec3::new(0.0, 0.0, 0.5)];
    points.extend(polygon(around).iter().map(|v| Vec3::new(v.x, 0.6 * v.y, v.z)));
    let spokes = (1..n).map(|k| [0, k]);
    let rim = loop_of(around).into_iter().map(|[a, b]| [a + 1, b + 1]);
    (points, spokes.chain(rim).collect())
}

/// The ends of a ridge, then the two corners beside it.
fn hinge() -> Figure {
    let points = [[0.0, -0.9, 0.5], [0.0, 0.9, 0.5], [-1.0, 0.0, -0.2], [1.0, 0.0, -0.2]];
    (points.map(Vec3::from).to_vec(), vec![[0, 1], [0, 2], [1, 2], [0, 3], [1, 3]])
}

fn tetrahedron() -> Figure {
    let mut points = polygon(3);
    points.push(Vec3::new(0.0, 0.0, 1.4));
    (points, vec![[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]])
}

fn to_rows(points: &[Vec3<f64>]) -> Vec<Row> {
    points.iter().map(|p| [p.x, p.y, p.z, 0.0]).collect()
}

/// Unit vectors to the right and upwards in the drawing: seen from the front, slightly left, and
/// above.
const RIGHT: [f64; 3] = [0.96, -0.28, 0.0];
const UP: [f64; 3] = [0.224, 0.768, 0.6];

fn seen(p: Vec3<f64>) -> [f64; 2] {
    [p.dot(Vec3::from(RIGHT)), -p.dot(Vec3::from(UP))]
}

/// Returns a fitted shape as closed curves: a sphere by its outline in the drawing and its equator.
fn outlines(shape: &Fitted) -> Vec<Vec<Vec3<f64>>> {
    let (right, up) = (Vec3::from(RIGHT), Vec3::from(UP));
    match *shape {
        Fitted::Circle { centre, normal, radius } => vec![circle(centre, across(normal), radius)],
        Fitted::Sphere { centre, radius } => {
            let vertical = Vec3::new(0.0, 0.0, 1.0);
            vec![circle(centre, [right, up], radius), circle(centre, across(vertical), radius)]
        }
    }
}

/// Returns the circle about `centre` in the plane of two orthogonal unit vectors.
fn circle(centre: Vec3<f64>, [e, f]: [Vec3<f64>; 2], radius: f64) -> Vec<Vec3<f64>> {
    UnitPolygon::new(48).iter().map(|&[x, y]| centre + (e * x + f * y) * radius).collect()
}

/// Returns two unit vectors orthogonal to a unit vector and to each other.
fn across(normal: Vec3<f64>) -> [Vec3<f64>; 2] {
    let (right, up) = (Vec3::from(RIGHT), Vec3::from(UP));
    // The axis farther from the normal.
    let near = if normal.dot(right).abs() < normal.dot(up).abs() { right } else { up };
    let e = near - normal * near.dot(normal);
    let e = e * (1.0 / e.length());
    [e, normal.cross(e)]
}
