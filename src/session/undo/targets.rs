//! The check of handle targets.

use crate::mesh::{LARGEST_COORDINATE, Point, first_out_of_range};
use crate::scene::SceneError;

/// Checks that the targets of these vertices are valid in a scene file.
///
/// # Errors
/// If the numbers of targets and vertices differ, or a target is not finite or too far out; the
/// error names its vertex.
pub fn check_targets(vertices: &[u32], targets: &[Point]) -> Result<(), SceneError> {
    let error = |message| Err(SceneError { path: "handles".to_owned(), message });
    if vertices.len() != targets.len() {
        let (found, expected) = (targets.len(), vertices.len());
        return error(format!(
            "found {found} targets, expected one for each of the {expected} vertices"
        ));
    }
    match first_out_of_range(targets) {
        None => Ok(()),
        Some(place) => error(format!(
            "the target of vertex {} is not finite or too far out, expected coordinates from -{LARGEST_COORDINATE:e} to {LARGEST_COORDINATE:e}",
            vertices[place]
        )),
    }
}
