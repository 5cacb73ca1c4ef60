//! Declaration of a kind of new mesh, and the errors in its sizes.

use crate::generate::quads::TooManyFaces;
use crate::mesh::{Mesh, Size, SizeError};
use serde::Serialize;
use std::fmt;

/// A kind of new mesh. Hosts build their controls from it.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct NewKind {
    /// Identifier.
    pub id: &'static str,
    /// Display name.
    pub label: &'static str,
    /// Description in one sentence.
    pub summary: &'static str,
    /// Parameters, in the order of the values of [`NewKind::mesh`].
    pub sizes: &'static [Size],
    #[serde(skip)]
    pub(super) make: fn(&[f64]) -> Result<Mesh, NewMeshError>,
}

/// Why a mesh cannot be made.
#[derive(Clone, Debug, PartialEq)]
pub enum NewMeshError {
    /// A size is missing, or out of its limits.
    Size(SizeError),
    /// Two sizes contradict each other.
    Together {
        /// The condition that they violate.
        expected: &'static str,
    },
    /// Too many faces.
    TooManyFaces(TooManyFaces),
}

impl fmt::Display for NewMeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NewMeshError::Size(why) => why.fmt(f),
            NewMeshError::Together { expected } => write!(f, "expected {expected}"),
            NewMeshError::TooManyFaces(why) => why.fmt(f),
        }
    }
}

impl std::error::Error for NewMeshError {}

impl NewKind {
    /// The default values of its sizes.
    pub fn defaults(&self) -> Vec<f64> {
        self.sizes.iter().map(|size| size.default).collect()
    }

    /// The mesh with these sizes, given in the order of [`NewKind::sizes`].
    ///
    /// # Errors
    /// If a size is missing or out of its limits, two sizes contradict each other, or the mesh
    /// would have too many faces.
    pub fn mesh(&self, values: &[f64]) -> Result<Mesh, NewMeshError> {
        Size::check(self.sizes, values).map_err(NewMeshError::Size)?;
        (self.make)(values)
    }
}

/// The values of all sizes.
pub(super) fn exactly<const N: usize>(sizes: &[f64]) -> [f64; N] {
    sizes.try_into().expect("`Size::check` has counted them")
}
