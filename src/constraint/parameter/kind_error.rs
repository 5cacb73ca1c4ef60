//! Why a kind with its parameters is refused.

use crate::json::JsonError;

/// Why [`Kind::new`](crate::constraint::Kind::new) gave none.
#[derive(Clone, Debug, PartialEq)]
pub enum KindError {
    /// No kind has that id.
    Unknown,
    /// A parameter is unknown, missing or out of type.
    Params {
        /// Where below the constraint, such as `scale[0]`.
        path: String,
        /// The fault, and what was expected instead.
        message: String,
    },
}

impl From<JsonError> for KindError {
    fn from(JsonError { path, message }: JsonError) -> KindError {
        KindError::Params { path, message }
    }
}
