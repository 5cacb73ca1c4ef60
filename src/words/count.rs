//! Counts with their nouns, lists, and sentences.

/// Formats a count with its noun: `1 vertex`, `12 vertices`.
pub fn count(count: usize, one: &str, many: &str) -> String {
    format!("{} {}", group_digits(count), if count == 1 { one } else { many })
}

/// The verb of a count: `is`, `are`.
pub fn is_or_are(count: usize) -> &'static str {
    if count == 1 { "is" } else { "are" }
}

/// Formats a whole number, from five digits on with thin spaces between thousands.
#[cfg_attr(
    all(target_arch = "wasm32", feature = "words"),
    wasm_bindgen::prelude::wasm_bindgen(js_name = groupDigits)
)]
pub fn group_digits(number: usize) -> String {
    let digits = number.to_string();
    if digits.len() < 5 {
        return digits;
    }
    let mut grouped = String::new();
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            grouped.push('\u{2009}');
        }
        grouped.push(digit);
    }
    grouped
}

/// Lists at most `most` names, and the number of the others: `A, B and 3 more`.
pub fn and_more(names: &[String], most: usize) -> String {
    let named = names[..names.len().min(most)].join(", ");
    match names.len().saturating_sub(most) {
        0 => named,
        more => format!("{named} and {} more", group_digits(more)),
    }
}

/// Returns the words with their first letter in upper case, if it is ASCII.
pub fn sentence(words: &str) -> String {
    let mut words = words.to_owned();
    if let Some(first) = words.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    words
}
