//! Functions of [`crate::words`] with other arguments on the page; the others are exported where they
//! are. They run on the page's thread, where a number that follows the hand is written at once; the
//! engine runs in workers. `units` is the symbol of the unit of the mesh, empty if it is not known.

use super::thrown;
use crate::words::{self, LengthUnit, MeasureUnit, TypedLength, UNITS, WrittenUnit};
use wasm_bindgen::prelude::*;

/// Formats a measured length with its unit, in the unit in which the length `like` is written.
#[wasm_bindgen]
pub fn length(value: f64, units: &str, like: Option<f64>) -> String {
    words::length_like(value, units, like.unwrap_or(value))
}

/// Formats a displacement by its components that are not negligible on a mesh of this `size`.
///
/// # Errors
/// Other than three components.
#[wasm_bindgen]
pub fn displacement(by: &[f64], units: &str, size: f64) -> Result<String, JsValue> {
    let by = by.try_into().map_err(|_| thrown("a displacement has three components"))?;
    Ok(words::displacement(by, units, size))
}

/// Reads a length as people type it, or a number if `units` is empty.
///
/// # Errors
/// If it is none.
#[wasm_bindgen(js_name = readLength)]
pub fn read_length(text: &str, units: &str) -> Result<TypedLength, JsValue> {
    TypedLength::read(text, units).map_err(thrown)
}

/// Returns the symbols of the units of length that are offered, in order.
#[wasm_bindgen(js_name = unitsOfLength)]
pub fn units_of_length() -> Vec<String> {
    UNITS.iter().map(|unit| unit.symbol.to_owned()).collect()
}

/// Returns the length of a unit in metres, if it is one of those that are offered.
#[wasm_bindgen(js_name = metresOf)]
pub fn metres_of(symbol: &str) -> Option<f64> {
    LengthUnit::of(symbol).map(|unit| unit.metres)
}

/// Returns the name of a unit among the unit systems of Rhino, if it is one of those that are offered.
#[wasm_bindgen(js_name = rhinoUnit)]
pub fn rhino_unit(symbol: &str) -> Option<String> {
    LengthUnit::of(symbol).map(|unit| unit.rhino.to_owned())
}

/// Returns the measure's unit, by its name among those of the engine.
fn measure_unit(name: &str) -> Result<MeasureUnit, JsValue> {
    MeasureUnit::of(name).ok_or_else(|| thrown(format!("{name:?} is no unit of a measure")))
}

/// Returns the unit in which values of a measure are written beside a value `like`.
///
/// # Errors
/// If no measure has such a unit.
#[wasm_bindgen(js_name = writtenUnit)]
pub fn written_unit(unit: &str, units: &str, like: f64) -> Result<WrittenUnit, JsValue> {
    Ok(measure_unit(unit)?.written(units, like))
}

/// Formats a value of a measure with its unit, as it is written beside a value `like`.
///
/// # Errors
/// If no measure has such a unit.
#[wasm_bindgen]
pub fn measured(value: f64, unit: &str, units: &str, like: Option<f64>) -> Result<String, JsValue> {
    Ok(measure_unit(unit)?.in_words(value, units, like.unwrap_or(value)))
}

/// Returns a length, or zero if it is a rounding error on a mesh of this `size`.
#[wasm_bindgen(js_name = lengthOrZero)]
pub fn length_or_zero(length: f64, size: f64) -> f64 {
    MeasureUnit::Length.or_zero(length, size)
}

/// Formats a count with its noun; the plural has an s if it is not given.
#[wasm_bindgen]
pub fn count(count: usize, noun: &str, plural: Option<String>) -> String {
    let plural = plural.unwrap_or_else(|| format!("{noun}s"));
    words::count(count, noun, &plural)
}
