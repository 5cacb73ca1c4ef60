//! Welding, joining, merging and snapping vertices.

use super::declaration::{OperationError, Task};
use crate::mesh::coincident::first_of_group;
use crate::mesh::edit::origins::Edited;
use crate::mesh::edit::rebuild::{Rebuild, Touching};
use crate::mesh::seams;
use std::collections::BTreeMap;

/// Welds each picked vertex to the first picked vertex within the size.
pub(super) fn weld(task: &Task<'_>) -> Result<Edited, OperationError> {
    let is_picked = task.picked_vertices();
    let first = first_of_group(task.mesh, |v| is_picked[v as usize].then_some(0), task.sizes[0]);
    let mut rebuild = Rebuild::new(task.mesh);
    let mut welds = 0;
    for (v, first) in (0..).zip(first) {
        if v != first {
            rebuild.merge(&[v, first], &[first]);
            welds += 1;
        }
    }
    if welds == 0 {
        return Err(OperationError::Expected("vertices within this distance of each other"));
    }
    let kept = rebuild.keep(task.all_faces());
    kept.map_err(|Touching(face)| OperationError::TouchingWithin(face))?;
    Ok(rebuild.finish())
}

/// Merges the boundary vertices that lie on each other at rest, at the mean of where they are now, as
/// far as a seam may have opened; if there are none, those that lie on each other now: see [`seams`].
pub(super) fn join(task: &Task<'_>) -> Result<Edited, OperationError> {
    let mut at_place: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    let at_rest = seams(&task.mesh.at(task.rest));
    let pairs = if at_rest.is_empty() { seams(task.mesh) } else { at_rest };
    for [v, first] in pairs {
        at_place.entry(first).or_insert_with(|| vec![first]).push(v);
    }
    if at_place.is_empty() {
        return Err(OperationError::Expected("boundary vertices that lie on each other"));
    }
    let mut rebuild = Rebuild::new(task.mesh);
    at_place.values().for_each(|vertices| rebuild.merge(vertices, vertices));
    rebuild.keep(task.all_faces())?;
    Ok(rebuild.finish())
}

/// Merges the picked vertices into one at their mean.
pub(super) fn merge(task: &Task<'_>) -> Result<Edited, OperationError> {
    if task.vertices.iter().all(|v| *v == task.vertices[0]) {
        return Err(OperationError::Expected("at least two selected vertices"));
    }
    let mut rebuild = Rebuild::new(task.mesh);
    rebuild.merge(task.vertices, task.vertices);
    rebuild.keep(task.all_faces())?;
    Ok(rebuild.finish())
}

/// Rounds the coordinates of the picked vertices to multiples of the size.
pub(super) fn snap(task: &Task<'_>) -> Result<Edited, OperationError> {
    let step = task.sizes[0];
    let is_picked = task.picked_vertices();
    let mut rebuild = Rebuild::new(task.mesh);
    for (v, at) in (0..).zip(&task.mesh.positions).filter(|(v, _)| is_picked[*v as usize]) {
        rebuild.place(v, at.map(|x| (x / step).round() * step));
    }
    rebuild.keep(task.all_faces())?;
    Ok(rebuild.finish())
}
