//! JSON by `serde_json`, with errors in our words: path, value found, value expected.
//!
//! Types derive serde's traits; what the derived code does not refuse by itself is in `shape`.
//!
//! | file | holds |
//! |---|---|
//! | `error` | an error with its JSON path, from the errors of serde |
//! | `shape` | repeated keys, only an object, only a word, a word or an object, points |
//! | `indices` | lists of indices: arrays, or strings of ranges |
//! | `pairs` | lists of pairs of indices |

mod error;
pub(crate) mod indices;
pub(crate) mod pairs;
mod shape;

pub(crate) use error::{JsonError, push_key};
pub(crate) use shape::{
    Either, Entries, Object, SplitKeys, Words, fixed, lists_of_objects, object, object_or_none,
    objects, points, present, word, word_or, word_or_null,
};

use serde::de::DeserializeOwned;
use serde_json::Value;

/// Reads a document, with or without a leading byte order mark.
///
/// # Errors
/// Text that is not JSON, with line and column, or a value that does not fit, with its path.
pub(crate) fn from_text<T: DeserializeOwned>(text: &str) -> Result<T, JsonError> {
    indices::begin();
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut reader = serde_json::Deserializer::from_str(text);
    let value = serde_path_to_error::deserialize(&mut reader)
        .map_err(|error| JsonError::of(error.path(), error.inner()))?;
    reader.end().map_err(|error| JsonError::of_syntax(&error))?;
    Ok(value)
}

/// Reads a value that has been parsed; the path of an error is relative to it.
pub(crate) fn from_value<T: DeserializeOwned>(value: Value) -> Result<T, JsonError> {
    serde_path_to_error::deserialize(value)
        .map_err(|error| JsonError::of(error.path(), error.inner()))
}
