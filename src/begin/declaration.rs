//! The declaration of a kind of new mesh, and the errors of its sizes.

use crate::mesh::{Mesh, Size, SizeError};
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
    /// Its parameters, in the order of the values of [`NewKind::mesh`].
    pub sizes: &'static [Size],
    #[serde(skip)]
    pub(super) make: fn(&[f64]) -> Result<Mesh, NewMeshError>,
}

/// Why a mesh cannot be made.
#[derive(Clone, Debug, PartialEq)]
pub enum NewMeshError {
    /// A size is missing, or out of its limits.
    Size(SizeError),
    /// Two sizes do not go together.
    Together {
        /// The condition that they break.
        expected: &'static str,
    },
    /// More faces than are made, see the number.
    TooMany(f64),
}

impl fmt::Display for NewMeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NewMeshError::Size(why) => why.fmt(f),
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
        Size::check(self.sizes, values).map_err(NewMeshError::Size)?;
        (self.make)(values)
    }
}

/// Refuses more faces than are made.
pub(super) fn few(faces: f64) -> Result<(), NewMeshError> {
    if faces > MOST_FACES { Err(NewMeshError::TooMany(faces)) } else { Ok(()) }
}
