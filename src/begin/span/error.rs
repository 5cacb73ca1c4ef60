//! Why there is no surface between curves.

use crate::begin::face_count::TooManyFaces;
use std::fmt;

/// Why there is no surface between curves.
#[derive(Clone, Debug, PartialEq)]
pub enum SpanError {
    /// There is no such curve.
    Missing {
        /// The index asked for, from 0.
        asked: usize,
        /// The number of curves.
        found: usize,
    },
    /// A curve without length.
    NoLength,
    /// Only one of two curves is closed.
    OneClosed,
    /// A closed curve was expected.
    Open,
    /// The two curves are the same.
    Same,
    /// A size of panels that is not a positive length.
    Size(f64),
    /// Too many faces.
    TooManyFaces(TooManyFaces),
    /// The surface inside the curve would be folded.
    Folded,
}

impl fmt::Display for SpanError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            SpanError::Missing { asked, found } => write!(
                f,
                "there is no curve {asked}: the file has {found} polylines and boundaries, counted from 0"
            ),
            SpanError::NoLength => f.write_str("the curve has no length"),
            SpanError::OneClosed => f.write_str(
                "one curve is closed and the other is open: expected both closed or both open",
            ),
            SpanError::Open => f.write_str("expected a closed curve or boundary"),
            SpanError::Same => f.write_str("expected two different curves"),
            SpanError::Size(found) => write!(f, "expected a panel size above 0, found {found}"),
            SpanError::TooManyFaces(why) => why.fmt(f),
            SpanError::Folded => f.write_str(
                "the surface would be folded: the curve turns back between its four corners",
            ),
        }
    }
}

impl std::error::Error for SpanError {}
