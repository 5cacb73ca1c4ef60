//! Two numbers in one 128-bit register.
//!
//! The compiler packs plain arrays only where it finds that profitable, and unpacks them on loads
//! and stores. Written with the processor's instructions, through safe functions, every operation
//! is a single instruction. All of them round as IEEE 754 requires, so that the three
//! implementations below give the same bits.

#[cfg(not(any(
    all(target_arch = "x86_64", target_feature = "sse2"),
    all(target_arch = "wasm32", target_feature = "simd128")
)))]
pub(super) use plain::Register;
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
pub(super) use sse2::Register;
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
pub(super) use wasm::Register;

/// SSE2, which every x86-64 processor has.
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
mod sse2 {
    use safe_arch::*;

    /// Two numbers.
    #[derive(Clone, Copy)]
    pub(crate) struct Register(m128d);

    impl Register {
        #[inline(always)]
        pub(crate) fn new(low: f64, high: f64) -> Self {
            Register(set_m128d(high, low))
        }
        #[inline(always)]
        pub(crate) fn splat(x: f64) -> Self {
            Register(set_splat_m128d(x))
        }
        #[inline(always)]
        pub(crate) fn low(self) -> f64 {
            get_f64_from_m128d_s(self.0)
        }
        #[inline(always)]
        pub(crate) fn high(self) -> f64 {
            get_f64_from_m128d_s(unpack_high_m128d(self.0, self.0))
        }
        #[inline(always)]
        pub(crate) fn lows(self, other: Self) -> Self {
            Register(unpack_low_m128d(self.0, other.0))
        }
        #[inline(always)]
        pub(crate) fn highs(self, other: Self) -> Self {
            Register(unpack_high_m128d(self.0, other.0))
        }
        #[inline(always)]
        pub(crate) fn add(self, other: Self) -> Self {
            Register(add_m128d(self.0, other.0))
        }
        #[inline(always)]
        pub(crate) fn sub(self, other: Self) -> Self {
            Register(sub_m128d(self.0, other.0))
        }
        #[inline(always)]
        pub(crate) fn mul(self, other: Self) -> Self {
            Register(mul_m128d(self.0, other.0))
        }
        #[inline(always)]
        pub(crate) fn div(self, other: Self) -> Self {
            Register(div_m128d(self.0, other.0))
        }
        #[inline(always)]
        pub(crate) fn neg(self) -> Self {
            Register(bitxor_m128d(self.0, set_splat_m128d(-0.0)))
        }
        #[inline(always)]
        pub(crate) fn abs(self) -> Self {
            Register(bitandnot_m128d(set_splat_m128d(-0.0), self.0))
        }
        #[inline(always)]
        pub(crate) fn sqrt(self) -> Self {
            Register(sqrt_m128d(self.0))
        }
        #[inline(always)]
        pub(crate) fn max(self, other: Self) -> Self {
            Register(max_m128d(self.0, other.0))
        }
        #[inline(always)]
        pub(crate) fn min(self, other: Self) -> Self {
            Register(min_m128d(self.0, other.0))
        }
        #[inline(always)]
        pub(crate) fn if_greater(self, bound: Self, yes: Self, no: Self) -> Self {
            let greater = cmp_gt_mask_m128d(self.0, bound.0);
            Register(bitor_m128d(bitand_m128d(greater, yes.0), bitandnot_m128d(greater, no.0)))
        }
        #[inline(always)]
        pub(crate) fn all_greater(self, bound: Self) -> bool {
            move_mask_m128d(cmp_gt_mask_m128d(self.0, bound.0)) == 3
        }
    }
}

/// `simd128`.
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
mod wasm {
    use std::arch::wasm32::*;

    /// Two numbers.
    #[derive(Clone, Copy)]
    pub(crate) struct Register(v128);

    impl Register {
        #[inline(always)]
        pub(crate) fn new(low: f64, high: f64) -> Self {
            Register(f64x2(low, high))
        }
        #[inline(always)]
        pub(crate) fn splat(x: f64) -> Self {
            Register(f64x2_splat(x))
        }
        #[inline(always)]
        pub(crate) fn low(self) -> f64 {
            f64x2_extract_lane::<0>(self.0)
        }
        #[inline(always)]
        pub(crate) fn high(self) -> f64 {
            f64x2_extract_lane::<1>(self.0)
        }
        #[inline(always)]
        pub(crate) fn lows(self, other: Self) -> Self {
            Register(i64x2_shuffle::<0, 2>(self.0, other.0))
        }
        #[inline(always)]
        pub(crate) fn highs(self, other: Self) -> Self {
            Register(i64x2_shuffle::<1, 3>(self.0, other.0))
        }
        #[inline(always)]
        pub(crate) fn add(self, other: Self) -> Self {
            Register(f64x2_add(self.0, other.0))
        }
        #[inline(always)]
        pub(crate) fn sub(self, other: Self) -> Self {
            Register(f64x2_sub(self.0, other.0))
        }
        #[inline(always)]
        pub(crate) fn mul(self, other: Self) -> Self {
            Register(f64x2_mul(self.0, other.0))
        }
        #[inline(always)]
        pub(crate) fn div(self, other: Self) -> Self {
            Register(f64x2_div(self.0, other.0))
        }
        #[inline(always)]
        pub(crate) fn neg(self) -> Self {
            Register(f64x2_neg(self.0))
        }
        #[inline(always)]
        pub(crate) fn abs(self) -> Self {
            Register(f64x2_abs(self.0))
        }
        #[inline(always)]
        pub(crate) fn sqrt(self) -> Self {
            Register(f64x2_sqrt(self.0))
        }
        // The pseudo-maximum of `(a, b)` is `b` if `a < b`, else `a`: one instruction on x86.
        #[inline(always)]
        pub(crate) fn max(self, other: Self) -> Self {
            Register(f64x2_pmax(other.0, self.0))
        }
        #[inline(always)]
        pub(crate) fn min(self, other: Self) -> Self {
            Register(f64x2_pmin(other.0, self.0))
        }
        #[inline(always)]
        pub(crate) fn if_greater(self, bound: Self, yes: Self, no: Self) -> Self {
            Register(v128_bitselect(yes.0, no.0, f64x2_gt(self.0, bound.0)))
        }
        #[inline(always)]
        pub(crate) fn all_greater(self, bound: Self) -> bool {
            i64x2_all_true(f64x2_gt(self.0, bound.0))
        }
    }
}

/// Plain arrays, for other processors.
#[cfg(not(any(
    all(target_arch = "x86_64", target_feature = "sse2"),
    all(target_arch = "wasm32", target_feature = "simd128")
)))]
mod plain {
    /// Two numbers.
    #[derive(Clone, Copy)]
    pub(crate) struct Register([f64; 2]);

    impl Register {
        #[inline(always)]
        fn map(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
            Register([f(self.0[0], other.0[0]), f(self.0[1], other.0[1])])
        }
        #[inline(always)]
        pub(crate) fn new(low: f64, high: f64) -> Self {
            Register([low, high])
        }
        #[inline(always)]
        pub(crate) fn splat(x: f64) -> Self {
            Register([x, x])
        }
        #[inline(always)]
        pub(crate) fn low(self) -> f64 {
            self.0[0]
        }
        #[inline(always)]
        pub(crate) fn high(self) -> f64 {
            self.0[1]
        }
        #[inline(always)]
        pub(crate) fn lows(self, other: Self) -> Self {
            Register([self.0[0], other.0[0]])
        }
        #[inline(always)]
        pub(crate) fn highs(self, other: Self) -> Self {
            Register([self.0[1], other.0[1]])
        }
        #[inline(always)]
        pub(crate) fn add(self, other: Self) -> Self {
            self.map(other, |a, b| a + b)
        }
        #[inline(always)]
        pub(crate) fn sub(self, other: Self) -> Self {
            self.map(other, |a, b| a - b)
        }
        #[inline(always)]
        pub(crate) fn mul(self, other: Self) -> Self {
            self.map(other, |a, b| a * b)
        }
        #[inline(always)]
        pub(crate) fn div(self, other: Self) -> Self {
            self.map(other, |a, b| a / b)
        }
        #[inline(always)]
        pub(crate) fn neg(self) -> Self {
            Register(self.0.map(|a| -a))
        }
        #[inline(always)]
        pub(crate) fn abs(self) -> Self {
            Register(self.0.map(f64::abs))
        }
        #[inline(always)]
        pub(crate) fn sqrt(self) -> Self {
            Register(self.0.map(f64::sqrt))
        }
        #[inline(always)]
        pub(crate) fn max(self, other: Self) -> Self {
            self.map(other, |a, b| if a > b { a } else { b })
        }
        #[inline(always)]
        pub(crate) fn min(self, other: Self) -> Self {
            self.map(other, |a, b| if a < b { a } else { b })
        }
        #[inline(always)]
        pub(crate) fn if_greater(self, bound: Self, yes: Self, no: Self) -> Self {
            let pick = |i: usize| if self.0[i] > bound.0[i] { yes.0[i] } else { no.0[i] };
            Register([pick(0), pick(1)])
        }
        #[inline(always)]
        pub(crate) fn all_greater(self, bound: Self) -> bool {
            self.0[0] > bound.0[0] && self.0[1] > bound.0[1]
        }
    }
}
