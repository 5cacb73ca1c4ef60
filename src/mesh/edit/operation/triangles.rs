//! Triangles from faces.

use super::declaration::{OperationError, Task};
use crate::math::{Vec3, twice_vector_area};
use crate::mesh::edit::origins::Edited;
use crate::mesh::edit::rebuild::Rebuild;

/// Quads are cut along the shorter diagonal that lies inside, larger faces become a fan around their middle.
pub(super) fn apply(task: &Task<'_>) -> Result<Edited, OperationError> {
    if task.topology.is_triangle_mesh() {
        return Err(OperationError::Expected("a face with more than three corners"));
    }
    let at = |v: u32| Vec3::from(task.mesh.positions[v as usize]);
    let mut rebuild = Rebuild::new(task.mesh);
    for (f, face) in (0..).zip(task.mesh.faces.iter()) {
        match *face {
            [_, _, _] => rebuild.face(face, &[f]),
            [a, b, c, d] => {
                let cuts = [[[a, b, c], [a, c, d]], [[b, c, d], [b, d, a]]];
                let normal = twice_vector_area(face.iter().map(|&v| at(v)));
                let bends = |[first, second]: [[u32; 3]; 2]| {
                    let normals = [first, second].map(|t| twice_vector_area(t.map(at)));
                    normals.iter().any(|n| n.dot(normal) < 0.0)
                };
                let [ac, bd] = [[a, c], [b, d]].map(|[p, q]| (at(q) - at(p)).length());
                let second = match cuts.map(bends) {
                    [true, false] => true,
                    [false, true] => false,
                    _ => bd < ac,
                };
                cuts[usize::from(second)].iter().for_each(|t| rebuild.face(t, &[f]));
            }
            _ => {
                let middle = rebuild.vertex(face);
                for side in crate::math::polygon_sides(face) {
                    rebuild.face(&[side[0], side[1], middle], &[f]);
                }
            }
        }
    }
    Ok(rebuild.finish())
}
