//! The angle between two directions, from `+ - * / sqrt` alone, so that every machine makes the same
//! bits.

use std::f64::consts::PI;

/// How often the angle is halved before its tangent is small enough for the series.
const HALVINGS: u32 = 4;

/// The angle in radians, from 0 to pi, of which these are the cosine and the sine, each times the same
/// positive number; the sine is not negative. Good to 1e-15. NaN where both are zero.
pub fn angle(cosine: f64, sine: f64) -> f64 {
    if cosine < 0.0 {
        // Halving adds the cosine to the length: here digits would cancel.
        return PI - angle(-cosine, sine);
    }
    let (mut c, mut s) = (cosine, sine);
    for _ in 0..HALVINGS {
        let length = (c * c + s * s).sqrt();
        (c, s) = ((c + length) / length, s / length);
    }
    let x = s / c;
    // The series of the arc tangent, x - x^3/3 + x^5/5 - ..., by Horner's scheme.
    let series = (0..12).rev().fold(0.0, |sum, k| 1.0 / f64::from(2 * k + 1) - x * x * sum);
    f64::from(1 << HALVINGS) * x * series
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[expect(clippy::disallowed_methods, reason = "the platform is what is compared with")]
    fn agrees_with_the_platform_at_every_length() {
        for k in 0..=1800 {
            let expected = f64::from(k) / 1800.0 * PI;
            for length in [1e-100, 1.0, 3e50] {
                let found = angle(length * expected.cos(), length * expected.sin());
                assert!((found - expected).abs() <= 1e-15 * PI, "{expected}: {found}");
            }
        }
        assert_eq!([angle(2.0, 0.0), angle(-2.0, 0.0)], [0.0, PI]);
        assert!(angle(0.0, 0.0).is_nan());
    }
}
