//! What nalgebra lacks for the small dense problems of subspace iterations: eigenvectors by an
//! iteration that always ends, and orthonormal vectors where some may depend on others.

use super::super::argsort::{argsort, key_of_number};
use nalgebra::{ComplexField, DMatrix};

/// Greatest number of sweeps over all pairs; eight are usual.
const SWEEPS: usize = 30;

/// Returns the eigenvalues of the symmetric part of a matrix, the greatest first, and their unit
/// eigenvectors, the columns of the second matrix; by Jacobi's rotations (Golub and Van Loan,
/// Matrix Computations, 8.5).
///
/// Unlike the QR iteration of nalgebra, they end for every matrix, and small eigenvalues of a
/// graded matrix keep their digits.
pub fn symmetric_eigen(matrix: &DMatrix<f64>) -> (Vec<f64>, DMatrix<f64>) {
    let n = matrix.nrows();
    let mut a = (matrix + matrix.transpose()) * 0.5;
    let mut vectors = DMatrix::identity(n, n);
    for _ in 0..SWEEPS {
        let mut rotated = false;
        for p in 0..n {
            for q in p + 1..n {
                // Negligible beside the diagonal.
                let (pp, qq, pq) = (a[(p, p)], a[(q, q)], a[(p, q)]);
                let least = f64::EPSILON * f64::EPSILON * (pp.abs() + qq.abs());
                if pq.abs() <= (0.1 * f64::EPSILON * (pp * qq).abs().sqrt()).max(least) {
                    continue;
                }
                rotated = true;
                let ratio = (qq - pp) / (2.0 * pq);
                let sign = if ratio < 0.0 { -1.0 } else { 1.0 };
                let tangent = sign / (ratio.abs() + (1.0 + ratio * ratio).sqrt());
                let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
                let turned = |x: f64, y: f64| {
                    (cosine * x - cosine * tangent * y, cosine * tangent * x + cosine * y)
                };
                for k in 0..n {
                    (a[(k, p)], a[(k, q)]) = turned(a[(k, p)], a[(k, q)]);
                }
                for k in 0..n {
                    (a[(p, k)], a[(q, k)]) = turned(a[(p, k)], a[(q, k)]);
                    (vectors[(k, p)], vectors[(k, q)]) = turned(vectors[(k, p)], vectors[(k, q)]);
                }
            }
        }
        if !rotated {
            break;
        }
    }
    let order = argsort((0..n).map(|k| !key_of_number(a[(k, k)])));
    let at = |k: usize| order[k] as usize;
    let values = (0..n).map(|k| a[(at(k), at(k))]).collect();
    (values, DMatrix::from_fn(n, n, |i, k| vectors[(i, at(k))]))
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
            let (values, vectors) = symmetric_eigen(&matrix);
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
        assert_eq!(symmetric_eigen(&DMatrix::zeros(3, 3)).0, [0.0; 3]);
        let diagonal = DMatrix::from_row_slice(2, 2, &[2.0, 0.0, 0.0, -1.0]);
        assert_eq!(symmetric_eigen(&diagonal), (vec![2.0, -1.0], DMatrix::identity(2, 2)));
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
