//! From the values of faces to places on a colour map: over a range, evenly or by their logarithm, and
//! with a tolerance: what is within it keeps the material.

/// So far below its high end does a logarithmic scale begin at the latest.
const LEAST_PART: f64 = 1e-6;

/// How values become colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColourScale {
    /// The value at the first colour.
    pub low: f32,
    /// The value at the last colour.
    pub high: f32,
    /// Values up to this keep the material, and those beyond it have the map of what is beyond a
    /// tolerance; without one all values are on the full map.
    pub tolerance: Option<f32>,
    /// Equal factors of a value are equal steps, instead of equal differences.
    pub logarithmic: bool,
}

impl ColourScale {
    /// The full map, evenly.
    pub fn linear(low: f32, high: f32) -> ColourScale {
        ColourScale { low, high, tolerance: None, logarithmic: false }
    }

    /// Whether values have both signs: the range is as long to both sides of 0.
    pub fn is_signed(&self) -> bool {
        self.low < 0.0
    }

    /// Whether a value keeps the material.
    pub fn is_within(&self, value: f32) -> bool {
        self.tolerance.is_some_and(|tolerance| value <= tolerance)
    }

    /// Where the range begins and ends, in the coordinate of [`ColourScale::coordinate`].
    pub fn ends(&self) -> [f64; 2] {
        [self.low, self.high].map(|end| self.along(exact(end)))
    }

    /// The quantity that is proportional to the place of a value in the range: the value itself or its logarithm to
    /// the base 10. What is not a number stays none.
    pub fn coordinate(&self, value: f32) -> f64 {
        self.along(f64::from(value))
    }

    fn along(&self, value: f64) -> f64 {
        if value.is_nan() || !self.logarithmic {
            return value;
        }
        value.max(LEAST_PART * f64::from(self.high)).log10()
    }

    /// The place of a value in the range, from 0 to 1; values beyond it are at its ends. `None` stands
    /// for a value that is not a number. Where there is no range, everything is at the low end.
    pub fn part(&self, value: f32) -> Option<f64> {
        if value.is_nan() {
            return None;
        }
        let [low, high] = self.ends();
        let part = if high > low { (self.coordinate(value) - low) / (high - low) } else { 0.0 };
        Some(part.clamp(0.0, 1.0))
    }
}

/// The shortest decimal: what was entered as 0.01 is not a little less.
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
        // A range from nothing on has a first factor all the same.
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
