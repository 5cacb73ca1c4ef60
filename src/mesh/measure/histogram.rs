//! Histograms: of values for colour legends, with a range that excludes the few outliers, and of
//! the corner angles of faces (paper Fig. 7).

use crate::math::{Vec3, argsort, cosine, key_of_number, polygon_corners};
use crate::mesh::{Point, Ragged};

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

/// Counts the corners of `faces` at `positions` (`#V by 3`) by their angles, in `bins` of equal
/// width from 0 to 180 degrees. An angle on the bound of two bins is in the upper one. Corners at a
/// side of zero length have no angle and are not counted.
pub fn angle_histogram(positions: &[Point], faces: &Ragged, bins: usize) -> Vec<u32> {
    // Angles are compared by their cosines, which decrease with the angle.
    let bound = |k: usize| cosine(0.5 * k as f64 / bins as f64);
    let bounds: Vec<f64> = (1..bins).map(bound).collect();
    let at = |v: u32| Vec3::from(positions[v as usize]);
    let mut counts = vec![0; bins];
    for face in faces.iter() {
        for [before, here, after] in polygon_corners(face) {
            let here = at(here);
            let (before, after) = (at(before) - here, at(after) - here);
            let lengths = before.length() * after.length();
            if lengths > 0.0 {
                let cosine = before.dot(after) / lengths;
                counts[bounds.partition_point(|&bound| cosine <= bound)] += 1;
            }
        }
    }
    counts
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

    #[test]
    fn angles_fall_into_their_bins() {
        // A square, a triangle of 30, 60 and 90 degrees, and one without area or angles.
        let height = 3.0f64.sqrt();
        let positions = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, 1.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, height, 0.0],
        ];
        let mut faces = Ragged::new();
        faces.push(&[0, 1, 2, 3]);
        faces.push(&[0, 1, 4]);
        faces.push(&[2, 2, 2]);
        // Bins of 10 degrees.
        let counts = angle_histogram(&positions, &faces, 18);
        let mut expected = [0; 18];
        (expected[3], expected[6]) = (1, 1);
        expected[9] = 5;
        let near = |from: usize| counts[from - 1] + counts[from];
        // 30, 60 and 90 degrees are bounds of bins up to rounding.
        for k in [3, 6, 9] {
            assert_eq!(near(k), expected[k], "{counts:?}");
        }
        assert_eq!(counts.iter().sum::<u32>(), 7);
    }

    #[test]
    fn a_mesh_at_any_scale_has_the_same_angles() {
        let mut faces = Ragged::new();
        faces.push(&[0, 1, 2]);
        let counts = |scale: f64| {
            let corners = [[0.0, 0.0, 0.0], [1.0, 0.2, 0.1], [0.3, 0.9, -0.2]];
            angle_histogram(&corners.map(|p| p.map(|x| x * scale)), &faces, 36)
        };
        assert_eq!(counts(1.0), counts(1e-3));
        assert_eq!(counts(1.0), counts(1e3));
        assert_eq!(counts(1.0).iter().sum::<u32>(), 3);
    }
}
