//! Flipping faces.

use super::declaration::{OperationError, Task};
use crate::math::polygon_sides;
use crate::mesh::edit::origins::Edited;
use crate::mesh::edit::rebuild::Rebuild;

pub(super) fn flip(task: &Task<'_>) -> Result<Edited, OperationError> {
    Ok(turned(task, &vec![true; task.mesh.faces.len()]))
}

/// Orients each component consistently, so that neighbours traverse their common edge in opposite
/// directions, by flipping as few faces as possible.
pub(super) fn unify(task: &Task<'_>) -> Result<Edited, OperationError> {
    let Task { mesh, topology, .. } = task;
    let mut is_turned: Vec<Option<bool>> = vec![None; mesh.faces.len()];
    for start in 0..mesh.faces.len() {
        if is_turned[start].is_some() {
            continue;
        }
        is_turned[start] = Some(false);
        let mut piece = vec![start];
        let mut at = 0;
        while let Some(&face) = piece.get(at) {
            at += 1;
            let own = is_turned[face].unwrap_or(false);
            for [a, b] in polygon_sides(mesh.faces.row(face)) {
                let edge = topology.edge(a, b).expect("every side of a face is an edge");
                let &[f, g] = topology.edge_faces().row(edge as usize) else { continue };
                let other = if f as usize == face { g } else { f } as usize;
                let alike = topology.agreement(edge) < 0.0;
                match is_turned[other] {
                    None => {
                        is_turned[other] = Some(own != alike);
                        piece.push(other);
                    }
                    Some(turned) if turned != (own != alike) => {
                        return Err(OperationError::Expected(
                            "an orientable surface; this one is not, like a Moebius strip",
                        ));
                    }
                    Some(_) => {}
                }
            }
        }
        let over = piece.iter().filter(|&&face| is_turned[face] == Some(true)).count();
        if 2 * over > piece.len() {
            piece.iter().for_each(|&face| is_turned[face] = is_turned[face].map(|over| !over));
        }
    }
    let is_turned: Vec<bool> = is_turned.into_iter().map(|turned| turned == Some(true)).collect();
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
