//! Handles as listed in a scene, and as stored in the solver.

use crate::mesh::Point;
use crate::scene::{HandleSpec, Hold};
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
