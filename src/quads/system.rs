//! A sparse symmetric positive definite system whose values change and whose pattern stays: analysed
//! once, factored for each set of values, with some unknowns given.

use super::MapFault;
use crate::sparse::{Factor, Factorization, Precision, SymbolicAnalysis, UpperTriangle};
use std::rc::Rc;

/// Right-hand sides that one pair of triangular sweeps solves.
pub(super) const RIGHT_SIDES: usize = 4;

/// A matrix with its factor. Unknowns are numbered as the caller does.
pub(super) struct SymmetricSystem {
    analysis: SymbolicAnalysis,
    matrix: UpperTriangle,
    /// The matrix with rows and columns of the identity for given unknowns.
    reduced: Option<UpperTriangle>,
    /// Whether an unknown is given, in the elimination order.
    given: Vec<bool>,
    factor: Factor,
}

impl SymmetricSystem {
    /// Analyses the pattern of `n` unknowns that `pairs` couple, in any order and repetition.
    pub(super) fn new(n: usize, mut pairs: Vec<[u32; 2]>) -> SymmetricSystem {
        pairs.iter_mut().for_each(|pair| pair.sort_unstable());
        pairs.retain(|[i, j]| i != j);
        pairs.sort_unstable();
        pairs.dedup();
        let analysis = SymbolicAnalysis::of_edges(n, pairs.into_iter());
        let matrix = analysis.zeros();
        let factor = Factor::new(Rc::clone(analysis.supernodes()), Factorization::Supernodal);
        SymmetricSystem { given: vec![false; n], reduced: None, analysis, matrix, factor }
    }

    /// The index among [`SymmetricSystem::values`] of the entry of two unknowns, which the pattern
    /// must couple.
    pub(super) fn place(&self, i: usize, j: usize) -> usize {
        let [a, b] = [i, j].map(|i| self.analysis.position_of()[i]);
        let (row, column) = (a.min(b), a.max(b));
        let range = self.matrix.indptr().outer_inds_sz(column as usize);
        let found = self.matrix.indices()[range.clone()].binary_search(&row);
        range.start + found.expect("the pattern couples the unknowns")
    }

    /// The index of the diagonal entry of an unknown.
    pub(super) fn diagonal(&self, i: usize) -> usize {
        let column = self.analysis.position_of()[i] as usize;
        self.matrix.indptr().outer_inds_sz(column).end - 1
    }

    /// The entries of the matrix; those off the diagonal stand for both of their places.
    pub(super) fn values(&mut self) -> &mut [f64] {
        self.matrix.data_mut()
    }

    /// Factors the matrix for unknowns of which some are `given`, `#n`.
    ///
    /// # Errors
    /// If the matrix is not positive definite to working precision.
    pub(super) fn factor(&mut self, given: &[bool]) -> Result<(), MapFault> {
        let any = given.iter().any(|&given| given);
        for (k, flag) in self.given.iter_mut().enumerate() {
            *flag = any && given[self.analysis.unknown_at(k) as usize];
        }
        self.reduced = any.then(|| {
            let mut reduced = self.matrix.clone();
            for column in 0..reduced.cols() {
                for place in self.matrix.indptr().outer_inds_sz(column) {
                    let row = self.matrix.indices()[place] as usize;
                    if self.given[row] || self.given[column] {
                        reduced.data_mut()[place] = if row == column { 1.0 } else { 0.0 };
                    }
                }
            }
            reduced
        });
        let matrix = self.reduced.as_ref().unwrap_or(&self.matrix);
        let factored = self.factor.factor(matrix, &self.given, Precision::Double);
        factored.map_err(|_| MapFault::Numerical)
    }

    /// Solves for the unknowns that are not given. `x` has the right-hand sides, and the values of
    /// given unknowns; then the solution.
    pub(super) fn solve<const R: usize>(&mut self, x: &mut [[f64; R]]) {
        let SymmetricSystem { analysis, matrix, reduced, given, factor } = self;
        let of_step = (0..x.len()).map(|k| x[analysis.unknown_at(k) as usize]);
        let mut ordered: Vec<[f64; R]> = of_step.collect();
        if reduced.is_some() {
            for column in 0..matrix.cols() {
                for place in matrix.indptr().outer_inds_sz(column) {
                    let row = matrix.indices()[place] as usize;
                    let value = matrix.data()[place];
                    for (from, to) in [(row, column), (column, row)] {
                        if given[from] && !given[to] {
                            for r in 0..R {
                                ordered[to][r] -= value * ordered[from][r];
                            }
                        }
                    }
                }
            }
        }
        let kept: Vec<[f64; R]> = if reduced.is_some() { ordered.clone() } else { Vec::new() };
        factor.double(reduced.as_ref().unwrap_or(matrix), given).solve(&mut ordered);
        for (k, value) in ordered.into_iter().enumerate() {
            let value = if given[k] { kept[k] } else { value };
            x[analysis.unknown_at(k) as usize] = value;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector};

    #[test]
    fn it_solves_for_what_is_not_given_as_a_dense_matrix_does() {
        let n = 12;
        let pairs = (0..n as u32).flat_map(|i| [[i, (i + 1) % 12], [(i * i) % 12, i]]).collect();
        let mut system = SymmetricSystem::new(n, pairs);
        let mut dense = DMatrix::<f64>::zeros(n, n);
        for i in 0..n {
            let (diagonal, next) = (system.diagonal(i), system.place((i + 1) % n, i));
            system.values()[diagonal] = 5.0 + i as f64;
            system.values()[next] = -1.0 - 0.1 * i as f64;
            dense[(i, i)] = 5.0 + i as f64;
            dense[(i, (i + 1) % n)] = -1.0 - 0.1 * i as f64;
            dense[((i + 1) % n, i)] = -1.0 - 0.1 * i as f64;
        }
        for given in [vec![false; n], (0..n).map(|i| i % 4 == 1).collect::<Vec<bool>>()] {
            let mut x: Vec<[f64; 1]> = (0..n).map(|i| [(i % 5) as f64 - 1.0]).collect();
            let before = x.clone();
            system.factor(&given).unwrap();
            system.solve(&mut x);
            let product = &dense * DVector::from_fn(n, |i, _| x[i][0]);
            for i in 0..n {
                let expected = if given[i] { x[i][0] } else { product[i] };
                assert!((expected - before[i][0]).abs() < 1e-12, "unknown {i}");
            }
        }
    }
}
