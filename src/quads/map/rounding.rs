//! Greedy rounding of the integer unknowns of a quadratic energy on the dense inverse of their Schur
//! complement: the same result as one elimination after another of the whole matrix, at the cost of
//! a rank-one update each.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// Distances to the nearest integer that differ by less count as equal.
const TIE: f64 = 1e-6;
/// A variance below this fraction of the first one means that other unknowns determine this one.
const DETERMINED: f64 = 1e-12;

/// The inverse `G` of the energy's matrix, restricted to the integer unknowns: `G_jj` is how easily
/// unknown j moves, and rounding it moves the others along `G_:j`.
pub(super) struct Inverse {
    matrix: DMatrix<f64>,
    factor: Cholesky<f64, Dyn>,
}

impl Inverse {
    /// Takes a symmetric matrix; `None` if it is not positive definite.
    pub(super) fn new(matrix: DMatrix<f64>) -> Option<Inverse> {
        let matrix = (&matrix + matrix.transpose()) * 0.5;
        Some(Inverse { factor: Cholesky::new(matrix.clone())?, matrix })
    }

    /// Rounds the unknowns one by one, that nearest to an integer first; of equal ones all at once if
    /// none then moves another away from its integer, else the first. Symmetric inputs so stay
    /// symmetric.
    ///
    /// Before, each sum of unknowns in `given` takes its value.
    pub(super) fn round(&self, unknowns: &[f64], given: &[(Vec<(usize, f64)>, f64)]) -> Vec<f64> {
        let mut x = DVector::from_column_slice(unknowns);
        let mut g = self.matrix.clone();
        for (row, value) in given {
            let mut along = DVector::zeros(x.len());
            row.iter().for_each(|&(j, c)| along.axpy(c, &g.column(j), 1.0));
            let sum = |v: &DVector<f64>| row.iter().map(|&(j, c)| c * v[j]).sum::<f64>();
            let variance = sum(&along);
            let before: f64 = row.iter().map(|&(j, c)| c * c * self.matrix[(j, j)]).sum();
            if variance > DETERMINED * before {
                x.axpy((value - sum(&x)) / variance, &along, 1.0);
                g.ger(-1.0 / variance, &along, &along.clone(), 1.0);
            }
        }
        let mut left: Vec<usize> = (0..x.len()).collect();
        while !left.is_empty() {
            let distance = |j: usize| (x[j] - nearest(x[j])).abs();
            let least = left.iter().map(|&j| distance(j)).fold(f64::INFINITY, f64::min);
            let mut tied: Vec<usize> =
                left.iter().copied().filter(|&j| distance(j) <= least + TIE).collect();
            let shift = |j: usize| nearest(x[j]) - x[j];
            let is_free = |j: usize| g[(j, j)] > DETERMINED * self.matrix[(j, j)];
            let moves = |j: usize, k: usize| {
                is_free(j) && (x[k] + g[(k, j)] / g[(j, j)] * shift(j) - nearest(x[k])).abs() > 0.5
            };
            // With a value that is no number there is none; what is done with the values refuses it.
            if tied.is_empty() {
                break;
            }
            if tied.iter().any(|&j| tied.iter().any(|&k| j != k && moves(j, k))) {
                tied.truncate(1);
            }
            let targets: Vec<f64> = tied.iter().map(|&j| nearest(x[j])).collect();
            for (&j, target) in tied.iter().zip(targets) {
                if g[(j, j)] > DETERMINED * self.matrix[(j, j)] {
                    let along = g.column(j) / g[(j, j)];
                    x.axpy(target - x[j], &along, 1.0);
                    let row = g.row(j).transpose();
                    g.ger(-1.0, &along, &row, 1.0);
                }
                x[j] = target;
            }
            left.retain(|j| !tied.contains(j));
        }
        x.iter().copied().collect()
    }

    /// The forces that hold the unknowns at `values` instead of `free`, where they are without:
    /// `G^-1 (values - free)`.
    pub(super) fn forces(&self, values: &[f64], free: &[f64]) -> Vec<f64> {
        let difference = DVector::from_iterator(
            values.len(),
            values.iter().zip(free).map(|(value, free)| value - free),
        );
        self.factor.solve(&difference).iter().copied().collect()
    }
}

/// The nearest integer; of two the greater.
pub(super) fn nearest(x: f64) -> f64 {
    (x + 0.5).floor()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers between -1 and 1 that look random.
    fn numbers(count: usize) -> Vec<f64> {
        let mut state = 1u64;
        let mut next = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 33) as f64 / f64::from(1u32 << 30) - 1.0
        };
        (0..count).map(|_| next()).collect()
    }

    #[test]
    fn rounding_agrees_with_eliminating_one_unknown_after_another() {
        let n = 50;
        let entries = DMatrix::from_column_slice(n, n, &numbers(n * n));
        let normal = &entries * entries.transpose() + DMatrix::identity(n, n);
        let right = DVector::from_column_slice(&numbers(n)) * 30.0;
        let start = normal.clone().cholesky().unwrap().solve(&right);
        let inverse = Inverse::new(normal.clone().cholesky().unwrap().inverse()).unwrap();
        let found = inverse.round(start.as_slice(), &[]);
        // The slow way: minimise with all unknowns rounded so far given, each time anew.
        let mut given: Vec<Option<f64>> = vec![None; n];
        for _ in 0..n {
            let free: Vec<usize> = (0..n).filter(|&k| given[k].is_none()).collect();
            let part = normal.select_rows(&free).select_columns(&free);
            let of_given = |&i: &usize| {
                let sum: f64 = (0..n).filter_map(|k| Some(normal[(i, k)] * given[k]?)).sum();
                right[i] - sum
            };
            let part_right = DVector::from_iterator(free.len(), free.iter().map(of_given));
            let x = part.cholesky().unwrap().solve(&part_right);
            let distance = |k: usize| (x[k] - nearest(x[k])).abs();
            let k = (0..free.len()).min_by(|&a, &b| distance(a).total_cmp(&distance(b))).unwrap();
            given[free[k]] = Some(nearest(x[k]));
        }
        let expected: Vec<f64> = given.into_iter().flatten().collect();
        assert_eq!(found, expected);
        // Forces hold the rounded values.
        let forces = inverse.forces(&found, start.as_slice());
        let held = normal.cholesky().unwrap().solve(&(right + DVector::from_vec(forces)));
        held.iter().zip(&found).for_each(|(x, y)| assert!((x - y).abs() < 1e-9, "{x} {y}"));
    }

    #[test]
    fn equal_distances_are_rounded_together() {
        // Two unknowns that are mirror images of each other.
        let coupled = DMatrix::from_row_slice(2, 2, &[1.0, -0.3, -0.3, 1.0]);
        let inverse = Inverse::new(coupled).unwrap();
        assert_eq!(inverse.round(&[2.3, -2.3], &[]), [2.0, -2.0]);
        // Three apart, and as near as that allows.
        assert_eq!(inverse.round(&[2.3, 2.2], &[(vec![(0, 1.0), (1, -1.0)], 3.0)]), [4.0, 1.0]);
    }
}
