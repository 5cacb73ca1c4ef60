//! Translations, rotations and scaling about the centre. Those that keep the constraints are not
//! variations.

use super::subspace::{INDEPENDENT, rows_of};
use crate::constraint::Row;
use crate::math::{orthonormalise, symmetric_eigen};
use crate::solve::exact::block_system::BlockSystem;
use nalgebra::DMatrix;

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
    let (values, mut factors) = symmetric_eigen(&across.tr_mul(&across));
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
