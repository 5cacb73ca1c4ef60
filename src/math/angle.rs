//! The angle between two directions, computed with `libm` so that all platforms give the same bits,
//! which their own functions do not.

/// Returns the angle in radians, from 0 to pi, whose cosine and sine are these times the same
/// positive number. The sine must not be negative. Relative error below 3e-16. NaN if both are
/// zero.
pub fn angle(cosine: f64, sine: f64) -> f64 {
    if cosine == 0.0 && sine == 0.0 { f64::NAN } else { libm::atan2(sine, cosine) }
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
                assert!((found - expected).abs() <= 1e-15 * PI, "{expected}: {found}");
            }
        }
        assert_eq!([angle(2.0, 0.0), angle(-2.0, 0.0)], [0.0, PI]);
        assert!(angle(0.0, 0.0).is_nan());
    }
}
