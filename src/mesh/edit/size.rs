//! Numeric parameters of new meshes and of operations: quantity, default and range.

use serde::Serialize;
use std::fmt;

/// The quantity that a size measures.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub enum SizeOf {
    /// A length in the unit of the mesh.
    Length,
    /// A whole number.
    Count,
    /// An angle in degrees.
    Degrees,
}

/// A numeric parameter from `least` to `most`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct Size {
    /// Identifier.
    pub id: &'static str,
    /// Name shown to the user.
    pub label: &'static str,
    /// The quantity.
    pub of: SizeOf,
    /// The default. Lengths are in metres for a new mesh, in mean edge lengths for an edit.
    pub default: f64,
    /// The least accepted value.
    pub least: f64,
    /// The largest accepted value.
    pub most: f64,
}

/// Reason why sizes are rejected.
#[derive(Clone, Debug, PartialEq)]
pub enum SizeError {
    /// The wrong number of sizes.
    Number {
        /// Number of declared sizes.
        expected: usize,
        /// Number of values given.
        found: usize,
    },
    /// A value is out of range, or is a count that is not a whole number.
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
                // Limits that are those of all coordinates would have fifty digits.
                let limit = |x: &f64| match x.abs() {
                    0.0 | 1e-12..=1e12 => x.to_string(),
                    _ => format!("{x:e}"),
                };
                let [least, most] = [least, most].map(limit);
                write!(f, "{label}: expected {number} from {least} to {most}, found {found}")
            }
        }
    }
}

impl std::error::Error for SizeError {}

impl Size {
    /// A length in the unit of the mesh.
    pub(crate) const fn length(
        id: &'static str,
        label: &'static str,
        default: f64,
        [least, most]: [f64; 2],
    ) -> Size {
        Size { id, label, of: SizeOf::Length, default, least, most }
    }

    /// An angle in degrees.
    pub(crate) const fn degrees(
        id: &'static str,
        label: &'static str,
        default: f64,
        [least, most]: [f64; 2],
    ) -> Size {
        Size { id, label, of: SizeOf::Degrees, default, least, most }
    }

    /// Checks `values` against the declared `sizes`.
    ///
    /// # Errors
    /// If their number is wrong, or a value is out of range.
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
