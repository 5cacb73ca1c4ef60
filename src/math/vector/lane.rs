//! One scalar, or the same scalar of several constraints side by side.
//!
//! An operator is written once over [`Lane`]. With `f64` it treats one constraint, with [`Lanes`]
//! several; plain arrays compile to `simd128` in wasm and to SSE2
//! natively, so no intrinsics are needed. Only operations that IEEE 754 rounds exactly are
//! offered, so that both give the same bits.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// How many constraints a batch treats at a time. One register holds two; two registers side by
/// side hide the latency of division and square root.
pub const LANES: usize = 4;

/// Two things side by side in one 128-bit register.
pub type Pair = Lanes<2>;

/// A scalar (`f64`) or one scalar for each of several constraints ([`Lanes`]).
pub trait Lane:
    Copy
    + std::fmt::Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
{
    /// How many constraints it holds.
    const WIDTH: usize;
    /// The same value in every lane.
    fn splat(x: f64) -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// The greater of the two; `other` where `self` is NaN.
    fn max(self, other: Self) -> Self;
    /// The smaller of the two; `other` where `self` is NaN.
    fn min(self, other: Self) -> Self;
    /// Lane by lane: `yes` where `self > bound`, else `no`.
    fn if_greater(self, bound: Self, yes: Self, no: Self) -> Self;
    /// Whether every lane is greater than that of `bound`; false where one is NaN.
    fn all_greater(self, bound: Self) -> bool;
    /// The value of lane `i`.
    fn lane(self, i: usize) -> f64;
    /// Replaces the value of lane `i`.
    fn set_lane(&mut self, i: usize, x: f64);
    /// Zero in every lane.
    fn zero() -> Self {
        Self::splat(0.0)
    }
    /// One in every lane.
    fn one() -> Self {
        Self::splat(1.0)
    }
}

impl Lane for f64 {
    const WIDTH: usize = 1;
    #[inline(always)]
    fn splat(x: f64) -> Self {
        x
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        f64::abs(self)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }
    #[inline(always)]
    fn if_greater(self, bound: Self, yes: Self, no: Self) -> Self {
        if self > bound { yes } else { no }
    }
    #[inline(always)]
    fn all_greater(self, bound: Self) -> bool {
        self > bound
    }
    #[inline(always)]
    fn lane(self, _: usize) -> f64 {
        self
    }
    #[inline(always)]
    fn set_lane(&mut self, _: usize, x: f64) {
        *self = x;
    }
}

/// The same scalar of `N` constraints.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(16))]
pub struct Lanes<const N: usize = LANES>(pub [f64; N]);

impl<const N: usize> Lanes<N> {
    #[inline(always)]
    fn map2(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Lanes(std::array::from_fn(|i| f(self.0[i], other.0[i])))
    }
}

macro_rules! lane_by_lane {
    ($($op:ident $method:ident),*) => {$(
        impl<const N: usize> $op for Lanes<N> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.map2(other, |a, b| a.$method(b))
            }
        }
    )*};
}
lane_by_lane!(Add add, Sub sub, Mul mul, Div div);

impl<const N: usize> Neg for Lanes<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Lanes(self.0.map(|a| -a))
    }
}

impl<const N: usize> AddAssign for Lanes<N> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<const N: usize> SubAssign for Lanes<N> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl<const N: usize> Lane for Lanes<N> {
    const WIDTH: usize = N;
    #[inline(always)]
    fn splat(x: f64) -> Self {
        Lanes([x; N])
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Lanes(self.0.map(f64::sqrt))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Lanes(self.0.map(f64::abs))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.map2(other, Lane::max)
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.map2(other, Lane::min)
    }
    #[inline(always)]
    fn if_greater(self, bound: Self, yes: Self, no: Self) -> Self {
        Lanes(std::array::from_fn(|i| if self.0[i] > bound.0[i] { yes.0[i] } else { no.0[i] }))
    }
    #[inline(always)]
    fn all_greater(self, bound: Self) -> bool {
        (0..N).all(|i| self.0[i] > bound.0[i])
    }
    #[inline(always)]
    fn lane(self, i: usize) -> f64 {
        self.0[i]
    }
    #[inline(always)]
    fn set_lane(&mut self, i: usize, x: f64) {
        self.0[i] = x;
    }
}
