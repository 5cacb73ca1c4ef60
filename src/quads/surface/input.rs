//! The surface as given: its connected parts as oriented triangles, with curvature. Independent of
//! the size of panels.

use super::edges::Edges;
use super::slivers::remove_slivers;
use crate::math::{Vec3, argsort, ears_in_space, marked, mean};
use crate::mesh::{Mesh, Ragged, Topology, Weld, curvatures};
use crate::quads::{RemeshError, Side};

/// Fewer triangles have no curvature to speak of.
const FEWEST: usize = 10;

/// A symmetric tensor in space: xx, yy, zz, xy, xz, yz.
pub(crate) type Tensor = [f64; 6];

/// A connected part of the input.
#[derive(Clone, Debug, PartialEq)]
pub struct InputSurface {
    /// `#V by 3`.
    pub(super) positions: Vec<Vec3<f64>>,
    /// `#T by 3`, consistently oriented.
    pub(super) triangles: Vec<[usize; 3]>,
    /// `#T`: faces of the input.
    pub(super) faces: Vec<u32>,
    /// `#V`: vertices of the input; two where fans that touch in a vertex were split.
    pub(super) vertices: Vec<u32>,
    /// `#V`: whether a face that stays has the vertex.
    pub(super) beside: Vec<bool>,
    /// `#V`: the second fundamental form; zero where it is unknown.
    pub(super) tensors: Vec<Tensor>,
}

/// The connected parts of the input: those that can be covered, and the others.
#[derive(Clone, Debug, Default)]
pub struct InputParts {
    /// In the order of their first faces.
    pub surfaces: Vec<InputSurface>,
    /// The others, in this order too.
    pub left: Vec<LeftPart>,
}

/// A part of the input that is not covered.
#[derive(Clone, Debug)]
pub struct LeftPart {
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
    /// that share no vertices are welded first; triangles without area are removed. The faces `stay`
    /// belong to no part.
    ///
    /// # Errors
    /// If there is nothing to remesh.
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
        let (mut triangles, faces) = triangulate(&positions, &welded, &stays);
        let mut beside = vec![false; positions.len()];
        let staying = welded.faces.iter().zip(&stays).filter(|(_, stays)| **stays);
        staying.flat_map(|(face, _)| face).for_each(|&v| beside[v as usize] = true);
        if triangles.is_empty() {
            return Err(RemeshError::Empty);
        }
        let edges = Edges::new(&triangles);
        let (parts, faults) = orient(&mut triangles, &edges, &positions);
        let mut members = vec![Vec::new(); faults.len()];
        parts.iter().enumerate().for_each(|(t, &part)| members[part].push(t));
        let mut found = InputParts::default();
        for (members, fault) in members.into_iter().zip(faults) {
            let own: Vec<[usize; 3]> = members.iter().map(|&t| triangles[t]).collect();
            let mut faces: Vec<u32> = members.iter().map(|&t| faces[t]).collect();
            let at = positions[own[0][0]];
            let few = (own.len() < FEWEST).then_some(RemeshError::TooFewTriangles { at });
            match fault.or(few) {
                None => {
                    let vertices = (&original[..], &beside[..]);
                    let surface = InputSurface::of_part(&positions, own, faces, vertices);
                    found.surfaces.push(surface);
                }
                Some(error) => {
                    faces.dedup();
                    let area = area(&positions, &own);
                    let at = middle(&positions, &own);
                    found.left.push(LeftPart { faces, area, error, at });
                }
            }
        }
        Ok(found)
    }

    /// The whole part, left as it is for this reason.
    pub(crate) fn left(&self, error: RemeshError) -> LeftPart {
        let mut faces = self.faces.clone();
        faces.dedup();
        let at = middle(&self.positions, &self.triangles);
        LeftPart { faces, area: self.area(), error, at }
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
        (original, beside): (&[u32], &[bool]),
    ) -> InputSurface {
        let neighbours = Edges::new(&triangles).neighbours();
        let fans = fans(&triangles, &neighbours);
        let order = argsort((0..3 * triangles.len()).map(|k| {
            let (vertex, fan) = (triangles[k / 3][k % 3], fans[k]);
            ((vertex as u64) << 32) | fan as u64
        }));
        let mut vertices: Vec<usize> = Vec::new();
        let mut last = None;
        let mut renumbered = triangles.clone();
        for k in order.into_iter().map(|k| k as usize) {
            let vertex = triangles[k / 3][k % 3];
            if last != Some((vertex, fans[k])) {
                vertices.push(vertex);
                last = Some((vertex, fans[k]));
            }
            renumbered[k / 3][k % 3] = vertices.len() - 1;
        }
        triangles = renumbered;
        let positions: Vec<Vec3<f64>> = vertices.iter().map(|&v| positions[v]).collect();
        let tensors = tensors(&positions, &triangles);
        let beside = vertices.iter().map(|&v| beside[v]).collect();
        let vertices = vertices.iter().map(|&v| original[v]).collect();
        InputSurface { positions, triangles, faces, vertices, beside, tensors }
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

/// Returns the triangles of all faces but those that stay, and the face of each.
fn triangulate(
    positions: &[Vec3<f64>],
    mesh: &Mesh,
    stays: &[bool],
) -> (Vec<[usize; 3]>, Vec<u32>) {
    let mut found: Vec<([usize; 3], u32)> = Vec::new();
    let others = (0..).zip(mesh.faces.iter()).zip(stays).filter(|(_, stays)| !**stays);
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
    let (mut triangles, mut faces) = found.into_iter().unzip();
    remove_slivers(positions, &mut triangles, &mut faces);
    (triangles, faces)
}

/// Orients the triangles of each part as its first one. Returns the part of each triangle, and for
/// each part why it is no surface, if so.
fn orient(
    triangles: &mut [[usize; 3]],
    edges: &Edges,
    positions: &[Vec3<f64>],
) -> (Vec<usize>, Vec<Option<RemeshError>>) {
    const NONE: usize = usize::MAX;
    let given = triangles.to_vec();
    let start = |Side { triangle, side }: Side| given[triangle][side];
    let mut part = vec![NONE; given.len()];
    let mut turned = vec![false; given.len()];
    let mut faults: Vec<Option<RemeshError>> = Vec::new();
    for first in 0..given.len() {
        if part[first] != NONE {
            continue;
        }
        let own = faults.len();
        let mut fault = None;
        part[first] = own;
        let mut queue = vec![first];
        while let Some(t) = queue.pop() {
            for side in (0..3).map(|side| Side { triangle: t, side }) {
                let all = &edges.sides[edges.of_side[t][side.side]];
                for &other in all.iter().filter(|&&other| other != side) {
                    // Neighbours run along the edge in opposite directions.
                    let turn = turned[t] != (start(side) == start(other));
                    if part[other.triangle] == NONE {
                        part[other.triangle] = own;
                        turned[other.triangle] = turn;
                        queue.push(other.triangle);
                    } else if turned[other.triangle] != turn {
                        let at = positions[start(side)];
                        fault.get_or_insert(RemeshError::OneSided { at });
                    }
                }
            }
        }
        faults.push(fault);
    }
    for (&[a, b], sides) in edges.ends.iter().zip(&edges.sides).filter(|(_, all)| all.len() > 2) {
        let fault = &mut faults[part[sides[0].triangle]];
        if let Some(RemeshError::BranchingEdge { count, .. }) = fault {
            *count += 1;
        } else {
            let at = (positions[a] + positions[b]) * 0.5;
            *fault = Some(RemeshError::BranchingEdge { at, count: 1 });
        }
    }
    for (triangle, turned) in triangles.iter_mut().zip(turned) {
        if turned {
            triangle.swap(1, 2);
        }
    }
    (part, faults)
}

/// Numbers the fans of triangles around vertices: the same for corners of one vertex that are
/// connected by triangles around it, `3 #T`.
fn fans(triangles: &[[usize; 3]], neighbours: &[[Option<Side>; 3]]) -> Vec<usize> {
    let mut fan: Vec<usize> = (0..3 * triangles.len()).collect();
    for first in 0..fan.len() {
        if fan[first] != first {
            continue;
        }
        let mut queue = vec![first];
        while let Some(corner) = queue.pop() {
            let (t, k) = (corner / 3, corner % 3);
            // Over the side that starts here and the one that ends here.
            let ahead = neighbours[t][k].map(|next| 3 * next.triangle + (next.side + 1) % 3);
            let behind = neighbours[t][(k + 2) % 3].map(|next| 3 * next.triangle + next.side);
            for other in [ahead, behind].into_iter().flatten() {
                if other > first && fan[other] != first {
                    fan[other] = first;
                    queue.push(other);
                }
            }
        }
    }
    fan
}

/// The second fundamental form at each vertex (quadrics over two rings of neighbours).
fn tensors(positions: &[Vec3<f64>], triangles: &[[usize; 3]]) -> Vec<Tensor> {
    let mesh = Mesh {
        positions: positions.iter().map(|&p| p.into()).collect(),
        faces: triangles.iter().map(|t| t.map(|v| v as u32)).collect::<Ragged>(),
        ..Mesh::default()
    };
    let found = curvatures(&mesh.positions, &mesh.faces, &Topology::new(&mesh));
    found.into_iter().map(|one| one.map_or([0.0; 6], |one| one.tensor())).collect()
}
