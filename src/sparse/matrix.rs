//! The types of matrices and of right-hand sides, and which pivots of `L D L^T` are those of a positive definite
//! matrix.

use sprs::CsMatI;

/// The upper triangle of a symmetric matrix in compressed columns, rows ascending, with every diagonal
/// entry: it is the last one of its column.
pub(crate) type UpperTriangle = CsMatI<f64, u32>;

/// Coordinates x, y, z of one unknown, and a zero that fills two 128-bit registers.
pub(crate) type Row = [f64; 4];

/// A pivot no greater than this, relative to the diagonal entry of its column, is what rounding leaves of
/// zero. `sprs-ldl` reports exact zeros only.
pub(crate) const SMALLEST_PIVOT: f64 = 1e-13;

/// A matrix is not positive definite to working precision.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Singular {
    /// The first column whose pivot is not positive.
    pub column: usize,
}

/// Whether `pivot` is positive beside the `diagonal` entry of its column; never of a NaN.
pub(crate) fn is_positive(pivot: f64, diagonal: f64, smallest: f64) -> bool {
    pivot > smallest * diagonal && diagonal > 0.0
}
