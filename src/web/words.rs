//! The functions of [`crate::words`] under the page's names. They run on the page's thread, where a
//! number that follows the hand is written at once; the engine runs in workers. `units` is the symbol
//! of the unit of the mesh, empty if it is not known.

use super::thrown;
use crate::words::{
    self, ComparedLengths, LengthUnit, MeasureUnit, TypedLength, UNITS, WrittenUnit,
};
use wasm_bindgen::prelude::*;

/// Formats a measured number: `1.23`, `2.50e−7`.
#[wasm_bindgen]
pub fn number(value: f64) -> String {
    words::number(value)
}

/// Formats an entered number as briefly as possible.
#[wasm_bindgen]
pub fn brief(value: f64) -> String {
    words::brief(value)
}

/// Rounds to significant digits, for numbers that somebody reads and may edit.
#[wasm_bindgen]
pub fn rounded(value: f64, digits: usize) -> f64 {
    words::rounded(value, digits)
}

/// Formats a measured length with its unit, in the unit in which the length `like` is written.
#[wasm_bindgen]
pub fn length(value: f64, units: &str, like: Option<f64>) -> String {
    words::length_like(value, units, like.unwrap_or(value))
}

/// Formats a length that was entered, such as a tolerance.
#[wasm_bindgen]
pub fn limit(value: f64, units: &str) -> String {
    words::limit(value, units)
}

/// Formats the area of a surface, which is in the squared unit of the mesh.
#[wasm_bindgen(js_name = areaOf)]
pub fn area_of(area: f64, units: &str) -> String {
    words::area_of(area, units)
}

/// Formats a measured number with a unit, which is written after it.
#[wasm_bindgen(js_name = numberIn)]
pub fn number_in(value: f64, unit: &str) -> String {
    words::number_in(value, unit)
}

/// Formats a range of numbers with their unit, of which each end may be missing.
#[wasm_bindgen(js_name = rangeIn)]
pub fn range_in(from: Option<f64>, to: Option<f64>, unit: &str) -> String {
    words::range_in(from, to, unit)
}

/// Formats an estimated length with one or two digits.
#[wasm_bindgen(js_name = roughLength)]
pub fn rough_length(value: f64, units: &str) -> String {
    words::rough_length(value, units)
}

/// Formats lengths that are compared in a table.
#[wasm_bindgen(js_name = comparedLengths)]
pub fn compared_lengths(lengths: &[f64], units: &str) -> ComparedLengths {
    words::compared_lengths(lengths, units)
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

/// Returns the number of decimals for coordinates of a model of this size.
#[wasm_bindgen(js_name = decimalsFor)]
pub fn decimals_for(size: f64) -> usize {
    words::decimals_for(size)
}

/// Formats a coordinate, which may be edited.
#[wasm_bindgen]
pub fn coordinate(value: f64, decimals: usize) -> String {
    words::coordinate(value, decimals)
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

/// Returns an energy, or zero if it is a rounding error on a mesh of this `size`.
#[wasm_bindgen(js_name = energyOrZero)]
pub fn energy_or_zero(energy: f64, size: f64) -> f64 {
    words::energy_or_zero(energy, size)
}

/// Formats a fraction, from 0 to 1, in per cent.
#[wasm_bindgen]
pub fn part(share: f64) -> String {
    words::part(share)
}

/// Formats a signed fraction in per cent.
#[wasm_bindgen(js_name = signedPart)]
pub fn signed_part(share: f64) -> String {
    words::signed_part(share)
}

/// Formats a time in milliseconds.
#[wasm_bindgen]
pub fn duration(milliseconds: f64) -> String {
    words::duration(milliseconds)
}

/// Formats a ratio that is ideally 1.
#[wasm_bindgen]
pub fn ratio(value: f64) -> String {
    words::ratio(value)
}

/// Formats a power of ten, as at the ticks of a logarithmic axis.
#[wasm_bindgen(js_name = powerOfTen)]
pub fn power_of_ten(value: f64) -> String {
    words::power_of_ten(value)
}

/// Formats a number of bytes in megabytes, without the unit.
#[wasm_bindgen]
pub fn megabytes(bytes: f64) -> String {
    words::megabytes(bytes)
}

/// Formats a count with its noun; the plural has an s if it is not given.
#[wasm_bindgen]
pub fn count(count: usize, noun: &str, plural: Option<String>) -> String {
    let plural = plural.unwrap_or_else(|| format!("{noun}s"));
    words::count(count, noun, &plural)
}

/// Formats a whole number, from five digits on with thin spaces between thousands.
#[wasm_bindgen(js_name = groupDigits)]
pub fn group_digits(number: usize) -> String {
    words::group_digits(number)
}
