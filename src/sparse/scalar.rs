//! The two precisions in which a factor is stored and swept.

use std::ops::{Mul, Sub};

/// `f32` or `f64`.
pub(crate) trait Scalar: Copy + Mul<Output = Self> + Sub<Output = Self> {
    /// Zero.
    const ZERO: Self;
    /// Columns of a panel at most: so many that the rows of `x` which a sweep keeps, one or two
    /// registers each, stay in the sixteen vector registers that V8 uses.
    const PANEL_WIDTH: usize;
    /// Whether backward sweeps go through a panel from its last row. They take the panels from last to first, so
    /// that the values are then read in one direction throughout, which processors foresee. Factors in single
    /// precision are the large ones, which caches do not hold.
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
    /// Values that are nothing beside one become zero: their products would be denormal numbers,
    /// with which processors take a hundred times longer.
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
