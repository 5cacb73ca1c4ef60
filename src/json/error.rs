//! An error in a JSON document, with its JSON path.

use serde_json::Value;
use serde_json::error::Category;
use serde_path_to_error::{Path, Segment};
use std::fmt;

/// An error in a JSON document.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct JsonError {
    /// JSON path, such as `constraints[2].on.set`; empty for the whole document.
    pub(crate) path: String,
    /// What is wrong, and what was expected instead.
    pub(crate) message: String,
}

impl JsonError {
    pub(crate) fn new(path: impl Into<String>, message: impl Into<String>) -> JsonError {
        JsonError { path: path.into(), message: message.into() }
    }

    /// An error of the form "found ..., expected ...".
    pub(crate) fn found(value: &Value, expected: &str) -> JsonError {
        JsonError::new("", format!("found {}, expected {expected}", describe(value)))
    }

    pub(crate) fn unknown_key(key: &str, known: &[&str]) -> JsonError {
        JsonError::new("", format!("unknown key `{key}`, known here: {}", known.join(", ")))
    }

    pub(crate) fn missing_key(key: &str) -> JsonError {
        JsonError::new("", format!("`{key}` is missing"))
    }

    /// Returns this error with `step` prepended to its path.
    fn below(mut self, mut step: String) -> JsonError {
        if !(step.is_empty() || self.path.is_empty() || self.path.starts_with('[')) {
            step.push('.');
        }
        self.path.insert_str(0, &step);
        self
    }

    pub(crate) fn below_key(self, key: &str) -> JsonError {
        let mut step = String::new();
        push_key(&mut step, key);
        self.below(step)
    }

    pub(crate) fn below_index(self, index: usize) -> JsonError {
        self.below(format!("[{index}]"))
    }

    /// Translates an error of serde at `path` of a document.
    pub(super) fn of(path: &Path, error: &serde_json::Error) -> JsonError {
        let mut steps: Vec<&Segment> = path.iter().collect();
        let own = match error.classify() {
            Category::Data => of_data(&message(error)),
            _ => return JsonError::of_syntax(error),
        };
        // The place of an unknown key is the object that has it.
        let is_last =
            |key: &&str| matches!(steps.last(), Some(Segment::Map { key: last }) if last == key);
        if own.unknown().filter(is_last).is_some() {
            steps.pop();
        }
        let mut place = String::new();
        for step in steps {
            match step {
                Segment::Seq { index } => place.push_str(&format!("[{index}]")),
                Segment::Map { key } => push_key(&mut place, key),
                // The name of an enum's variant is no key of ours.
                Segment::Enum { .. } | Segment::Unknown => {}
            }
        }
        own.below(place)
    }

    pub(super) fn of_syntax(error: &serde_json::Error) -> JsonError {
        let (line, column, fault) = (error.line(), error.column(), message(error));
        let fault = match &*fault {
            "expected value" | "expected ident" => "expected a value".to_owned(),
            _ => fault.replacen("EOF while parsing ", "the text ends within ", 1),
        };
        JsonError::new("", format!("line {line}, column {column}: not JSON: {fault}"))
    }

    fn unknown(&self) -> Option<&str> {
        let rest = self.message.strip_prefix("unknown key `")?;
        rest.rsplit_once("`, known here: ").map(|(key, _)| key)
    }

    /// Returns the key that the object lacks, if that is the error.
    pub(crate) fn missing(&self) -> Option<&str> {
        self.message.strip_prefix('`')?.strip_suffix("` is missing")
    }
}

/// Delimits the path in the text of an error. Serde turns errors to text; the marks let
/// [`of_data`] recover the path. No path contains this character.
const MARK: char = '\u{1}';

impl fmt::Display for JsonError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{MARK}{}{MARK}{}", self.path, self.message)
    }
}

/// Returns the message of an error without its position.
fn message(error: &serde_json::Error) -> String {
    let text = error.to_string();
    let position = format!(" at line {} column {}", error.line(), error.column());
    text.strip_suffix(&position).unwrap_or(&text).to_owned()
}

/// Translates the message of a value that does not fit.
fn of_data(text: &str) -> JsonError {
    if let Some((path, message)) = text.strip_prefix(MARK).and_then(|rest| rest.split_once(MARK)) {
        return JsonError::new(path, message);
    }
    let after = |words: &str| text.strip_prefix(words);
    let message = if let Some(rest) = after("invalid type: ").or(after("invalid value: ")) {
        let (found, expected) = rest.rsplit_once(", expected ").unwrap_or((rest, "another value"));
        let (found, mut expected) = (plain_found(found), plain(expected));
        if expected == WHOLE && found.parse::<u64>().is_ok() {
            // Natively and in wasm: indices and numbers of elements are of 32 bits.
            expected = "a whole number up to 4294967295";
        }
        format!("found {found}, expected {expected}")
    } else if let Some(rest) = after("invalid length ") {
        format!("found an array of {rest}")
    } else if let Some(rest) = after("unknown field `") {
        let Some((key, known)) = rest.rsplit_once("`, expected ") else {
            // Where keys of another object are among them, serde does not say which are known.
            return JsonError::new("", format!("unknown key `{rest}"));
        };
        // Every second piece between backquotes is the name of a key.
        let known: Vec<&str> = known.split('`').skip(1).step_by(2).collect();
        return JsonError::unknown_key(key, &known);
    } else if let Some((word, known)) =
        after("unknown variant `").and_then(|rest| rest.split_once("`, expected "))
    {
        format!("found `{}`, expected {known}", shortened(word))
    } else if let Some(rest) = after("missing field `") {
        return JsonError::missing_key(rest.trim_end_matches('`'));
    } else if let Some(rest) = after("duplicate field `") {
        twice(rest.trim_end_matches('`'))
    } else {
        text.to_owned()
    };
    JsonError::new("", message)
}

pub(super) fn twice(key: &str) -> String {
    format!("the key `{key}` occurs twice")
}

/// Describes a value as serde names it.
fn plain_found(found: &str) -> String {
    match found {
        "sequence" => "an array".to_owned(),
        "map" => "an object".to_owned(),
        _ => match found.strip_prefix("string ") {
            Some(text) => shortened(text),
            None => found.split('`').nth(1).unwrap_or(found).to_owned(),
        },
    }
}

fn describe(value: &Value) -> String {
    match value {
        Value::String(text) => shortened(&format!("{text:?}")),
        Value::Array(items) => format!("an array of {}", items.len()),
        Value::Object(_) => "an object".to_owned(),
        plain => plain.to_string(),
    }
}

/// Shortens a text, which may be in quotes.
fn shortened(text: &str) -> String {
    let quote = if text.starts_with('"') { "\"" } else { "" };
    match text.char_indices().nth(41) {
        Some((end, _)) if end + 1 < text.len() => format!("{}{quote}...", &text[..end]),
        _ => text.to_owned(),
    }
}

/// What is expected where serde expects `u32`.
const WHOLE: &str = "a whole number, 0 or more";

/// Replaces the words of serde that name Rust types by plain ones.
fn plain(expected: &str) -> &str {
    match expected {
        "f64" => "a number",
        "u32" | "usize" => WHOLE,
        "a boolean" => "true or false",
        "a sequence" => "an array",
        "a map" => "an object",
        "map with a single key" => "an object with one key",
        "string or map" => "a word",
        _ if expected.starts_with("struct ") => "an object",
        _ => expected,
    }
}

/// Appends a key to a JSON path, in brackets and quotes unless it is a plain word.
pub(crate) fn push_key(path: &mut String, key: &str) {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if key.is_empty() || !key.chars().all(plain) {
        path.push_str(&format!("[{key:?}]"));
    } else {
        if !path.is_empty() {
            path.push('.');
        }
        path.push_str(key);
    }
}

#[cfg(test)]
mod tests {
    use crate::json::from_text;

    #[test]
    fn long_words_and_large_numbers_are_said_as_they_are() {
        #[derive(Debug, serde::Deserialize)]
        #[serde(rename_all = "kebab-case")]
        enum One {
            Only,
        }
        let word = "x".repeat(50);
        let said =
            from_text::<One>(&format!("\"{word}\"")).expect_err("it is another word").message;
        assert!(said.starts_with(&format!("found `{}...`, expected", &word[..41])), "{said}");
        let said = from_text::<u32>("5000000000").expect_err("it is too large").message;
        assert_eq!(said, "found 5000000000, expected a whole number up to 4294967295");
        let said = from_text::<u32>("-1").expect_err("it is negative").message;
        assert_eq!(said, "found -1, expected a whole number, 0 or more");
    }
}
