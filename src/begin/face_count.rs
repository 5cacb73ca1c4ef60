//! The limit of the number of faces.

use std::fmt;

/// Largest number of faces of a new mesh: it starts coarse and is refined later.
const MOST_FACES: f64 = 100_000.0;

/// A mesh would have too many faces; holds their number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TooManyFaces(pub f64);

impl fmt::Display for TooManyFaces {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "that would be {:.0} faces, expected at most {MOST_FACES}", self.0)
    }
}

impl std::error::Error for TooManyFaces {}

/// Fails if there would be too many faces.
pub(super) fn check_face_count(faces: f64) -> Result<(), TooManyFaces> {
    if faces > MOST_FACES { Err(TooManyFaces(faces)) } else { Ok(()) }
}
