//! An error in a JSON document, with its JSON path.

use super::tree::Tree;
use serde::de::{self, Unexpected};
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

    /// Returns this error with `step` prepended to its path.
    pub(crate) fn below(mut self, mut step: String) -> JsonError {
        if !(self.path.is_empty() || self.path.starts_with('[')) {
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

    pub(super) fn found(found: &str, expected: &str) -> JsonError {
        JsonError::new("", format!("found {found}, expected {}", plain(expected)))
    }

    pub(crate) fn unknown_key(key: &str, known: &[&str]) -> JsonError {
        JsonError::new("", format!("unknown key `{key}`, known here: {}", known.join(", ")))
    }

    /// Returns the key that the object lacks, if that is the error.
    pub(crate) fn missing_key(&self) -> Option<&str> {
        self.message.strip_prefix('`')?.strip_suffix("` is missing")
    }
}

/// Delimits the path in the text of an error. Serde converts the errors of `try_from` to text; the
/// marks let [`de::Error::custom`] recover the path. No path contains this character.
const MARK: char = '\u{1}';

impl fmt::Display for JsonError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{MARK}{}{MARK}{}", self.path, self.message)
    }
}

impl std::error::Error for JsonError {}

impl de::Error for JsonError {
    fn custom<T: fmt::Display>(message: T) -> JsonError {
        let text = message.to_string();
        match text.strip_prefix(MARK).and_then(|text| text.split_once(MARK)) {
            Some((path, message)) => JsonError::new(path, message),
            None => JsonError::new("", text),
        }
    }

    fn invalid_type(unexpected: Unexpected<'_>, expected: &dyn de::Expected) -> JsonError {
        let unexpected = match unexpected {
            Unexpected::Bool(value) => value.to_string(),
            Unexpected::Unsigned(value) => value.to_string(),
            Unexpected::Signed(value) => value.to_string(),
            Unexpected::Float(value) => value.to_string(),
            Unexpected::Str(value) => Tree::Text(value.to_owned()).describe(),
            Unexpected::Seq => "an array".to_owned(),
            Unexpected::Map => "an object".to_owned(),
            _ => "null".to_owned(),
        };
        JsonError::found(&unexpected, &expected.to_string())
    }

    fn invalid_value(unexpected: Unexpected<'_>, expected: &dyn de::Expected) -> JsonError {
        JsonError::invalid_type(unexpected, expected)
    }

    fn invalid_length(length: usize, expected: &dyn de::Expected) -> JsonError {
        let expected = expected.to_string();
        JsonError::new("", format!("found an array of {length}, expected {}", plain(&expected)))
    }

    fn unknown_field(key: &str, known: &'static [&'static str]) -> JsonError {
        JsonError::unknown_key(key, known)
    }

    fn missing_field(key: &'static str) -> JsonError {
        JsonError::new("", format!("`{key}` is missing"))
    }
}

/// An error of the form "found ..., expected ...".
pub(crate) fn found(value: impl Into<Tree>, expected: &str) -> JsonError {
    JsonError::found(&value.into().describe(), expected)
}

/// Replaces the serde messages that name Rust types by plain words.
fn plain(expected: &str) -> &str {
    match expected {
        "f64" => "a number",
        "u32" | "usize" => "a whole number, 0 or more",
        "a boolean" => "true or false",
        "a sequence" => "an array",
        "an array of length 3" => "a point [x, y, z]",
        "a map" => "an object",
        _ if expected.starts_with("struct ") => "an object",
        _ if expected.starts_with("enum ") => "a word",
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
