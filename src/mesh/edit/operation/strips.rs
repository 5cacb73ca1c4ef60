//! Inserting and removing strips of quads.

use super::declaration::{OperationError, Task};
use crate::math::{marked, polygon_sides};
use crate::mesh::edit::origins::Edited;
use crate::mesh::edit::rebuild::Rebuild;
use crate::mesh::edit::sharp::Sharp;
use crate::mesh::edit::subdivide::KEPT_TURN;

const ENDS: &str = "an edge whose two ends are selected";

/// Splits the strips of quads across the picked edges lengthwise.
pub(super) fn insert(task: &Task<'_>) -> Result<Edited, OperationError> {
    let is_cut = crossed(task)?;
    let cut =
        |ends: [u32; 2]| task.topology.edge(ends[0], ends[1]).is_some_and(|e| is_cut[e as usize]);
    let mut rebuild = Rebuild::new(task.mesh);
    for (f, face) in (0..).zip(task.mesh.faces.iter()) {
        let sides: Vec<[u32; 2]> = polygon_sides(face).collect();
        let cuts: Vec<bool> = sides.iter().map(|&side| cut(side)).collect();
        match (face, &*cuts) {
            (&[a, b, c, d], [true, false, true, false]) => {
                let [m, n] = [[a, b], [c, d]].map(|ends| rebuild.middle(ends));
                rebuild.face(&[a, m, n, d], &[f]);
                rebuild.face(&[m, b, c, n], &[f]);
            }
            (&[a, b, c, d], [false, true, false, true]) => {
                let [m, n] = [[b, c], [d, a]].map(|ends| rebuild.middle(ends));
                rebuild.face(&[a, b, m, n], &[f]);
                rebuild.face(&[n, m, c, d], &[f]);
            }
            (&[a, b, c, d], [true, true, true, true]) => {
                let [ab, bc, cd, da] =
                    [[a, b], [b, c], [c, d], [d, a]].map(|ends| rebuild.middle(ends));
                let middle = rebuild.vertex(face);
                for corners in [
                    [a, ab, middle, da],
                    [ab, b, bc, middle],
                    [middle, bc, c, cd],
                    [da, middle, cd, d],
                ] {
                    rebuild.face(&corners, &[f]);
                }
            }
            _ => {
                // A strip ends at this face, which gets the new vertices as corners.
                let mut corners = Vec::with_capacity(face.len() + 1);
                for (&side, cut) in sides.iter().zip(cuts) {
                    corners.push(side[0]);
                    if cut {
                        corners.push(rebuild.middle(side));
                    }
                }
                rebuild.face(&corners, &[f]);
            }
        }
    }
    Ok(rebuild.finish())
}

/// Collapses the edges that the strips across the picked edges cross, each to its midpoint, or to
/// an end that is a corner or else on the boundary.
pub(super) fn remove(task: &Task<'_>) -> Result<Edited, OperationError> {
    let topology = task.topology;
    let is_crossed = crossed(task)?;
    let mut of_vertex = vec![u32::MAX; task.mesh.positions.len()];
    let mut parts: Vec<Vec<u32>> = Vec::new();
    for (&[a, b], _) in topology.edges().iter().zip(&is_crossed).filter(|(_, crossed)| **crossed) {
        let [of_a, of_b] = [a, b].map(|v| of_vertex[v as usize]);
        let (into, from) = match (of_a, of_b) {
            (u32::MAX, u32::MAX) => {
                parts.push(Vec::new());
                (parts.len() as u32 - 1, vec![a, b])
            }
            (part, u32::MAX) => (part, vec![b]),
            (u32::MAX, part) => (part, vec![a]),
            (one, other) if one == other => continue,
            (one, other) => (one, std::mem::take(&mut parts[other as usize])),
        };
        from.iter().for_each(|&v| of_vertex[v as usize] = into);
        parts[into as usize].extend(from);
    }
    let is_on_boundary = marked(task.mesh.positions.len(), topology.boundary_loops().indices());
    let sharp = Sharp::of(task.mesh, topology, KEPT_TURN);
    let mut rebuild = Rebuild::new(task.mesh);
    for part in parts.iter().filter(|part| !part.is_empty()) {
        let among = |is: &[bool]| -> Vec<u32> {
            part.iter().copied().filter(|&v| is[v as usize]).collect()
        };
        let outer = among(&is_on_boundary);
        let corners = among(&sharp.corners);
        let at = [&corners, &outer].into_iter().find(|some| !some.is_empty()).unwrap_or(part);
        rebuild.merge(part, at);
    }
    rebuild.keep(task.all_faces())?;
    Ok(rebuild.finish())
}

/// Returns for each edge whether a strip of quads across a picked edge crosses it.
fn crossed(task: &Task<'_>) -> Result<Vec<bool>, OperationError> {
    let Task { mesh, topology, .. } = task;
    let is_picked = task.picked_vertices();
    let edges = topology.edges();
    // A curve between the two has no strip.
    let both = |(e, ends): (u32, &[u32; 2])| {
        topology.is_of_body(e) && ends.iter().all(|&v| is_picked[v as usize])
    };
    let mut is_crossed: Vec<bool> = (0..).zip(edges).map(both).collect();
    let mut next: Vec<u32> =
        (0..).zip(&is_crossed).filter(|(_, picked)| **picked).map(|(e, _)| e).collect();
    if next.is_empty() {
        return Err(OperationError::Expected(ENDS));
    }
    while let Some(edge) = next.pop() {
        let ends = edges[edge as usize];
        for &face in topology.edge_faces().row(edge as usize) {
            let &[a, b, c, d] = mesh.faces.row(face as usize) else { continue };
            let opposite = [([a, b], [c, d]), ([b, c], [d, a]), ([c, d], [a, b]), ([d, a], [b, c])]
                .into_iter()
                .find(|(side, _)| *side == ends || [side[1], side[0]] == ends);
            let beyond = opposite.and_then(|(_, [p, q])| topology.edge(p, q));
            if let Some(e) = beyond.filter(|&e| !is_crossed[e as usize]) {
                is_crossed[e as usize] = true;
                next.push(e);
            }
        }
    }
    Ok(is_crossed)
}
