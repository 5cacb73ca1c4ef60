//! The surface as given: its connected parts as oriented triangles, with curvature. Independent of
//! the size of panels.

use super::edges::{Edges, corner_classes};
use super::slivers::remove_slivers;
use crate::math::{Vec3, argsort, ears_in_space, key_of_pair, marked, mean};
use crate::mesh::{Mesh, Tensor, Topology, Weld, components, curvatures, orientation};
use crate::quads::RemeshError;
use std::collections::BTreeMap;

/// Fewer triangles have no curvature to speak of.
const FEWEST: usize = 10;

/// A connected part of the input.
#[derive(Clone, Debug, PartialEq)]
pub struct InputSurface {
    /// `#V by 3`.
    pub(super) positions: Vec<Vec3<f64>>,
    /// `#T by 3`, consistently oriented.
    pub(super) triangles: Vec<[usize; 3]>,
    /// Its faces of the input, ascending.
    pub(super) faces: Vec<u32>,
    /// `#V`: vertices of the input; two where fans that touch in a vertex were split.
    pub(super) vertices: Vec<u32>,
    /// `#V`: whether a face that stays has the vertex.
    pub(super) at_staying: Vec<bool>,
    /// `#V`: the second fundamental form; zero where it is unknown.
    pub(super) tensors: Vec<Tensor>,
}

/// The connected parts of the input: those that can be covered, and the others.
#[derive(Clone, Debug, Default)]
pub struct InputParts {
    /// In the order of their first faces.
    pub surfaces: Vec<InputSurface>,
    /// The others, in this order too; those of faces without area last.
    pub staying: Vec<StayingPart>,
    /// Faces that are left out, ascending: the position of a corner is not in the file.
    pub left_out: Vec<u32>,
}

/// A part of the input that is not covered.
#[derive(Clone, Debug)]
pub struct StayingPart {
    /// Its faces, ascending.
    pub faces: Vec<u32>,
    /// In the squared unit of the mesh.
    pub area: f64,
    /// Why it is not covered.
    pub error: RemeshError,
    /// Its middle, in the unit of the mesh.
    pub at: Vec3<f64>,
}

impl InputSurface {
    /// Returns the connected parts of the faces of a mesh, in the order of their first faces. Faces
    /// that share no vertices are welded first; triangles without area are removed, their faces still
    /// belong to their part. The faces `stay` belong to no part, nor do those with a vertex whose position
    /// is not in the file: these are not a surface.
    ///
    /// # Errors
    /// [`RemeshError::Empty`], [`RemeshError::AllStay`] or [`RemeshError::Unplaced`] if there is nothing
    /// to remesh.
    pub fn parts(mesh: &Mesh, stay: &[u32]) -> Result<InputParts, RemeshError> {
        let mut welded = mesh.clone();
        let weld = Weld::apply(&mut welded);
        // The original vertex of each welded one: the first that became it.
        let mut original: Vec<u32> = (0..welded.positions.len() as u32).collect();
        if let Some(weld) = &weld {
            for (v, &to) in weld.to.iter().enumerate().rev() {
                original[to as usize] = v as u32;
            }
        }
        let positions: Vec<Vec3<f64>> = welded.positions.iter().map(|&p| Vec3::from(p)).collect();
        let stays = marked(mesh.faces.len(), stay);
        let mut at_staying = vec![false; positions.len()];
        let staying = welded.faces.iter().zip(&stays).filter(|(_, stays)| **stays);
        staying.flat_map(|(face, _)| face).for_each(|&v| at_staying[v as usize] = true);
        let left_out = mesh.faces_left_out(stay);
        let mut is_out = stays;
        left_out.iter().for_each(|&f| is_out[f as usize] = true);
        let (all, face_of) = triangulate(&positions, &welded, &is_out);
        let mut triangles = all.clone();
        let given = remove_slivers(&positions, &mut triangles);
        if triangles.is_empty() {
            return Err(match stay {
                _ if !left_out.is_empty() => RemeshError::Unplaced,
                [] => RemeshError::Empty,
                _ => RemeshError::AllStay,
            });
        }
        let (part_of, mut faults) = orient(&positions, &mut triangles);
        let mut members: Vec<(Vec<[usize; 3]>, Vec<u32>)> = vec![Default::default(); faults.len()];
        for ((&part, triangle), &k) in part_of.iter().zip(triangles).zip(&given) {
            let (triangles, faces) = &mut members[part as usize];
            triangles.push(triangle);
            faces.push(face_of[k]);
        }
        let has_area = marked(mesh.faces.len(), given.iter().map(|&k| face_of[k]));
        let mut without = (0..all.len()).filter(|&k| !has_area[face_of[k] as usize]).peekable();
        if without.peek().is_some() {
            // Those belong to a part that they share edges with, or are parts of their own.
            let topology = Topology::new(&as_mesh(&positions, &all));
            let connected = components(all.len(), topology.edge_faces().iter());
            let mut parts = BTreeMap::new();
            for (&part, &k) in part_of.iter().zip(&given) {
                parts.entry(connected[k]).or_insert(part as usize);
            }
            for k in without {
                let part = *parts.entry(connected[k]).or_insert_with(|| {
                    members.push((vec![all[k]], Vec::new()));
                    faults.push(Some(RemeshError::TooFewTriangles { at: positions[all[k][0]] }));
                    members.len() - 1
                });
                members[part].1.push(face_of[k]);
            }
        }
        let mut found = InputParts { left_out, ..InputParts::default() };
        for ((own, mut faces), fault) in members.into_iter().zip(faults) {
            faces.sort_unstable();
            faces.dedup();
            let at = positions[own[0][0]];
            let few = (own.len() < FEWEST).then_some(RemeshError::TooFewTriangles { at });
            match fault.or(few) {
                None => {
                    let vertices = (&original[..], &at_staying[..]);
                    let surface = InputSurface::of_part(&positions, own, faces, vertices);
                    found.surfaces.push(surface);
                }
                Some(error) => {
                    let area = area(&positions, &own);
                    let at = middle(&positions, &own);
                    found.staying.push(StayingPart { faces, area, error, at });
                }
            }
        }
        Ok(found)
    }

    /// The whole part, which stays as it is for this reason.
    pub(crate) fn staying(&self, error: RemeshError) -> StayingPart {
        StayingPart { faces: self.faces.clone(), area: self.area(), error, at: self.middle() }
    }

    /// The mean of the corners of the triangles.
    pub(in crate::quads) fn middle(&self) -> Vec3<f64> {
        middle(&self.positions, &self.triangles)
    }

    /// The area, in the squared unit of the mesh.
    pub fn area(&self) -> f64 {
        area(&self.positions, &self.triangles)
    }

    /// One part: its vertices are renumbered, one for each fan of triangles. Of all positions are given
    /// the vertices of the input, and whether faces that stay have them.
    pub(super) fn of_part(
        positions: &[Vec3<f64>],
        mut triangles: Vec<[usize; 3]>,
        faces: Vec<u32>,
        (original, at_staying): (&[u32], &[bool]),
    ) -> InputSurface {
        let neighbours = Edges::new(&triangles).neighbours();
        let fans = corner_classes(&neighbours);
        let fan = |k: usize| [triangles[k / 3][k % 3] as u32, fans[k / 3][k % 3]];
        let order = argsort((0..3 * triangles.len()).map(|k| key_of_pair(fan(k))));
        let mut vertices: Vec<usize> = Vec::new();
        let mut last = None;
        let mut renumbered = triangles.clone();
        for k in order.into_iter().map(|k| k as usize) {
            if last.replace(fan(k)) != Some(fan(k)) {
                vertices.push(triangles[k / 3][k % 3]);
            }
            renumbered[k / 3][k % 3] = vertices.len() - 1;
        }
        triangles = renumbered;
        let positions: Vec<Vec3<f64>> = vertices.iter().map(|&v| positions[v]).collect();
        let tensors = tensors(&positions, &triangles);
        let at_staying = vertices.iter().map(|&v| at_staying[v]).collect();
        let vertices = vertices.iter().map(|&v| original[v]).collect();
        InputSurface { positions, triangles, faces, vertices, at_staying, tensors }
    }
}

/// The mean of the corners of triangles.
fn middle(positions: &[Vec3<f64>], triangles: &[[usize; 3]]) -> Vec3<f64> {
    mean(triangles.as_flattened().iter().map(|&v| positions[v]))
}

/// The area of triangles.
fn area(positions: &[Vec3<f64>], triangles: &[[usize; 3]]) -> f64 {
    let area = |t: &[usize; 3]| {
        let [a, b, c] = t.map(|v| positions[v]);
        0.5 * (b - a).cross(c - a).length()
    };
    triangles.iter().map(area).sum()
}

/// Returns the triangles of all faces but those that are left out, and the face of each.
fn triangulate(
    positions: &[Vec3<f64>],
    mesh: &Mesh,
    is_out: &[bool],
) -> (Vec<[usize; 3]>, Vec<u32>) {
    let mut found: Vec<([usize; 3], u32)> = Vec::new();
    let others = (0..).zip(mesh.faces.iter()).zip(is_out).filter(|(_, is_out)| !**is_out);
    for ((f, face), _) in others {
        let mut face = face.to_vec();
        face.dedup();
        if face.len() > 1 && face.first() == face.last() {
            face.pop();
        }
        if face.len() >= 3 {
            let corners: Vec<Vec3<f64>> = face.iter().map(|&v| positions[v as usize]).collect();
            let cut = ears_in_space(&corners).into_iter();
            found.extend(cut.map(|triangle| (triangle.map(|k| face[k] as usize), f)));
        }
    }
    found.into_iter().unzip()
}

/// Orients the triangles of each part, connected over edges, consistently, and turns the fewer. Returns
/// the part of each triangle, and for each part why it is no surface, if so.
fn orient(
    positions: &[Vec3<f64>],
    triangles: &mut [[usize; 3]],
) -> (Vec<u32>, Vec<Option<RemeshError>>) {
    let mesh = as_mesh(positions, triangles);
    let topology = Topology::new(&mesh);
    let (turned, contradictions) = orientation(&mesh.faces, &topology);
    let part_of = components(triangles.len(), topology.edge_faces().iter());
    let mut faults = vec![None; part_of.iter().max().map_or(0, |&last| last as usize + 1)];
    let faces = |e: u32| topology.edge_faces().row(e as usize);
    let middle = |e: u32| mean(topology.edges()[e as usize].map(|v| positions[v as usize]));
    let part = |e: u32| part_of[faces(e)[0] as usize] as usize;
    for e in contradictions {
        faults[part(e)].get_or_insert(RemeshError::OneSided { at: middle(e) });
    }
    for e in (0..topology.edges().len() as u32).filter(|&e| faces(e).len() > 2) {
        match &mut faults[part(e)] {
            Some(RemeshError::BranchingEdge { count, .. }) => *count += 1,
            fault => *fault = Some(RemeshError::BranchingEdge { at: middle(e), count: 1 }),
        }
    }
    for (triangle, _) in triangles.iter_mut().zip(turned).filter(|(_, turned)| *turned) {
        triangle.swap(1, 2);
    }
    (part_of, faults)
}

/// The triangles as faces of a mesh.
pub(super) fn as_mesh(positions: &[Vec3<f64>], triangles: &[[usize; 3]]) -> Mesh {
    let faces = triangles.iter().map(|triangle| triangle.map(|v| v as u32)).collect();
    Mesh { positions: positions.iter().map(|&p| p.into()).collect(), faces, ..Mesh::default() }
}

/// The second fundamental form at each vertex (quadrics over two rings of neighbours).
fn tensors(positions: &[Vec3<f64>], triangles: &[[usize; 3]]) -> Vec<Tensor> {
    let mesh = as_mesh(positions, triangles);
    let found = curvatures(&mesh.positions, &mesh.faces, &Topology::new(&mesh));
    found.into_iter().map(|one| one.map_or([0.0; 6], |one| one.tensor())).collect()
}
