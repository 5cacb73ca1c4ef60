//! Eigenvalues and eigenvectors of a small symmetric matrix by Jacobi's rotations (Golub and Van Loan,
//! Matrix Computations, 8.5).

/// Greatest number of sweeps over all pairs; eight are usual.
const SWEEPS: usize = 30;

/// Returns the eigenvalues of a symmetric matrix, unordered, and their unit eigenvectors.
pub fn symmetric_eigen<const N: usize>(mut a: [[f64; N]; N]) -> ([f64; N], [[f64; N]; N]) {
    let mut vectors: [[f64; N]; N] =
        std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))));
    for _ in 0..SWEEPS {
        let mut rotated = false;
        for p in 0..N {
            for q in p + 1..N {
                // Negligible beside the diagonal.
                let diagonal = (a[p][p] * a[q][q]).abs().sqrt();
                let least = f64::EPSILON * f64::EPSILON * (a[p][p].abs() + a[q][q].abs());
                if a[p][q].abs() <= (0.1 * f64::EPSILON * diagonal).max(least) {
                    continue;
                }
                rotated = true;
                let ratio = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
                let sign = if ratio < 0.0 { -1.0 } else { 1.0 };
                let tangent = sign / (ratio.abs() + (1.0 + ratio * ratio).sqrt());
                let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
                let sine = cosine * tangent;
                for row in &mut a {
                    (row[p], row[q]) =
                        (cosine * row[p] - sine * row[q], sine * row[p] + cosine * row[q]);
                }
                for k in 0..N {
                    let (x, y) = (a[p][k], a[q][k]);
                    (a[p][k], a[q][k]) = (cosine * x - sine * y, sine * x + cosine * y);
                    let (x, y) = (vectors[p][k], vectors[q][k]);
                    (vectors[p][k], vectors[q][k]) = (cosine * x - sine * y, sine * x + cosine * y);
                }
            }
        }
        if !rotated {
            break;
        }
    }
    (std::array::from_fn(|k| a[k][k]), vectors)
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
            let matrix: [[f64; 5]; 5] = std::array::from_fn(|i| {
                std::array::from_fn(|j| entries[5 * i.min(j) + i.max(j)] * size[i] * size[j])
            });
            let (values, vectors) = symmetric_eigen(matrix);
            let scale = matrix.as_flattened().iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            for k in 0..5 {
                for i in 0..5 {
                    let dot: f64 = (0..5).map(|j| vectors[k][j] * vectors[i][j]).sum();
                    prop_assert!((dot - f64::from(u8::from(i == k))).abs() < 1e-13);
                    let image: f64 = (0..5).map(|j| matrix[i][j] * vectors[k][j]).sum();
                    prop_assert!((image - values[k] * vectors[k][i]).abs() <= 1e-13 * scale);
                }
            }
        }
    }

    #[test]
    fn nothing_has_nothing_and_a_diagonal_stays() {
        assert_eq!(symmetric_eigen([[0.0; 3]; 3]).0, [0.0; 3]);
        let (values, vectors) = symmetric_eigen([[2.0, 0.0], [0.0, -1.0]]);
        assert_eq!((values, vectors), ([2.0, -1.0], [[1.0, 0.0], [0.0, 1.0]]));
    }
}
