//! Lengths with their units.

use super::number::{
    DIGITS, brief, decimal, is_zero, leading_exponent, number, rounded, signed, with_plus,
};
use super::units::LengthUnit;

/// Lengths below this many mm are 0: they are irrelevant for buildings.
const LEAST_MM: f64 = 0.001;
/// Metres below this become millimetres.
const LEAST_M: f64 = 0.1;
/// Millimetres of a building from this on become metres.
const MOST_MM: f64 = 1e4;
/// Significant digits of the longest of lengths that are compared.
const COMPARED_DIGITS: usize = 5;
/// Resolution of coordinates relative to the model: millimetres for a building of some 100 m.
const STEPS: f64 = 2e5;
/// Lengths below this fraction of the size of a mesh are rounding errors: sixteen digits of a coordinate
/// leave errors of about 1e-16 of the size, and sums over the vertices somewhat more.
pub const ROUNDING: f64 = 1e-12;

/// Formats a measured length with its unit: `42.1 mm`, `2.00 m`, `0 mm`.
///
/// `value` is in the unit of the mesh, whose symbol is `units`; empty if it is not known.
pub fn length(value: f64, units: &str) -> String {
    length_like(value, units, value)
}

/// As [`length`], in the unit in which another length, `like`, is written: errors are written in
/// that of their tolerance. What would be a power of ten in metres is written in millimetres.
pub fn length_like(value: f64, units: &str, like: f64) -> String {
    let (unit, factor) = unit_of(like, units);
    match (unit, in_mm(value, units)) {
        (_, Some(size)) if size < LEAST_MM => format!("0 {unit}"),
        ("m" | "mm", Some(size)) if size < 1.0 => signed(value, &decimal(size, 3)) + " mm",
        _ => with_unit(&number(value * factor), unit),
    }
}

/// Formats an estimated length with one or two digits: `0.3 m`, `20 mm`, `15 mm`.
pub fn rough_length(value: f64, units: &str) -> String {
    let first = rounded(value, 1);
    let digits = if first > 0.0 && format!("{first:e}").starts_with('1') { 2 } else { 1 };
    limit(rounded(value, digits), units)
}

/// Formats a length that was entered, such as a tolerance: `5 mm`. As [`length`] otherwise.
#[cfg_attr(all(target_arch = "wasm32", feature = "words"), wasm_bindgen::prelude::wasm_bindgen)]
pub fn limit(value: f64, units: &str) -> String {
    limit_like(value, units, value)
}

/// As [`limit`], in the unit in which another length, `like`, is written.
pub fn limit_like(value: f64, units: &str, like: f64) -> String {
    let (unit, factor) = unit_of(like, units);
    with_unit(&brief(value * factor), unit)
}

/// Lengths that are compared, in words.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(
    all(target_arch = "wasm32", feature = "words"),
    wasm_bindgen::prelude::wasm_bindgen(getter_with_clone)
)]
pub struct ComparedLengths {
    /// The lengths, without their unit.
    pub lengths: Vec<String>,
    /// The symbol of their unit; empty if it is not known.
    pub unit: String,
}

/// Formats lengths that are compared in a table: all in one unit and with as many decimals, so that
/// the longest has at least five digits.
#[cfg_attr(
    all(target_arch = "wasm32", feature = "words"),
    wasm_bindgen::prelude::wasm_bindgen(js_name = comparedLengths)
)]
pub fn compared_lengths(lengths: &[f64], units: &str) -> ComparedLengths {
    let longest = lengths.iter().fold(0.0_f64, |longest, length| longest.max(length.abs()));
    let (unit, factor) = unit_of(longest, units);
    let decimals = decimals_of(longest * factor, COMPARED_DIGITS);
    let in_words = |length: &f64| signed(*length, &decimal(length.abs() * factor, decimals));
    ComparedLengths { lengths: lengths.iter().map(in_words).collect(), unit: unit.to_owned() }
}

/// The decimals with which a size has this many significant digits, at most twelve.
fn decimals_of(size: f64, digits: usize) -> usize {
    (digits as i32 - 1 - leading_exponent(size)).clamp(0, 12) as usize
}

/// Formats the components of a displacement: `x +0.20  z −1.50 m`, all with the decimals of the
/// longest, without those that are then zero. `size` is that of the mesh.
pub fn displacement(by: [f64; 3], units: &str, size: f64) -> String {
    let longest = by.iter().fold(0.0_f64, |longest, part| longest.max(part.abs()));
    let (unit, factor) = unit_of(longest, units);
    let decimals = decimals_of(longest * factor, DIGITS);
    let is_nothing = in_mm(longest, units).map_or(longest <= ROUNDING * size, |mm| mm < LEAST_MM);
    let parts: Vec<String> = ["x", "y", "z"]
        .into_iter()
        .zip(by.map(|part| with_plus(part, &decimal(part.abs() * factor, decimals))))
        .filter(|(_, part)| !is_nothing && !is_zero(part))
        .map(|(axis, part)| format!("{axis} {part}"))
        .collect();
    with_unit(if parts.is_empty() { "0".to_owned() } else { parts.join("  ") }.as_str(), unit)
}

/// Returns the number of decimals for coordinates of a model of this `size`: millimetres for a building
/// of some 100 m. Three without a size.
#[cfg_attr(
    all(target_arch = "wasm32", feature = "words"),
    wasm_bindgen::prelude::wasm_bindgen(js_name = decimalsFor)
)]
pub fn decimals_for(size: f64) -> usize {
    if size.is_nan() || size <= 0.0 {
        return 3;
    }
    (STEPS / size).log10().floor().clamp(0.0, 12.0) as usize
}

/// Formats a coordinate, which may be edited: with a hyphen for a minus sign, and no negative zero.
#[cfg_attr(all(target_arch = "wasm32", feature = "words"), wasm_bindgen::prelude::wasm_bindgen)]
pub fn coordinate(value: f64, decimals: usize) -> String {
    signed(value, &decimal(value.abs(), decimals)).replace('−', "-")
}

/// Formats a measured length of a building in mm; in metres from 10 m on.
pub fn millimetres(mm: f64) -> String {
    let (unit, factor) = unit_of_building(mm);
    length(mm * factor, unit)
}

/// Formats a length of a building that was entered, in mm; in metres from 10 m on.
pub fn millimetres_limit(mm: f64) -> String {
    let (unit, factor) = unit_of_building(mm);
    with_unit(&brief(mm * factor), unit)
}

/// Formats an area of a building, given in square mm, in square metres.
pub fn area(square_mm: f64) -> String {
    area_of(square_mm, "mm")
}

/// Formats the area of a surface: in square metres, or in the squared unit of a mesh in feet or
/// inches; without a unit if that is not known.
/// `area` is in the squared unit of the mesh, whose symbol is `units`.
#[cfg_attr(
    all(target_arch = "wasm32", feature = "words"),
    wasm_bindgen::prelude::wasm_bindgen(js_name = areaOf)
)]
pub fn area_of(area: f64, units: &str) -> String {
    match (units, LengthUnit::of(units)) {
        ("m" | "cm" | "mm", Some(unit)) => number_in(area * unit.metres * unit.metres, "m²"),
        (_, Some(unit)) => number_in(area, &format!("{}²", unit.symbol)),
        (_, None) => number(area),
    }
}

/// Formats a measured number with a unit, which is written after it.
#[cfg_attr(
    all(target_arch = "wasm32", feature = "words"),
    wasm_bindgen::prelude::wasm_bindgen(js_name = numberIn)
)]
pub fn number_in(value: f64, unit: &str) -> String {
    with_unit(&number(value), unit)
}

/// Formats a range of numbers with their unit, of which each end may be missing: `up to 5.00 m`,
/// `from 3.00 m`, `3.00 to 5.00 m`, `any`.
#[cfg_attr(
    all(target_arch = "wasm32", feature = "words"),
    wasm_bindgen::prelude::wasm_bindgen(js_name = rangeIn)
)]
pub fn range_in(from: Option<f64>, to: Option<f64>, unit: &str) -> String {
    match (from, to) {
        (None, None) => "any".to_owned(),
        (None, Some(to)) => format!("up to {}", number_in(to, unit)),
        (Some(from), None) => format!("from {}", number_in(from, unit)),
        (Some(from), Some(to)) => format!("{} to {}", number(from), number_in(to, unit)),
    }
}

/// Describes how far vertices moved, given the largest and the mean distance: `at most 0.21 m,
/// 0.05 m on average`; none if they did not move.
///
/// All lengths are in the unit of the mesh; `size` is that of the mesh.
pub fn moved(max: f64, mean: f64, units: &str, size: f64) -> Option<String> {
    let is_still = in_mm(max, units).map_or(max <= ROUNDING * size, |mm| mm < LEAST_MM);
    let words =
        || format!("at most {}, {} on average", length(max, units), length_like(mean, units, max));
    (!is_still).then(words)
}

/// The size of a length in mm; none if its unit is not known.
fn in_mm(value: f64, units: &str) -> Option<f64> {
    LengthUnit::of(units).map(|unit| 1000.0 * unit.metres * value.abs())
}

/// The unit in which a length of this size is written, and the factor to it.
pub(super) fn unit_of(size: f64, units: &str) -> (&str, f64) {
    if units == "m" && size.abs() < LEAST_M { ("mm", 1000.0) } else { (units, 1.0) }
}

fn unit_of_building(mm: f64) -> (&'static str, f64) {
    if mm.abs() < MOST_MM { ("mm", 1.0) } else { ("m", 1e-3) }
}

pub(super) fn with_unit(number: &str, unit: &str) -> String {
    let space = if matches!(unit, "" | "°") { "" } else { " " };
    format!("{number}{space}{unit}")
}
