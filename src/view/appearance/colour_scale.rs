//! From the values of faces to positions on a colour map: over a range, linear or logarithmic, and
//! with an optional tolerance within which values keep the material.

/// Minimum ratio of the low end of a logarithmic scale to its high end.
const LEAST_PART: f64 = 1e-6;

/// The mapping of values to colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColourScale {
    /// The value at the first colour.
    pub low: f32,
    /// The value at the last colour.
    pub high: f32,
    /// Values up to this keep the material, and values beyond it have a map of their own; without a
    /// tolerance all values are on the full map.
    pub tolerance: Option<f32>,
    /// Whether equal factors of a value, rather than equal differences, are equal steps.
    pub logarithmic: bool,
}

impl ColourScale {
    /// Creates a linear scale over the full map.
    pub fn linear(low: f32, high: f32) -> ColourScale {
        ColourScale { low, high, tolerance: None, logarithmic: false }
    }

    /// Returns whether values have both signs: the range is then symmetric about 0.
    pub fn is_signed(&self) -> bool {
        self.low < 0.0
    }

    /// Returns whether a value keeps the material.
    pub fn is_within(&self, value: f32) -> bool {
        self.tolerance.is_some_and(|tolerance| value <= tolerance)
    }

    /// Returns the ends of the range, in terms of [`ColourScale::coordinate`].
    pub fn ends(&self) -> [f64; 2] {
        [self.low, self.high].map(|end| self.along(exact(end)))
    }

    /// Returns the quantity that is linear in the position of a value in the range: the value
    /// itself, or its logarithm to base 10. NaN stays NaN.
    pub fn coordinate(&self, value: f32) -> f64 {
        self.along(f64::from(value))
    }

    fn along(&self, value: f64) -> f64 {
        if value.is_nan() || !self.logarithmic {
            return value;
        }
        value.max(LEAST_PART * f64::from(self.high)).log10()
    }

    /// Returns the position of a value in the range, from 0 to 1; values beyond it are at its ends.
    /// `None` for NaN. If the range is empty, everything is at the low end.
    pub fn part(&self, value: f32) -> Option<f64> {
        if value.is_nan() {
            return None;
        }
        let [low, high] = self.ends();
        let part = if high > low { (self.coordinate(value) - low) / (high - low) } else { 0.0 };
        Some(part.clamp(0.0, 1.0))
    }
}

/// Converts via the shortest decimal: a value entered as 0.01 is not slightly less.
fn exact(value: f32) -> f64 {
    format!("{value}").parse().unwrap_or_else(|_| f64::from(value))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_have_places_in_the_range_and_stay_in_it() {
        let scale = ColourScale::linear(2.0, 4.0);
        let parts = [2.0, 3.0, 9.0, -9.0, f32::INFINITY].map(|value| scale.part(value));
        assert_eq!(parts, [0.0, 0.5, 1.0, 0.0, 1.0].map(Some));
        assert_eq!(scale.part(f32::NAN), None);
        assert_eq!(ColourScale::linear(1.0, 1.0).part(1.0), Some(0.0));
    }

    #[test]
    fn by_logarithms_equal_factors_are_equal_steps() {
        let scale = ColourScale { logarithmic: true, ..ColourScale::linear(0.01, 1.0) };
        for (value, part) in [(0.01, 0.0), (0.1, 0.5), (1.0, 1.0), (0.0, 0.0), (7.0, 1.0)] {
            let found = scale.part(value).unwrap();
            assert!((found - part).abs() < 1e-6, "{value}: {found}");
        }
        // A range that starts at zero still has a finite low end.
        let from_nothing = ColourScale { logarithmic: true, ..ColourScale::linear(0.0, 1.0) };
        assert!(from_nothing.ends().iter().all(|end| end.is_finite()));
        assert!(from_nothing.part(1e-3).unwrap() > 0.3);
        assert_eq!(from_nothing.part(f32::NAN), None);
    }

    #[test]
    fn the_tolerance_itself_is_within_it() {
        let scale = ColourScale { tolerance: Some(0.005), ..ColourScale::linear(0.0, 1.0) };
        assert!(scale.is_within(0.005) && scale.is_within(0.0));
        assert!(!scale.is_within(0.0051) && !scale.is_within(f32::NAN));
        assert!(!ColourScale::linear(0.0, 1.0).is_within(0.0));
    }
}
