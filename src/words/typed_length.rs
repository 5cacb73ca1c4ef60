//! Lengths as people type them.

use super::units::LengthUnit;

/// A length that was typed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(all(target_arch = "wasm32", feature = "words"), wasm_bindgen::prelude::wasm_bindgen)]
pub struct TypedLength {
    /// Whether it is relative to the present value.
    pub by: bool,
    /// The length in the unit of the mesh.
    pub length: f64,
}

/// What was typed is no length, or no number where there is no unit.
#[derive(Clone, Debug, PartialEq)]
pub struct NotALength {
    text: String,
    expected: &'static str,
}

impl std::fmt::Display for NotALength {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "“{}” is not a {}. Expected 1.5, 1/3 or +0.5.", self.text, self.expected)
    }
}

impl std::error::Error for NotALength {}

impl TypedLength {
    /// Reads a length: `1.5`, `1,5`, `1e-3`, `1/3`, `20cm`; or a relative one, `+0.5` or `+-0.5`.
    /// `units` is the symbol of the unit of the mesh; empty if it is not known, or if a plain number
    /// is read.
    ///
    /// # Errors
    /// If it is no length.
    pub fn read(text: &str, units: &str) -> Result<TypedLength, NotALength> {
        let text = text.trim();
        let (by, signed) = match text.strip_prefix('+') {
            Some(rest) => (true, rest.trim_start()),
            None => (false, text),
        };
        let (sign, unsigned) =
            signed.strip_prefix(MINUS).map_or((1.0, signed), |rest| (-1.0, rest));
        let length = unsigned_length(unsigned, units).map(|length| sign * length);
        let length = length.filter(|length| length.is_finite());
        let expected = if units.is_empty() { "number" } else { "length" };
        let refused = || NotALength { text: text.to_owned(), expected };
        Ok(TypedLength { by, length: length.ok_or_else(refused)? })
    }
}

/// Reads a number, a divisor if any, and a unit if any.
fn unsigned_length(text: &str, units: &str) -> Option<f64> {
    let (value, rest) = number(text)?;
    let (divisor, rest) = match rest.trim_start().strip_prefix('/') {
        Some(rest) => number(rest.trim_start())?,
        None => (1.0, rest),
    };
    let metres = |symbol: &str| LengthUnit::of(symbol).map(|unit| unit.metres);
    let factor = match rest.trim_start() {
        "" => 1.0,
        unit => metres(&unit.to_ascii_lowercase())? / metres(units)?,
    };
    Some(value / divisor * factor)
}

/// The signs of negative numbers: as typed, and as the page writes it.
const MINUS: [char; 2] = ['-', '−'];

/// Reads the number at the start of a text, with a point or a comma, and spaces between groups of three
/// digits as [`group_digits`](super::group_digits) writes them, and returns what follows.
fn number(text: &str) -> Option<(f64, &str)> {
    let is_of_number = |c: char| c.is_ascii_digit() || c == '.' || c == ',';
    let mut end = 0;
    for (at, c) in text.char_indices() {
        let after = &text[at + c.len_utf8()..];
        let digits = after.find(|c: char| !c.is_ascii_digit()).unwrap_or(after.len());
        // Only before the point, and after one to three digits.
        let before = text[..at].rsplit(char::is_whitespace).next().unwrap_or_default();
        let is_whole = !text[..at].contains(['.', ',']) && (1..=3).contains(&before.len());
        let is_group = c.is_whitespace() && is_whole && digits == 3;
        if !is_of_number(c) && !is_group {
            break;
        }
        end = at + c.len_utf8();
    }
    let (number, rest) = text.split_at(end + exponent_length(&text[end..]));
    let plain: String = number.chars().filter(|c| !c.is_whitespace()).collect();
    Some((plain.replace(',', ".").replace(MINUS, "-").parse().ok()?, rest))
}

/// The length of the exponent at the start of a text; zero without one.
fn exponent_length(text: &str) -> usize {
    let Some(signed) = text.strip_prefix(['e', 'E']) else { return 0 };
    let digits = signed.strip_prefix(MINUS).or(signed.strip_prefix('+')).unwrap_or(signed);
    let rest = digits.trim_start_matches(|c: char| c.is_ascii_digit());
    if rest.len() == digits.len() { 0 } else { text.len() - rest.len() }
}
