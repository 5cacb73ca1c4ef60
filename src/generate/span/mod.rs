//! Surfaces between the curves of a file, its polylines, the boundaries of its faces, and polylines
//! that close together: the curves, points in equal steps along them, and why there is no surface
//! between them.

mod chains;
mod fill;
mod loft;

use chains::{closed_chains, one_place};
pub use fill::fill;
pub use loft::loft;

use crate::generate::quads::TooManyFaces;
use crate::generate::sides::even_steps;
use crate::math::{Vec3, angle_between};
use crate::mesh::{Mesh, Topology};
use crate::words;
use serde::Serialize;
use std::fmt;

/// Turns of more degrees than this are corners, which are kept.
const CORNER: f64 = 30.0;

/// Why there is no surface between curves.
#[derive(Clone, Debug, PartialEq)]
pub enum SpanError {
    /// There is no such curve.
    Missing {
        /// The index asked for, from 0.
        asked: usize,
        /// The number of curves.
        found: usize,
    },
    /// A curve without length.
    NoLength,
    /// Only one of two curves is closed.
    OneClosed,
    /// A closed curve was expected.
    Open,
    /// The two curves are the same.
    Same,
    /// A size of panels that is not a positive length.
    Size(f64),
    /// Too many faces.
    TooManyFaces(TooManyFaces),
    /// The surface inside the curve would be folded.
    Folded,
}

impl fmt::Display for SpanError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            SpanError::Missing { asked, found } => {
                let has = words::count(found, "curve or boundary", "curves and boundaries");
                write!(f, "there is no curve {asked}: the file has {has}, counted from 0")
            }
            SpanError::NoLength => f.write_str("the curve has no length"),
            SpanError::OneClosed => f.write_str(
                "one curve is closed and the other is open: expected both closed or both open",
            ),
            SpanError::Open => f.write_str("expected a closed curve or boundary"),
            SpanError::Same => f.write_str("expected two different curves"),
            SpanError::Size(found) => write!(f, "expected a panel size above 0, found {found}"),
            SpanError::TooManyFaces(why) => why.fmt(f),
            SpanError::Folded => f.write_str(
                "the surface would be folded: the curve turns back between its four corners",
            ),
        }
    }
}

impl std::error::Error for SpanError {}

/// A polyline in space.
#[derive(Clone, Debug, PartialEq)]
pub struct SpanCurve {
    /// In order, each different from the one before; a closed curve does not repeat its first
    /// point.
    points: Vec<Vec3<f64>>,
    closed: bool,
    source: Source,
}

/// What a curve is in its file.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Source {
    Polyline,
    /// Of faces.
    Boundary,
    /// Of several polylines, each of which ends where the next one begins.
    Chain,
}

/// A curve as hosts list it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct CurveLabel {
    /// Label, such as "Curve 1", "Boundary 2" or "Joined curves 1".
    pub label: String,
    /// Length in the unit of the mesh.
    pub length: f64,
    /// Whether it ends where it begins.
    pub closed: bool,
}

impl SpanCurve {
    /// The polylines of `mesh`, then the boundaries of its faces, then the closed curves that
    /// several polylines make together.
    pub fn all(mesh: &Mesh) -> Vec<SpanCurve> {
        let topology = Topology::new(mesh);
        let polylines = mesh.curves.iter().map(|curve| (curve.to_vec(), Source::Polyline));
        let boundaries = topology.boundary_loops().iter().map(|row| {
            let again = topology.is_closed_loop(row).then_some(row[0]);
            (row.iter().copied().chain(again).collect(), Source::Boundary)
        });
        let chains = closed_chains(mesh).into_iter().map(|chain| (chain, Source::Chain));
        let through = |(vertices, source): (Vec<u32>, Source)| {
            let near = one_place(mesh, &vertices);
            let mut points: Vec<_> =
                vertices.iter().map(|&v| Vec3::from(mesh.positions[v as usize])).collect();
            let meet = |a: Vec3<f64>, b: Vec3<f64>| (b - a).length() <= near;
            // Steps without length have no direction.
            points.dedup_by(|next, last| meet(*last, *next));
            let closed = points.len() > 3 && meet(points[0], points[points.len() - 1]);
            points.truncate(points.len() - usize::from(closed));
            SpanCurve { points, closed, source }
        };
        polylines.chain(boundaries).chain(chains).map(through).collect()
    }

    /// The labels and lengths of curves, for hosts to list.
    pub fn labels(curves: &[SpanCurve]) -> Vec<CurveLabel> {
        let mut counts = [0; 3];
        let label = |curve: &SpanCurve| {
            let count = &mut counts[curve.source as usize];
            *count += 1;
            let name = match curve.source {
                Source::Polyline => "Curve",
                Source::Boundary => "Boundary",
                Source::Chain => "Joined curves",
            };
            let length = length_of(&curve.ring());
            CurveLabel { label: format!("{name} {count}"), length, closed: curve.closed }
        };
        curves.iter().map(label).collect()
    }

    /// Whether it ends where it begins.
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// The curve with this index.
    ///
    /// # Errors
    /// If there is none, or it has no length.
    pub fn of(curves: &[SpanCurve], number: usize) -> Result<&SpanCurve, SpanError> {
        let curve = curves.get(number);
        let curve = curve.ok_or(SpanError::Missing { asked: number, found: curves.len() })?;
        if length_of(&curve.ring()) > 0.0 { Ok(curve) } else { Err(SpanError::NoLength) }
    }

    /// Its points from end to end; a closed curve ends with its first point.
    fn ring(&self) -> Vec<Vec3<f64>> {
        let again = self.points.first().filter(|_| self.closed);
        self.points.iter().chain(again).copied().collect()
    }

    /// The indices of points that turn by more than [`CORNER`], with the turn in degrees; ends do
    /// not count.
    fn corners(&self) -> Vec<(usize, f64)> {
        let n = self.points.len();
        let inner = if self.closed { 0..n } else { 1..n.max(2) - 1 };
        let turn = |k: usize| {
            let [before, here, after] = [k + n - 1, k, k + 1].map(|k| self.points[k % n]);
            let (a, b) = (here - before, after - here);
            angle_between(a, b).map_or(0.0, f64::to_degrees)
        };
        inner.map(|k| (k, turn(k))).filter(|&(_, degrees)| degrees > CORNER).collect()
    }
}

/// The length of a polyline.
fn length_of(points: &[Vec3<f64>]) -> f64 {
    points.windows(2).map(|ends| (ends[1] - ends[0]).length()).sum()
}

/// `n + 1` points in equal steps along a polyline from end to end. The points in `corners` replace
/// the nearest of them, as far as there are enough: the indices of these are second.
fn evenly(points: &[Vec3<f64>], corners: &[usize], n: usize) -> (Vec<Vec3<f64>>, Vec<usize>) {
    let mut ends = vec![0.0];
    for pair in points.windows(2) {
        ends.push(ends[ends.len() - 1] + (pair[1] - pair[0]).length());
    }
    let point = |(k, part): (usize, f64)| match part {
        0.0 => points[k],
        1.0 => points[k + 1],
        _ => points[k] + (points[k + 1] - points[k]) * part,
    };
    let (steps, kept) = even_steps(&ends, corners.iter().copied(), n);
    (steps.into_iter().map(point).collect(), kept)
}
