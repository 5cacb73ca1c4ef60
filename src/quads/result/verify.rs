//! Whether the faces are a surface like the input: the result is checked itself, not the map from
//! which it comes.

use crate::math::visits_twice;
use crate::mesh::{Mesh, Ragged, Topology, around, components};
use crate::quads::fault::ResultFault;

/// The shape of a surface as far as deformations keep it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::quads) struct Shape {
    /// Vertices minus edges plus faces.
    pub(in crate::quads) euler: i64,
    /// Number of boundary loops.
    pub(in crate::quads) loops: usize,
    /// Number of connected parts.
    pub(in crate::quads) parts: usize,
}

/// Checks faces against those of the input. `fits` says whether a face may have its number of
/// corners.
pub(in crate::quads) fn verify<F: AsRef<[usize]>>(
    faces: &[F],
    expected: Shape,
    fits: impl Fn(&[usize]) -> bool,
) -> (Shape, Vec<ResultFault>) {
    let wrong = |face: &&F| !fits(face.as_ref()) || visits_twice(face.as_ref());
    let mesh = as_mesh(faces);
    let topology = Topology::new(&mesh);
    let found = shape(&mesh, &topology);
    let is_wrong_edge = |&e: &u32| match topology.edge_faces().row(e as usize) {
        [_] => false,
        [_, _] => topology.agreement(e) < 0.0,
        _ => true,
    };
    let is_wrong_vertex = |&v: &u32| {
        !topology.vertex_faces().row(v as usize).is_empty() && around(&mesh, &topology, v).is_none()
    };
    let edges = (0..topology.edges().len() as u32).filter(is_wrong_edge).count();
    let vertices = (0..mesh.positions.len() as u32).filter(is_wrong_vertex).count();
    let mut faults = Vec::new();
    let mut count = |count: usize, fault: fn(usize) -> ResultFault| {
        if count > 0 {
            faults.push(fault(count));
        }
    };
    count(faces.iter().filter(wrong).count(), |count| ResultFault::Face { count });
    count(edges, |count| ResultFault::Edge { count });
    count(vertices, |count| ResultFault::Vertex { count });
    if found.loops != expected.loops {
        faults.push(ResultFault::Loops { expected: expected.loops, found: found.loops });
    }
    if found.euler != expected.euler {
        faults.push(ResultFault::Euler { expected: expected.euler, found: found.euler });
    }
    // A torus would otherwise be no faces at all, which have as many loops and the same Euler number.
    if found.parts != expected.parts {
        faults.push(ResultFault::Parts { expected: expected.parts, found: found.parts });
    }
    (found, faults)
}

impl Shape {
    /// The shape of faces that are a surface.
    pub(in crate::quads) fn of<F: AsRef<[usize]>>(faces: &[F]) -> Shape {
        let mesh = as_mesh(faces);
        shape(&mesh, &Topology::new(&mesh))
    }
}

/// The faces as a mesh, of which only the connectivity counts.
fn as_mesh<F: AsRef<[usize]>>(faces: &[F]) -> Mesh {
    let corners = |face: &F| face.as_ref().iter().map(|&v| v as u32).collect::<Vec<u32>>();
    let faces: Ragged = faces.iter().map(corners).collect();
    let count = faces.indices().iter().max().map_or(0, |&last| last as usize + 1);
    Mesh { positions: vec![[0.0; 3]; count], faces, ..Mesh::default() }
}

fn shape(mesh: &Mesh, topology: &Topology) -> Shape {
    let count = mesh.positions.len();
    let unused = topology.vertex_faces().iter().filter(|faces| faces.is_empty()).count();
    // Parts share vertices; each unused one would be another.
    let parts = components(count, mesh.faces.iter()).into_iter().max().map_or(0, |last| last + 1);
    Shape {
        euler: (count - unused + mesh.faces.len()) as i64 - topology.edges().len() as i64,
        loops: topology.boundary_loops().len(),
        parts: parts as usize - unused,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_quad(face: &[usize]) -> bool {
        face.len() == 4
    }

    #[test]
    fn a_cube_and_a_cube_without_lid_are_surfaces() {
        let cube =
            [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
        let closed = Shape { euler: 2, loops: 0, parts: 1 };
        assert_eq!(verify(&cube, closed, is_quad), (closed, Vec::new()));
        let open = Shape { euler: 1, loops: 1, parts: 1 };
        assert_eq!(verify(&cube[1..], open, is_quad), (open, Vec::new()));
        let (_, faults) = verify(&cube[1..], closed, is_quad);
        assert_eq!(faults.len(), 2);
        let turned = [[0, 1, 2, 3], cube[1], cube[2], cube[3], cube[4], cube[5]];
        let (_, faults) = verify(&turned, closed, is_quad);
        assert!(faults.contains(&ResultFault::Edge { count: 4 }), "{faults:?}");
    }

    #[test]
    fn quads_that_touch_in_a_vertex_and_triangles_are_named() {
        let disk = Shape { euler: 1, loops: 1, parts: 1 };
        let bow = [vec![0, 1, 2, 3], vec![0, 4, 5, 6]];
        let (_, faults) = verify(&bow, disk, is_quad);
        assert!(faults.contains(&ResultFault::Vertex { count: 1 }), "{faults:?}");
        let (_, faults) = verify(&[[0, 1, 2]], disk, is_quad);
        assert_eq!(faults, [ResultFault::Face { count: 1 }]);
    }

    #[test]
    fn no_faces_are_no_torus_and_two_parts_are_not_one() {
        let torus = Shape { euler: 0, loops: 0, parts: 1 };
        let nothing: [[usize; 4]; 0] = [];
        let missing = ResultFault::Parts { expected: 1, found: 0 };
        assert_eq!(verify(&nothing, torus, is_quad).1, [missing]);
        let two = [[0, 1, 2, 3], [4, 5, 6, 7]];
        let apart = Shape { euler: 2, loops: 2, parts: 1 };
        assert_eq!(verify(&two, apart, is_quad).1, [ResultFault::Parts { expected: 1, found: 2 }]);
    }
}
