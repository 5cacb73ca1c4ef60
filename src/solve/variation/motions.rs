//! Translations, rotations and scaling about the centre. Those that keep the constraints are not
//! variations.

use super::vectors::{COUNT, Products, Vectors, principal};
use crate::constraint::Row;
use crate::solve::exact::block_system::BlockSystem;

const MOTIONS: usize = 7;

/// A motion of length one keeps the constraints if the square of its part across them is at most
/// this.
const KEPT: f64 = 1e-8;

/// Returns the combinations of such motions that keep the constraints of `system` and its fixed
/// nodes, orthonormal. `at` are the positions of the nodes, and `nodes` those of vertices.
pub(super) fn kept_motions(system: &mut BlockSystem, at: &[Row], nodes: &[u32]) -> Vectors {
    let n = nodes.len() as f64;
    let mut centre = [0.0; 3];
    for &node in nodes {
        (0..3).for_each(|c| centre[c] += at[node as usize][c] / n);
    }
    let mut motions = Vectors::zero(at.len());
    for &node in nodes {
        let [x, y, z] = std::array::from_fn(|c| at[node as usize][c] - centre[c]);
        let rows: [[f64; MOTIONS]; 3] = [
            [1.0, 0.0, 0.0, 0.0, z, -y, x],
            [0.0, 1.0, 0.0, -z, 0.0, x, y],
            [0.0, 0.0, 1.0, y, -x, 0.0, z],
        ];
        for (entries, row) in motions.0[3 * node as usize..][..3].iter_mut().zip(rows) {
            entries[..MOTIONS].copy_from_slice(&row);
        }
    }
    motions.orthonormalise();
    let mut across: Vec<Vec<f64>> = (0..MOTIONS).map(|k| system.across(&motions.get(k))).collect();
    for (node, _) in system.fixed().iter().enumerate().filter(|(_, fixed)| **fixed) {
        for entries in &motions.0[3 * node..3 * node + 3] {
            across.iter_mut().zip(entries).for_each(|(across, entry)| across.push(*entry));
        }
    }
    let mut gram: Products = [[0.0; COUNT]; COUNT];
    for (i, a) in across.iter().enumerate() {
        for (j, b) in across.iter().enumerate() {
            gram[i][j] = a.iter().zip(b).map(|(a, b)| a * b).sum();
        }
    }
    (MOTIONS..COUNT).for_each(|k| gram[k][k] = 1.0);
    let (values, mut factors) = principal(&gram);
    for (value, factors) in values.iter().zip(&mut factors) {
        if *value > KEPT {
            factors.fill(0.0);
        }
    }
    motions.mix(&factors);
    // Motions that are combinations of others, as for vertices on a line, are still zero.
    motions.orthonormalise();
    motions
}
