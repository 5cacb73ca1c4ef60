//! The corners of regular polygons with `n` corners on the unit circle, `cos` and `sin` of
//! `2 pi k / n`: within one ulp for up to 500 corners, and within an ulp of one for any number.
//!
//! The platform's `cos` and `sin` may differ between native and wasm. Here the angle is folded into
//! the first octant by exact integer arithmetic, and the Taylor series is summed in fixed-point
//! numbers, so that only the last conversion rounds.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::ops::Deref;
use std::rc::Rc;

/// Polygons with up to this many corners are in a compile-time table; the others are computed on
/// first use and cached.
const IN_TABLE: usize = 8;

static TABLE: [[[f64; 2]; IN_TABLE]; IN_TABLE + 1] = {
    let mut table = [[[0.0; 2]; IN_TABLE]; IN_TABLE + 1];
    let mut n = 1;
    while n <= IN_TABLE {
        let mut k = 0;
        while k < n {
            table[n][k] = corner(k, n);
            k += 1;
        }
        n += 1;
    }
    table
};

thread_local! {
    static KEPT: RefCell<BTreeMap<usize, Rc<[[f64; 2]]>>> = const { RefCell::new(BTreeMap::new()) };
}

/// The `n` corners in order, the first at (1, 0).
#[derive(Clone, Debug)]
pub enum UnitPolygon {
    /// From the table.
    Few(&'static [[f64; 2]]),
    /// Computed in this thread.
    Many(Rc<[[f64; 2]]>),
}

impl UnitPolygon {
    /// The polygon with `n` corners, `n` at least one.
    #[inline(always)]
    pub fn new(n: usize) -> Self {
        if n <= IN_TABLE { UnitPolygon::Few(&TABLE[n][..n]) } else { UnitPolygon::many(n) }
    }

    #[inline(never)]
    fn many(n: usize) -> Self {
        KEPT.with_borrow_mut(|kept| {
            let made = kept.entry(n).or_insert_with(|| (0..n).map(|k| corner(k, n)).collect());
            UnitPolygon::Many(made.clone())
        })
    }
}

impl Deref for UnitPolygon {
    type Target = [[f64; 2]];
    #[inline(always)]
    fn deref(&self) -> &[[f64; 2]] {
        match self {
            UnitPolygon::Few(corners) => corners,
            UnitPolygon::Many(corners) => corners,
        }
    }
}

/// `[cos, sin]` of `2 pi k / n`.
const fn corner(k: usize, n: usize) -> [f64; 2] {
    let octant = 8 * k / n;
    let past = 8 * k - octant * n;
    let folded = if octant % 2 == 1 { n - past } else { past };
    let [c, s] = cosine_and_sine(folded as u128, n as u128);
    match octant {
        0 => [c, s],
        1 => [s, c],
        2 => [-s, c],
        3 => [-c, s],
        4 => [-c, -s],
        5 => [-s, -c],
        6 => [s, -c],
        _ => [c, -s],
    }
}

/// `pi / 4` in units of 2^-64.
const QUARTER_PI: u128 = 0xC90F_DAA2_2168_C235;

/// Number of terms: the first one omitted is below 2^-64 for angles up to `pi / 4`.
const TERMS: u128 = 10;

/// `[cos, sin]` of `pi / 4` times `part / of`, where `part` is at most `of`: the series
/// `1 - x^2/2 (1 - x^2/12 (1 - ...))` and `x (1 - x^2/6 (1 - x^2/20 (1 - ...)))`.
const fn cosine_and_sine(part: u128, of: u128) -> [f64; 2] {
    const ONE: u128 = 1 << 64;
    let angle = QUARTER_PI * part / of;
    let square = (angle * angle) >> 64;
    let (mut cosine, mut sine_over_angle) = (ONE, ONE);
    let mut i = 2 * TERMS;
    while i > 0 {
        cosine = ONE - ((square * cosine) >> 64) / (i * (i - 1));
        sine_over_angle = ONE - ((square * sine_over_angle) >> 64) / (i * (i + 1));
        i -= 2;
    }
    let one = ONE as f64;
    [cosine as f64 / one, (angle * sine_over_angle) as f64 / one / one]
}

#[cfg(test)]
mod tests {
    use super::UnitPolygon;

    #[test]
    #[expect(clippy::disallowed_methods, reason = "the platform is what to agree with")]
    fn corners_agree_with_the_platform() {
        for n in (1..=400).chain([500, 1001, 4096, 9973]) {
            let polygon = UnitPolygon::new(n);
            assert_eq!(polygon.len(), n);
            for (k, [c, s]) in polygon.iter().enumerate() {
                // The platform's angle is rounded, which costs up to an ulp of the result even
                // after folding into the first octant.
                let (k8, turn) = (8 * k, std::f64::consts::TAU);
                let angle = |past: usize| turn * (past as f64 / (8 * n) as f64);
                let (cosine, sine) = match k8 / n {
                    0 => (angle(k8).cos(), angle(k8).sin()),
                    1 => (angle(2 * n - k8).sin(), angle(2 * n - k8).cos()),
                    2 => (-angle(k8 - 2 * n).sin(), angle(k8 - 2 * n).cos()),
                    3 => (-angle(4 * n - k8).cos(), angle(4 * n - k8).sin()),
                    4 => (-angle(k8 - 4 * n).cos(), -angle(k8 - 4 * n).sin()),
                    5 => (-angle(6 * n - k8).sin(), -angle(6 * n - k8).cos()),
                    6 => (angle(k8 - 6 * n).sin(), -angle(k8 - 6 * n).cos()),
                    _ => (angle(8 * n - k8).cos(), -angle(8 * n - k8).sin()),
                };
                for (found, expected) in [(*c, cosine), (*s, sine)] {
                    let size = if n <= 500 { expected.abs() } else { 1.0 };
                    let ulps = (found - expected).abs() / (f64::EPSILON * size);
                    assert!(found == expected || ulps <= 2.0, "{k} of {n}: {found:e}, {ulps} ulp");
                }
            }
        }
    }

    #[test]
    fn right_angles_are_exact() {
        let square = UnitPolygon::new(4);
        assert_eq!(*square, [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]]);
        assert_eq!(UnitPolygon::new(400)[300], [0.0, -1.0]);
    }
}
