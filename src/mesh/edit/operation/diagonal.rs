//! Diagonal mesh: a quad for each edge.

use super::declaration::{OperationError, Task};
use crate::math::polygon_sides;
use crate::mesh::edit::origins::Edited;
use crate::mesh::edit::rebuild::Rebuild;

/// Builds Conway's join: a quad between the ends of each edge and the centres of its two faces. An
/// edge with one face, or with three or more, gets a triangle in each of its faces.
pub(super) fn apply(task: &Task<'_>) -> Result<Edited, OperationError> {
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
