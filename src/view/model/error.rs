//! Why data from outside cannot be shown.

use std::fmt;

/// Why arrays from outside cannot be shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ViewError {
    /// No line of the model is in the picture.
    NoLine,
    /// The length of an array does not match the others.
    Length {
        /// Which array.
        what: &'static str,
        /// Its actual number of entries.
        got: usize,
        /// The expected number.
        expected: usize,
    },
    /// Row offsets that do not start at 0, decrease, or do not end at the number of indices.
    Offsets {
        /// Which rows: faces or curves.
        what: &'static str,
        /// The index of the wrong offset.
        row: usize,
    },
    /// An index out of range.
    Index {
        /// Which array.
        what: &'static str,
        /// The index.
        index: u32,
        /// The number of elements, which the index must be below.
        count: usize,
    },
    /// A coordinate that is not finite.
    NotFinite {
        /// The vertex with this coordinate.
        vertex: usize,
    },
    /// An unknown word.
    Word {
        /// What the word selects.
        what: &'static str,
        /// The given word.
        got: String,
        /// The known words.
        known: &'static str,
    },
}

impl fmt::Display for ViewError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ViewError::NoLine => write!(f, "No line of the model is in the picture."),
            ViewError::Length { what, got, expected } => {
                write!(f, "{what}: {got} entries, expected {expected}")
            }
            ViewError::Offsets { what, row } => write!(
                f,
                "{what}: offset {row} is wrong: expected offsets that start at 0, never decrease and \
                 end at the number of indices"
            ),
            ViewError::Index { what, index, count } => {
                write!(f, "{what}: found {index}, expected an index below {count}")
            }
            ViewError::NotFinite { vertex } => {
                write!(f, "vertex {vertex} has a coordinate that is not finite")
            }
            ViewError::Word { what, got, known } => {
                write!(f, "{what}: \"{got}\", expected {known}")
            }
        }
    }
}

impl std::error::Error for ViewError {}
