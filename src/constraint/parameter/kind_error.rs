//! Errors of a kind and its parameters.

use crate::json::JsonError;

/// The error of [`Kind::new`](crate::constraint::Kind::new).
#[derive(Clone, Debug, PartialEq)]
pub enum KindError {
    /// No kind has that id.
    Unknown,
    /// A parameter is unknown, missing or of the wrong type.
    Params {
        /// The JSON path below the constraint, such as `scale[0]`.
        path: String,
        /// The fault, and the expected value.
        message: String,
    },
}

impl From<JsonError> for KindError {
    fn from(JsonError { path, message }: JsonError) -> KindError {
        KindError::Params { path, message }
    }
}
