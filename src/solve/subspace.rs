//! The smallest eigenvector of `A u = lambda B u` by inverse iteration of a few vectors at once,
//! the Rayleigh-Ritz way, on the factored matrix.
//!
//! The factor solves for the four columns of a [`Row`] at the price of three, so four vectors are
//! iterated. With the two-dimensional eigenspaces of a complex problem that leaves one more pair,
//! which speeds up convergence.

use super::System;
use crate::constraint::Row;
use nalgebra::{Matrix4, SymmetricEigen};

/// Iterations at most. Maps whose second eigenvalue is well apart need ten to forty.
const ITERATIONS: usize = 300;

/// The eigenspace has converged when a step turns it by less.
const TURN: f64 = 1e-11;

/// Iterates from the columns of `x` (`#nodes` rows) towards the two smallest eigenvectors, which
/// become its first two columns, orthonormal in `B = diag(mass)`.
///
/// `system` holds the factor of `A + shift B`. `kernel` tells for each node which constant vector it
/// belongs to, 0 or 1: both are in the kernel of `A` and are left out. None when the vectors do not stay
/// independent.
pub(super) fn smallest_pair(
    system: &System,
    mass: &[f64],
    kernel: &[u8],
    mut x: Vec<Row>,
) -> Option<Vec<Row>> {
    deflate(&mut x, mass, kernel);
    for _ in 0..ITERATIONS {
        let mut right = x.clone();
        right.iter_mut().zip(mass).for_each(|(row, &mass)| *row = row.map(|value| value * mass));
        let mut y = right.clone();
        system.solve(&mut y);
        deflate(&mut y, mass, kernel);
        let inverse = products(&y, &right, None);
        let gram = products(&y, &y, Some(mass));
        // Scaled, so that vectors that grew very differently stay independent in working precision.
        let scale = Matrix4::from_diagonal(&gram.diagonal().map(|square| 1.0 / square.sqrt()));
        let lower = (scale * gram * scale).cholesky()?.l();
        let to_orthonormal = scale * lower.try_inverse()?.transpose();
        let ritz = to_orthonormal.transpose() * inverse * to_orthonormal;
        let ritz = SymmetricEigen::new((ritz + ritz.transpose()) * 0.5);
        let mut order = [0, 1, 2, 3];
        order.sort_by(|&a, &b| ritz.eigenvalues[a].total_cmp(&ritz.eigenvalues[b]));
        let mix = to_orthonormal * Matrix4::from_fn(|i, j| ritz.eigenvectors[(i, order[j])]);
        for row in &mut y {
            let old = *row;
            *row = std::array::from_fn(|j| (0..4).map(|i| old[i] * mix[(i, j)]).sum());
        }
        let turn = turn(&x, &y, mass);
        x = y;
        if turn <= TURN {
            break;
        }
    }
    // Written so that NaN fails.
    x.iter().flatten().all(|value| value.is_finite()).then_some(x)
}

/// The length of what of the first new vector is outside the plane of the two old ones.
fn turn(old: &[Row], new: &[Row], mass: &[f64]) -> f64 {
    let overlap = products(old, new, Some(mass));
    let (along, across) = (overlap[(0, 0)], overlap[(1, 0)]);
    let rows = old.iter().zip(new).zip(mass);
    let squares = rows.map(|((old, new), mass)| {
        let outside = new[0] - along * old[0] - across * old[1];
        mass * outside * outside
    });
    squares.sum::<f64>().sqrt()
}

/// Takes out the two constant vectors.
fn deflate(x: &mut [Row], mass: &[f64], kernel: &[u8]) {
    let (mut sums, mut weights) = ([[0.0; 4]; 2], [0.0; 2]);
    for ((row, &mass), &k) in x.iter().zip(mass).zip(kernel) {
        weights[k as usize] += mass;
        (0..4).for_each(|j| sums[k as usize][j] += mass * row[j]);
    }
    for (row, &k) in x.iter_mut().zip(kernel) {
        let k = k as usize;
        (0..4).for_each(|j| row[j] -= sums[k][j] / weights[k]);
    }
}

/// The inner products of the columns of `a` with those of `b`, in `diag(mass)` if given.
fn products(a: &[Row], b: &[Row], mass: Option<&[f64]>) -> Matrix4<f64> {
    let mut products = Matrix4::zeros();
    for (k, (a, b)) in a.iter().zip(b).enumerate() {
        let mass = mass.map_or(1.0, |mass| mass[k]);
        for i in 0..4 {
            for j in 0..4 {
                products[(i, j)] += mass * a[i] * b[j];
            }
        }
    }
    products
}
