//! The types of matrices and right-hand sides, the criterion for positive pivots, and the two
//! precisions in which a factor is stored and swept.

use sprs::CsMatI;
use std::ops::{Mul, Sub};

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
#[inline]
pub(crate) fn is_positive(pivot: f64, diagonal: f64, smallest: f64) -> bool {
    pivot > smallest * diagonal && diagonal > 0.0
}

/// `f32` or `f64`.
pub(crate) trait Scalar: Copy + Mul<Output = Self> + Sub<Output = Self> {
    /// Zero.
    const ZERO: Self;
    /// Greatest number of columns of a panel, such that the rows of `x` kept by a sweep, one or two
    /// registers each, fit the sixteen vector registers that V8 uses.
    const PANEL_WIDTH: usize;
    /// Whether backward sweeps read a panel from its last row. Since they visit the panels from
    /// last to first, the values are then read in one direction throughout, which processors
    /// prefetch. Factors in single precision are the large ones, which do not fit into caches.
    const FROM_LAST_ROW: bool;
    /// The nearest value of this precision.
    fn rounded(x: f64) -> Self;
    /// The same value in double precision.
    fn wide(self) -> f64;
}

impl Scalar for f32 {
    const ZERO: f32 = 0.0;
    const PANEL_WIDTH: usize = 6;
    const FROM_LAST_ROW: bool = true;
    /// Values negligible beside one become zero: their products would be denormal numbers, with
    /// which processors are a hundred times slower.
    #[inline(always)]
    fn rounded(x: f64) -> f32 {
        const NOTHING: f64 = 1e-18;
        if x.abs() < NOTHING { 0.0 } else { x as f32 }
    }
    #[inline(always)]
    fn wide(self) -> f64 {
        f64::from(self)
    }
}

impl Scalar for f64 {
    const ZERO: f64 = 0.0;
    const PANEL_WIDTH: usize = 4;
    const FROM_LAST_ROW: bool = false;
    #[inline(always)]
    fn rounded(x: f64) -> f64 {
        x
    }
    #[inline(always)]
    fn wide(self) -> f64 {
        self
    }
}
