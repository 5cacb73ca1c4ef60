//! The target of a constraint: a selector, which may refer to a set without a name; and its shape on
//! the mesh, which determines the usual kind.

use crate::constraint::{Element, Selector, Set, Sets, TargetShape};
use crate::math::marked;
use crate::mesh::{Mesh, Ragged, Topology};
use serde::{Deserialize, Serialize};

/// The target of a constraint: a selector, as in a scene file, and the set without a name that it refers
/// to, if it does.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct ConstraintTarget {
    /// The selector.
    #[cfg_attr(
        target_arch = "wasm32",
        tsify(type = "string | { each: string; in?: string } | { vertices: number[] | string }")
    )]
    pub on: Selector,
    /// The set that [`ConstraintTarget::UNNAMED`] stands for in the selector.
    #[cfg_attr(
        target_arch = "wasm32",
        tsify(type = "{ vertices?: number[] | string; faces?: number[] | string } | null")
    )]
    pub set: Option<Set>,
}

impl ConstraintTarget {
    /// The placeholder for `set` in the selector.
    pub const UNNAMED: &str = "";

    /// Returns the selector with the name that its set has in `sets`. If it has none, chooses a name
    /// that no set has, and no group of the `mesh`, and also returns it with the set.
    pub(crate) fn named_in(self, sets: &Sets, mesh: &Mesh) -> (Selector, Option<(String, Set)>) {
        let ConstraintTarget { mut on, set } = self;
        let Some(set) = set else { return (on, None) };
        let known = sets.iter().find(|(_, other)| **other == set);
        let name = match known {
            Some((name, _)) => name.clone(),
            None => (1..)
                .map(|k| format!("selection {k}"))
                .find(|name| !sets.contains_key(name) && !mesh.has_group(name))
                .expect("some number is free"),
        };
        if let Selector::Each { within: Some(within), .. } = &mut on {
            within.clone_from(&name);
        }
        let is_new = known.is_none();
        (on, is_new.then_some((name, set)))
    }
}

/// Returns the shape of the rows of a selector; none if no kind is the usual one for it.
pub(crate) fn target_shape(
    on: &Selector,
    rows: &Ragged,
    mesh: &Mesh,
    topology: &Topology,
) -> Option<TargetShape> {
    match on {
        Selector::Each { element: Element::Face, .. } => {
            let triangles = rows.iter().filter(|row| row.len() == 3).count();
            let mostly = 2 * triangles > rows.len();
            Some(if mostly { TargetShape::Triangles } else { TargetShape::Panels })
        }
        Selector::Each { element: Element::Edge, .. } => Some(TargetShape::Edges),
        Selector::Each { element: Element::Boundary, .. } => Some(TargetShape::Loop),
        Selector::Each { element: Element::Curve, .. } => Some(TargetShape::Chain),
        Selector::Each { .. } => None,
        Selector::Set(_) | Selector::Vertices(_) => {
            rows.iter().next().and_then(|vertices| together(vertices, mesh, topology))
        }
    }
}

/// Returns the shape of distinct vertices that one constraint acts on together.
fn together(vertices: &[u32], mesh: &Mesh, topology: &Topology) -> Option<TargetShape> {
    let inside = marked(mesh.positions.len(), vertices);
    let all_inside = |row: &[u32]| row.iter().all(|&v| inside[v as usize]);
    let is_boundary_loop =
        topology.boundary_loops().iter().any(|row| row.len() == vertices.len() && all_inside(row));
    if is_boundary_loop {
        return Some(TargetShape::Loop);
    }
    let mut faces = mesh.faces.iter().filter(|face| all_inside(face));
    if let Some(first) = faces.next() {
        return match faces.next() {
            None if first.len() == 3 => Some(TargetShape::Triangles),
            None => Some(TargetShape::Panels),
            Some(_) if mesh.faces.iter().all(all_inside) => None,
            Some(_) => Some(TargetShape::Patch),
        };
    }
    let joined = |v: u32| {
        topology.neighbours().row(v as usize).iter().filter(|&&n| inside[n as usize]).count()
    };
    let ends = vertices.iter().filter(|&&v| joined(v) == 1).count();
    let is_path = vertices.iter().all(|&v| matches!(joined(v), 1 | 2))
        && reached(vertices[0], &inside, topology) == vertices.len();
    match (vertices.len(), ends) {
        (0 | 1, _) => None,
        (2, 2) => Some(TargetShape::Edges),
        (_, 0) if is_path => Some(TargetShape::Loop),
        (_, 2) if is_path => Some(TargetShape::Chain),
        _ => Some(TargetShape::Points),
    }
}

/// Counts the vertices that edges connect to `start` through vertices that are `inside`.
fn reached(start: u32, inside: &[bool], topology: &Topology) -> usize {
    let mut left = inside.to_vec();
    let mut queue = vec![start];
    left[start as usize] = false;
    let mut count = 0;
    while let Some(v) = queue.pop() {
        count += 1;
        for &n in topology.neighbours().row(v as usize) {
            if std::mem::take(&mut left[n as usize]) {
                queue.push(n);
            }
        }
    }
    count
}
