//! Angles, sines and cosines, and round numbers. All platforms give the same bits, which their own
//! functions do not: these use `libm`, and `+ - * / sqrt`, which round correctly.

use crate::math::Vec3;

/// Returns the angle in radians, from 0 to pi, whose cosine and sine are these times the same
/// positive number. The sine must not be negative. Relative error below 3e-16. None if both are
/// zero, as between vectors of which one is zero.
pub fn angle(cosine: f64, sine: f64) -> Option<f64> {
    (cosine != 0.0 || sine != 0.0).then(|| libm::atan2(sine, cosine))
}

/// Returns the angle between two directions in radians, from 0 to pi; none if one is zero.
pub fn angle_between(a: Vec3<f64>, b: Vec3<f64>) -> Option<f64> {
    angle(a.dot(b), a.cross(b).length())
}

/// The sine of an angle in turns, accurate to 1e-15.
pub fn sine(turns: f64) -> f64 {
    // Reduced to -1/2..1/2 turns, then mirrored into -1/4..1/4.
    let turns = turns - (turns + 0.5).floor();
    let turns = match turns {
        t if t > 0.25 => 0.5 - t,
        t if t < -0.25 => -0.5 - t,
        t => t,
    };
    libm::sin(turns * std::f64::consts::TAU)
}

/// The cosine of an angle in turns.
pub fn cosine(turns: f64) -> f64 {
    sine(turns + 0.25)
}

/// Cosine and sine of an angle in degrees, accurate to 1e-15, and exact at their zeros.
pub fn cosine_and_sine_of_degrees(degrees: f64) -> [f64; 2] {
    [sine((90.0 - degrees) / 360.0), sine(degrees / 360.0)]
}

/// The factors of a power of ten at the ends of ranges, in tenths.
const ENDS: [u32; 9] = [10, 15, 20, 30, 40, 50, 60, 80, 100];

/// Returns the largest number up to `most` that is one, two or five times a power of ten; zero unless
/// `most` is positive and finite.
pub fn round_down(most: f64) -> f64 {
    let powers = powers_below(most, &[50, 20, 10]);
    powers.and_then(|mut powers| powers.find(|&round| round <= most)).unwrap_or(0.0)
}

/// Returns the next round number from `least` on, for the end of a range, which then changes seldom;
/// zero unless `least` is positive and finite.
pub fn round_up(least: f64) -> f64 {
    // A number that was computed may be slightly more than the round one that is meant.
    let is_enough = |&round: &f64| round >= least * (1.0 - 1e-9);
    powers_below(least, &ENDS).and_then(|mut powers| powers.find(is_enough)).unwrap_or(0.0)
}

/// Returns the nearest of one, two and five times a power of ten; none unless `number` is positive and
/// finite.
pub fn nearest_round(number: f64) -> Option<f64> {
    let mut bounds = powers_below(number, &[15, 35, 75])?;
    // The bounds are compared as decimal numbers too: 0.0015 is rounded up.
    powers_below(number, &[10, 20, 50, 100])?
        .find(|_| bounds.next().is_none_or(|bound| number < bound))
}

/// Returns the step of a grid with about `count` steps over a length: the smallest of 1, 2 or 5 times
/// a power of ten with no more steps; zero unless the length is positive and finite.
pub fn grid_step(length: f64, count: f64) -> f64 {
    let powers = powers_below(length / count, &[10, 20, 50, 100]);
    powers.and_then(|mut powers| powers.find(|&step| step * count >= length)).unwrap_or(0.0)
}

/// The power of ten below a number, times each of these tenths; none unless the number is positive and
/// finite.
fn powers_below(number: f64, tenths: &[u32]) -> Option<impl Iterator<Item = f64>> {
    let text = format!("{number:e}");
    let exponent: i32 = text.split_once('e')?.1.parse().ok().filter(|_| number > 0.0)?;
    // A parsed literal is the nearest number: 0.005, not 5 times an inexact 0.001.
    let times = move |tenths: &u32| format!("{tenths}e{}", exponent - 1).parse().ok();
    Some(tenths.iter().filter_map(times))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    #[expect(clippy::disallowed_methods, reason = "the platform is what is compared with")]
    fn agrees_with_the_platform_at_every_length() {
        for k in 0..=1800 {
            let expected = f64::from(k) / 1800.0 * PI;
            for length in [1e-100, 1.0, 3e50] {
                let found = angle(length * expected.cos(), length * expected.sin());
                let found = found.expect("they are not both zero");
                assert!((found - expected).abs() <= 1e-15 * PI, "{expected}: {found}");
            }
        }
        assert_eq!(
            [angle(2.0, 0.0), angle(-2.0, 0.0), angle(0.0, 0.0)],
            [Some(0.0), Some(PI), None]
        );
    }

    #[test]
    #[expect(clippy::disallowed_methods, reason = "the platform is what is compared with")]
    fn degrees_agree_with_the_platform() {
        for k in -1800..=3600 {
            let degrees = f64::from(k) / 10.0;
            let [c, s] = cosine_and_sine_of_degrees(degrees);
            let radians = degrees.to_radians();
            // Radians beyond half a turn are themselves rounded by more.
            let tolerance = if degrees <= 180.0 { 1e-15 } else { 2e-15 };
            assert!((c - radians.cos()).abs() <= tolerance, "cosine of {degrees}");
            assert!((s - radians.sin()).abs() <= tolerance, "sine of {degrees}");
        }
        for k in 0..4 {
            let [c, s] = cosine_and_sine_of_degrees(f64::from(90 * k));
            assert_eq!(if k % 2 == 0 { s } else { c }, 0.0, "{k} quarters");
        }
    }

    #[test]
    fn sine_and_cosine_lie_on_the_unit_circle_and_add_up() {
        for k in -300..300 {
            let (a, b) = (f64::from(k) / 97.0, f64::from(k) / 41.0 + 0.1);
            let unit = sine(a) * sine(a) + cosine(a) * cosine(a);
            assert!((unit - 1.0).abs() < 1e-12, "{a}: {unit}");
            let sum = sine(a) * cosine(b) + cosine(a) * sine(b);
            assert!((sine(a + b) - sum).abs() < 2e-12, "{a} + {b}");
        }
        assert!((sine(1.0 / 12.0) - 0.5).abs() < 1e-15);
        assert_eq!((sine(0.0), sine(0.25)), (0.0, cosine(0.0)));
    }

    #[test]
    fn round_numbers_are_one_two_and_five_of_any_size() {
        for (most, round) in [
            (1.0, 1.0),
            (1.99, 1.0),
            (2.0, 2.0),
            (4.7, 2.0),
            (5.0, 5.0),
            (9.999, 5.0),
            (0.0069, 0.005),
            (0.001, 0.001),
            (12_345.0, 10_000.0),
            (3e-9, 2e-9),
        ] {
            assert_eq!(round_down(most), round, "{most}");
        }
        for nothing in [0.0, -3.0, f64::NAN, f64::INFINITY] {
            assert_eq!(round_down(nothing), 0.0);
        }
    }

    #[test]
    fn the_nearest_round_number_may_be_above_or_below() {
        for (number, round) in [
            (0.0013, 0.001),
            (0.0015, 0.002),
            (0.0017, 0.002),
            (4.9, 5.0),
            (0.08, 0.1),
            (730.0, 500.0),
            (2.2e-7, 2e-7),
        ] {
            assert_eq!(nearest_round(number), Some(round));
        }
        for nothing in [0.0, -3.0, f64::NAN, f64::INFINITY] {
            assert_eq!(nearest_round(nothing), None);
        }
    }

    #[test]
    fn ends_are_rounded_up() {
        for (least, round) in
            [(0.9, 1.0), (1.2, 1.5), (7.3, 8.0), (10.0, 10.0), (1e-300, 1e-300), (0.1 + 0.2, 0.3)]
        {
            assert_eq!(round_up(least), round, "{least}");
        }
        for nothing in [0.0, f64::NAN, f64::INFINITY] {
            assert_eq!(round_up(nothing), 0.0);
        }
    }

    #[test]
    fn grid_steps_are_one_two_or_five_times_a_power_of_ten() {
        let steps = [24.0, 25.0, 100.0, 30_000.0].map(|length| grid_step(length, 24.0));
        assert_eq!(steps, [1.0, 2.0, 5.0, 2000.0]);
        assert_eq!(grid_step(0.0, 24.0), 0.0);
    }
}
