//! Handles as listed in a scene, and as stored in the solver; the check of their targets.

use crate::mesh::{LARGEST_COORDINATE, Point, first_out_of_range};
use crate::scene::{HandleSpec, Hold, SceneError};
use crate::solve::Handle;

/// Returns one handle per vertex.
pub(crate) fn flat(specs: &[HandleSpec], rest: &[Point]) -> Vec<Handle> {
    let mut handles = Vec::new();
    for spec in specs {
        for (k, &vertex) in spec.vertices.iter().enumerate() {
            let target = spec.targets.as_ref().map_or(rest[vertex as usize], |targets| targets[k]);
            handles.push(Handle { vertex, target, hold: spec.hold });
        }
    }
    handles
}

/// Groups consecutive handles with the same hold, as in the scene file.
pub(crate) fn grouped(handles: &[Handle]) -> Vec<HandleSpec> {
    let alike = |a: &Handle, b: &Handle| match (a.hold, b.hold) {
        (Hold::Fixed, Hold::Fixed) => true,
        (Hold::Soft { weight: a }, Hold::Soft { weight: b }) => a == b,
        _ => false,
    };
    handles
        .chunk_by(alike)
        .map(|run| HandleSpec {
            vertices: run.iter().map(|handle| handle.vertex).collect(),
            targets: Some(run.iter().map(|handle| handle.target).collect()),
            hold: run[0].hold,
        })
        .collect()
}

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
