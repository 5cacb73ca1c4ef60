//! Triangles from faces.

use std::collections::BTreeSet;

use super::declaration::{OperationError, Task};
use crate::math::{Vec3, twice_vector_area};
use crate::mesh::edit::origins::Edited;
use crate::mesh::edit::rebuild::Rebuild;

/// Cuts quads along the shorter diagonal that lies inside and is not yet an edge. If there is none,
/// and for faces with more corners, adds a fan around the centre.
pub(super) fn apply(task: &Task<'_>) -> Result<Edited, OperationError> {
    if task.topology.is_triangle_mesh() {
        return Err(OperationError::Expected("a face with more than three corners"));
    }
    let at = |v: u32| Vec3::from(task.mesh.positions[v as usize]);
    let mut rebuild = Rebuild::new(task.mesh);
    let mut diagonals = BTreeSet::new();
    for (f, face) in (0..).zip(task.mesh.faces.iter()) {
        let cut = match *face {
            [_, _, _] => {
                rebuild.face(face, &[f]);
                continue;
            }
            [a, b, c, d] => {
                let cuts = [[[a, b, c], [a, c, d]], [[b, c, d], [b, d, a]]];
                let normal = twice_vector_area(face.iter().map(|&v| at(v)));
                let bends = |[first, second]: [[u32; 3]; 2]| {
                    let normals = [first, second].map(|t| twice_vector_area(t.map(at)));
                    normals.iter().any(|n| n.dot(normal) < 0.0)
                };
                let [ac, bd] = [[a, c], [b, d]].map(|[p, q]| (at(q) - at(p)).length());
                let first = match cuts.map(bends) {
                    [true, false] => 1,
                    [false, true] => 0,
                    _ => usize::from(bd < ac),
                };
                // A second edge between the same vertices would join separate faces.
                let is_free = |&cut: &usize| {
                    let [p, q] = [[a, c], [b, d]][cut];
                    task.topology.edge(p, q).is_none() && diagonals.insert([p.min(q), p.max(q)])
                };
                [first, 1 - first].into_iter().find(is_free).map(|cut| cuts[cut])
            }
            _ => None,
        };
        match cut {
            Some(triangles) => triangles.iter().for_each(|t| rebuild.face(t, &[f])),
            None => {
                let middle = rebuild.vertex(face);
                for side in crate::math::polygon_sides(face) {
                    rebuild.face(&[side[0], side[1], middle], &[f]);
                }
            }
        }
    }
    Ok(rebuild.finish())
}
