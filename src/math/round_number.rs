//! Round numbers for scales, grids and the ends of ranges.

/// The factors of a power of ten for the end of a range, in tenths.
const ENDS: [u32; 9] = [10, 15, 20, 30, 40, 50, 60, 80, 100];

/// Returns the largest number up to `most` that is one, two or five times a power of ten; zero unless
/// `most` is positive and finite.
pub fn round_down(most: f64) -> f64 {
    let Some(exponent) = exponent(most) else { return 0.0 };
    [(5, exponent), (2, exponent), (1, exponent), (5, exponent - 1.0)]
        .into_iter()
        .map(|(digit, exponent)| times_power(digit, exponent))
        .find(|&round| round <= most)
        .unwrap_or(0.0)
}

/// Returns the next round number from `least` on, for the end of a range, which then changes seldom;
/// zero unless `least` is positive and finite.
pub fn round_up(least: f64) -> f64 {
    next(least, &ENDS)
}

/// Returns the step of a grid with about `count` steps over a length: the smallest of 1, 2 or 5 times
/// a power of ten with no more steps; zero unless the length is positive and finite.
pub fn grid_step(length: f64, count: f64) -> f64 {
    next(length / count, &[10, 20, 50, 100])
}

/// The smallest of these factors, in tenths, of the power of ten below a number that is not less.
fn next(least: f64, tenths: &[u32]) -> f64 {
    let Some(exponent) = exponent(least) else { return 0.0 };
    let rounded = |&tenths: &u32| times_power(tenths, exponent - 1.0);
    // A number that was computed may be slightly more than the round one that is meant.
    let found = tenths.iter().map(rounded).find(|&round| round >= least * (1.0 - 1e-9));
    // The logarithm may have been rounded down.
    found.unwrap_or_else(|| rounded(&100))
}

/// The exponent of the power of ten below a number; none unless it is positive and finite.
fn exponent(number: f64) -> Option<f64> {
    (number > 0.0 && number.is_finite()).then(|| number.log10().floor())
}

/// A parsed literal is the nearest number: 0.005, not 5 times an inexact 0.001.
fn times_power(factor: u32, exponent: f64) -> f64 {
    let text = format!("{factor}e{exponent}");
    text.parse::<f64>().expect("digits with a whole exponent are a number")
}

#[cfg(test)]
mod tests {
    use super::*;

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
