//! The mesh of the diagonals: a quad for each edge.

use super::declaration::{OperationError, Task};
use crate::math::polygon_sides;
use crate::mesh::edit::origins::Edited;
use crate::mesh::edit::rebuild::Rebuild;

/// Each quad is between the ends of an edge and the middles of its two faces: Conway's join. An edge with one face
/// has a triangle, one with three or more a triangle in each.
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
                    // The face that comes first makes it.
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
