//! Deleting, merging, splitting and flipping faces, and filling holes with faces.

use super::declaration::{OperationError, Task};
use crate::math::{Vec3, is_diagonal_inside, polygon_sides};
use crate::mesh::edit::origins::Edited;
use crate::mesh::edit::rebuild::Rebuild;
use crate::mesh::{Mesh, components, orientation};
use std::collections::BTreeMap;

pub(super) fn delete(task: &Task<'_>) -> Result<Edited, OperationError> {
    let is_picked = task.picked_faces();
    let mut rebuild = Rebuild::new(task.mesh);
    rebuild.keep(task.all_faces().filter(|&face| !is_picked[face as usize]))?;
    Ok(rebuild.finish())
}

/// Merges the picked faces into one face, at the index of the first of them.
pub(super) fn merge(task: &Task<'_>) -> Result<Edited, OperationError> {
    let mut picked = task.faces.to_vec();
    picked.sort_unstable();
    picked.dedup();
    let outline = outline(task, &picked).ok_or(OperationError::Expected(
        "at least two selected neighbouring faces, oriented consistently and without a hole between them",
    ))?;
    let mut rebuild = Rebuild::new(task.mesh);
    for face in task.all_faces() {
        if face == picked[0] {
            rebuild.face(&outline, &picked);
        } else if picked.binary_search(&face).is_err() {
            rebuild.keep(std::iter::once(face))?;
        }
    }
    Ok(rebuild.finish())
}

/// Returns the corners around the union of faces; `None` unless the union has a single outline.
fn outline(task: &Task<'_>, faces: &[u32]) -> Option<Vec<u32>> {
    let is_picked = task.picked_faces();
    let mut next = vec![u32::MAX; task.mesh.positions.len()];
    let mut count = 0;
    for &face in faces {
        for [a, b] in polygon_sides(task.mesh.faces.row(face as usize)) {
            let edge = task.topology.edge(a, b)?;
            let around = task.topology.edge_faces().row(edge as usize).iter();
            match around.filter(|&&other| is_picked[other as usize]).count() {
                1 if next[a as usize] == u32::MAX => next[a as usize] = b,
                // The edge is between two picked faces.
                2 => continue,
                _ => return None,
            }
            count += 1;
        }
    }
    let first = *task
        .mesh
        .faces
        .row(*faces.first()? as usize)
        .iter()
        .find(|&&v| next[v as usize] != u32::MAX)?;
    let mut corners = vec![first];
    while next[*corners.last()? as usize] != first {
        corners.push(next[*corners.last()? as usize]);
        if corners.len() > count || corners.last() == Some(&u32::MAX) {
            return None;
        }
    }
    (faces.len() > 1 && corners.len() == count && count > 2).then_some(corners)
}

/// Splits the face that has both picked vertices, which no edge of faces may connect, and the line
/// between them inside it.
pub(super) fn split(task: &Task<'_>) -> Result<Edited, OperationError> {
    let wrong = OperationError::Expected(
        "two selected corners of one face without an edge between them, and the line between them inside it",
    );
    let &[a, b] = task.vertices else { return Err(wrong) };
    let is_cut = |corners: &[u32]| {
        let ends = [a, b].map(|end| corners.iter().position(|&corner| corner == end));
        let (true, [Some(a), Some(b)]) = (task.topology.body_edge(a, b).is_none(), ends) else {
            return false;
        };
        let corners = corners.iter().map(|&v| Vec3::from(task.mesh.positions[v as usize]));
        a != b && is_diagonal_inside(&corners.collect::<Vec<_>>(), [a, b])
    };
    let cut = task.all_faces().find(|&face| is_cut(task.mesh.faces.row(face as usize)));
    let cut = cut.ok_or(wrong)?;
    let mut rebuild = Rebuild::new(task.mesh);
    for face in task.all_faces() {
        if face != cut {
            rebuild.keep(std::iter::once(face))?;
            continue;
        }
        let corners = task.mesh.faces.row(face as usize);
        let from = corners.iter().position(|corner| *corner == a).unwrap_or(0);
        let turned: Vec<u32> = corners[from..].iter().chain(&corners[..from]).copied().collect();
        let to = turned.iter().position(|corner| *corner == b).unwrap_or(0);
        rebuild.face(&turned[..=to], &[face]);
        let mut rest = turned[to..].to_vec();
        rest.push(a);
        rebuild.face(&rest, &[face]);
    }
    Ok(rebuild.finish())
}

/// Closes the boundary loops with a picked vertex; without one, all but the longest of each piece that is
/// connected over edges, its outline.
pub(super) fn fill_holes(task: &Task<'_>) -> Result<Edited, OperationError> {
    let (mesh, topology) = (task.mesh, task.whole_topology());
    let at = |v: u32| Vec3::from(mesh.positions[v as usize]);
    if topology.boundary_loops().is_empty() {
        return Err(OperationError::NoBoundary);
    }
    let face_at = |[a, b]: [u32; 2]| {
        let edge = topology.edge(a, b).expect("loops run along edges");
        topology.edge_faces().row(edge as usize)[0] as usize
    };
    // An open chain, such as the rim of a wall on a floor, encloses no hole.
    let loops = topology.boundary_loops().iter().filter(|row| topology.is_closed_loop(row));
    let loops: Vec<&[u32]> = loops.collect();
    let is_picked = task.picked_vertices();
    let length = |corners: &[u32]| -> f64 {
        polygon_sides(corners).map(|[a, b]| (at(b) - at(a)).length()).sum()
    };
    let pieces = components(mesh.all_faces().count(), topology.edge_faces().iter());
    let mut longest: BTreeMap<u32, (f64, usize)> = BTreeMap::new();
    for (i, corners) in loops.iter().enumerate().filter(|_| task.vertices.is_empty()) {
        let own = longest.entry(pieces[face_at([corners[0], corners[1]])]).or_insert((0.0, i));
        if length(corners) > own.0 {
            *own = (length(corners), i);
        }
    }
    let is_outline = |i: usize| longest.values().any(|(_, outline)| *outline == i);
    let is_meant = |(i, corners): &(usize, &&[u32])| {
        // A hole in a face that is left as it is stays too.
        let mut sides = polygon_sides(corners);
        !is_outline(*i)
            && sides.any(|side| face_at(side) < mesh.faces.len())
            && corners.iter().any(|&v| is_picked[v as usize])
    };
    let holes: Vec<&[u32]> =
        loops.iter().enumerate().filter(is_meant).map(|(_, corners)| *corners).collect();
    if holes.is_empty() {
        return Err(OperationError::Expected(if task.vertices.is_empty() {
            "a hole other than the outline of a piece; to close the outline, select one of its vertices"
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

pub(super) fn flip(task: &Task<'_>) -> Result<Edited, OperationError> {
    Ok(turned(task, &vec![true; task.mesh.all_faces().count()]))
}

/// Orients each component consistently, so that neighbours traverse their common edge in opposite
/// directions, by flipping as few faces as possible.
pub(super) fn unify(task: &Task<'_>) -> Result<Edited, OperationError> {
    let all = task.mesh.all_faces().collect();
    let (is_turned, contradictions) = orientation(&all, &task.whole_topology());
    if !contradictions.is_empty() {
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

/// Flips the given faces, of all and those that are left as they are; a flipped face still begins at the
/// same corner.
fn turned(task: &Task<'_>, is_turned: &[bool]) -> Edited {
    let mut rows = task.mesh.all_faces().zip(is_turned).map(|(face, turned)| {
        let mut corners = face.to_vec();
        if *turned {
            corners[1..].reverse();
        }
        corners
    });
    let mut rebuild = Rebuild::new(task.mesh);
    task.all_faces().zip(&mut rows).for_each(|(face, corners)| rebuild.face(&corners, &[face]));
    // All vertices keep their numbers.
    let untouched = rows.collect();
    let Edited { mesh, origins } = rebuild.finish();
    Edited { mesh: Mesh { untouched, ..mesh }, origins }
}
