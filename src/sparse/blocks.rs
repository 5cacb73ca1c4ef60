//! Symmetric matrices of 3-by-3 blocks in the pattern of a scalar matrix, and their factor, for
//! problems that couple x, y and z of a node. The order, tree and supernodes are those of the
//! scalar matrix with every node repeated three times, so that no new analysis is needed.

use super::analysis::SymbolicAnalysis;
use super::matrix::{Row, Singular, UpperTriangle};
use super::panels::Panels;
use super::supernodal;
use super::supernodes::Supernodes;
use sprs::{CsMatI, CsStructureI};
use std::rc::Rc;

/// Unknowns per node.
const BLOCK: u32 = 3;

/// A pivot is accepted if it exceeds this fraction of its diagonal entry. Stiff and soft directions
/// of a node differ by up to ten digits.
const SMALLEST_PIVOT: f64 = 1e-15;

/// A matrix of blocks, and its factor.
pub(crate) struct BlockMatrix {
    /// Start of the values of each column of blocks, `#nodes + 1`.
    starts: Vec<u32>,
    /// The rows of the upper triangle of the scalar matrix, by columns.
    rows: Vec<u32>,
    /// Start of each column in `rows`, `#nodes + 1`.
    columns: Vec<u32>,
    matrix: UpperTriangle,
    supernodes: Rc<Supernodes>,
    pivots: Vec<f64>,
    panels: Panels<f64>,
    /// One right-hand side, one value for each unknown.
    unknowns: Vec<[f64; 1]>,
}

impl BlockMatrix {
    /// Returns a zero matrix in the pattern and the order of `analysis`.
    pub(crate) fn new(analysis: &SymbolicAnalysis) -> BlockMatrix {
        let scalar = analysis.zeros();
        let columns = scalar.indptr().raw_storage().to_vec();
        let rows = scalar.indices();
        let n = scalar.cols();
        let (mut starts, mut ends, mut indices) = (vec![0], vec![0], Vec::new());
        for ends_of in columns.windows(2) {
            let own = &rows[ends_of[0] as usize..ends_of[1] as usize];
            for c in 0..BLOCK {
                let above = own.iter().flat_map(|&row| (0..BLOCK).map(move |k| BLOCK * row + k));
                indices.extend(above.take(BLOCK as usize * (own.len() - 1) + c as usize + 1));
                ends.push(indices.len() as u32);
            }
            starts.push(indices.len() as u32);
        }
        let size = BLOCK as usize * n;
        let pattern = CsStructureI::new_csc((size, size), ends, indices, vec![(); last(&starts)]);
        let supernodes = Rc::new(analysis.supernodes().of_blocks(BLOCK, &pattern));
        let (ends, indices) = (pattern.indptr().raw_storage().to_vec(), pattern.indices().to_vec());
        BlockMatrix {
            rows: rows.to_vec(),
            columns,
            matrix: CsMatI::new_csc((size, size), ends, indices, vec![0.0; last(&starts)]),
            starts,
            panels: Panels::new(Rc::clone(&supernodes)),
            supernodes,
            pivots: vec![0.0; size],
            unknowns: vec![[0.0]; size],
        }
    }

    /// Approximate size in bytes of such a matrix with its factor, if the scalar factor has
    /// `nonzeros`. A real number: in a browser a `usize` has 32 bits.
    pub(crate) fn bytes(nonzeros: f64) -> f64 {
        // 5/3 for the factor, the waiting fronts and the matrix.
        nonzeros * (BLOCK * BLOCK) as f64 * size_of::<f64>() as f64 * 5.0 / 3.0
    }

    /// Sets this to the scalar matrix `entries`, in the pattern of the analysis, for each of x, y
    /// and z.
    pub(crate) fn set_scalar(&mut self, entries: &UpperTriangle) {
        self.matrix.data_mut().fill(0.0);
        for column in 0..entries.cols() as u32 {
            let range = entries.indptr().outer_inds_sz(column as usize);
            for (k, place) in range.enumerate() {
                let value = entries.data()[place];
                self.add_at(column, k as u32, |r, c| if r == c { value } else { 0.0 });
            }
        }
    }

    /// The values, as accepted by [`BlockMatrix::set_values`].
    pub(crate) fn values(&self) -> &[f64] {
        self.matrix.data()
    }

    /// Sets the values to those of another matrix of this pattern.
    pub(crate) fn set_values(&mut self, values: &[f64]) {
        self.matrix.data_mut().copy_from_slice(values);
    }

    /// Sets all values to zero.
    pub(crate) fn clear(&mut self) {
        self.matrix.data_mut().fill(0.0);
    }

    /// Adds `block(row, column)` to the diagonal block of a node. Only the upper triangle is used.
    pub(crate) fn add_diagonal(&mut self, node: u32, block: impl Fn(usize, usize) -> f64) {
        let above = self.columns[node as usize + 1] - self.columns[node as usize] - 1;
        self.add_at(node, above, block);
    }

    /// Adds `block(row, column)` to the block of two nodes that the pattern couples; `row` must not
    /// be eliminated after `column`. Of a diagonal block only the upper triangle is used.
    pub(crate) fn add(&mut self, row: u32, column: u32, block: impl Fn(usize, usize) -> f64) {
        let range =
            self.columns[column as usize] as usize..self.columns[column as usize + 1] as usize;
        let k = self.rows[range].partition_point(|&other| other < row);
        self.add_at(column, k as u32, block);
    }

    /// The same, with `row` given as entry `k` of the column.
    #[inline(always)]
    fn add_at(&mut self, column: u32, k: u32, block: impl Fn(usize, usize) -> f64) {
        let v = column as usize;
        let above = self.columns[v + 1] - self.columns[v] - 1;
        let on_diagonal = k == above;
        let values = self.matrix.data_mut();
        for c in 0..BLOCK {
            let start = self.starts[v] + c * BLOCK * above + c * (c + 1) / 2 + BLOCK * k;
            let rows = if on_diagonal { c + 1 } else { BLOCK };
            for r in 0..rows {
                values[(start + r) as usize] += block(r as usize, c as usize);
            }
        }
    }

    /// Sets `product` to this matrix times `vectors`, one row for each node.
    pub(crate) fn times(&self, vectors: &[Row], product: &mut [Row]) {
        product.fill([0.0; 4]);
        let values = self.matrix.data();
        for v in 0..vectors.len() {
            let rows = &self.rows[self.columns[v] as usize..self.columns[v + 1] as usize];
            let (above, own) = (rows.len() - 1, vectors[v]);
            let mut start = self.starts[v] as usize;
            for c in 0..BLOCK as usize {
                let column = &values[start..][..BLOCK as usize * above + c + 1];
                start += column.len();
                let (blocks, diagonal) = column.split_at(BLOCK as usize * above);
                let mut sum = diagonal[c] * own[c];
                for (block, &row) in blocks.chunks_exact(BLOCK as usize).zip(rows) {
                    for (r, value) in block.iter().enumerate() {
                        product[row as usize][r] += value * own[c];
                        sum += value * vectors[row as usize][r];
                    }
                }
                for r in 0..c {
                    product[v][r] += diagonal[r] * own[c];
                    sum += diagonal[r] * own[r];
                }
                product[v][c] += sum;
            }
        }
    }

    /// Factors the matrix. The rows and columns of `fixed` nodes must be those of the identity.
    ///
    /// # Errors
    /// If the matrix is not positive definite to working precision.
    pub(crate) fn factor(&mut self, fixed: &[bool]) -> Result<(), Singular> {
        let fixed: Vec<bool> = fixed.iter().flat_map(|&fixed| [fixed; BLOCK as usize]).collect();
        let BlockMatrix { supernodes, matrix, pivots, panels, .. } = self;
        supernodal::factor(supernodes, matrix, &fixed, SMALLEST_PIVOT, pivots, &mut |s, front| {
            panels.store(s, front);
        })?;
        panels.set_pivots(pivots);
        Ok(())
    }

    /// Applies the inverse of the factored matrix to four right-hand sides in place, one row for
    /// each unknown.
    pub(crate) fn solve_columns(&self, right: &mut [Row]) {
        self.panels.solve(right);
    }

    /// Applies the inverse of the factored matrix to `right` in place, one row for each node.
    pub(crate) fn solve(&mut self, right: &mut [Row]) {
        for (unknowns, row) in self.unknowns.chunks_exact_mut(BLOCK as usize).zip(&*right) {
            unknowns.iter_mut().zip(row).for_each(|(unknown, value)| *unknown = [*value]);
        }
        self.panels.solve(&mut self.unknowns);
        for (unknowns, row) in self.unknowns.chunks_exact(BLOCK as usize).zip(right) {
            row.iter_mut().zip(unknowns).for_each(|(value, unknown)| *value = unknown[0]);
        }
    }
}

fn last(starts: &[u32]) -> usize {
    starts.last().map_or(0, |&end| end as usize)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector};

    /// A path and a few more couplings over `n` nodes.
    fn pattern(n: usize) -> CsStructureI<u32> {
        let couples = |i: usize, j: usize| i.abs_diff(j) < 2 || (i * j + i + j).is_multiple_of(7);
        let (mut ends, mut rows) = (vec![0], Vec::new());
        for v in 0..n {
            rows.extend((0..n).filter(|&u| couples(u, v)).map(|u| u as u32));
            ends.push(rows.len() as u32);
        }
        let values = vec![(); rows.len()];
        CsStructureI::new_csc((n, n), ends, rows, values)
    }

    #[test]
    fn it_multiplies_and_solves_as_a_dense_matrix_does() {
        let n = 23;
        let analysis = SymbolicAnalysis::new(pattern(n));
        let mut scalar = analysis.zeros();
        let mut blocks = BlockMatrix::new(&analysis);
        let mut dense = DMatrix::<f64>::zeros(3 * n, 3 * n);
        for column in 0..n {
            for place in scalar.indptr().outer_inds_sz(column) {
                let row = scalar.indices()[place] as usize;
                let value = if row == column { 40.0 } else { -1.0 - (row % 3) as f64 };
                scalar.data_mut()[place] = value;
                for k in 0..3 {
                    dense[(3 * row + k, 3 * column + k)] = value;
                    dense[(3 * column + k, 3 * row + k)] = value;
                }
            }
        }
        blocks.set_scalar(&scalar);
        for column in 0..n {
            for place in scalar.indptr().outer_inds_sz(column) {
                let row = scalar.indices()[place] as usize;
                // Symmetric only on the diagonal.
                let block = |r: usize, c: usize| {
                    let skew = if row == column { 0.0 } else { 0.25 * r as f64 };
                    ((r + c + row + column) % 4) as f64 * 0.5 + skew
                };
                blocks.add(row as u32, column as u32, block);
                for (r, c) in (0..3).flat_map(|r| (0..3).map(move |c| (r, c))) {
                    dense[(3 * row + r, 3 * column + c)] += block(r, c);
                    if row != column {
                        dense[(3 * column + c, 3 * row + r)] += block(r, c);
                    }
                }
            }
        }
        blocks.factor(&vec![false; n]).expect("it is positive definite");
        let mut rows: Vec<Row> =
            (0..n).map(|v| [v as f64, 1.0 - v as f64, (v % 5) as f64, 0.0]).collect();
        let right = DVector::from_fn(3 * n, |i, _| rows[i / 3][i % 3]);
        let mut product = vec![[f64::NAN; 4]; n];
        blocks.times(&rows, &mut product);
        let of_dense = &dense * &right;
        for (v, row) in product.iter().enumerate() {
            for k in 0..3 {
                assert!((row[k] - of_dense[3 * v + k]).abs() < 1e-12, "{row:?} of node {v}");
            }
        }
        blocks.solve(&mut rows);
        let expected = dense.cholesky().expect("it is positive definite").solve(&right);
        for (v, row) in rows.iter().enumerate() {
            for k in 0..3 {
                assert!((row[k] - expected[3 * v + k]).abs() < 1e-12, "{row:?} of node {v}");
            }
        }
    }
}
