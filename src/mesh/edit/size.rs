//! A number that a mesh is made by, or changed by: what it counts, and what is taken.

use serde::Serialize;
use std::fmt;

/// The quantity that a size measures.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub enum SizeOf {
    /// In the unit of the mesh.
    Length,
    /// A whole number.
    Count,
    /// An angle.
    Degrees,
}

/// A size, from `least` to `most`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Size {
    /// The word for it.
    pub id: &'static str,
    /// Its name.
    pub label: &'static str,
    /// The quantity.
    pub of: SizeOf,
    /// The default. Lengths are in metres for a new mesh, in mean edges for an edit.
    pub default: f64,
    /// The smallest that is taken.
    pub least: f64,
    /// The largest that is taken.
    pub most: f64,
}

/// A size that is not taken.
#[derive(Clone, Debug, PartialEq)]
pub enum SizeError {
    /// Another number of sizes than there are.
    Number {
        /// How many there are.
        expected: usize,
        /// How many were given.
        found: usize,
    },
    /// It is out of its limits, or is no whole number where it counts something.
    Outside {
        /// The size.
        size: Size,
        /// Its value.
        found: f64,
    },
}

impl fmt::Display for SizeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SizeError::Number { expected, found } => {
                write!(f, "expected {expected} sizes, found {found}")
            }
            SizeError::Outside { size: Size { label, of, least, most, .. }, found } => {
                let number = match of {
                    SizeOf::Length => "a length",
                    SizeOf::Count => "a whole number",
                    SizeOf::Degrees => "an angle in degrees",
                };
                write!(f, "{label}: expected {number} from {least} to {most}, found {found}")
            }
        }
    }
}

impl std::error::Error for SizeError {}

impl Size {
    /// Refuses `values` that are not those of `sizes`.
    ///
    /// # Errors
    /// When one is missing, or out of its limits.
    pub fn check(sizes: &[Size], values: &[f64]) -> Result<(), SizeError> {
        let (expected, found) = (sizes.len(), values.len());
        if expected != found {
            return Err(SizeError::Number { expected, found });
        }
        for (&size, &found) in sizes.iter().zip(values) {
            let inside = (size.least..=size.most).contains(&found);
            if !inside || size.of == SizeOf::Count && found.fract() != 0.0 {
                return Err(SizeError::Outside { size, found });
            }
        }
        Ok(())
    }
}
