//! Round numbers for scales and grids: one, two or five times a power of ten.

/// Returns the largest round number up to `most`; zero unless `most` is positive and finite.
pub fn round_down(most: f64) -> f64 {
    if !(most > 0.0 && most.is_finite()) {
        return 0.0;
    }
    let exponent = most.log10().floor();
    // A parsed literal is the nearest number: 0.005, not 5 times an inexact 0.001.
    let times_power = |digit: u32, exponent: f64| {
        let text = format!("{digit}e{exponent}");
        text.parse::<f64>().expect("a digit with a whole exponent is a number")
    };
    [(5, exponent), (2, exponent), (1, exponent), (5, exponent - 1.0)]
        .into_iter()
        .map(|(digit, exponent)| times_power(digit, exponent))
        .find(|&round| round <= most)
        .unwrap_or(0.0)
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
}
