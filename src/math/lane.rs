//! One scalar, or the same scalar of several constraints side by side.
//!
//! An operator is written once over [`Lane`]. With `f64` it treats one constraint, with [`Lanes`]
//! several. Only operations that IEEE 754 rounds exactly are offered, so that both give the same
//! bits, in wasm and natively.

use super::register::Register;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// Number of constraints that a batch projects at a time. One register stores two; two registers
/// side by side hide the latency of division and square root.
pub const LANES: usize = 4;

/// Two scalars in one 128-bit register.
pub type Pair = Lanes<1>;

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
    /// Number of lanes.
    const WIDTH: usize;
    /// The same value in every lane.
    fn splat(x: f64) -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// The greater of the two; `other` if `self` is NaN.
    fn max(self, other: Self) -> Self;
    /// The smaller of the two; `other` if `self` is NaN.
    fn min(self, other: Self) -> Self;
    /// Lane by lane: `yes` where `self > bound`, else `no`.
    fn if_greater(self, bound: Self, yes: Self, no: Self) -> Self;
    /// Whether every lane is greater than that of `bound`; false if any is NaN.
    fn all_greater(self, bound: Self) -> bool;
    /// The value of lane `i`.
    fn lane(self, i: usize) -> f64;
    /// Replaces the value of lane `i`.
    fn set_lane(&mut self, i: usize, x: f64);
    /// Zero in every lane.
    #[inline(always)]
    fn zero() -> Self {
        Self::splat(0.0)
    }
    /// One in every lane.
    #[inline(always)]
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

/// The same scalar of `2 * P` constraints, in `P` registers.
#[derive(Clone, Copy)]
#[repr(C, align(16))]
pub struct Lanes<const P: usize = { LANES / 2 }>(pub(super) [Register; P]);

impl<const P: usize> Lanes<P> {
    /// Returns lanes with the values `value(lane)`.
    #[inline(always)]
    pub fn from_fn(value: impl Fn(usize) -> f64) -> Self {
        // A loop, because `array::from_fn` may not be inlined.
        let mut lanes = [Register::new(0.0, 0.0); P];
        for (k, register) in lanes.iter_mut().enumerate() {
            *register = Register::new(value(2 * k), value(2 * k + 1));
        }
        Lanes(lanes)
    }

    // Loops, because `array::map` and the like may not be inlined.
    #[inline(always)]
    fn map(mut self, f: impl Fn(Register) -> Register) -> Self {
        for register in &mut self.0 {
            *register = f(*register);
        }
        self
    }

    #[inline(always)]
    fn map2(mut self, other: Self, f: impl Fn(Register, Register) -> Register) -> Self {
        for k in 0..P {
            self.0[k] = f(self.0[k], other.0[k]);
        }
        self
    }
}

impl<const P: usize> std::fmt::Debug for Lanes<P> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_list().entries((0..Self::WIDTH).map(|i| self.lane(i))).finish()
    }
}

impl<const P: usize> PartialEq for Lanes<P> {
    fn eq(&self, other: &Self) -> bool {
        (0..Self::WIDTH).all(|i| self.lane(i) == other.lane(i))
    }
}

macro_rules! register_by_register {
    ($($op:ident $method:ident),*) => {$(
        impl<const P: usize> $op for Lanes<P> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.map2(other, Register::$method)
            }
        }
    )*};
}
register_by_register!(Add add, Sub sub, Mul mul, Div div);

impl<const P: usize> Neg for Lanes<P> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(Register::neg)
    }
}

impl<const P: usize> AddAssign for Lanes<P> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<const P: usize> SubAssign for Lanes<P> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl<const P: usize> Lane for Lanes<P> {
    const WIDTH: usize = 2 * P;
    #[inline(always)]
    fn splat(x: f64) -> Self {
        Lanes([Register::splat(x); P])
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        self.map(Register::sqrt)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.map(Register::abs)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.map2(other, Register::max)
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.map2(other, Register::min)
    }
    #[inline(always)]
    fn if_greater(mut self, bound: Self, yes: Self, no: Self) -> Self {
        for k in 0..P {
            self.0[k] = self.0[k].if_greater(bound.0[k], yes.0[k], no.0[k]);
        }
        self
    }
    #[inline(always)]
    fn all_greater(self, bound: Self) -> bool {
        (0..P).all(|k| self.0[k].all_greater(bound.0[k]))
    }
    #[inline(always)]
    fn lane(self, i: usize) -> f64 {
        let register = self.0[i / 2];
        if i.is_multiple_of(2) { register.low() } else { register.high() }
    }
    #[inline(always)]
    fn set_lane(&mut self, i: usize, x: f64) {
        let register = &mut self.0[i / 2];
        *register = if i.is_multiple_of(2) {
            Register::new(x, register.high())
        } else {
            Register::new(register.low(), x)
        };
    }
}

#[cfg(test)]
mod tests {
    use super::{Lane, Lanes, Pair};

    const NUMBERS: [f64; 10] =
        [0.0, -0.0, 1.0, -2.5, 1e-310, 3e200, -7e-200, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];

    /// Checks that `lanes` gives in each lane what `one` gives for a number alone, whatever the
    /// other lanes contain.
    fn same<L: Lane>(lanes: impl Fn(L, L) -> L, one: impl Fn(f64, f64) -> f64) {
        for i in 0..NUMBERS.len() {
            for shift in 0..NUMBERS.len() {
                let (mut a, mut b) = (L::zero(), L::zero());
                let number = |k: usize| NUMBERS[k % NUMBERS.len()];
                for lane in 0..L::WIDTH {
                    a.set_lane(lane, number(i + lane));
                    b.set_lane(lane, number(i + lane + shift));
                }
                let found = lanes(a, b);
                for lane in 0..L::WIDTH {
                    let (a, b) = (number(i + lane), number(i + lane + shift));
                    let (found, expected) = (found.lane(lane), one(a, b));
                    let both_nan = found.is_nan() && expected.is_nan();
                    assert!(both_nan || found.to_bits() == expected.to_bits(), "{a}, {b}: {found}");
                }
            }
        }
    }

    fn all<L: Lane>() {
        same::<L>(|a, b| a + b, |a, b| a + b);
        same::<L>(|a, b| a - b, |a, b| a - b);
        same::<L>(|a, b| a * b, |a, b| a * b);
        same::<L>(|a, b| a / b, |a, b| a / b);
        same::<L>(|a, _| -a, |a, _| -a);
        same::<L>(|a, _| a.abs(), |a, _| a.abs());
        same::<L>(|a, _| a.sqrt(), |a, _| a.sqrt());
        same::<L>(L::max, <f64 as Lane>::max);
        same::<L>(L::min, <f64 as Lane>::min);
        same::<L>(|a, b| a.if_greater(b, L::one(), a), |a, b| if a > b { 1.0 } else { a });
        for (k, x) in NUMBERS.into_iter().enumerate() {
            let mut one_is_not = L::splat(4e200);
            one_is_not.set_lane(k % L::WIDTH, x);
            assert_eq!(one_is_not.all_greater(L::splat(3e200)), x == f64::INFINITY, "{x}");
        }
    }

    #[test]
    fn every_lane_gets_the_bits_of_a_number_alone() {
        all::<f64>();
        all::<Pair>();
        all::<Lanes>();
    }
}
