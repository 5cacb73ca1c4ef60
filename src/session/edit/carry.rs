//! A scene carried over to a mesh that was made from its own: its sets, constraints, handles and shapes.
//!
//! A set of faces becomes the faces made of them; a set of vertices also gets those between its vertices. Where all of
//! these are on the boundary, it is a curve and gets the vertices on the boundary only. A handle stays at its vertex
//! and moves along with it; between fixed neighbours on the boundary the new vertices are fixed too.

use crate::constraint::{Element, Selector, describe};
use crate::mesh::{Origins, Point, Topology};
use crate::scene::{ConstraintSpec, Hold, MeshSource, Pose, Scene};
use crate::session::state::{RestMesh, resolve_row};
use crate::solve::Handle;
use serde_json::Value;

/// A scene on another mesh.
pub(crate) struct Carried {
    /// Without handles and positions.
    pub(crate) document: Scene,
    pub(crate) handles: Vec<Handle>,
    /// `#V by 3`.
    pub(crate) positions: Vec<Point>,
    /// What could not be carried over, or means something else now: a sentence each.
    pub(crate) lost: Vec<String>,
}

/// Carries a document with its handles and positions (`#V by 3`) from the mesh `before` to the mesh `after`.
pub(crate) fn carry(
    document: &Scene,
    (handles, positions): (&[Handle], &[Point]),
    before: &RestMesh,
    origins: &Origins,
    after: &RestMesh,
) -> Carried {
    let moved = origins.positions.apply(positions);
    let handles = carry_handles(handles, (positions, &moved), before.topology(), origins);
    let mut document = document.clone();
    // The mesh is in no file any more.
    document.mesh = MeshSource::Inline(Box::default());
    if let Some(Pose::Positions(pose)) = &mut document.pose {
        *pose = origins.positions.apply(pose).into();
    }
    for variant in &mut document.variants.kept {
        variant.positions = origins.positions.apply(&variant.positions).into();
    }
    for set in document.sets.values_mut() {
        set.vertices = carry_vertices(&set.vertices, before.topology(), origins);
        set.faces = carry_faces(&set.faces, origins);
    }
    let on_vertices = |on: &mut Selector, takes: &dyn Fn(usize) -> bool| {
        if let Selector::Vertices(vertices) = on {
            let all = carry_vertices(vertices, before.topology(), origins);
            if takes(all.len()) {
                *vertices = all;
            }
        }
    };
    for row in &mut document.constraints {
        let info = row.kind.info();
        // Where their order means something, they stay those that they are.
        on_vertices(&mut row.on, &|count| info.elements.is_empty() && info.arity.fits(count));
    }
    document.closeness.weights.iter_mut().for_each(|entry| on_vertices(&mut entry.on, &|_| true));
    let mut lost = Vec::new();
    let rows = std::mem::take(&mut document.constraints);
    for row in rows {
        match resolve_row(&row, &document, after.mesh(), after.topology()) {
            Err(why) => lost.push(format!("Left out: {}: {why}.", named(&row))),
            Ok(_) => {
                if has_sizes_of_elements(&row) {
                    lost.push(format!(
                        "{} keeps its sizes; its elements are smaller.",
                        named(&row)
                    ));
                }
                document.constraints.push(row);
            }
        }
    }
    Carried { document, handles, positions: moved, lost }
}

/// The vertices with those between them, ascending behind them.
fn carry_vertices(vertices: &[u32], topology: &Topology, origins: &Origins) -> Vec<u32> {
    let mut has = vec![false; topology.neighbours().len()];
    vertices.iter().for_each(|&v| has[v as usize] = true);
    let is_on_boundary = boundary_vertices(topology);
    let is_curve = vertices.iter().all(|&v| is_on_boundary[v as usize]);
    let mut carried = vertices.to_vec();
    for (v, between) in (0..).zip(origins.between.iter()).skip(has.len()) {
        let all = between.iter().all(|&old| has[old as usize]);
        if all && (!is_curve || on_boundary(between, topology)) {
            carried.push(v);
        }
    }
    carried
}

/// The faces that were made of `faces`, in the order of these.
fn carry_faces(faces: &[u32], origins: &Origins) -> Vec<u32> {
    if faces.is_empty() {
        return Vec::new();
    }
    let last = origins.faces.iter().max().copied().unwrap_or(0);
    let mut children = vec![Vec::new(); last as usize + 1];
    (0..).zip(&origins.faces).for_each(|(child, &face)| children[face as usize].push(child));
    faces.iter().flat_map(|&face| children[face as usize].iter().copied()).collect()
}

fn carry_handles(
    handles: &[Handle],
    (before, after): (&[Point], &[Point]),
    topology: &Topology,
    origins: &Origins,
) -> Vec<Handle> {
    let along = |handle: &Handle| {
        let (from, to) = (before[handle.vertex as usize], after[handle.vertex as usize]);
        let target = std::array::from_fn(|i| {
            if handle.target[i] == from[i] { to[i] } else { handle.target[i] + (to[i] - from[i]) }
        });
        Handle { target, ..*handle }
    };
    let mut carried: Vec<Handle> = handles.iter().map(along).collect();
    let mut is_fixed = vec![false; before.len()];
    let fixed = handles.iter().filter(|handle| handle.hold == Hold::Fixed);
    fixed.for_each(|handle| is_fixed[handle.vertex as usize] = true);
    for (vertex, between) in (0..).zip(origins.between.iter()).skip(before.len()) {
        if on_boundary(between, topology) && between.iter().all(|&old| is_fixed[old as usize]) {
            let target = after[vertex as usize];
            carried.push(Handle { vertex, target, hold: Hold::Fixed });
        }
    }
    carried
}

/// Whether these are the ends of an edge without a second face.
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

/// Whether it asks a number in the unit of the mesh of elements that are smaller now.
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
