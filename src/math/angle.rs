//! Cosine and sine of an angle in degrees, the same on every machine: native and wasm take theirs
//! from different libraries.

/// The cosine and the sine of a finite angle in degrees, to within an ulp of one. Multiples of 90
/// degrees are exact.
pub fn cosine_and_sine(degrees: f64) -> (f64, f64) {
    // The remainder, and the differences below, are exact.
    let turned = degrees.abs() % 360.0;
    let octant = (turned / 45.0).floor();
    let past = turned - 45.0 * octant;
    let is_odd = octant % 2.0 == 1.0;
    let x = (if is_odd { 45.0 - past } else { past }) * (std::f64::consts::PI / 180.0);
    // Horner's scheme on 1 - x^2/(1*2) (1 - x^2/(3*4) (...)) and x (1 - x^2/(2*3) (1 - ...)).
    let (mut cosine, mut sine) = (1.0, 1.0);
    for k in (1..=TERMS).rev() {
        let k = f64::from(2 * k);
        cosine = 1.0 - x * x / ((k - 1.0) * k) * cosine;
        sine = 1.0 - x * x / (k * (k + 1.0)) * sine;
    }
    sine *= x;
    let (cosine, sine) = match octant as u32 {
        0 => (cosine, sine),
        1 => (sine, cosine),
        2 => (-sine, cosine),
        3 => (-cosine, sine),
        4 => (-cosine, -sine),
        5 => (-sine, -cosine),
        6 => (sine, -cosine),
        _ => (cosine, -sine),
    };
    (cosine + 0.0, if degrees < 0.0 { 0.0 - sine } else { sine + 0.0 })
}

/// The first term left out is below 1e-17 up to 45 degrees.
const TERMS: u32 = 8;

#[cfg(test)]
mod tests {
    use super::cosine_and_sine;

    #[test]
    #[expect(clippy::disallowed_methods, reason = "the platform is what to agree with")]
    fn agrees_with_the_platform() {
        for k in -4000..4000 {
            let degrees = f64::from(k) * 0.173;
            let (cosine, sine) = cosine_and_sine(degrees);
            // Beyond a turn the platform's angle in radians has fewer digits.
            let radians = (degrees % 360.0).to_radians();
            assert!((cosine - radians.cos()).abs() <= 1e-15, "cosine of {degrees}: {cosine}");
            assert!((sine - radians.sin()).abs() <= 1e-15, "sine of {degrees}: {sine}");
        }
    }

    #[test]
    fn right_angles_are_exact() {
        for (degrees, expected) in [
            (0.0, (1.0, 0.0)),
            (90.0, (0.0, 1.0)),
            (180.0, (-1.0, 0.0)),
            (270.0, (0.0, -1.0)),
            (-90.0, (0.0, -1.0)),
            (720.0, (1.0, 0.0)),
        ] {
            assert_eq!(cosine_and_sine(degrees), expected, "{degrees}");
        }
        assert!((cosine_and_sine(60.0).0 - 0.5).abs() <= 1e-16);
    }
}
