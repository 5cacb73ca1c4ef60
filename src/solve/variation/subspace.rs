//! The softest directions along the constraints, by subspace iteration: the inverse of the factored
//! matrix almost cancels components across them. Translations, rotations and scaling that keep the
//! constraints are no variations: these motions are subtracted too, so that the
//! iterated operator is symmetric, and its greatest eigenvalues are the compliances.
//!
//! A vector is a column over all unknowns: x, y and z of every node.

use crate::constraint::Row;
use crate::math::{orthonormalise, symmetric_eigen};
use crate::solve::exact::block_system::BlockSystem;
use nalgebra::DMatrix;

/// Number of vectors, a multiple of four. Those beyond the modes make the modes converge sooner.
const COUNT: usize = 12;

/// Greatest number of modes.
pub(super) const MODES: usize = 8;

/// A vector with less than this fraction of its length outside the span of the previous ones is a
/// combination of them.
pub(super) const INDEPENDENT: f64 = 1e-9;

/// Greatest number of iterations; five to forty are usual.
const ITERATIONS: u32 = 60;

/// The iteration has converged when no compliance of a mode grows by more than this fraction.
const GAIN: f64 = 1e-4;

/// The iteration.
pub(super) struct Subspace {
    /// Orthonormal, or zero.
    pub vectors: DMatrix<f64>,
    /// Compliances, the greatest first.
    pub compliances: Vec<f64>,
    /// Orthonormal, or zero.
    motions: DMatrix<f64>,
    iterations: u32,
}

impl Subspace {
    /// Starts from pseudo-random vectors.
    pub(super) fn new(system: &BlockSystem, motions: DMatrix<f64>) -> Subspace {
        let mut vectors = DMatrix::zeros(motions.nrows(), COUNT);
        let mut state = 1_u32;
        for node in (0..system.size()).filter(|&node| !system.fixed()[node]) {
            for entry in vectors.rows_mut(3 * node, 3).row_iter_mut().flatten() {
                // Numerical Recipes' quick generator.
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                *entry = f64::from(state >> 8) - f64::from(1 << 23);
            }
        }
        project_out(&mut vectors, &motions);
        orthonormalise(&mut vectors, INDEPENDENT);
        Subspace { vectors, compliances: vec![0.0; COUNT], motions, iterations: 0 }
    }

    /// Performs one iteration; returns whether there is more to gain.
    pub(super) fn iterate(&mut self, system: &BlockSystem) -> bool {
        let mut next = self.vectors.clone();
        solve(system, &mut next);
        project_out(&mut next, &self.motions);
        let Some((compliances, factors)) = symmetric_eigen(&self.vectors.tr_mul(&next)) else {
            return false;
        };
        next *= factors;
        orthonormalise(&mut next, INDEPENDENT);
        self.vectors = next;
        let gains =
            compliances.iter().zip(&self.compliances).take(MODES).any(|(c, b)| c - b > GAIN * c);
        self.compliances = compliances;
        self.iterations += 1;
        gains && self.iterations < ITERATIONS
    }
}

/// Subtracts the components in the span of the orthonormal vectors of `basis`.
fn project_out(vectors: &mut DMatrix<f64>, basis: &DMatrix<f64>) {
    *vectors -= basis * basis.tr_mul(vectors);
}

/// Applies the inverse of the factored matrix to the vectors, four at once.
fn solve(system: &BlockSystem, vectors: &mut DMatrix<f64>) {
    let n = vectors.nrows();
    let mut four = vec![[0.0; 4]; n];
    for columns in vectors.as_mut_slice().chunks_exact_mut(4 * n) {
        for (i, row) in four.iter_mut().enumerate() {
            *row = std::array::from_fn(|k| columns[k * n + i]);
        }
        system.solve(&mut four);
        for (i, row) in four.iter().enumerate() {
            (0..4).for_each(|k| columns[k * n + i] = row[k]);
        }
    }
}

/// Column `k`, a row for each node.
pub(super) fn rows_of(vectors: &DMatrix<f64>, k: usize) -> Vec<Row> {
    vectors.column(k).as_slice().chunks_exact(3).map(|p| [p[0], p[1], p[2], 0.0]).collect()
}

/// The column of some rows, one for each node.
pub(super) fn column_of(rows: &[Row]) -> impl Iterator<Item = f64> + '_ {
    rows.iter().flat_map(|&[x, y, z, _]| [x, y, z])
}

const MOTIONS: usize = 7;

/// A motion of length one keeps the constraints if the square of its part across them is at most
/// this.
const KEPT: f64 = 1e-8;

/// Returns the combinations of such motions that keep the constraints of `system` and its fixed
/// nodes, orthonormal. `at` are the positions of the nodes, and `nodes` those of vertices.
pub(super) fn kept_motions(system: &mut BlockSystem, at: &[Row], nodes: &[u32]) -> DMatrix<f64> {
    let n = nodes.len() as f64;
    let mut centre = [0.0; 3];
    for &node in nodes {
        (0..3).for_each(|c| centre[c] += at[node as usize][c] / n);
    }
    let mut motions = DMatrix::zeros(3 * at.len(), MOTIONS);
    for &node in nodes {
        let [x, y, z] = std::array::from_fn(|c| at[node as usize][c] - centre[c]);
        let rows: [[f64; MOTIONS]; 3] = [
            [1.0, 0.0, 0.0, 0.0, z, -y, x],
            [0.0, 1.0, 0.0, -z, 0.0, x, y],
            [0.0, 0.0, 1.0, y, -x, 0.0, z],
        ];
        for (c, row) in rows.into_iter().enumerate() {
            motions.row_mut(3 * node as usize + c).copy_from_slice(&row);
        }
    }
    orthonormalise(&mut motions, INDEPENDENT);
    let mut across: Vec<Vec<f64>> =
        (0..MOTIONS).map(|k| system.across(&rows_of(&motions, k))).collect();
    for (node, _) in system.fixed().iter().enumerate().filter(|(_, fixed)| **fixed) {
        for (across, motion) in across.iter_mut().zip(motions.column_iter()) {
            across.extend(motion.rows(3 * node, 3).iter());
        }
    }
    let across = DMatrix::from_fn(across[0].len(), MOTIONS, |i, k| across[k][i]);
    let Some((values, mut factors)) = symmetric_eigen(&across.tr_mul(&across)) else {
        return DMatrix::zeros(motions.nrows(), MOTIONS);
    };
    for (value, mut factors) in values.iter().zip(factors.column_iter_mut()) {
        if *value > KEPT {
            factors.fill(0.0);
        }
    }
    motions *= factors;
    // Motions that are combinations of others, as for vertices on a line, are still zero.
    orthonormalise(&mut motions, INDEPENDENT);
    motions
}
