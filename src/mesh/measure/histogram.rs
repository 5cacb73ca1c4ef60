//! Histogram of values for colour legends, with a range that excludes the few outliers.

use crate::math::{argsort, key_of_number};

/// Percentage of the values that may lie beyond the upper end.
const BEYOND: usize = 1;

/// Counts of values in bins of equal width; the first and last bins include the values beyond.
#[derive(Clone, Debug, PartialEq)]
pub struct Histogram {
    /// The upper end of the last bin.
    pub high: f64,
    /// The count of each bin.
    pub counts: Vec<u32>,
}

impl Histogram {
    /// Counts the values that are not NaN in `bins` from `low` to the 99th percentile, and at least
    /// to `least_high`.
    ///
    /// # Panics
    /// If there are no bins, or `least_high` is not greater than `low`.
    pub fn new(values: &[f64], [low, least_high]: [f64; 2], bins: usize) -> Histogram {
        assert!(bins > 0 && least_high > low, "there is at least one bin, of some width");
        let numbers: Vec<f64> = values.iter().copied().filter(|v| !v.is_nan()).collect();
        let order = argsort(numbers.iter().map(|&v| key_of_number(v)));
        let sorted: Vec<f64> = order.into_iter().map(|i| numbers[i as usize]).collect();
        let within = sorted.len() - sorted.len() * BEYOND / 100;
        let finite = sorted[..within].iter().rev().find(|value| value.is_finite());
        let high = finite.map_or(least_high, |&value| value.max(least_high));
        let mut counts = vec![0; bins];
        for value in sorted {
            let part = (value - low) / (high - low) * bins as f64;
            // The conversion to an index saturates.
            counts[(part as usize).min(bins - 1)] += 1;
        }
        Histogram { high, counts }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_is_counted_and_the_far_ones_do_not_stretch_the_range() {
        let mut values: Vec<f64> = (0..990).map(|k| 1.0 + f64::from(k) / 989.0).collect();
        values.extend([50.0, 1e9, f64::INFINITY, f64::NAN]);
        let histogram = Histogram::new(&values, [1.0, 1.01], 10);
        assert!(histogram.high < 2.0 + 1e-12 && histogram.high > 1.99, "{}", histogram.high);
        assert_eq!(histogram.counts.iter().sum::<u32>(), 993);
        assert!(histogram.counts.iter().all(|&count| (95..=110).contains(&count)));
    }

    #[test]
    fn where_nothing_differs_the_range_has_its_least_width() {
        let histogram = Histogram::new(&[1.0; 7], [1.0, 1.01], 4);
        assert_eq!(histogram, Histogram { high: 1.01, counts: vec![7, 0, 0, 0] });
        assert_eq!(Histogram::new(&[f64::NAN], [1.0, 1.01], 2).counts, [0, 0]);
        assert_eq!(Histogram::new(&[f64::INFINITY], [1.0, 1.01], 2).counts, [0, 1]);
    }
}
