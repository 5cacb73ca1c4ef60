//! Small dense problems of subspace iterations, on the matrices of nalgebra.

use super::indices::{argsort, key_of_number};
use nalgebra::{ComplexField, DMatrix, SymmetricEigen};

/// Greatest number of iterations for eigenvalues to one tolerance; two or three for each are usual.
const ITERATIONS: usize = 1000;

/// Returns the eigenvalues of the symmetric part of a matrix, the greatest first, and their unit
/// eigenvectors, the columns of the second matrix. `None` if the matrix is empty, or if an entry is
/// not finite: no tolerance would end the iteration.
pub fn symmetric_eigen(matrix: &DMatrix<f64>) -> Option<(Vec<f64>, DMatrix<f64>)> {
    let symmetric = (matrix + matrix.transpose()) * 0.5;
    if symmetric.is_empty() || !symmetric.iter().all(|entry| entry.is_finite()) {
        return None;
    }
    let mut tolerance = f64::EPSILON;
    // Rounding errors may prevent the iteration from ending at this tolerance (nalgebra, issue
    // 1025), but not at every looser one.
    let found = loop {
        match SymmetricEigen::try_new(symmetric.clone(), tolerance, ITERATIONS) {
            Some(found) => break found,
            None => tolerance *= 10.0,
        }
    };
    let order = argsort(found.eigenvalues.iter().map(|&value| !key_of_number(value)));
    let order: Vec<usize> = order.into_iter().map(|k| k as usize).collect();
    let values = order.iter().map(|&k| found.eigenvalues[k]).collect();
    Some((values, found.eigenvectors.select_columns(&order)))
}

/// Orthonormalises the columns of a matrix, each against those before it. One with at most the
/// fraction `independent` of its length outside the span of those becomes zero.
pub fn orthonormalise<T: ComplexField<RealField = f64>>(
    vectors: &mut DMatrix<T>,
    independent: f64,
) {
    for j in 0..vectors.ncols() {
        let (before, mut rest) = vectors.columns_range_pair_mut(..j, j..);
        let mut own = rest.column_mut(0);
        let length = own.norm();
        // Twice is enough (Kahan, Parlett).
        for other in before.column_iter().chain(before.column_iter()) {
            let along = other.dotc(&own);
            own.axpy(-along, &other, T::one());
        }
        let left = own.norm();
        own.scale_mut(if left > independent * length { 1.0 / left } else { 0.0 });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn vectors_are_orthonormal_and_turned_into_multiples(
            entries in proptest::array::uniform25(-1.0..1.0f64),
            sizes in proptest::array::uniform5(-6i32..6),
        ) {
            let size: [f64; 5] = sizes.map(|k| 10f64.powi(k));
            let matrix = DMatrix::from_fn(5, 5, |i, j| {
                entries[5 * i.min(j) + i.max(j)] * size[i] * size[j]
            });
            let (values, vectors) = symmetric_eigen(&matrix).expect("all entries are finite");
            prop_assert!(values.is_sorted_by(|a, b| a >= b));
            prop_assert!((vectors.tr_mul(&vectors) - DMatrix::identity(5, 5)).amax() < 1e-13);
            let images = &matrix * &vectors;
            for k in 0..5 {
                let error = images.column(k) - vectors.column(k) * values[k];
                prop_assert!(error.amax() <= 1e-13 * matrix.amax());
            }
        }
    }

    #[test]
    fn nothing_has_nothing_and_a_diagonal_stays() {
        let found = |matrix| symmetric_eigen(&matrix).expect("all entries are finite");
        assert_eq!(found(DMatrix::zeros(3, 3)).0, [0.0; 3]);
        let (values, vectors) = found(DMatrix::from_row_slice(2, 2, &[2.0, 0.0, 0.0, -1.0]));
        assert_eq!((values, vectors.abs()), (vec![2.0, -1.0], DMatrix::identity(2, 2)));
    }

    #[test]
    fn what_is_empty_or_not_finite_has_no_eigenvalues() {
        assert_eq!(symmetric_eigen(&DMatrix::zeros(0, 0)), None);
        assert_eq!(symmetric_eigen(&DMatrix::from_element(2, 2, f64::NAN)), None);
    }

    #[test]
    fn what_depends_on_earlier_vectors_becomes_zero() {
        let mut vectors = DMatrix::from_column_slice(
            3,
            4,
            &[3.0, 0.0, 4.0, 6.0, 0.0, 8.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0],
        );
        orthonormalise(&mut vectors, 1e-12);
        let expected = DMatrix::from_row_slice(
            4,
            4,
            &[1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        );
        assert!((vectors.tr_mul(&vectors) - expected).amax() < 1e-15, "{vectors}");
    }
}
