//! The normal space of a constraint, by central differences of its projection only.
//!
//! If `P` projects to a set, `J = I - DP` at a point of the set is zero along the set and nowhere
//! else. If `P` is the closest point, `J` is the orthogonal projector to the normal space, and
//! `J^T J` is the same projector. For another projection to the same set `J^T J` still has the same
//! kernel, and errors of `J` enter it squared.

use super::hard_rows::HardBatch;
use crate::constraint::{Centring, Row};
use crate::math::{LANES, Lanes, Vec3};

/// The step of the differences, relative to the root mean square of the points. There the rounding
/// and the truncation error of a difference are about equal.
const STEP: f64 = 1e-6;

/// An entry of `J` beyond this is not a derivative: the projection jumps there.
const LARGEST: f64 = 10.0;

/// The fraction of their width at which bands begin to hold, slightly inside.
pub(super) const BAND: f64 = 0.98;

/// The linearisation of a constraint at some positions.
pub(super) struct Linear<'a> {
    /// The residual, three numbers for each point.
    pub residual: &'a mut [f64],
    /// `J^T J`, row by row.
    pub normal: &'a mut [f64],
}

/// Storage for the points of one constraint in all lanes.
pub(super) struct Differences {
    points: Vec<Vec3<Lanes>>,
    projected: Vec<Vec3<Lanes>>,
    /// `J`, column by column.
    columns: Vec<f64>,
    /// The columns that differences are computed for; centring gives the others.
    own: Vec<usize>,
}

impl Differences {
    pub(super) fn new(points: usize, centring: Centring) -> Differences {
        let is_first = |k: usize| (k / 3).is_multiple_of(group(points, centring));
        let is_own = |k: &usize| centring == Centring::Placed || !is_first(*k);
        Differences {
            points: vec![Vec3::zero(); points],
            projected: vec![Vec3::zero(); points],
            columns: vec![0.0; 9 * points * points],
            own: (0..3 * points).filter(is_own).collect(),
        }
    }

    /// Linearises constraint `i` of a batch, or of the band around its shapes, at positions `x`.
    /// Its residual there must be in `to`. `unit` is a length of the size of the model, for
    /// constraints without a size of their own.
    pub(super) fn linearise(
        &mut self,
        (hard, band): (&HardBatch, Option<f64>),
        i: usize,
        x: &[Row],
        unit: f64,
        to: Linear<'_>,
    ) {
        to.normal.fill(0.0);
        if band.is_some() {
            return across_band(to);
        }
        let Differences { points, projected, .. } = self;
        hard.batch.gather(i / LANES, x, points);
        points.iter_mut().for_each(|point| *point = Vec3::splat(point.lane(i % LANES)));
        let rest = hard.batch.rest_of(i);
        hard.batch.project_copies(&rest, points, projected);
        hard.batch.centre(projected);
        let at: Vec<Vec3<f64>> = projected.iter().map(|point| point.lane(0)).collect();
        let Some(step) = step(&at, unit) else { return along_residual(to) };
        let size = 3 * at.len();
        // Each lane has a displaced copy: forwards or backwards along one coordinate of one point.
        for pairs in self.own.chunks(LANES / 2) {
            for (point, at) in self.points.iter_mut().zip(&at) {
                *point = Vec3::splat(*at);
            }
            for (pair, &k) in pairs.iter().enumerate() {
                for (lane, by) in [(2 * pair, step), (2 * pair + 1, -step)] {
                    self.points[k / 3].set_lane(lane, moved(at[k / 3], k % 3, by));
                }
            }
            hard.batch.centre(&mut self.points);
            hard.batch.project_copies(&rest, &self.points, &mut self.projected);
            hard.batch.centre(&mut self.projected);
            for (pair, &k) in pairs.iter().enumerate() {
                let column = &mut self.columns[k * size..(k + 1) * size];
                let residuals = self.points.iter().zip(&self.projected).map(|(z, p)| *z - *p);
                for (to, residual) in column.chunks_exact_mut(3).zip(residuals) {
                    let change = residual.lane(2 * pair) - residual.lane(2 * pair + 1);
                    let derivative = change * (0.5 / step);
                    to.copy_from_slice(&[derivative.x, derivative.y, derivative.z]);
                }
            }
        }
        if self.own.len() < size {
            self.derive_others(group(at.len(), hard.batch.centring()));
        }
        // Written so that NaN is not a derivative either.
        if !self.columns.iter().all(|value| value.abs() < LARGEST) {
            return along_residual(to);
        }
        for (a, left) in self.columns.chunks_exact(size).enumerate() {
            for (b, right) in self.columns.chunks_exact(size).enumerate().take(a + 1) {
                let entry = left.iter().zip(right).map(|(l, r)| l * r).sum();
                to.normal[a * size + b] = entry;
                to.normal[b * size + a] = entry;
            }
        }
    }

    /// If points are centred in groups of this size, moving a whole group changes nothing: the
    /// columns of its first point are minus the sum of the others.
    fn derive_others(&mut self, group: usize) {
        let size = 3 * self.points.len();
        for points in self.columns.chunks_exact_mut(3 * group * size) {
            let (first, others) = points.split_at_mut(3 * size);
            first.fill(0.0);
            for columns in others.chunks_exact(3 * size) {
                first.iter_mut().zip(columns).for_each(|(to, value)| *to -= value);
            }
        }
    }
}

/// Number of points that are centred together.
fn group(points: usize, centring: Centring) -> usize {
    match centring {
        Centring::Together => points,
        Centring::ByEdge => 2,
        Centring::Placed => 1,
    }
}

/// The step of the differences at these points; `None` if they coincide.
fn step(at: &[Vec3<f64>], unit: f64) -> Option<f64> {
    if let [_] = at {
        return Some(STEP * unit);
    }
    let mean = at.iter().fold(Vec3::zero(), |sum, p| sum + *p) * (1.0 / at.len() as f64);
    let squares: f64 = at.iter().map(|p| (*p - mean).length_squared()).sum();
    let radius = (squares / at.len() as f64).sqrt();
    (radius > 1e-9 * unit).then_some(STEP * radius)
}

fn moved(point: Vec3<f64>, coordinate: usize, by: f64) -> Vec3<f64> {
    let mut moved: [f64; 3] = point.into();
    moved[coordinate] += by;
    moved.into()
}

/// Without a derivative, uses the direction to the shape.
fn along_residual(to: Linear<'_>) {
    let size = to.residual.len();
    let squared: f64 = to.residual.iter().map(|r| r * r).sum();
    if squared > 0.0 && squared < f64::INFINITY {
        for (a, row) in to.normal.chunks_exact_mut(size).enumerate() {
            for (b, entry) in row.iter_mut().enumerate() {
                *entry = to.residual[a] * to.residual[b] / squared;
            }
        }
    }
}

/// A band holds each point beyond it along the direction to the shape, and no other point.
fn across_band(to: Linear<'_>) {
    let size = to.residual.len();
    for (k, away) in to.residual.chunks_exact(3).enumerate() {
        let squared = away.iter().map(|r| r * r).sum::<f64>();
        if squared > 0.0 && squared < f64::INFINITY {
            for (r, c) in (0..3).flat_map(|r| (0..3).map(move |c| (r, c))) {
                to.normal[(3 * k + r) * size + 3 * k + c] = away[r] * away[c] / squared;
            }
        }
    }
}
