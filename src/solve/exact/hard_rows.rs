//! Hard constraints in batches, with shifted projections: `rho * sum w |z + u - P(z + u)|^2` is the
//! augmented Lagrangian of the constraint that `z` is in the set that `P` projects to, with
//! `z = N_i x` and the shift `u`. Its gradient is that of the shape energy with `z + u` for `z`, so
//! that the normal matrix of the iteration majorises it too.
//!
//! "Within a distance" is the same with a projection that goes only as far as the band around the
//! shape.

use super::requirement::Require;
use crate::constraint::{Batch, Reference, Row, batches};
use crate::math::{LANES, Lane, Lanes, Vec3};
use crate::mesh::{Mesh, Point};
use crate::solve::energy::Constraints;
use crate::solve::local_frame::{centre_and_extent, rest_surface, rows};
use std::rc::Rc;

/// Bands are aimed at from inside, at this fraction of their width: the approach ends on one side
/// of its aim.
const AIM: f64 = 0.5;

/// A guarded edge is far from its bound if it may be shorter by this fraction.
const SHORTER: f64 = 1e-5;

/// Hard constraints of one row with the same number of points.
pub(in crate::solve) struct HardBatch {
    /// The row of constraints of the problem; `None` for the guard.
    pub row: Option<usize>,
    /// The width of the band; `None` if the shape itself is required.
    pub within: Option<f64>,
    pub batch: Batch,
    /// `u`, in the layout of the nodes of the batch.
    shift: Vec<Vec3<Lanes>>,
    /// `z + u - P(z + u)` of the last local step.
    residual: Vec<Vec3<Lanes>>,
}

/// The batches of all hard rows, and of the guard.
pub(in crate::solve) struct HardRows {
    pub batches: Vec<HardBatch>,
}

/// A row of constraints, its index in the problem, and its requirement.
pub(in crate::solve) type HardRow<'a> = (&'a Constraints, Option<usize>, Require);

/// The distance of a constraint from being met.
#[derive(Clone, Copy)]
pub(in crate::solve) struct Miss {
    /// The greatest distance of a point to the fitted shape.
    pub distance: f64,
    /// The part of it beyond the allowed distance.
    pub excess: f64,
}

impl HardRows {
    /// Batches the rows. `node_of` is the node of each vertex, `rest` the rest position of each
    /// node.
    pub(in crate::solve) fn new(
        rows: &[HardRow<'_>],
        node_of: &[u32],
        rest: &[Row],
        reference: &Reference<'_>,
    ) -> HardRows {
        let mut all = Vec::new();
        for &(row, index, require) in rows {
            let mut members = row.members.clone();
            members.rename(node_of);
            for batch in batches(&row.kind, &members, rest, row.weight, false, reference) {
                let zeros = vec![Vec3::zero(); batch.nodes().len()];
                let within = match require {
                    Require::Within(distance) => Some(distance),
                    Require::Soft | Require::Exact => None,
                };
                all.push(HardBatch {
                    row: index,
                    within,
                    batch,
                    shift: zeros.clone(),
                    residual: zeros,
                });
            }
        }
        HardRows { batches: all }
    }

    /// Batches `constraints` as exact ones whose rest shape is `mesh`, each vertex its own node, in
    /// coordinates relative to the centre of the mesh. Kinds take their rest shape from the `pose`,
    /// `#V by 3`, if given.
    pub(in crate::solve) fn at_rest(
        mesh: &Mesh,
        pose: Option<&[Point]>,
        constraints: &[Constraints],
    ) -> HardRows {
        let (centre, _) = centre_and_extent(mesh);
        let pose = pose.map(|pose| rows(pose, centre));
        let surface = || Rc::new(rest_surface(mesh, centre));
        let reference = Reference { surface: &surface, pose: pose.as_deref() };
        let exact = |(index, row)| (row, Some(index), Require::Exact);
        let exact: Vec<HardRow<'_>> = constraints.iter().enumerate().map(exact).collect();
        let own_nodes: Vec<u32> = (0..mesh.positions.len() as u32).collect();
        HardRows::new(&exact, &own_nodes, &rows(&mesh.positions, centre), &reference)
    }

    /// The local step with shifts: adds half the gradient of `rho * E` to `gradient`, and returns
    /// `E`.
    pub(in crate::solve) fn local_step(
        &mut self,
        x: &[Row],
        gradient: &mut [Row],
        rho: f64,
    ) -> f64 {
        self.batches.iter_mut().map(|batch| batch.local_step(x, gradient, rho)).sum()
    }

    /// Updates the multipliers: `u := z + u - P(z + u)` of the last local step.
    pub(in crate::solve) fn update_shifts(&mut self) {
        self.batches.iter_mut().for_each(|batch| batch.shift.copy_from_slice(&batch.residual));
    }

    /// Divides all shifts when `rho` grows: the multiplier `rho * w * u` stays.
    pub(in crate::solve) fn divide_shifts(&mut self, by: f64) {
        let part = Lanes::splat(1.0 / by);
        for shift in self.batches.iter_mut().flat_map(|batch| &mut batch.shift) {
            *shift = *shift * part;
        }
    }

    /// Whether any constraint must be exact, or the guard, which has no slack where edges may not become
    /// shorter at all.
    pub(in crate::solve) fn any_exact(&self) -> bool {
        self.batches.iter().any(|hard| hard.within.is_none())
    }

    /// The greatest excess, including that of the guard.
    pub(in crate::solve) fn worst_excess(&self, x: &[Row]) -> f64 {
        let mut worst = 0.0;
        for batch in &self.batches {
            batch.misses(x, |_, miss| worst = Lane::max(miss.excess, worst));
        }
        worst
    }
}

impl HardBatch {
    fn local_step(&mut self, x: &[Row], gradient: &mut [Row], rho: f64) -> f64 {
        let n = self.batch.points();
        let mut scratch = vec![Vec3::zero(); 2 * n];
        let mut energy = 0.0;
        for chunk in 0..self.batch.count().div_ceil(LANES) {
            let rows = (x, &mut *gradient);
            energy += match n {
                2 => self.step_few::<2>(chunk, rows, rho),
                4 => self.step_few::<4>(chunk, rows, rho),
                _ => self.step_chunk(chunk, scratch.split_at_mut(n), rows, rho),
            };
        }
        energy
    }

    /// [`HardBatch::step_chunk`] for `N` points.
    #[inline(never)]
    fn step_few<const N: usize>(
        &mut self,
        chunk: usize,
        rows: (&[Row], &mut [Row]),
        rho: f64,
    ) -> f64 {
        let (mut points, mut projected) = ([Vec3::zero(); N], [Vec3::zero(); N]);
        self.step_chunk(chunk, (&mut points, &mut projected), rows, rho)
    }

    #[inline(always)]
    fn step_chunk(
        &mut self,
        chunk: usize,
        (points, projected): (&mut [Vec3<Lanes>], &mut [Vec3<Lanes>]),
        (x, gradient): (&[Row], &mut [Row]),
        rho: f64,
    ) -> f64 {
        let HardBatch { batch, shift, residual, within, .. } = self;
        let own = chunk * points.len()..(chunk + 1) * points.len();
        batch.gather(chunk, x, points);
        points.iter_mut().zip(&shift[own.clone()]).for_each(|(point, shift)| *point += *shift);
        batch.project(chunk, points, projected);
        if let Some(distance) = within {
            stop_at_band(points, projected, AIM * *distance);
        }
        batch.centre(projected);
        let counts = batch.counts(chunk) * Lanes::splat(batch.weight());
        let scale = counts * Lanes::splat(rho);
        let mut sum = Lanes::zero();
        let nodes = &batch.nodes()[own.clone()];
        for (((point, p), residual), nodes) in
            points.iter().zip(projected.iter()).zip(&mut residual[own]).zip(nodes)
        {
            *residual = *point - *p;
            sum += residual.length_squared();
            let scaled = *residual * scale;
            for lane in 0..LANES {
                let row = &mut gradient[nodes[lane] as usize];
                row[0] += scaled.x.lane(lane);
                row[1] += scaled.y.lane(lane);
                row[2] += scaled.z.lane(lane);
            }
        }
        let sum = sum * counts;
        (0..LANES).map(|lane| sum.lane(lane)).sum()
    }

    /// The width of the band in which the polish keeps points. A band thinner than `thin` is
    /// replaced by the shape itself: steps then go to the middle, and end when they are inside.
    pub(in crate::solve) fn wide(&self, thin: f64) -> Option<f64> {
        self.within.filter(|width| *width > thin)
    }

    /// Writes the residuals at positions `x`, constraint by constraint, three numbers for each
    /// point: the displacement from the shape to the point, or its part beyond the `band`. Returns
    /// the sum of squares.
    pub(in crate::solve) fn residuals(&self, x: &[Row], band: Option<f64>, to: &mut [f64]) -> f64 {
        let n = self.batch.points();
        let mut squares = 0.0;
        self.each_chunk(x, 1.0, &mut |chunk, points, projected| {
            match band {
                Some(width) => stop_at_band(points, projected, width),
                None => self.batch.centre(projected),
            }
            let own = &mut to[chunk * LANES * 3 * n..];
            for (lane, own) in own.chunks_exact_mut(3 * n).take(self.lanes(chunk)).enumerate() {
                for (k, (point, p)) in points.iter().zip(&*projected).enumerate() {
                    let residual = (*point - *p).lane(lane);
                    own[3 * k..3 * k + 3].copy_from_slice(&[residual.x, residual.y, residual.z]);
                    squares += residual.length_squared();
                }
            }
        });
        squares
    }

    /// For the guard, whether each edge is longer than required at positions `x`, even if slightly
    /// shortened: nothing holds it there. Empty for other constraints.
    pub(in crate::solve) fn slack(&self, x: &[Row]) -> Vec<bool> {
        let mut slack = Vec::new();
        if self.row.is_none() {
            self.each_chunk(x, 1.0 - SHORTER, &mut |chunk, points, projected| {
                slack.extend((0..self.lanes(chunk)).map(|lane| {
                    points
                        .iter()
                        .zip(&*projected)
                        .all(|(point, p)| point.lane(lane) == p.lane(lane))
                }));
            });
        }
        slack
    }

    /// Calls `each` with the distance of every constraint from being met at positions `x`.
    pub(in crate::solve) fn misses(&self, x: &[Row], mut each: impl FnMut(usize, Miss)) {
        self.each_chunk(x, 1.0, &mut |chunk, points, projected| {
            let mut worst = Lanes::zero();
            for (point, p) in points.iter().zip(&*projected) {
                worst = (*point - *p).length_squared().max(worst);
            }
            for lane in 0..self.lanes(chunk) {
                let distance = worst.lane(lane).sqrt();
                let excess = distance - self.within.unwrap_or(0.0);
                each(chunk * LANES + lane, Miss { distance, excess: Lane::max(excess, 0.0) });
            }
        });
    }

    /// Calls `each` with the centred points of every chunk at positions `x`, times `scale`, and
    /// their projections.
    fn each_chunk(&self, x: &[Row], scale: f64, each: EachChunk<'_>) {
        let n = self.batch.points();
        let (mut points, mut projected) = (vec![Vec3::zero(); n], vec![Vec3::zero(); n]);
        for chunk in 0..self.batch.count().div_ceil(LANES) {
            self.batch.gather(chunk, x, &mut points);
            points.iter_mut().for_each(|point| *point = *point * Lanes::splat(scale));
            self.batch.project(chunk, &points, &mut projected);
            each(chunk, &points, &mut projected);
        }
    }

    /// Number of lanes of a chunk that have a constraint of their own.
    fn lanes(&self, chunk: usize) -> usize {
        LANES.min(self.batch.count() - chunk * LANES)
    }
}

/// A callback for a chunk: its index, points and projections.
type EachChunk<'a> = &'a mut dyn FnMut(usize, &[Vec3<Lanes>], &mut [Vec3<Lanes>]);

/// Replaces projections to a shape by those to the band of this width around it.
#[inline(always)]
fn stop_at_band(points: &[Vec3<Lanes>], projected: &mut [Vec3<Lanes>], width: f64) {
    for (point, p) in points.iter().zip(projected) {
        let away = *point - *p;
        let part = Lanes::splat(width) / away.length();
        *p += away * part.min(Lanes::one());
    }
}
