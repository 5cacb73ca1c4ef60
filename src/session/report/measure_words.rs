//! Values of measures in words, and the bounds below which they are rounding errors.

use super::face_measure::MeasureUnit;
use crate::scene::UNITS;
use crate::words::{self, ROUNDING};

impl MeasureUnit {
    /// The exponent of the unit of the mesh in this unit; none if it does not depend on that.
    fn power(self) -> Option<i32> {
        match self {
            MeasureUnit::Length => Some(1),
            MeasureUnit::PerLength => Some(-1),
            MeasureUnit::PerArea => Some(-2),
            MeasureUnit::Percent | MeasureUnit::Degrees | MeasureUnit::Number => None,
        }
    }

    /// Returns the bound below which values are rounding errors, in this unit, on a mesh of this
    /// `size`.
    pub fn rounding(self, size: f64) -> f64 {
        match (self, self.power()) {
            (_, Some(power)) => ROUNDING * size.powi(power),
            // These are squares.
            (MeasureUnit::Number, None) => ROUNDING * ROUNDING,
            // These have two digits before the point.
            (_, None) => 100.0 * ROUNDING,
        }
    }

    /// Returns the value, or zero if it is a rounding error on a mesh of this `size`.
    pub fn or_zero(self, value: f64, size: f64) -> f64 {
        if value.abs() < self.rounding(size) { 0.0 } else { value }
    }

    /// Formats a value with its unit, on a mesh whose unit has the symbol `units`. Lengths are
    /// written in the unit in which `like` is written, for errors their tolerance. Curvatures are
    /// written per metre, so that the radius in metres can be read off.
    pub fn in_words(self, value: f64, units: &str, like: f64) -> String {
        let metres = || UNITS.iter().find(|unit| unit.symbol == units).map(|unit| unit.metres);
        match self {
            MeasureUnit::Length => words::length_like(value, units, like),
            MeasureUnit::Percent => words::number(value) + " %",
            MeasureUnit::Degrees => words::number(value) + "°",
            MeasureUnit::Number => words::number(value),
            MeasureUnit::PerLength | MeasureUnit::PerArea => match (metres(), self) {
                (None, _) => words::number(value),
                (Some(metres), MeasureUnit::PerLength) => words::number(value / metres) + " 1/m",
                (Some(metres), _) => words::number(value / (metres * metres)) + " 1/m²",
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curvatures_are_written_per_metre_whatever_the_unit_of_the_mesh() {
        let [mean, gauss] = [MeasureUnit::PerLength, MeasureUnit::PerArea];
        let words = |unit: MeasureUnit, value: f64, units: &str| unit.in_words(value, units, value);
        assert_eq!(words(mean, 0.002, "mm"), "2.00 1/m");
        assert_eq!(words(gauss, -2e-6, "mm"), "−2.00 1/m²");
        assert_eq!(words(gauss, 0.25, "m"), "0.250 1/m²");
        // A mesh without a unit shows none.
        assert_eq!(words(gauss, 0.25, ""), "0.250");
    }

    #[test]
    fn other_values_have_their_signs_and_lengths_the_unit_of_their_tolerance() {
        assert_eq!(MeasureUnit::Percent.in_words(3.0, "m", 3.0), "3.00 %");
        assert_eq!(MeasureUnit::Degrees.in_words(3.0, "m", 3.0), "3.00°");
        assert_eq!(MeasureUnit::Length.in_words(0.3, "m", 0.005), "300 mm");
    }

    #[test]
    fn the_bound_of_rounding_falls_as_the_mesh_size_grows_for_curvatures() {
        let [length, mean, gauss] =
            [MeasureUnit::Length, MeasureUnit::PerLength, MeasureUnit::PerArea]
                .map(|unit| unit.rounding(100.0));
        assert!((gauss * 100.0 / mean - 1.0).abs() < 1e-12 && length > mean);
        assert_eq!(MeasureUnit::Length.or_zero(-1e-12, 100.0), 0.0);
        assert_eq!(MeasureUnit::Length.or_zero(-1e-9, 100.0), -1e-9);
    }
}
