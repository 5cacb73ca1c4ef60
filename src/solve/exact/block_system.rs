//! The system of the polish: the metric of the energies for each of x, y and z, and stiff springs
//! across the normal spaces of hard constraints, which couple x, y and z.

use super::model::Model;
use super::normal_space::{BAND, Differences, Linear};
use crate::constraint::Row;
use crate::math::Lane;
use crate::mesh::Laplacian;
use crate::solve::assemble::Terms;
use crate::solve::error::SolveError;
use crate::solve::rows::add_scaled;
use crate::solve::system::System;
use crate::sparse::{BlockMatrix, UpperTriangle};

/// The stiffness of the springs relative to the metric. The weakest combinations of constraints
/// have 1e-5 of the stiffness of a single one, and each pass of the multipliers contracts by one
/// over the product.
const STIFFEST: f64 = 1e7;

/// The least stiffness, for short steps that are far from least change.
const SOFTEST: f64 = 1e1;

/// Bands thinner than this fraction of the size are replaced by the shape itself: steps across them
/// are as good as Newton's.
const THIN: f64 = 1e-4;

/// The constraints of one batch at the last linearisation.
struct LinearBatch {
    points: usize,
    weight: f64,
    /// The width of the band around the shape; `None` if the shape itself is required.
    band: Option<f64>,
    /// The block node of each point of each constraint.
    nodes: Vec<u32>,
    /// `J^T J` of each constraint.
    normals: Vec<f64>,
    multipliers: Vec<f64>,
    residuals: Vec<f64>,
    /// `J^T J (r + dx)` of the last change.
    images: Vec<f64>,
}

/// The system of the polish, and the constraints in it.
pub(in crate::solve) struct BlockSystem {
    matrix: BlockMatrix,
    /// The metric of the energies.
    metric: UpperTriangle,
    fixed: Vec<bool>,
    /// The block node of each vertex.
    node_of: Vec<u32>,
    /// The stiffness of the springs, and the unit of its limits.
    stiffness: f64,
    unit: f64,
    batches: Vec<LinearBatch>,
    /// Storage for a gradient.
    gradient: Vec<Row>,
}

/// Number of passes of the multipliers for a downhill step.
const DOWNHILL: u32 = 4;

/// The greatest fraction of a direction that may remain across the constraints.
const TANGENT: f64 = 1e-9;

impl BlockSystem {
    /// Creates the system for the hard constraints of `model`. `held` is added to the metric of
    /// each node, as a fraction of the mean, for nodes that nothing else holds. `smooth_terms`
    /// returns the terms of smoothness in the metric.
    pub(in crate::solve) fn new(
        model: &Model,
        held: f64,
        smooth_terms: fn(&Laplacian) -> Terms,
    ) -> BlockSystem {
        let smooth = model.laplacian.as_ref().map(smooth_terms).unwrap_or_default();
        let [soft, hard] = model.cliques.clone();
        let terms = vec![soft, smooth, hard];
        let parts = &model.parts;
        let n = parts.n_vertices.max(2);
        let order = Some(parts.system.analysis());
        let system = System::with_order([n, n], terms, Default::default(), order);
        let node_of = system.node_of()[..parts.n_vertices].to_vec();
        let (mut fixed, mut diagonal) = (vec![true; n], vec![0.0; n]);
        let [metric, hard] = model.stiffness;
        // Without any energy, the metric measures only lengths.
        let (held, unit) = if metric > 0.0 { (held * metric, metric) } else { (hard, hard) };
        let mut block_of = vec![u32::MAX; model.x.len()];
        for (&node, &own) in parts.system.node_of().iter().zip(&node_of) {
            block_of[node as usize] = own;
            fixed[own as usize] = model.holding.fixed[node as usize];
            diagonal[own as usize] = model.holding.diagonal[node as usize] + held;
        }
        let metric = system.values(&model.scales(0.0), &diagonal, &fixed);
        let batches = model.hard.batches.iter().map(|hard| {
            let (points, count) = (hard.batch.points(), hard.batch.count());
            let nodes = (0..count).flat_map(|i| hard.batch.nodes_of(i));
            LinearBatch {
                points,
                weight: hard.batch.weight(),
                band: hard.wide(THIN * model.parts.extent).map(|width| BAND * width),
                nodes: nodes.map(|node| block_of[node as usize]).collect(),
                normals: vec![0.0; 9 * points * points * count],
                multipliers: vec![0.0; 3 * points * count],
                residuals: vec![0.0; 3 * points * count],
                images: vec![0.0; 3 * points * count],
            }
        });
        BlockSystem {
            matrix: BlockMatrix::new(system.analysis()),
            metric,
            fixed,
            node_of,
            stiffness: STIFFEST * unit / hard,
            unit: unit / hard,
            batches: batches.collect(),
            gradient: vec![[0.0; 4]; n],
        }
    }

    /// Lets steps lead to the shapes themselves where a distance from them is permitted; returns
    /// whether that changes anything.
    pub(super) fn aim_at_shapes(&mut self) -> bool {
        let bands = self.batches.iter_mut().filter_map(|batch| batch.band.take());
        bands.count() > 0
    }

    /// The block node of each vertex.
    pub(in crate::solve) fn node_of(&self) -> &[u32] {
        &self.node_of
    }

    /// Whether the springs are so stiff that steps meet the linearised constraints.
    pub(in crate::solve) fn is_stiffest(&self) -> bool {
        self.stiffness >= STIFFEST * self.unit
    }

    /// Multiplies the stiffness of the springs, within limits; takes effect with the next factor.
    pub(in crate::solve) fn stiffen(&mut self, times: f64) {
        let [least, most] = [SOFTEST, STIFFEST].map(|stiffness| stiffness * self.unit);
        self.stiffness = Lane::max(Lane::min(self.stiffness * times, most), least);
    }

    /// Number of nodes.
    pub(in crate::solve) fn size(&self) -> usize {
        self.fixed.len()
    }

    /// Linearises the constraints at the positions of `model`, and factors. With `bands`, a band
    /// holds only the points beyond it; without, it is replaced by the shape inside it.
    ///
    /// # Errors
    /// If the matrix is not positive definite to working precision.
    pub(in crate::solve) fn factor(
        &mut self,
        model: &Model,
        bands: bool,
    ) -> Result<(), SolveError> {
        self.batches.iter_mut().for_each(|batch| batch.normals.fill(0.0));
        self.hold_others(model, bands)
    }

    /// As [`BlockSystem::factor`], but linearises only the constraints that are not held; the
    /// others keep their linearisation.
    ///
    /// # Errors
    /// If the matrix is not positive definite to working precision.
    pub(in crate::solve) fn hold_others(
        &mut self,
        model: &Model,
        bands: bool,
    ) -> Result<(), SolveError> {
        let x = &model.x;
        self.matrix.set_scalar(&self.metric);
        for (own, hard) in self.batches.iter_mut().zip(&model.hard.batches) {
            let band = own.band.filter(|_| bands);
            hard.residuals(x, band, &mut own.residuals);
            let size = 3 * own.points;
            let mut differences = Differences::new(own.points, hard.batch.centring());
            let slack = hard.slack(x);
            let scale = self.stiffness * own.weight;
            let each =
                own.residuals.chunks_exact_mut(size).zip(own.normals.chunks_exact_mut(size * size));
            for (i, (residual, normal)) in each.enumerate() {
                if is_zero(normal) && slack.get(i) != Some(&true) {
                    let linear = Linear { residual, normal: &mut *normal };
                    differences.linearise((hard, band), i, x, model.parts.extent, linear);
                }
                if is_zero(normal) {
                    continue;
                }
                let nodes = &own.nodes[i * own.points..(i + 1) * own.points];
                for (a, &u) in nodes.iter().enumerate() {
                    for (b, &v) in nodes.iter().enumerate() {
                        if u <= v && !self.fixed[u as usize] && !self.fixed[v as usize] {
                            let at =
                                |r: usize, c: usize| scale * normal[(3 * a + r) * size + 3 * b + c];
                            self.matrix.add(u, v, at);
                        }
                    }
                }
            }
        }
        self.matrix.factor(&self.fixed).map_err(|singular| {
            let node = singular.column as u32 / 3;
            let vertex = self.node_of.iter().position(|&of| of == node).unwrap_or(0);
            SolveError::NotPositiveDefinite { vertex: vertex as u32 }
        })
    }

    /// For every constraint, whether it was not held at the last linearisation.
    pub(in crate::solve) fn inactive(&self) -> Vec<bool> {
        let inactive = |batch: &LinearBatch| {
            let normals = batch.normals.chunks_exact(9 * batch.points * batch.points);
            normals.map(is_zero).collect::<Vec<_>>()
        };
        self.batches.iter().flat_map(inactive).collect()
    }

    /// The fraction of the current squared residuals that is of constraints that are not held.
    pub(in crate::solve) fn inactive_fraction(&self) -> f64 {
        let (mut inactive, mut all) = (0.0, 0.0);
        for batch in &self.batches {
            let size = 3 * batch.points;
            let each =
                batch.residuals.chunks_exact(size).zip(batch.normals.chunks_exact(size * size));
            for (residual, normal) in each {
                let squares: f64 = residual.iter().map(|r| r * r).sum();
                all += squares;
                inactive += if squares > 0.0 && is_zero(normal) { squares } else { 0.0 };
            }
        }
        if all > 0.0 { inactive / all } else { 0.0 }
    }

    /// Whether any of the constraints marked by `of` is violated at positions `x` of the model.
    pub(in crate::solve) fn is_violated(&mut self, model: &Model, x: &[Row], of: &[bool]) -> bool {
        let noise = model.goal();
        self.residuals(model, x);
        let residuals = self.batches.iter().flat_map(|it| it.residuals.chunks_exact(3 * it.points));
        residuals.zip(of).any(|(residual, of)| *of && residual.iter().any(|r| r.abs() > noise))
    }

    /// `#nodes`: whether the node is fixed.
    pub(in crate::solve) fn fixed(&self) -> &[bool] {
        &self.fixed
    }

    /// Applies the inverse of the factored matrix to four right-hand sides in place, one row for
    /// each unknown: x, y and z of every node.
    pub(in crate::solve) fn solve(&self, right: &mut [Row]) {
        self.matrix.solve_columns(right);
    }

    /// Returns the part of a displacement (`#nodes`) in the normal spaces, three numbers for each
    /// point of each constraint.
    pub(in crate::solve) fn across(&mut self, displacement: &[Row]) -> Vec<f64> {
        self.batches.iter_mut().for_each(|batch| batch.residuals.fill(0.0));
        self.update_images(displacement);
        self.batches.iter().flat_map(|batch| &batch.images).copied().collect()
    }

    /// Makes a displacement, `#nodes`, tangent to the constraints by the least change.
    pub(in crate::solve) fn make_tangent(&mut self, displacement: &mut [Row]) {
        for batch in &mut self.batches {
            for (residual, &node) in batch.residuals.chunks_exact_mut(3).zip(&batch.nodes) {
                residual.copy_from_slice(&displacement[node as usize][..3]);
            }
        }
        let mut change = vec![[0.0; 4]; displacement.len()];
        self.least_change(&mut change, TANGENT);
        for (to, by) in displacement.as_flattened_mut().iter_mut().zip(change.as_flattened()) {
            *to += by;
        }
    }

    /// Computes and stores the residuals at positions `x` of the model, and returns their norm.
    pub(in crate::solve) fn residuals(&mut self, model: &Model, x: &[Row]) -> f64 {
        let batches = self.batches.iter_mut().zip(&model.hard.batches);
        let squares = batches.map(|(own, hard)| hard.residuals(x, own.band, &mut own.residuals));
        squares.sum::<f64>().sqrt()
    }

    /// Computes the least change `dx`, `#nodes`, in the metric of the energies that meets the
    /// linearised constraints with the current residuals, except for a fraction `left` of them.
    pub(in crate::solve) fn least_change(&mut self, dx: &mut [Row], left: f64) {
        // Softer springs are for shorter steps, without multipliers.
        let passes = if self.is_stiffest() { 7 } else { 1 };
        let before = self.begin_change(dx);
        for _ in 0..passes {
            if self.change(dx, None) <= left * before {
                break;
            }
        }
    }

    /// Computes the displacement `dx`, `#nodes`, along the linearised constraints that minimises
    /// the energies in their metric. `pull` is half the gradient of the energies.
    pub(in crate::solve) fn downhill(&mut self, pull: &[Row], dx: &mut [Row]) {
        self.begin_change(dx);
        for _ in 0..DOWNHILL {
            self.change(dx, Some(pull));
        }
    }

    fn begin_change(&mut self, dx: &mut [Row]) -> f64 {
        dx.fill([0.0; 4]);
        self.batches.iter_mut().for_each(|batch| batch.multipliers.fill(0.0));
        self.update_images(dx)
    }

    /// Performs one pass of the multipliers; returns the norm of what remains of the linearised
    /// constraints.
    fn change(&mut self, dx: &mut [Row], pull: Option<&[Row]>) -> f64 {
        let mut gradient = std::mem::take(&mut self.gradient);
        multiply(&self.metric, dx, &mut gradient);
        if let Some(pull) = pull {
            add_scaled(&mut gradient, 1.0, pull);
        }
        for batch in &self.batches {
            let scale = self.stiffness * batch.weight;
            let rows = batch.multipliers.chunks_exact(3).zip(batch.images.chunks_exact(3));
            for ((multiplier, image), &node) in rows.zip(&batch.nodes) {
                for c in 0..3 {
                    gradient[node as usize][c] += multiplier[c] + scale * image[c];
                }
            }
        }
        let fixed = gradient.iter_mut().zip(&self.fixed).filter(|(_, fixed)| **fixed);
        fixed.for_each(|(row, _)| *row = [0.0; 4]);
        self.matrix.solve(&mut gradient);
        for (to, by) in dx.as_flattened_mut().iter_mut().zip(gradient.as_flattened()) {
            *to -= by;
        }
        self.gradient = gradient;
        let after = self.update_images(dx);
        for batch in &mut self.batches {
            let scale = self.stiffness * batch.weight;
            for (multiplier, image) in batch.multipliers.iter_mut().zip(&batch.images) {
                *multiplier += scale * image;
            }
        }
        after
    }

    /// Computes `J^T J (r + dx)` of every constraint; returns the norm of all.
    fn update_images(&mut self, dx: &[Row]) -> f64 {
        let mut squares = 0.0;
        for batch in &mut self.batches {
            let LinearBatch { points, nodes, normals, residuals, images, .. } = batch;
            let size = 3 * *points;
            let mut moved = vec![0.0; size];
            let each = nodes.chunks_exact(*points).zip(normals.chunks_exact(size * size));
            let each = each.zip(residuals.chunks_exact(size)).zip(images.chunks_exact_mut(size));
            for (((nodes, normal), residual), image) in each {
                if is_zero(normal) {
                    image.fill(0.0);
                    continue;
                }
                for (k, &node) in nodes.iter().enumerate() {
                    for c in 0..3 {
                        moved[3 * k + c] = residual[3 * k + c] + dx[node as usize][c];
                    }
                }
                for (to, row) in image.iter_mut().zip(normal.chunks_exact(size)) {
                    *to = row.iter().zip(&moved).map(|(entry, value)| entry * value).sum();
                    squares += *to * *to;
                }
            }
        }
        squares.sqrt()
    }

    /// The norm of the residuals after the last least change, according to the linear model: the
    /// remainder in the normal spaces, in which constraints are held, and the part outside them.
    pub(in crate::solve) fn predicted(&self) -> f64 {
        let mut squares = 0.0;
        for batch in &self.batches {
            let size = 3 * batch.points;
            let each =
                batch.normals.chunks_exact(size * size).zip(batch.residuals.chunks_exact(size));
            for ((normal, residual), image) in each.zip(batch.images.chunks_exact(size)) {
                for ((row, own), image) in normal.chunks_exact(size).zip(residual).zip(image) {
                    let held: f64 = row.iter().zip(residual).map(|(entry, r)| entry * r).sum();
                    let left = own - held + image;
                    squares += left * left;
                }
            }
        }
        squares.sqrt()
    }
}

/// Whether a normal space is empty, so that nothing is held.
fn is_zero(normal: &[f64]) -> bool {
    normal.iter().all(|entry| *entry == 0.0)
}

/// `to = matrix * x`, of a symmetric matrix.
fn multiply(matrix: &UpperTriangle, x: &[Row], to: &mut [Row]) {
    to.fill([0.0; 4]);
    for column in 0..matrix.cols() {
        for place in matrix.indptr().outer_inds_sz(column) {
            let (row, value) = (matrix.indices()[place] as usize, matrix.data()[place]);
            for c in 0..3 {
                to[row][c] += value * x[column][c];
                if row != column {
                    to[column][c] += value * x[row][c];
                }
            }
        }
    }
}
