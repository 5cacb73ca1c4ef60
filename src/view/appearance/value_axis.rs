//! The axis of a legend: the positions of values, linear or logarithmic.

/// The least start of a logarithmic axis, relative to its end.
const LEAST_PART: f64 = 1e-6;

/// The axis of a legend.
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

    /// Returns the position of a value, from 0 to 1; values beyond the axis are at its ends. NaN for
    /// NaN; 0 on an empty axis.
    pub fn part(&self, value: f64) -> f64 {
        let ValueAxis { low, high, logarithmic } = *self;
        if value.is_nan() {
            return value;
        }
        let part = match logarithmic {
            _ if low.partial_cmp(&high) != Some(std::cmp::Ordering::Less) => 0.0,
            true => (value.max(low) / low).ln() / (high / low).ln(),
            false => (value - low) / (high - low),
        };
        part.clamp(0.0, 1.0)
    }

    /// Returns the value at a position from 0 to 1.
    #[expect(clippy::disallowed_methods, reason = "no number of the solver depends on it")]
    pub fn value(&self, part: f64) -> f64 {
        let ValueAxis { low, high, logarithmic } = *self;
        if logarithmic { low * (high / low).powf(part) } else { low + part * (high - low) }
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
    }

    #[test]
    fn every_value_has_a_position_on_the_axis() {
        let axis = ValueAxis::new(0.0, 8.0, false);
        assert_eq!([9.0, -1.0, f64::INFINITY].map(|value| axis.part(value)), [1.0, 0.0, 1.0]);
        assert!(axis.part(f64::NAN).is_nan());
        assert_eq!(ValueAxis::new(3.0, 3.0, false).part(3.0), 0.0);
        // A logarithmic axis from nothing has a start all the same.
        let from_nothing = ValueAxis::new(0.0, 1.0, true);
        assert!(from_nothing.low > 0.0);
        assert_eq!(from_nothing.part(0.0), 0.0);
    }
}
