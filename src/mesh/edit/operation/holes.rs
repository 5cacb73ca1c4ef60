//! Filling holes with faces.

use super::declaration::{OperationError, Task};
use crate::math::Vec3;
use crate::mesh::edit::origins::Edited;
use crate::mesh::edit::rebuild::Rebuild;

/// Closes the boundary loops with a picked vertex; without one, all but the longest, the outline.
pub(super) fn apply(task: &Task<'_>) -> Result<Edited, OperationError> {
    let Task { mesh, topology, .. } = task;
    let at = |v: u32| Vec3::from(mesh.positions[v as usize]);
    // An open chain, such as the rim of a wall on a floor, encloses no hole.
    let loops = topology.boundary_loops().iter().filter(|row| topology.is_closed_loop(row));
    let loops: Vec<&[u32]> = loops.collect();
    let is_picked = task.picked_vertices();
    let length = |corners: &[u32]| -> f64 {
        crate::math::polygon_sides(corners).map(|[a, b]| (at(b) - at(a)).length()).sum()
    };
    let outline = (0..loops.len())
        .max_by(|&i, &j| length(loops[i]).total_cmp(&length(loops[j])))
        .filter(|_| task.vertices.is_empty());
    let is_meant = |(i, corners): &(usize, &[u32])| {
        Some(*i) != outline && corners.iter().any(|&v| is_picked[v as usize])
    };
    let holes: Vec<&[u32]> =
        loops.iter().copied().enumerate().filter(is_meant).map(|(_, corners)| corners).collect();
    if holes.is_empty() {
        return Err(OperationError::Expected(if task.vertices.is_empty() {
            "a hole other than the outline; to close the outline, select one of its vertices"
        } else {
            "a selected vertex on a closed boundary"
        }));
    }
    let mut rebuild = Rebuild::new(mesh);
    rebuild.keep(task.all_faces())?;
    for corners in holes {
        // Boundary loops have the orientation of their faces, so the closing face is reversed.
        let closing: Vec<u32> = corners.iter().rev().copied().collect();
        rebuild.face(&closing, &[]);
    }
    Ok(rebuild.finish())
}
