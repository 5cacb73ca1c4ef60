//! Numbers without a unit, and angles.

/// Significant digits of measured values.
pub(super) const DIGITS: usize = 3;
/// Significant digits of entered values, at most.
const MOST_DIGITS: usize = 6;
/// Smaller and larger numbers are written as powers of ten.
const PLAIN: std::ops::Range<f64> = 1e-3..1e6;

/// Rounds to this many significant digits, in decimal, for numbers that somebody reads and may edit.
#[cfg_attr(all(target_arch = "wasm32", feature = "words"), wasm_bindgen::prelude::wasm_bindgen)]
pub fn rounded(value: f64, digits: usize) -> f64 {
    let size = format!("{:.*e}", digits.saturating_sub(1), half_up(value.abs()));
    size.parse().map_or(value, |size: f64| size.copysign(value))
}

/// Formats a measured number: `1.23`, `−0.500`, `12345`, `2.50e−7`; `–` if it is not finite.
#[cfg_attr(all(target_arch = "wasm32", feature = "words"), wasm_bindgen::prelude::wasm_bindgen)]
pub fn number(value: f64) -> String {
    let size = value.abs();
    let text = match size {
        0.0 => "0".to_owned(),
        _ if !size.is_finite() => return "–".to_owned(),
        _ if !PLAIN.contains(&size) => format!("{:.*e}", DIGITS - 1, half_up(size)),
        _ => significant(size, DIGITS),
    };
    signed(value, &text)
}

/// Formats an entered number as briefly as possible: `5`, `0.25`, `5e−6`.
#[cfg_attr(all(target_arch = "wasm32", feature = "words"), wasm_bindgen::prelude::wasm_bindgen)]
pub fn brief(value: f64) -> String {
    let text = format!("{:.*e}", MOST_DIGITS - 1, half_up(value.abs()));
    let size: f64 = text.parse().unwrap_or(value);
    let is_tiny = size != 0.0 && size < PLAIN.start;
    signed(value, &if is_tiny { format!("{size:e}") } else { size.to_string() })
}

/// Formats a fraction, from 0 to 1, in per cent: `0 %`, `less than 1 %`, `50 %`.
#[cfg_attr(all(target_arch = "wasm32", feature = "words"), wasm_bindgen::prelude::wasm_bindgen)]
pub fn part(share: f64) -> String {
    let percent = 100.0 * share;
    if percent > 0.0 && percent < 1.0 {
        "less than 1 %".to_owned()
    } else {
        format!("{} %", (percent + 0.5).floor())
    }
}

/// Formats a signed fraction in per cent: `+12.5 %`, `−3.0 %`, `0.0 %`.
#[cfg_attr(
    all(target_arch = "wasm32", feature = "words"),
    wasm_bindgen::prelude::wasm_bindgen(js_name = signedPart)
)]
pub fn signed_part(share: f64) -> String {
    with_plus(share, &decimal(100.0 * share.abs(), 1)) + " %"
}

/// Formats a time in milliseconds: `0.50 ms`, `12 ms`, `1234 ms`.
#[cfg_attr(all(target_arch = "wasm32", feature = "words"), wasm_bindgen::prelude::wasm_bindgen)]
pub fn duration(milliseconds: f64) -> String {
    let is_long = milliseconds >= 99.5;
    format!("{} ms", if is_long { decimal(milliseconds, 0) } else { significant(milliseconds, 2) })
}

/// Formats a ratio that is ideally 1: `1.0034`, `250`; `∞` if it has no bound.
#[cfg_attr(all(target_arch = "wasm32", feature = "words"), wasm_bindgen::prelude::wasm_bindgen)]
pub fn ratio(value: f64) -> String {
    match value {
        _ if value.is_infinite() => "∞".to_owned(),
        0.0..100.0 => decimal(value, 4),
        _ => number(value),
    }
}

/// Formats a power of ten, as at the ticks of a logarithmic axis: `1e−5`.
#[cfg_attr(
    all(target_arch = "wasm32", feature = "words"),
    wasm_bindgen::prelude::wasm_bindgen(js_name = powerOfTen)
)]
pub fn power_of_ten(value: f64) -> String {
    format!("{value:.0e}").replace('-', "−")
}

/// Formats a number of bytes in megabytes, without the unit: `1.2`.
#[cfg_attr(all(target_arch = "wasm32", feature = "words"), wasm_bindgen::prelude::wasm_bindgen)]
pub fn megabytes(bytes: f64) -> String {
    decimal(1e-6 * bytes, 1)
}

/// Formats a measured angle in degrees: `12.3°`; rounding errors are 0.
pub fn degrees(angle: f64) -> String {
    let angle = if angle.abs() < PLAIN.start { 0.0 } else { angle };
    number(angle) + "°"
}

/// Formats an angle in degrees, as precisely as a mean angle is read: `3.6°`, `49°`.
pub fn rough_degrees(angle: f64) -> String {
    let decimals = usize::from(angle.abs() < 9.95);
    signed(angle, &decimal(angle.abs(), decimals)) + "°"
}

/// Formats a size in [`PLAIN`] with this many significant digits, and all digits before the point.
fn significant(size: f64, digits: usize) -> String {
    let text = format!("{:.*e}", digits - 1, half_up(size));
    let exponent: i32 = text.split_once('e').and_then(|(_, at)| at.parse().ok()).unwrap_or(0);
    decimal(size, (digits as i32 - 1 - exponent).max(0) as usize)
}

/// The exponent of ten of the first digit of a size; 0 for zero.
pub(super) fn leading_exponent(size: f64) -> i32 {
    if size > 0.0 { size.log10().floor() as i32 } else { 0 }
}

/// Formats a number from 0 on with this many decimals.
pub fn decimal(size: f64, decimals: usize) -> String {
    format!("{:.decimals$}", half_up(size))
}

/// Adds the sign of `value` to its size in words; what is written as zero has none.
pub(super) fn signed(value: f64, size: &str) -> String {
    let sign = if value < 0.0 && !is_zero(size) { "−" } else { "" };
    format!("{sign}{}", size.replace('-', "−"))
}

/// As [`signed`], with a plus sign.
pub(super) fn with_plus(value: f64, size: &str) -> String {
    let sign = if value > 0.0 && !is_zero(size) { "+" } else { "" };
    sign.to_owned() + &signed(value, size)
}

/// Whether a number in words is zero.
pub(super) fn is_zero(number: &str) -> bool {
    !number.contains(|digit: char| ('1'..='9').contains(&digit))
}

/// Moves a size that lies in the middle of two decimal numbers up, as people round: the standard
/// library takes the even one.
fn half_up(size: f64) -> f64 {
    size * (1.0 + f64::EPSILON)
}
