//! The units of measures of a mesh: how values are written in them, and below which bound a value is a
//! rounding error.

use super::length::{ROUNDING, length_like, number_in, unit_of, with_unit};
use super::number::brief;
use super::units::LengthUnit;
use serde::de::value::{Error, StrDeserializer};
use serde::{Deserialize, Serialize};

/// The unit of a measure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(all(target_arch = "wasm32", feature = "engine"), derive(tsify::Tsify))]
#[cfg_attr(all(target_arch = "wasm32", feature = "engine"), tsify(missing_as_null))]
#[serde(rename_all = "kebab-case")]
pub enum MeasureUnit {
    /// The unit of the mesh.
    Length,
    /// Percent.
    Percent,
    /// Degrees.
    Degrees,
    /// A number without a unit.
    Number,
    /// One over the unit of the mesh.
    PerLength,
    /// One over the squared unit of the mesh.
    PerArea,
}

/// A unit in which values are written.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    all(target_arch = "wasm32", feature = "words"),
    wasm_bindgen::prelude::wasm_bindgen(getter_with_clone)
)]
pub struct WrittenUnit {
    /// Its symbol; empty for a number.
    pub symbol: String,
    /// What a value is multiplied by before it is written.
    pub factor: f64,
}

impl MeasureUnit {
    /// Returns the unit with this name in messages, if there is one.
    pub fn of(name: &str) -> Option<MeasureUnit> {
        MeasureUnit::deserialize(StrDeserializer::<Error>::new(name)).ok()
    }

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

    /// Returns the unit in which values are written on a mesh whose unit has the symbol `units`:
    /// lengths in that of the length `like`, for errors their tolerance; curvatures per metre, so
    /// that the radius in metres can be read off.
    pub fn written(self, units: &str, like: f64) -> WrittenUnit {
        let plain = |symbol: &str| WrittenUnit { symbol: symbol.to_owned(), factor: 1.0 };
        let per_metre = |symbol: &str, power: i32| match LengthUnit::of(units) {
            Some(unit) => {
                WrittenUnit { symbol: symbol.to_owned(), factor: 1.0 / unit.metres.powi(power) }
            }
            None => plain(""),
        };
        match self {
            MeasureUnit::Length => {
                let (symbol, factor) = unit_of(like, units);
                WrittenUnit { symbol: symbol.to_owned(), factor }
            }
            MeasureUnit::Percent => plain("%"),
            MeasureUnit::Degrees => plain("°"),
            MeasureUnit::Number => plain(""),
            MeasureUnit::PerLength => per_metre("1/m", 1),
            MeasureUnit::PerArea => per_metre("1/m²", 2),
        }
    }

    /// Formats a value with its unit, [as it is written](MeasureUnit::written).
    pub fn in_words(self, value: f64, units: &str, like: f64) -> String {
        if self == MeasureUnit::Length {
            return length_like(value, units, like);
        }
        let WrittenUnit { symbol, factor } = self.written(units, like);
        number_in(value * factor, &symbol)
    }

    /// Formats a value that was entered, such as a limit: `1 mm`. As [`MeasureUnit::in_words`]
    /// otherwise.
    pub fn limit(self, value: f64, units: &str) -> String {
        let WrittenUnit { symbol, factor } = self.written(units, value);
        with_unit(&brief(value * factor), &symbol)
    }
}

/// Returns an energy, or zero if it is a rounding error on a mesh of this `size`.
#[cfg_attr(
    all(target_arch = "wasm32", feature = "words"),
    wasm_bindgen::prelude::wasm_bindgen(js_name = energyOrZero)
)]
pub fn energy_or_zero(energy: f64, size: f64) -> f64 {
    if energy < (ROUNDING * size) * (ROUNDING * size) { 0.0 } else { energy }
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
        assert_eq!(MeasureUnit::Percent.limit(3.0, "m"), "3 %");
        assert_eq!(MeasureUnit::Length.limit(0.0015, "m"), "1.5 mm");
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
