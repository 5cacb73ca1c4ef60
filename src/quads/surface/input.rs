//! The surface as given: its connected parts as oriented triangles, with curvature. Independent of
//! the size of panels.

use super::edges::Edges;
use super::polygon;
use crate::math::{Vec3, argsort};
use crate::mesh::{Mesh, Ragged, Topology, Weld, curvatures};
use crate::quads::{RemeshError, Side};

/// Fewer triangles have no curvature to speak of.
const FEWEST: usize = 10;
/// Triangles with at most this fraction of the largest area have none.
const NO_AREA: f64 = 1e-14;

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
    /// `#V`: the second fundamental form; zero where it is unknown.
    pub(super) tensors: Vec<Tensor>,
}

impl InputSurface {
    /// Returns the connected parts of the faces of a mesh, in the order of their first faces. Faces
    /// that share no vertices are welded first; faces without area are dropped.
    ///
    /// # Errors
    /// See [`RemeshError`]: nothing to remesh, an edge of three faces, a surface with one side.
    pub fn components(mesh: &Mesh) -> Result<Vec<InputSurface>, RemeshError> {
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
        let (mut triangles, faces) = triangulate(&positions, &welded);
        if triangles.is_empty() {
            return Err(RemeshError::Empty);
        }
        let edges = Edges::new(&triangles);
        check_manifold(&edges, &positions)?;
        let parts = orient(&mut triangles, &edges, &positions)?;
        let count = parts.iter().max().map_or(0, |&last| last + 1);
        let mut members = vec![Vec::new(); count];
        parts.iter().enumerate().for_each(|(t, &part)| members[part].push(t));
        members
            .into_iter()
            .map(|members| {
                let own = members.iter().map(|&t| triangles[t]).collect();
                let faces = members.iter().map(|&t| faces[t]).collect();
                InputSurface::of_part(&positions, own, faces, &original)
            })
            .collect()
    }

    /// The area, in the squared unit of the mesh.
    pub fn area(&self) -> f64 {
        let area = |t: &[usize; 3]| {
            let [a, b, c] = t.map(|v| self.positions[v]);
            0.5 * (b - a).cross(c - a).length()
        };
        self.triangles.iter().map(area).sum()
    }

    /// Number of triangles.
    pub fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// One part: its vertices are renumbered, one for each fan of triangles.
    fn of_part(
        positions: &[Vec3<f64>],
        mut triangles: Vec<[usize; 3]>,
        faces: Vec<u32>,
        original: &[u32],
    ) -> Result<InputSurface, RemeshError> {
        if triangles.len() < FEWEST {
            return Err(RemeshError::TooFewTriangles { at: positions[triangles[0][0]] });
        }
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
        let vertices = vertices.iter().map(|&v| original[v]).collect();
        Ok(InputSurface { positions, triangles, faces, vertices, tensors })
    }
}

/// Returns the triangles of all faces, and the face of each.
fn triangulate(positions: &[Vec3<f64>], mesh: &Mesh) -> (Vec<[usize; 3]>, Vec<u32>) {
    let at = |v: u32| positions[v as usize];
    let mut found = Vec::new();
    for (f, face) in (0..).zip(mesh.faces.iter()) {
        let mut face = face.to_vec();
        face.dedup();
        if face.len() > 1 && face.first() == face.last() {
            face.pop();
        }
        if face.len() >= 3 {
            found.extend(polygon::triangles(&face, at).into_iter().map(|triangle| (triangle, f)));
        }
    }
    let area = |[a, b, c]: [u32; 3]| (at(b) - at(a)).cross(at(c) - at(a)).length();
    let largest = found.iter().fold(0.0, |most: f64, &(triangle, _)| most.max(area(triangle)));
    found.retain(|&(triangle, _)| area(triangle) > NO_AREA * largest);
    found.into_iter().map(|(triangle, f)| (triangle.map(|v| v as usize), f)).unzip()
}

fn check_manifold(edges: &Edges, positions: &[Vec3<f64>]) -> Result<(), RemeshError> {
    let mut branching =
        edges.ends.iter().zip(&edges.sides).filter(|(_, sides)| sides.len() > 2).map(|(e, _)| e);
    let Some(&[a, b]) = branching.next() else { return Ok(()) };
    let at = (positions[a] + positions[b]) * 0.5;
    Err(RemeshError::BranchingEdge { at, count: 1 + branching.count() })
}

/// Orients the triangles of each part as its first one, and returns the part of each.
fn orient(
    triangles: &mut [[usize; 3]],
    edges: &Edges,
    positions: &[Vec3<f64>],
) -> Result<Vec<usize>, RemeshError> {
    const NONE: usize = usize::MAX;
    let given = triangles.to_vec();
    let start = |Side { triangle, side }: Side| given[triangle][side];
    let mut part = vec![NONE; given.len()];
    let mut turned = vec![false; given.len()];
    let mut count = 0;
    for first in 0..given.len() {
        if part[first] != NONE {
            continue;
        }
        part[first] = count;
        let mut queue = vec![first];
        while let Some(t) = queue.pop() {
            for side in (0..3).map(|side| Side { triangle: t, side }) {
                let both = &edges.sides[edges.of_side[t][side.side]];
                let Some(&other) = both.iter().find(|&&other| other != side) else { continue };
                // Neighbours run along the edge in opposite directions.
                let turn = turned[t] != (start(side) == start(other));
                if part[other.triangle] == NONE {
                    part[other.triangle] = count;
                    turned[other.triangle] = turn;
                    queue.push(other.triangle);
                } else if turned[other.triangle] != turn {
                    return Err(RemeshError::OneSided { at: positions[start(side)] });
                }
            }
        }
        count += 1;
    }
    for (triangle, turned) in triangles.iter_mut().zip(turned) {
        if turned {
            triangle.swap(1, 2);
        }
    }
    Ok(part)
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
    let of_vertex = |curvature: Option<crate::mesh::Curvature>| {
        let mut tensor = [0.0; 6];
        let Some(curvature) = curvature else { return tensor };
        for (value, Vec3 { x, y, z }) in curvature.principal.into_iter().zip(curvature.directions) {
            let square = [x * x, y * y, z * z, x * y, x * z, y * z];
            tensor.iter_mut().zip(square).for_each(|(sum, part)| *sum += value * part);
        }
        tensor
    };
    let found = curvatures(&mesh.positions, &mesh.faces, &Topology::new(&mesh));
    found.into_iter().map(of_vertex).collect()
}
