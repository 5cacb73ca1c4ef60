//! Builder of a mesh made from another one, with the origins of its elements.

use super::origins::{Combinations, Edited, Origins};
use crate::math::{polygon_sides, visits_twice};
use crate::mesh::{Group, Mesh, Point, Ragged, Topology};
use std::collections::{BTreeMap, BTreeSet};

/// A mesh under construction, initially without faces. Until it is finished, old vertices keep
/// their indices and new ones follow them; finishing removes the vertices that are no longer used.
pub(super) struct Rebuild<'a> {
    mesh: &'a Mesh,
    /// The new index of each old vertex.
    names: Vec<u32>,
    /// Old vertices, then new ones.
    vertices: Vec<Vertex>,
    faces: Ragged,
    /// See [`Origins::faces`].
    parents: Ragged,
    /// The new vertex on an old edge; the key has the lower end first.
    on_edges: BTreeMap<[u32; 2], u32>,
}

struct Vertex {
    position: Point,
    /// See [`Origins::positions`]; ascending.
    of: Vec<(u32, f64)>,
}

/// Error: this face would visit a vertex twice.
pub(super) struct Touching(pub(super) u32);

impl<'a> Rebuild<'a> {
    pub(super) fn new(mesh: &'a Mesh) -> Rebuild<'a> {
        let old = |(v, &position): (u32, &Point)| Vertex { position, of: vec![(v, 1.0)] };
        Rebuild {
            mesh,
            names: (0..mesh.positions.len() as u32).collect(),
            vertices: (0..).zip(&mesh.positions).map(old).collect(),
            faces: Ragged::new(),
            parents: Ragged::new(),
            on_edges: BTreeMap::new(),
        }
    }

    /// Adds a vertex at the mean of old ones.
    pub(super) fn vertex(&mut self, between: &[u32]) -> u32 {
        let mean = mean(self.mesh, between);
        self.vertices.push(mean);
        self.vertices.len() as u32 - 1
    }

    /// Adds a vertex at `position` that moves with the old vertex `with`.
    pub(super) fn vertex_at(&mut self, position: Point, with: u32) -> u32 {
        self.vertices.push(Vertex { position, of: vec![(with, 1.0)] });
        self.vertices.len() as u32 - 1
    }

    /// Returns the vertex at the midpoint of an old edge, adding it at the first call. Curves along
    /// the edge pass through it.
    pub(super) fn middle(&mut self, [a, b]: [u32; 2]) -> u32 {
        let ends = [a.min(b), a.max(b)];
        if let Some(&middle) = self.on_edges.get(&ends) {
            return middle;
        }
        let middle = self.vertex(&ends);
        self.on_edges.insert(ends, middle);
        middle
    }

    pub(super) fn place(&mut self, v: u32, position: Point) {
        self.vertices[v as usize].position = position;
    }

    /// Merges old vertices into the one of lowest index, at the mean of `at`.
    pub(super) fn merge(&mut self, vertices: &[u32], at: &[u32]) {
        let Some(&first) = vertices.iter().min() else { return };
        self.vertices[first as usize] = mean(self.mesh, at);
        vertices.iter().for_each(|&v| self.names[v as usize] = first);
    }

    /// Adds a face with these corners, made from the old faces `parents`.
    pub(super) fn face(&mut self, corners: &[u32], parents: &[u32]) {
        self.faces.push(corners);
        self.parents.push(parents);
    }

    /// Adds old faces with their merged vertices; drops those with fewer than three corners left.
    ///
    /// # Errors
    /// If a face would visit a vertex twice.
    pub(super) fn keep(&mut self, faces: impl Iterator<Item = u32>) -> Result<(), Touching> {
        for face in faces {
            let old = self.mesh.faces.row(face as usize);
            let named = old.iter().map(|&v| self.names[v as usize]);
            let mut corners: Vec<u32> = named.collect();
            corners.dedup();
            if corners.len() > 1 && corners.first() == corners.last() {
                corners.pop();
            }
            if corners.len() < 3 {
                continue;
            }
            // Faces that already visited a vertex twice are accepted.
            if visits_twice(&corners) && !visits_twice(old) {
                return Err(Touching(face));
            }
            self.face(&corners, &[face]);
        }
        Ok(())
    }

    /// Returns the mesh and its origins. A group keeps the faces made from its own faces only.
    pub(super) fn finish(self) -> Edited {
        let Rebuild { mesh, names, vertices, faces, parents, on_edges } = self;
        let rename = |curve: &[u32]| {
            let mut renamed = vec![names[curve[0] as usize]];
            for ends in polygon_sides(curve).take(curve.len() - 1) {
                let edge = [ends[0].min(ends[1]), ends[0].max(ends[1])];
                renamed.extend(on_edges.get(&edge));
                renamed.push(names[ends[1] as usize]);
            }
            renamed.dedup();
            renamed
        };
        let curves: Vec<Vec<u32>> = mesh.curves.iter().map(rename).collect();
        // Vertices that no old face or curve used are kept, and those of faces that are left as they
        // are.
        let mut is_used = vec![false; vertices.len()];
        is_used[..names.len()].fill(true);
        let old = mesh.faces.indices().iter().chain(mesh.curves.indices());
        old.for_each(|&v| is_used[v as usize] = false);
        for (v, &name) in names.iter().enumerate() {
            is_used[v] &= name as usize == v;
        }
        let of_curves = curves.iter().filter(|curve| curve.len() > 1).flatten();
        let of_untouched = mesh.untouched.indices().iter().map(|&v| &names[v as usize]);
        let used = faces.indices().iter().chain(of_curves).chain(of_untouched);
        used.for_each(|&v| is_used[v as usize] = true);

        let mut next = 0..;
        let index: Vec<Option<u32>> =
            is_used.iter().map(|used| if *used { next.next() } else { None }).collect();
        let places: Vec<u32> = index.iter().map(|new| new.unwrap_or(u32::MAX)).collect();
        let mut edited = Mesh { faces, ..Mesh::default() };
        let (mut positions, mut between) = (Combinations::default(), Ragged::new());
        for (vertex, _) in vertices.iter().zip(&is_used).filter(|(_, used)| **used) {
            edited.positions.push(vertex.position);
            positions.push(&vertex.of);
            between.push(&vertex.of.iter().map(|(old, _)| *old).collect::<Vec<_>>());
        }
        edited.faces.rename(&places);
        let mut next = 0..;
        let curve_index: Vec<Option<u32>> =
            curves.iter().map(|curve| if curve.len() > 1 { next.next() } else { None }).collect();
        edited.curves = curves.iter().filter(|curve| curve.len() > 1).collect();
        edited.curves.rename(&places);
        edited.groups = regrouped(mesh, &parents, &curve_index);
        let vertices = names.iter().map(|&name| index[name as usize]).collect();
        let origins = Origins { vertices, positions, between, faces: parents };
        Edited { mesh: edited, origins }
    }
}

/// Returns the groups of a mesh made from `mesh`: `parents` are the old faces of each new one,
/// `curve_index` is the new index of each old curve. A group keeps the faces made from its own only.
pub(super) fn regrouped(mesh: &Mesh, parents: &Ragged, curve_index: &[Option<u32>]) -> Vec<Group> {
    if mesh.groups.is_empty() {
        return Vec::new();
    }
    let mut made = vec![Vec::new(); mesh.faces.len()];
    for (face, of) in (0..).zip(parents.iter()) {
        of.iter().for_each(|&parent| made[parent as usize].push(face));
    }
    let rebuilt = |group| rebuilt(group, parents, &made, curve_index);
    mesh.groups.iter().filter_map(rebuilt).collect()
}

/// Returns a group with the faces made from its own only and its remaining curves; `None` if it is
/// empty. `made` are the new faces of each old one.
fn rebuilt(
    group: &Group,
    parents: &Ragged,
    made: &[Vec<u32>],
    curve_index: &[Option<u32>],
) -> Option<Group> {
    let is_in = |face: &u32| group.faces.binary_search(face).is_ok();
    let mut faces: Vec<u32> =
        group.faces.iter().flat_map(|&face| &made[face as usize]).copied().collect();
    faces.sort_unstable();
    faces.dedup();
    faces.retain(|&face| parents.row(face as usize).iter().all(is_in));
    let curves: Vec<u32> = group.curves.iter().filter_map(|&c| curve_index[c as usize]).collect();
    let has_any = !faces.is_empty() || !curves.is_empty();
    has_any.then(|| Group { faces, curves, ..group.clone() })
}

fn mean(mesh: &Mesh, vertices: &[u32]) -> Vertex {
    let mut between = vertices.to_vec();
    between.sort_unstable();
    between.dedup();
    let part = 1.0 / between.len() as f64;
    let of: Vec<(u32, f64)> = between.iter().map(|&v| (v, part)).collect();
    let mut combination = Combinations::default();
    combination.push(&of);
    Vertex { position: combination.apply(&mesh.positions)[0], of }
}

/// Returns the faces around a vertex in cyclic order; `None` if they are not a single fan of
/// consistently oriented faces.
pub(crate) fn around(mesh: &Mesh, topology: &Topology, v: u32) -> Option<Vec<Step>> {
    let faces = topology.vertex_faces().row(v as usize);
    let mut steps = Vec::with_capacity(faces.len());
    let step = |face: u32| -> Option<Step> {
        let corners = mesh.faces.row(face as usize);
        let at = corners.iter().position(|&corner| corner == v)?;
        let n = corners.len();
        Some(Step { face, out: corners[(at + 1) % n], back: corners[(at + n - 1) % n] })
    };
    let all: Vec<Step> = faces.iter().map(|&face| step(face)).collect::<Option<_>>()?;
    // Begin at the face without a predecessor, or anywhere if the fan is closed.
    let backs: BTreeSet<u32> = all.iter().map(|step| step.back).collect();
    let first = all.iter().find(|step| !backs.contains(&step.out)).or(all.first())?;
    let mut by_out: BTreeMap<u32, &Step> = BTreeMap::new();
    if all.iter().any(|step| by_out.insert(step.out, step).is_some()) {
        // Two faces begin with the same edge.
        return None;
    }
    let mut at = *first;
    loop {
        steps.push(at);
        match by_out.get(&at.back) {
            None => break,
            Some(next) if next.face == first.face => break,
            Some(next) if steps.len() < all.len() => at = **next,
            Some(_) => return None,
        }
    }
    (steps.len() == all.len()).then_some(steps)
}

/// A face at a vertex, and the two neighbours of the vertex in the face.
#[derive(Clone, Copy)]
pub(crate) struct Step {
    pub(crate) face: u32,
    /// The corner after the vertex.
    pub(crate) out: u32,
    /// The corner before the vertex.
    pub(crate) back: u32,
}
