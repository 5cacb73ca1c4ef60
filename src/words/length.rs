//! Lengths with their units.

use super::number::{brief, decimal, number, rounded, signed};

/// Lengths below this many mm are 0: they are irrelevant for buildings.
const LEAST_MM: f64 = 0.001;
/// Metres below this become millimetres.
const LEAST_M: f64 = 0.1;
/// Millimetres of a building from this on become metres.
const MOST_MM: f64 = 1e4;
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
        ("m" | "mm", Some(size)) if size < LEAST_MM => format!("0 {unit}"),
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
pub fn limit(value: f64, units: &str) -> String {
    limit_like(value, units, value)
}

/// As [`limit`], in the unit in which another length, `like`, is written.
pub fn limit_like(value: f64, units: &str, like: f64) -> String {
    let (unit, factor) = unit_of(like, units);
    with_unit(&brief(value * factor), unit)
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
    number(1e-6 * square_mm) + " m²"
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

/// The size of a length in mm; none if its unit is neither metres nor millimetres.
fn in_mm(value: f64, units: &str) -> Option<f64> {
    match units {
        "m" => Some(1000.0 * value.abs()),
        "mm" => Some(value.abs()),
        _ => None,
    }
}

/// The unit in which a length of this size is written, and the factor to it.
fn unit_of(size: f64, units: &str) -> (&str, f64) {
    if units == "m" && size.abs() < LEAST_M { ("mm", 1000.0) } else { (units, 1.0) }
}

fn unit_of_building(mm: f64) -> (&'static str, f64) {
    if mm.abs() < MOST_MM { ("mm", 1.0) } else { ("m", 1e-3) }
}

fn with_unit(number: &str, unit: &str) -> String {
    format!("{number} {unit}").trim_end().to_owned()
}
