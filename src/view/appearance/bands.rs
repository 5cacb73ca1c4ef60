//! Values in bands: each band between two round limits has one colour; lines separate the bands.
//!
//! Most measures have one value per face: a face is in one band, and the lines run along the edges
//! between faces of different bands. If every vertex has a value, the colours are interpolated
//! between the corners, and the lines are isolines through the faces (`shaders/faces.wgsl`).

use super::colour_map::{ColourMap, texel};
use super::value_axis::ValueAxis;
use crate::math::round_down;

/// Minimum number of bands in a range; the maximum is 5/2 of it.
const LEAST: f64 = 5.0;

/// Round limits over a range of values.
#[derive(Clone, Debug, PartialEq)]
pub struct Bands {
    axis: ValueAxis,
    /// Distance between limits, a round number in the unit of the values or of their logarithm.
    pub step: f64,
    /// The limits inside the range, as fractions of it.
    pub limits: Vec<f64>,
    /// For each band the texel of the colour map at its midpoint.
    pub texels: Vec<u8>,
}

impl Bands {
    /// Creates the bands for a range; none if it is empty.
    pub fn new(axis: ValueAxis) -> Option<Bands> {
        let [low, high] = axis.ends();
        let step = round_down((high - low) / LEAST);
        if step == 0.0 {
            return None;
        }
        let first = (low / step).floor() + 1.0;
        let parts = (0..).map(|k| ((first + f64::from(k)) * step - low) / (high - low));
        // A limit at an end of the range, up to rounding, separates nothing.
        let limits = parts.skip_while(|&part| part < 1e-6).take_while(|&part| part < 1.0 - 1e-6);
        let limits: Vec<f64> = limits.collect();
        let starts = std::iter::once(0.0).chain(limits.iter().copied());
        let ends = limits.iter().copied().chain(std::iter::once(1.0));
        let middle = |(from, to): (f64, f64)| texel(0.5 * (from + to));
        let texels = starts.zip(ends).map(middle).collect();
        Some(Bands { axis, step, limits, texels })
    }

    /// Returns the index of the band of a value: the first or last outside the range, none for NaN.
    pub fn band(&self, value: f32) -> Option<usize> {
        let [low, high] = self.axis.ends();
        let part = (self.axis.coordinate(f64::from(value)) - low) / (high - low);
        (!part.is_nan()).then(|| self.limits.partition_point(|&limit| limit <= part))
    }

    /// Returns the CSS colour of each band.
    pub fn colours(&self, map: ColourMap) -> Vec<String> {
        let css = |&texel: &u8| {
            let [r, g, b] = (map.colour(texel) * 255.0).round().to_array();
            format!("rgb({r} {g} {b})")
        };
        self.texels.iter().map(css).collect()
    }

    /// Returns the ends of the range, in steps from a limit.
    pub fn range_in_steps(&self) -> [f32; 2] {
        self.axis.ends().map(|end| self.steps_to(end))
    }

    /// Returns a value in the same steps: whole at the limits, and clamped to slightly more than
    /// the range. NaN is at the start of the range.
    pub fn in_steps(&self, value: f64) -> f32 {
        let [begins, ends] = self.range_in_steps();
        let steps = self.steps_to(self.axis.coordinate(value));
        if steps.is_nan() { begins } else { steps.clamp(begins - 1.0, ends + 1.0).max(0.0) }
    }

    fn steps_to(&self, value: f64) -> f32 {
        // Counted from one step below the first, so that no value in the range is negative.
        let [low, _] = self.axis.ends();
        let whole = (low / self.step).floor() - 1.0;
        let steps = value / self.step - whole;
        // At a limit whole in spite of rounding.
        let is_limit = (steps - steps.round()).abs() < 1e-6;
        (if is_limit { steps.round() } else { steps }) as f32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(low: f64, high: f64) -> Option<Bands> {
        Bands::new(ValueAxis::new(low, high, false))
    }

    #[test]
    fn by_logarithms_the_powers_of_ten_part_bands() {
        let bands = Bands::new(ValueAxis::new(0.001, 1.0, true)).unwrap();
        assert_eq!(bands.step, 0.5);
        let found = [0.0011, 0.099, 0.101, 0.9].map(|value| bands.band(value).unwrap());
        assert_eq!(found, [0, 3, 4, 5]);
    }

    #[test]
    fn limits_are_round_and_inside_the_range() {
        let bands = of(0.0, 0.038).unwrap();
        assert_eq!(bands.step, 0.005);
        let limits: Vec<f64> = bands.limits.iter().map(|part| part * 0.038).collect();
        assert_eq!(limits.len(), 7);
        assert!((limits[0] - 0.005).abs() < 1e-9 && (limits[6] - 0.035).abs() < 1e-9);
        // A limit at the end of the range separates nothing.
        assert_eq!(of(0.0, 0.01).unwrap().limits.len(), 4);
        assert_eq!(of(3.0, 8.0).unwrap().limits, [0.2, 0.4, 0.6, 0.8]);
        // Neither does one at its start: 0.3 / 0.1 is rounded down to less than 3.
        for (low, high) in [(0.3, 0.8), (0.3, 1.0), (0.6, 1.5), (2.0, 7.0)] {
            let limits = of(low, high).unwrap().limits;
            assert!(limits.iter().all(|part| (0.1..0.9).contains(part)), "{low} {high} {limits:?}");
        }
        for (low, high) in [(0.0, 0.0), (1.0, 0.5), (0.0, f64::NAN), (0.0, f64::INFINITY)] {
            assert_eq!(of(low, high), None);
        }
    }

    #[test]
    fn a_value_is_in_the_band_between_its_limits() {
        let bands = of(0.0, 10.0).unwrap();
        assert_eq!(bands.step, 2.0);
        let found = [-1.0, 0.0, 1.9, 2.0, 9.9, 50.0].map(|value| bands.band(value).unwrap());
        assert_eq!(found, [0, 0, 0, 1, 4, 4]);
        assert_eq!(bands.band(f32::NAN), None);
        assert_eq!(bands.texels, [26, 77, 128, 179, 230]);
        assert_eq!(bands.colours(ColourMap::Viridis).len(), 5);
    }

    #[test]
    fn in_steps_limits_are_whole() {
        for (low, high, limit) in [(0.0, 10.0, 4.0), (1.0, 11.0, 4.0), (-3.0, 7.0, 0.0)] {
            let bands = of(low, high).unwrap();
            let steps = bands.in_steps(limit);
            assert_eq!(steps, steps.round());
            let [begins, ends] = bands.range_in_steps();
            assert!(begins > 0.0 && (ends - begins - 5.0).abs() < 1e-5);
            assert!(begins < steps && steps < ends);
            assert!(bands.in_steps(1e9) > ends && bands.in_steps(-1e9) >= 0.0);
            assert_eq!(bands.in_steps(f64::NAN), begins);
        }
    }
}
