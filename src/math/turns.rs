//! Sine and cosine of an angle in turns, from `+ - * /` alone, so that all platforms give the same
//! bits. `libm` would do so too, but takes 2 kB (compressed) for tables that reduce angles of any
//! size, which are not needed here.

/// The sine of an angle in turns: a Taylor polynomial over a quarter turn, accurate to 1e-15.
pub fn sine(turns: f64) -> f64 {
    // Reduced to -1/2..1/2 turns, then mirrored into -1/4..1/4.
    let turns = turns - (turns + 0.5).floor();
    let turns = match turns {
        t if t > 0.25 => 0.5 - t,
        t if t < -0.25 => -0.5 - t,
        t => t,
    };
    let x = turns * std::f64::consts::TAU;
    // Horner's scheme on 1 - x^2/(2*3) (1 - x^2/(4*5) (1 - ...)).
    let polynomial = (1..=9).rev().fold(1.0, |sum, k| {
        let k = f64::from(2 * k);
        1.0 - x * x / (k * (k + 1.0)) * sum
    });
    x * polynomial
}

/// The cosine of an angle in turns.
pub fn cosine(turns: f64) -> f64 {
    sine(turns + 0.25)
}

/// Cosine and sine of an angle in degrees, accurate to 1e-15, and exact at their zeros.
pub fn cosine_and_sine_of_degrees(degrees: f64) -> [f64; 2] {
    [sine((90.0 - degrees) / 360.0), sine(degrees / 360.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

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
}
