//! A few vectors over all unknowns (x, y and z of every node), solved for in groups of four.

use crate::constraint::Row;
use crate::math::{argsort, key_of_number, symmetric_eigen};
use crate::solve::exact::block_system::BlockSystem;

/// Number of vectors. Those beyond the modes make the modes converge sooner.
pub(super) const COUNT: usize = 12;

/// Greatest number of modes.
pub(super) const MODES: usize = 8;

/// A vector with less than this fraction of its length outside the span of the previous ones is a
/// combination of them.
const INDEPENDENT: f64 = 1e-9;

/// Inner products of vectors.
pub(super) type Products = [[f64; COUNT]; COUNT];

/// The vectors: for every unknown, an entry of each.
#[derive(Clone)]
pub(super) struct Vectors(pub Vec<[f64; COUNT]>);

impl Vectors {
    /// Zero vectors over this many nodes.
    pub(super) fn zero(nodes: usize) -> Vectors {
        Vectors(vec![[0.0; COUNT]; 3 * nodes])
    }

    /// Replaces vector `k`.
    pub(super) fn set(&mut self, k: usize, vector: &[Row]) {
        for (entries, row) in self.0.chunks_exact_mut(3).zip(vector) {
            (0..3).for_each(|c| entries[c][k] = row[c]);
        }
    }

    /// Vector `k`, a row for each node.
    pub(super) fn get(&self, k: usize) -> Vec<Row> {
        self.0.chunks_exact(3).map(|rows| [rows[0][k], rows[1][k], rows[2][k], 0.0]).collect()
    }

    /// Inner products with those of `other`.
    pub(super) fn products(&self, other: &Vectors) -> Products {
        let mut sums = [[0.0; COUNT]; COUNT];
        for (a, b) in self.0.iter().zip(&other.0) {
            for (sums, a) in sums.iter_mut().zip(a) {
                sums.iter_mut().zip(b).for_each(|(sum, b)| *sum += a * b);
            }
        }
        sums
    }

    /// Replaces vector `k` by the sum of the vectors times `factors[k]`.
    pub(super) fn mix(&mut self, factors: &Products) {
        for entries in &mut self.0 {
            let mixed = |own: &[f64; COUNT]| own.iter().zip(&*entries).map(|(a, b)| a * b).sum();
            *entries = std::array::from_fn(|k| mixed(&factors[k]));
        }
    }

    /// Subtracts the components in the span of the orthonormal vectors of `basis`.
    pub(super) fn project_out(&mut self, basis: &Vectors) {
        let along = basis.products(self);
        for (entries, basis) in self.0.iter_mut().zip(&basis.0) {
            for (along, part) in along.iter().zip(basis) {
                entries.iter_mut().zip(along).for_each(|(entry, along)| *entry -= along * part);
            }
        }
    }

    /// Orthonormalises the vectors, each against those before it; combinations of those become
    /// zero.
    pub(super) fn orthonormalise(&mut self) {
        for j in 0..COUNT {
            let before = self.product(j, j).sqrt();
            // Twice is enough (Kahan, Parlett).
            for i in (0..j).chain(0..j) {
                let along = self.product(i, j);
                self.0.iter_mut().for_each(|entries| entries[j] -= along * entries[i]);
            }
            let after = self.product(j, j).sqrt();
            let factor = if after > INDEPENDENT * before { 1.0 / after } else { 0.0 };
            self.0.iter_mut().for_each(|entries| entries[j] *= factor);
        }
    }

    fn product(&self, i: usize, j: usize) -> f64 {
        self.0.iter().map(|entries| entries[i] * entries[j]).sum()
    }

    /// Applies the inverse of the factored matrix.
    pub(super) fn solve(&mut self, system: &BlockSystem) {
        let mut four = vec![[0.0; 4]; self.0.len()];
        for group in 0..COUNT / 4 {
            for (to, entries) in four.iter_mut().zip(&self.0) {
                to.copy_from_slice(&entries[4 * group..4 * group + 4]);
            }
            system.solve(&mut four);
            for (from, entries) in four.iter().zip(&mut self.0) {
                entries[4 * group..4 * group + 4].copy_from_slice(from);
            }
        }
    }
}

/// Returns the eigenvalues of a symmetric matrix, the greatest first, and the eigenvector of each.
pub(super) fn principal(matrix: &Products) -> ([f64; COUNT], Products) {
    let symmetric: Products =
        std::array::from_fn(|i| std::array::from_fn(|j| 0.5 * (matrix[i][j] + matrix[j][i])));
    let (values, vectors) = symmetric_eigen(symmetric);
    let order = argsort(values.iter().map(|&value| !key_of_number(value)));
    let at = |k: usize| order[k] as usize;
    (std::array::from_fn(|k| values[at(k)]), std::array::from_fn(|k| vectors[at(k)]))
}
