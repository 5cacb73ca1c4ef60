//! Meshes with a face for each vertex (the dual mesh), or a quad for each edge (the diagonal mesh).

use super::declaration::{OperationError, Task};
use crate::math::polygon_sides;
use crate::mesh::edit::origins::Edited;
use crate::mesh::edit::rebuild::{Rebuild, around};
use crate::mesh::edit::sharp::Sharp;
use crate::mesh::{Mesh, ProblemKind, elements_with_problem};

/// Builds the dual, with corners at face centres. The face of a boundary vertex also has the
/// midpoints of its boundary edges as corners, and the vertex if the boundary turns there by more
/// than the size.
pub(super) fn dual(task: &Task<'_>) -> Result<Edited, OperationError> {
    let Task { mesh, topology, .. } = task;
    let sharp = Sharp::of(mesh, topology, task.sizes[0]);
    let mut rebuild = Rebuild::new(mesh);
    let middles: Vec<u32> = mesh.faces.iter().map(|face| rebuild.vertex(face)).collect();
    for v in 0..mesh.positions.len() as u32 {
        if topology.vertex_faces().row(v as usize).is_empty() {
            continue;
        }
        let steps = around(mesh, topology, v).ok_or_else(|| refusal(mesh))?;
        let (Some(first), Some(last)) = (steps.first(), steps.last()) else { continue };
        let mut corners: Vec<u32> = steps.iter().map(|step| middles[step.face as usize]).collect();
        let is_open = first.out != last.back;
        if is_open {
            corners.insert(0, rebuild.middle([v, first.out]));
            corners.push(rebuild.middle([v, last.back]));
            // The vertex is also needed to have at least a triangle.
            if sharp.corners[v as usize] || corners.len() < 3 {
                corners.push(v);
            }
        }
        if corners.len() > 2 {
            let parents: Vec<u32> = steps.iter().map(|step| step.face).collect();
            rebuild.face(&corners, &parents);
        }
    }
    Ok(rebuild.finish())
}

/// Why the faces around some vertex have no cyclic order.
fn refusal(mesh: &Mesh) -> OperationError {
    let flipped = elements_with_problem(mesh, ProblemKind::FlippedNeighbour).edges;
    OperationError::Expected(if flipped.is_empty() {
        "one ring of faces around each vertex: some faces touch at a vertex only, or more than two at an edge"
    } else {
        "faces with consistent orientation: apply Unify orientation first"
    })
}

/// Builds Conway's join: a quad between the ends of each edge and the centres of its two faces. An
/// edge with one face, or with three or more, gets a triangle in each of its faces.
pub(super) fn diagonal(task: &Task<'_>) -> Result<Edited, OperationError> {
    let Task { mesh, topology, .. } = task;
    let mut rebuild = Rebuild::new(mesh);
    let middles: Vec<u32> = mesh.faces.iter().map(|face| rebuild.vertex(face)).collect();
    for (f, face) in (0..).zip(mesh.faces.iter()) {
        for side in polygon_sides(face) {
            let edge = topology.edge(side[0], side[1]).expect("every side of a face is an edge");
            let [a, b] = side;
            match *topology.edge_faces().row(edge as usize) {
                [first, second] if first != second => {
                    // Add the quad once, at the first of the two faces.
                    if first == f {
                        let corners = [a, middles[second as usize], b, middles[f as usize]];
                        rebuild.face(&corners, &[first, second]);
                    }
                }
                _ => rebuild.face(&[a, b, middles[f as usize]], &[f]),
            }
        }
    }
    Ok(rebuild.finish())
}
