//! Saddles of the total energy. An iteration that began with some symmetry, or on a line between two
//! shapes, stands still there without a reason to stop: only its rounding errors lead away.
//!
//! Where the total no longer falls, the softest direction of its Hessian `H` is found by Lanczos'
//! method on `A^-1 H`, whose spectrum lies below one, with the factored normal matrix `A` as the
//! inner product, and differences of gradients for products with `H`. If the curvature along it is
//! negative, the positions move along it until the total stops falling.

use super::Solver;
use crate::constraint::Row;
use crate::math::symmetric_eigen;
use crate::solve::accelerate::Iterate;
use crate::solve::rows::{add_scaled, dot};
use nalgebra::DMatrix;

/// Greatest number of directions. Extreme eigenvalues come first: 60 tell a curvature of a thousandth
/// of that of `A` from none, which soft constraints have along the shapes that they allow.
const DIRECTIONS: usize = 60;

/// The curvature, relative to that of `A`, below which a direction is tried.
const LEADS_DOWN: f64 = -1e-5;

/// The length of the steps for differences of gradients, relative to the size.
const DIFFERENCE: f64 = 1e-6;

/// The length of the first step down, relative to the size, and the greatest number of doublings.
const FIRST: f64 = 1e-4;
const DOUBLINGS: u32 = 12;

/// Greatest number of nodes for which it is looked for: each direction costs an iteration.
const MOST_NODES: usize = 2_000;

/// A direction with less than this fraction of its square outside the previous ones is none.
const INDEPENDENT: f64 = 1e-20;

impl Solver {
    /// Moves down from a saddle, if the positions are at one; returns whether they were. The total
    /// has then fallen by more than `least`.
    pub(super) fn leave_saddle(&mut self, least: f64) -> bool {
        // Along curves the gradient is another one, and the differences of gradients would mix guarded
        // projections with those before.
        let is_plain = self.parts.gliding.is_none() && !self.parts.energies.shape.is_guarded();
        // What nothing but handles holds has no original to come near: a flat sheet that is stretched
        // is to stay flat.
        let is_plain = is_plain && self.parts.energies.weights.close > 0.0;
        if !is_plain || self.x.len() > MOST_NODES || self.parts.system.unknowns() == 0 {
            return false;
        }
        let start = self.x.clone();
        let before = self.energy.total;
        let direction = self.softest_direction(&start);
        let best =
            direction.and_then(|direction| self.lowest_along(&start, &direction, before - least));
        self.x = best.clone().unwrap_or(start);
        if best.is_some() {
            self.forget();
        }
        self.evaluate();
        best.is_some()
    }

    /// Returns a direction of negative curvature at `start`, of unit length; none if there is none.
    fn softest_direction(&mut self, start: &[Row]) -> Option<Vec<Row>> {
        let step = DIFFERENCE * self.parts.extent;
        let gradient = self.descent.gradient.clone();
        let mut image = random_rows(start.len());
        self.parts.system.clear_fixed(&mut image);
        // `A`-orthonormal directions, and their images by `A`.
        let (mut directions, mut images): (Vec<Vec<Row>>, Vec<Vec<Row>>) = Default::default();
        let (mut diagonal, mut beside): (Vec<f64>, Vec<f64>) = Default::default();
        let mut direction = self.solve_with_normal_matrix(&image);
        let mut squared = dot(&direction, &image);
        let first = squared;
        while directions.len() < DIRECTIONS && squared > INDEPENDENT * first {
            let length = squared.sqrt();
            scale(&mut direction, 1.0 / length);
            scale(&mut image, 1.0 / length);
            if !directions.is_empty() {
                beside.push(length);
            }
            // Differences of gradients over a step of this greatest length of a vertex.
            let by = step / dot_max(&direction).sqrt();
            self.x.copy_from_slice(start);
            add_scaled(&mut self.x, by, &direction);
            self.evaluate();
            let mut next_image = self.descent.gradient.clone();
            add_scaled(&mut next_image, -1.0, &gradient);
            scale(&mut next_image, 1.0 / by);
            self.parts.system.clear_fixed(&mut next_image);
            let mut next = self.solve_with_normal_matrix(&next_image);
            diagonal.push(dot(&direction, &next_image));
            directions.push(std::mem::take(&mut direction));
            images.push(std::mem::take(&mut image));
            for (known, its_image) in directions.iter().zip(&images) {
                let part = dot(its_image, &next);
                add_scaled(&mut next, -part, known);
                add_scaled(&mut next_image, -part, its_image);
            }
            (direction, image) = (next, next_image);
            squared = dot(&direction, &image);
        }
        let n = diagonal.len();
        let matrix = DMatrix::from_fn(n, n, |i, j| match i.abs_diff(j) {
            0 => diagonal[i],
            1 => beside[i.min(j)],
            _ => 0.0,
        });
        let (values, vectors) = symmetric_eigen(&matrix)?;
        let least = (0..n).min_by(|&a, &b| values[a].total_cmp(&values[b]))?;
        if values[least] > LEADS_DOWN {
            return None;
        }
        let mut softest = vec![[0.0; 4]; start.len()];
        for (known, part) in directions.iter().zip(vectors.column(least).iter()) {
            add_scaled(&mut softest, *part, known);
        }
        let length = dot_max(&softest).sqrt();
        scale(&mut softest, 1.0 / length);
        Some(softest)
    }

    /// Returns the positions of the lowest total along a direction from `start`, both ways, if it is
    /// below `most`.
    fn lowest_along(&mut self, start: &[Row], direction: &[Row], most: f64) -> Option<Vec<Row>> {
        let mut best: Option<(f64, Vec<Row>)> = None;
        for sign in [1.0, -1.0] {
            let mut by = sign * FIRST * self.parts.extent;
            let mut last = f64::INFINITY;
            for _ in 0..DOUBLINGS {
                self.x.copy_from_slice(start);
                add_scaled(&mut self.x, by, direction);
                self.evaluate();
                let total = self.energy.total;
                if total.is_nan() || total >= last {
                    break;
                }
                last = total;
                if total < best.as_ref().map_or(most, |(lowest, _)| *lowest) {
                    best = Some((total, self.x.clone()));
                }
                by *= 2.0;
            }
        }
        best.map(|(_, x)| x)
    }

    /// Returns `A^-1` times `rows`.
    fn solve_with_normal_matrix(&mut self, rows: &[Row]) -> Vec<Row> {
        let zeros = vec![[0.0; 4]; rows.len()];
        let mut solution = zeros.clone();
        let from = Iterate { x: &zeros, gradient: rows };
        from.plain_step(&mut self.parts.system, &mut solution);
        scale(&mut solution, -1.0);
        solution
    }
}

/// Numbers between -1 and 1 without a pattern, always the same.
fn random_rows(n: usize) -> Vec<Row> {
    let mut state = 0x9E37_79B9_7F4A_7C15_u64;
    let mut next = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / (1_u64 << 30) as f64 - 1.0
    };
    (0..n).map(|_| [next(), next(), next(), 0.0]).collect()
}

/// Returns the greatest squared length of a row.
fn dot_max(a: &[Row]) -> f64 {
    a.iter().map(|[x, y, z, _]| x * x + y * y + z * z).fold(f64::MIN_POSITIVE, f64::max)
}

fn scale(rows: &mut [Row], by: f64) {
    rows.as_flattened_mut().iter_mut().for_each(|value| *value *= by);
}
