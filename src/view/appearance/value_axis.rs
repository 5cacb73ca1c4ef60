//! Positions of values on the axis of a legend and on a colour map: linear or logarithmic.

/// The least start of a logarithmic axis, relative to its end.
const LEAST_PART: f64 = 1e-6;

/// An axis of values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ValueAxis {
    /// The value at its start; above 0 on a logarithmic axis.
    pub low: f64,
    /// The value at its end.
    pub high: f64,
    /// Whether equal factors of a value, rather than equal differences, have equal lengths.
    pub logarithmic: bool,
}

impl ValueAxis {
    /// Creates an axis; a logarithmic one starts later if it would be too long.
    pub fn new(low: f64, high: f64, logarithmic: bool) -> ValueAxis {
        let low = if logarithmic { low.max(LEAST_PART * high) } else { low };
        ValueAxis { low, high, logarithmic }
    }

    /// Returns the quantity that is linear in the position of a value: the value itself, or its
    /// logarithm to base 10. NaN stays NaN.
    pub fn coordinate(&self, value: f64) -> f64 {
        let is_itself = value.is_nan() || !self.logarithmic;
        if is_itself { value } else { value.max(LEAST_PART * self.high).log10() }
    }

    /// Returns the ends of the axis, in terms of [`ValueAxis::coordinate`].
    pub fn ends(&self) -> [f64; 2] {
        [self.low, self.high].map(|end| self.coordinate(end))
    }

    /// Returns the position of a value, from 0 to 1; values beyond the axis are at its ends. NaN for
    /// NaN. On an empty axis what is above its end is at 1, all else at 0.
    pub fn part(&self, value: f64) -> f64 {
        let ([low, high], at) = (self.ends(), self.coordinate(value));
        match high > low {
            true => ((at - low) / (high - low)).clamp(0.0, 1.0),
            false if value.is_nan() => value,
            false => f64::from(u8::from(value > self.high)),
        }
    }

    /// Returns the value at a position from 0 to 1.
    #[expect(clippy::disallowed_methods, reason = "no number of the solver depends on it")]
    pub fn value(&self, part: f64) -> f64 {
        let ValueAxis { low, high, logarithmic } = *self;
        if logarithmic { low * (high / low).powf(part) } else { low + part * (high - low) }
    }
}

/// The mapping of the values of faces to colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColourScale {
    /// From the value at the first colour to that at the last one.
    pub axis: ValueAxis,
    /// Values up to this keep the material, and values beyond it have a map of their own; without a
    /// tolerance all values are on the full map.
    pub tolerance: Option<f32>,
}

impl ColourScale {
    /// Creates a linear scale over the full map.
    pub fn linear(low: f64, high: f64) -> ColourScale {
        ColourScale { axis: ValueAxis::new(low, high, false), tolerance: None }
    }

    /// Returns whether values have both signs: the range is then symmetric about 0.
    pub fn is_signed(&self) -> bool {
        self.axis.low < 0.0
    }

    /// Returns whether a value keeps the material.
    pub fn is_within(&self, value: f32) -> bool {
        self.tolerance.is_some_and(|tolerance| value <= tolerance)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn position_and_value_are_inverse_to_each_other_on_linear_and_logarithmic_axes() {
        for axis in [ValueAxis::new(0.0, 8.0, false), ValueAxis::new(0.001, 8.0, true)] {
            for value in [0.001, 0.5, 8.0] {
                let there = axis.value(axis.part(value));
                assert!((there - value).abs() < 1e-12, "{value} is at {there}");
            }
        }
        let axis = ValueAxis::new(0.01, 1.0, true);
        for (value, part) in [(0.01, 0.0), (0.1, 0.5), (1.0, 1.0), (0.0, 0.0), (7.0, 1.0)] {
            assert!((axis.part(value) - part).abs() < 1e-12, "{value}");
        }
    }

    #[test]
    fn every_value_has_a_position_on_the_axis() {
        let axis = ValueAxis::new(0.0, 8.0, false);
        assert_eq!([9.0, -1.0, f64::INFINITY].map(|value| axis.part(value)), [1.0, 0.0, 1.0]);
        assert!(axis.part(f64::NAN).is_nan());
        // A logarithmic axis from nothing has a start all the same.
        let from_nothing = ValueAxis::new(0.0, 1.0, true);
        assert!(from_nothing.low > 0.0);
        assert_eq!(from_nothing.part(0.0), 0.0);
        assert!(from_nothing.part(1e-3) > 0.3);
        assert!(from_nothing.part(f64::NAN).is_nan());
    }

    /// All faces had the first colour, the worst as well.
    #[test]
    fn above_an_empty_range_there_is_the_last_colour() {
        for logarithmic in [false, true] {
            let axis = ValueAxis::new(0.01, 0.01, logarithmic);
            let parts = [0.0, 0.01, 9.0].map(|value| axis.part(value));
            assert_eq!(parts, [0.0, 0.0, 1.0]);
            assert!(axis.part(f64::NAN).is_nan());
        }
    }

    #[test]
    fn the_tolerance_itself_is_within_it() {
        let scale = ColourScale { tolerance: Some(0.005), ..ColourScale::linear(0.0, 1.0) };
        assert!(scale.is_within(0.005) && scale.is_within(0.0));
        assert!(!scale.is_within(0.0051) && !scale.is_within(f32::NAN));
        assert!(!ColourScale::linear(0.0, 1.0).is_within(0.0));
    }
}
