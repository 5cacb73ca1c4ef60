//! Carries a scene over to a mesh derived from its own: its sets, constraints, handles, shapes, and the
//! seams of a paper model.
//!
//! A set of faces becomes the faces made only of them. A set of vertices also gets the new vertices
//! between its own; if all of its vertices are on the boundary, it is a curve and gets only
//! boundary vertices. A handle stays at its vertex and moves with it; new boundary vertices between
//! fixed neighbours are fixed too. Of several new vertices at the place of an old one, all are it.

use crate::constraint::{Element, Selector, describe, resolve};
use crate::math::marked;
use crate::mesh::{Edited, Origins, Point, Topology};
use crate::scene::{ConstraintSpec, Hold, Lock, MeshSource, Pose, Scene, ordered};
use crate::session::state::{RestMesh, resolve_row};
use crate::solve::Handle;
use crate::words;
use serde_json::Value;
use std::collections::BTreeSet;
use std::rc::Rc;

/// A scene carried over to another mesh.
pub(crate) struct Carried {
    /// The document without handles and positions.
    pub(crate) document: Scene,
    pub(crate) handles: Vec<Handle>,
    /// `#V by 3`.
    pub(crate) positions: Vec<Point>,
    /// A sentence for each thing that was not carried over, or whose meaning changed.
    pub(crate) lost: Vec<String>,
    /// What a lesson may lock, of what was not carried over.
    pub(crate) dropped: Vec<Lock>,
}

/// Carries a document with its handles and positions (`#V by 3`) from the mesh `before` to the mesh
/// `after`. `edited` was computed at the positions `from`, `#V by 3`.
pub(crate) fn carry(
    document: &Scene,
    (handles, positions): (&[Handle], &[Point]),
    before: &RestMesh,
    (edited, from): (&Edited, &[Point]),
    after: &RestMesh,
) -> Carried {
    let origins = &edited.origins;
    let moved = |state: &[Point]| edited.in_other_state(from, state);
    let (mut lost, mut dropped) = (Vec::new(), Vec::new());
    let now = moved(positions);
    let carried = carry_handles(handles, (positions, &now), before.topology(), (edited, from));
    let gone = handles.iter().filter(|handle| is_gone(handle.vertex, origins)).count();
    if gone > 0 {
        let handles = words::count(gone, "handle", "handles");
        lost.push(format!("Left out: {handles} on vertices that no longer exist."));
        dropped.push(Lock::Handles);
    }
    let joined = joined(handles, origins);
    if joined > 0 {
        let handles = words::count(joined, "handle", "handles");
        lost.push(format!(
            "Left out: {handles} on vertices that were joined to one with a handle."
        ));
        dropped.push(Lock::Handles);
    }
    let mut document = document.clone();
    // No file contains this mesh.
    document.mesh = MeshSource::default();
    // How the constraints were met says nothing about another mesh: it has the user's settings.
    document.as_asked();
    if let Some(Pose::Positions(pose)) = &mut document.pose {
        *pose = moved(pose).into();
    }
    for variant in &mut document.variants.kept {
        variant.positions = moved(&variant.positions).into();
    }
    document.sets.retain(|name, set| {
        set.vertices = carry_vertices(&set.vertices, before.topology(), (edited, from)).into();
        set.faces = carry_faces(&set.faces, origins).into();
        let is_left = !set.vertices.is_empty() || !set.faces.is_empty();
        if !is_left {
            lost.push(format!("Left out: the set {name}, which would be empty."));
            dropped.push(Lock::Constraints);
        }
        is_left
    });
    document.closeness.weights.retain_mut(|entry| {
        let on = describe(&entry.on);
        if let Selector::Vertices(vertices) = &mut entry.on {
            *vertices = carry_vertices(vertices, before.topology(), (edited, from)).into();
        }
        let found = resolve(&entry.on, after.mesh(), after.topology(), &document.sets);
        let is_left = found.is_ok_and(|found| !found.indices().is_empty());
        if !is_left {
            lost.push(format!("Left out: the closeness of {on}: none are left."));
            dropped.push(Lock::Weights);
        }
        is_left
    });
    if let Some(build) = &mut document.build {
        let (seams, gone) = carry_edges(&build.seams, origins, after.topology());
        build.seams = seams;
        if gone > 0 {
            let seams = words::count(gone, "seam", "seams");
            lost.push(format!(
                "Left out: {seams} of the paper model, along which there is no edge."
            ));
        }
    }
    let has_other_sizes = !(0.9..1.1).contains(&(after.mean_edge() / before.mean_edge()));
    let rows = std::mem::take(&mut document.constraints);
    for mut row in rows {
        let label = named(&row);
        let resolved = carry_row(&mut row, before.topology(), (edited, from)).and_then(|()| {
            let resolved = resolve_row(&row, &document, after.mesh(), after.topology());
            resolved.map_err(|why| why.to_string())
        });
        match resolved {
            Err(why) => {
                lost.push(format!("Left out: {label}: {why}."));
                dropped.push(Lock::Constraints);
            }
            Ok(_) => {
                if has_other_sizes && has_sizes_of_elements(&row) {
                    lost.push(format!(
                        "{label} keeps its given sizes, but its elements have a different size now."
                    ));
                }
                document.constraints.push(row);
            }
        }
    }
    Carried { document, handles: carried, positions: now, lost, dropped }
}

/// Carries over the vertices of a row.
///
/// # Errors
/// If one of them is gone and their number or order matters, or if all are gone.
fn carry_row(
    row: &mut ConstraintSpec,
    topology: &Topology,
    (edited, from): (&Edited, &[Point]),
) -> Result<(), String> {
    let info = row.kind.info();
    let Selector::Vertices(vertices) = &mut row.on else { return Ok(()) };
    let carried = carry_vertices(vertices, topology, (edited, from));
    // If their order matters, no vertices are added.
    if info.elements.is_empty() && info.arity.fits(carried.len()) {
        *vertices = carried.into();
        return Ok(());
    }
    let now = &edited.origins.vertices;
    let same: Option<Rc<[u32]>> = vertices.iter().map(|&v| now[v as usize]).collect();
    let same = same.ok_or("some of its vertices no longer exist")?;
    if same.iter().collect::<BTreeSet<_>>().len() < same.len() {
        return Err("some of its vertices were merged".to_owned());
    }
    *vertices = same;
    Ok(())
}

fn is_gone(vertex: u32, origins: &Origins) -> bool {
    origins.vertices[vertex as usize].is_none()
}

/// Returns the remaining vertices in their order, followed by the vertices between them, ascending.
fn carry_vertices(
    vertices: &[u32],
    topology: &Topology,
    (edited, from): (&Edited, &[Point]),
) -> Vec<u32> {
    let origins = &edited.origins;
    let has = marked(topology.neighbours().len(), vertices);
    let is_on_boundary = boundary_vertices(topology);
    let is_curve = vertices.iter().all(|&v| is_on_boundary[v as usize]);
    let mut is_known = known(origins);
    let mut carried = Vec::with_capacity(vertices.len());
    let mut is_in = vec![false; is_known.len()];
    for now in vertices.iter().filter_map(|&v| origins.vertices[v as usize]) {
        if !std::mem::replace(&mut is_in[now as usize], true) {
            carried.push(now);
        }
    }
    for (v, between) in (0..).zip(origins.between.iter()) {
        let all = between.iter().all(|&old| has[old as usize]);
        let is_new = !std::mem::replace(&mut is_known[v as usize], true);
        let on_curve = || on_boundary(between, topology) || at_old(v, edited, from).is_some();
        if is_new && all && (!is_curve || on_curve()) {
            carried.push(v);
        }
    }
    carried
}

/// Returns for each vertex of the new mesh whether it is an old one.
fn known(origins: &Origins) -> Vec<bool> {
    marked(origins.between.len(), origins.vertices.iter().flatten())
}

/// Returns the faces that were made only of `faces`, in the order of `faces`.
fn carry_faces(faces: &[u32], origins: &Origins) -> Vec<u32> {
    let last = origins.faces.indices().iter().chain(faces).max().copied().unwrap_or(0);
    let mut places = vec![usize::MAX; last as usize + 1];
    (0..faces.len()).rev().for_each(|place| places[faces[place] as usize] = place);
    let mut made = vec![Vec::new(); faces.len()];
    for (child, parents) in (0..).zip(origins.faces.iter()) {
        let of = || parents.iter().map(|&parent| places[parent as usize]);
        if let (Some(first), Some(0..usize::MAX)) = (of().min(), of().max()) {
            made[first].push(child);
        }
    }
    made.concat()
}

/// Returns the sides of faces along old edges, and the number of these along which there is none. An edge
/// that was divided becomes several; one whose ends were moved or merged stays what it was.
fn carry_edges(edges: &[[u32; 2]], origins: &Origins, after: &Topology) -> (Rc<[[u32; 2]]>, usize) {
    if edges.is_empty() {
        return (Rc::default(), 0);
    }
    // The old vertices that each new one is, if it is any; else the ends of the edge that it is on.
    let mut own: Vec<Vec<u32>> = vec![Vec::new(); origins.between.len()];
    for (old, now) in (0..).zip(&origins.vertices) {
        now.iter().for_each(|&now| own[now as usize].push(old));
    }
    let known: BTreeSet<[u32; 2]> = edges.iter().copied().map(ordered).collect();
    let between = |v: u32| origins.between.row(v as usize);
    let is_old = |v: u32| !own[v as usize].is_empty() || between(v).len() == 1;
    let olds = |v: u32| match &own[v as usize][..] {
        [] => between(v),
        own => own,
    };
    // The known old edges that a new one lies along: several where vertices were merged.
    let along = |&[p, q]: &[u32; 2]| -> Vec<[u32; 2]> {
        let [first, second] = if is_old(p) { [p, q] } else { [q, p] };
        if is_old(second) {
            let pairs = olds(p).iter().flat_map(|&a| olds(q).iter().map(move |&b| ordered([a, b])));
            return pairs.filter(|edge| known.contains(edge)).collect();
        }
        let Ok(edge) = <[u32; 2]>::try_from(between(second)) else { return Vec::new() };
        let is_on = match is_old(first) {
            true => olds(first).iter().any(|old| edge.contains(old)),
            false => between(first) == edge,
        };
        if is_on && known.contains(&edge) { vec![edge] } else { Vec::new() }
    };
    let sides = after.edges().iter().zip(after.edge_faces().iter());
    // Along the boundary there is nothing to cut.
    let sides = sides.filter(|(_, faces)| faces.len() > 1).map(|(ends, _)| ends);
    let found: Vec<([u32; 2], Vec<[u32; 2]>)> = sides.map(|ends| (*ends, along(ends))).collect();
    let left: BTreeSet<[u32; 2]> = found.iter().flat_map(|(_, old)| old).copied().collect();
    let found = found.into_iter().filter(|(_, old)| !old.is_empty());
    (found.map(|(now, _)| now).collect(), known.len() - left.len())
}

/// Number of handles on vertices that are now one with that of an earlier handle.
fn joined(handles: &[Handle], origins: &Origins) -> usize {
    let there = || handles.iter().filter_map(|it| origins.vertices[it.vertex as usize]);
    there().count() - there().collect::<BTreeSet<u32>>().len()
}

fn carry_handles(
    handles: &[Handle],
    (before, after): (&[Point], &[Point]),
    topology: &Topology,
    (edited, from): (&Edited, &[Point]),
) -> Vec<Handle> {
    let origins = &edited.origins;
    let mut has_handle = vec![false; after.len()];
    let mut of_old: Vec<Option<&Handle>> = vec![None; before.len()];
    let mut carried = Vec::with_capacity(handles.len());
    let at = |handle: &Handle, vertex: u32| {
        let (from, to) = (before[handle.vertex as usize], after[vertex as usize]);
        let target = std::array::from_fn(|i| {
            if handle.target[i] == from[i] { to[i] } else { handle.target[i] + (to[i] - from[i]) }
        });
        Handle { vertex, target, ..*handle }
    };
    for handle in handles {
        of_old[handle.vertex as usize] = Some(handle);
        let Some(vertex) = origins.vertices[handle.vertex as usize] else { continue };
        // If several handles are on one vertex, keep the first.
        if !std::mem::replace(&mut has_handle[vertex as usize], true) {
            carried.push(at(handle, vertex));
        }
    }
    let is_fixed =
        |&old: &u32| of_old[old as usize].is_some_and(|handle| handle.hold == Hold::Fixed);
    let is_known = known(origins);
    let new = (0..).zip(origins.between.iter()).filter(|(v, _)| !is_known[*v as usize]);
    for (vertex, between) in new {
        if let Some(old) = at_old(vertex, edited, from) {
            carried.extend(of_old[old as usize].map(|handle| at(handle, vertex)));
        } else if on_boundary(between, topology) && between.iter().all(is_fixed) {
            let target = after[vertex as usize];
            carried.push(Handle { vertex, target, hold: Hold::Fixed });
        }
    }
    carried
}

/// Returns the old vertex at whose place a vertex lies that was made of it alone.
fn at_old(vertex: u32, edited: &Edited, from: &[Point]) -> Option<u32> {
    match *edited.origins.between.row(vertex as usize) {
        [old] if edited.mesh.positions[vertex as usize] == from[old as usize] => Some(old),
        _ => None,
    }
}

/// Whether these are the two ends of an edge with fewer than two faces.
fn on_boundary(between: &[u32], topology: &Topology) -> bool {
    let &[a, b] = between else { return false };
    topology.edge(a, b).is_some_and(|e| topology.edge_faces().row(e as usize).len() < 2)
}

fn boundary_vertices(topology: &Topology) -> Vec<bool> {
    let mut is_on_boundary = vec![false; topology.neighbours().len()];
    for (ends, faces) in topology.edges().iter().zip(topology.edge_faces().iter()) {
        if faces.len() < 2 {
            ends.iter().for_each(|&v| is_on_boundary[v as usize] = true);
        }
    }
    is_on_boundary
}

/// Whether the row has a parameter in the unit of the mesh for elements whose size has changed.
fn has_sizes_of_elements(row: &ConstraintSpec) -> bool {
    let is_small = matches!(
        row.on,
        Selector::Each {
            element: Element::Face | Element::Edge | Element::Ring,
            radius: 0 | 1,
            ..
        }
    );
    let values = row.kind.params();
    let mut sizes =
        row.kind.info().params.iter().filter(|param| !matches!(param.unit, "" | "degrees"));
    is_small
        && sizes
            .any(|param| matches!(values.get(param.id), Some(Value::Number(_) | Value::Array(_))))
}

fn named(row: &ConstraintSpec) -> String {
    format!("{} on {}", row.label(), describe(&row.on))
}
