//! Flipping faces.

use super::declaration::{OperationError, Task};
use crate::mesh::edit::origins::Edited;
use crate::mesh::edit::rebuild::Rebuild;
use crate::mesh::orientation;

pub(super) fn flip(task: &Task<'_>) -> Result<Edited, OperationError> {
    Ok(turned(task, &vec![true; task.mesh.faces.len()]))
}

/// Orients each component consistently, so that neighbours traverse their common edge in opposite
/// directions, by flipping as few faces as possible.
pub(super) fn unify(task: &Task<'_>) -> Result<Edited, OperationError> {
    let (is_turned, contradiction) = orientation(&task.mesh.faces, task.topology);
    if contradiction.is_some() {
        return Err(OperationError::Expected(
            "an orientable surface; this one is not, like a Moebius strip",
        ));
    }
    if !is_turned.contains(&true) {
        return Err(OperationError::Expected(
            "faces with opposite orientations; all are already oriented consistently",
        ));
    }
    Ok(turned(task, &is_turned))
}

/// Flips the given faces; a flipped face still begins at the same corner.
fn turned(task: &Task<'_>, is_turned: &[bool]) -> Edited {
    let mut rebuild = Rebuild::new(task.mesh);
    for ((f, face), turned) in (0..).zip(task.mesh.faces.iter()).zip(is_turned) {
        let mut corners = face.to_vec();
        if *turned {
            corners[1..].reverse();
        }
        rebuild.face(&corners, &[f]);
    }
    rebuild.finish()
}
