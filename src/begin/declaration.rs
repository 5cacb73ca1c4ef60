//! What a kind of mesh to begin with says of itself, and what sizes it refuses.

use crate::mesh::Mesh;
use serde::Serialize;
use std::fmt;

/// More faces are not made: what one begins with is coarse, and refined later.
pub(super) const MOST_FACES: f64 = 100_000.0;

/// A kind of mesh to begin with. Hosts build their controls from it.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct NewKind {
    /// The word for it.
    pub id: &'static str,
    /// Its name.
    pub label: &'static str,
    /// One sentence.
    pub summary: &'static str,
    /// What it is made by, in the order of the values of [`NewKind::mesh`].
    pub sizes: &'static [NewSize],
    #[serde(skip)]
    pub(super) make: fn(&[f64]) -> Result<Mesh, NewMeshError>,
}

/// What a size counts.
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

/// A size of a kind, from `least` to `most`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct NewSize {
    /// The word for it.
    pub id: &'static str,
    /// Its name.
    pub label: &'static str,
    /// What it counts.
    pub of: SizeOf,
    /// For a length, in metres.
    pub default: f64,
    /// The smallest that is taken.
    pub least: f64,
    /// The largest that is taken.
    pub most: f64,
}

/// Why a mesh cannot be made.
#[derive(Clone, Debug, PartialEq)]
pub enum NewMeshError {
    /// Another number of sizes than the kind has.
    Sizes {
        /// How many it has.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// A size is out of its limits, or is no whole number where it counts something.
    Outside {
        /// The size.
        size: NewSize,
        /// Its value.
        found: f64,
    },
    /// Two sizes do not go together.
    Together {
        /// What was expected of them.
        expected: &'static str,
    },
    /// More faces than are made, see the number.
    TooMany(f64),
}

impl fmt::Display for NewMeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NewMeshError::Sizes { expected, found } => {
                write!(f, "expected {expected} sizes, found {found}")
            }
            NewMeshError::Outside { size: NewSize { label, of, least, most, .. }, found } => {
                let number = match of {
                    SizeOf::Length => "a length",
                    SizeOf::Count => "a whole number",
                    SizeOf::Degrees => "an angle in degrees",
                };
                write!(f, "{label}: expected {number} from {least} to {most}, found {found}")
            }
            NewMeshError::Together { expected } => write!(f, "expected {expected}"),
            NewMeshError::TooMany(faces) => {
                write!(f, "that would be {faces:.0} faces, expected at most {MOST_FACES}")
            }
        }
    }
}

impl std::error::Error for NewMeshError {}

impl NewKind {
    /// The defaults of its sizes.
    pub fn defaults(&self) -> Vec<f64> {
        self.sizes.iter().map(|size| size.default).collect()
    }

    /// The mesh with these sizes, in the order of [`NewKind::sizes`].
    ///
    /// # Errors
    /// When a size is missing or out of its limits, two of them contradict each other, or there would be too
    /// many faces.
    pub fn mesh(&self, values: &[f64]) -> Result<Mesh, NewMeshError> {
        let (expected, found) = (self.sizes.len(), values.len());
        if expected != found {
            return Err(NewMeshError::Sizes { expected, found });
        }
        for (&size, &found) in self.sizes.iter().zip(values) {
            let inside = (size.least..=size.most).contains(&found);
            if !inside || size.of == SizeOf::Count && found.fract() != 0.0 {
                return Err(NewMeshError::Outside { size, found });
            }
        }
        (self.make)(values)
    }
}

/// Refuses more faces than are made.
pub(super) fn few(faces: f64) -> Result<(), NewMeshError> {
    if faces > MOST_FACES { Err(NewMeshError::TooMany(faces)) } else { Ok(()) }
}
