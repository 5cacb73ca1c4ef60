//! The types of matrices and right-hand sides, and the criterion for positive pivots.

use sprs::CsMatI;

/// The upper triangle of a symmetric matrix in compressed columns, rows ascending. Every diagonal
/// entry is stored, as the last one of its column.
pub(crate) type UpperTriangle = CsMatI<f64, u32>;

/// Coordinates x, y, z of one unknown, padded by a zero to two 128-bit registers.
pub(crate) type Row = [f64; 4];

/// A pivot at most this fraction of the diagonal entry of its column is a zero with rounding error.
/// `sprs-ldl` reports only exact zeros.
pub(crate) const SMALLEST_PIVOT: f64 = 1e-13;

/// The matrix is not positive definite to working precision.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Singular {
    /// The first column whose pivot is not positive.
    pub column: usize,
}

/// Whether `pivot` is positive relative to the `diagonal` entry of its column; false for NaN.
pub(crate) fn is_positive(pivot: f64, diagonal: f64, smallest: f64) -> bool {
    pivot > smallest * diagonal && diagonal > 0.0
}
