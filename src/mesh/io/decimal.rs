//! Formatting numbers as text that reads back to the same bits.

use std::fmt;

/// Displays the shortest decimal that reads back to the same bits: plain from 1e-5 to below 1e16,
/// else with an exponent, to avoid long runs of zeros.
#[derive(Clone, Copy)]
pub struct Decimal(pub f64);

impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Decimal(x) = *self;
        match x == 0.0 || (1e-5..1e16).contains(&x.abs()) {
            true => write!(f, "{x}"),
            false => write!(f, "{x:e}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_short_and_reads_back() {
        for (x, text) in [
            (0.0, "0"),
            (-0.0, "-0"),
            (1.0, "1"),
            (-0.1, "-0.1"),
            (1e-5, "0.00001"),
            (9.9e-6, "9.9e-6"),
            (9_999_999_999_999_998.0, "9999999999999998"),
            (1e16, "1e16"),
            (-2.5e300, "-2.5e300"),
            (5e-324, "5e-324"),
        ] {
            assert_eq!(Decimal(x).to_string(), text);
            assert_eq!(text.parse::<f64>().unwrap().to_bits(), f64::to_bits(x));
        }
    }
}
