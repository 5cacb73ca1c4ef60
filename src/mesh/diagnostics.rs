//! Problems of a mesh as a whole: unused vertices, open seams, duplicate faces, non-manifold edges.

use super::problem::{DiagnosticCounts, MeshProblem, ProblemKind};
use super::seams::{seams, seams_of};
use super::sides::{Side, sides_of_faces};
use super::{Mesh, Point};
use crate::math::{argsort, key_of_number, marked};

/// Returns the problems of a mesh that was not read from a file, such as one inside a scene.
pub fn diagnose(mesh: &Mesh) -> Vec<MeshProblem> {
    let mut counts = DiagnosticCounts::default();
    examine(mesh, &[], &[], &mut counts);
    counts.problems(|_| String::new())
}

/// The elements of a mesh that have a given problem of [`diagnose`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ElementsWithProblem {
    /// Indices of vertices.
    pub vertices: Vec<u32>,
    /// Pairs of vertices, lower first.
    pub edges: Vec<[u32; 2]>,
    /// Indices of faces.
    pub faces: Vec<u32>,
}

/// Returns the elements that have the problem `kind`; empty for problems of the file only.
pub fn elements_with_problem(mesh: &Mesh, kind: ProblemKind) -> ElementsWithProblem {
    let mut elements_with_problem = ElementsWithProblem::default();
    match kind {
        ProblemKind::UnusedVertex => {
            elements_with_problem.vertices =
                unused(mesh).into_iter().map(|vertex| vertex as u32).collect();
        }
        ProblemKind::UnjoinedVertex => {
            elements_with_problem.vertices = seams(mesh).into_iter().flatten().collect();
            elements_with_problem.vertices.sort_unstable();
            elements_with_problem.vertices.dedup();
        }
        ProblemKind::DuplicateFace => elements_with_problem.faces = duplicates(mesh),
        ProblemKind::NonManifoldEdge | ProblemKind::FlippedNeighbour => {
            let sides = sides_of_faces(mesh);
            let edges = sides.chunk_by(|a, b| a.ends == b.ends);
            elements_with_problem.edges = edges
                .filter(|edge| problem_of(edge) == Some(kind))
                .map(|edge| edge[0].ends)
                .collect();
        }
        _ => {}
    }
    elements_with_problem
}

/// Returns the problem of the edge with these sides, if any.
fn problem_of(edge: &[Side]) -> Option<ProblemKind> {
    match edge {
        [a, b] if a.ascends == b.ascends => Some(ProblemKind::FlippedNeighbour),
        [_] | [_, _] => None,
        _ => Some(ProblemKind::NonManifoldEdge),
    }
}

/// Counts the problems of a mesh whose vertices and faces are from these lines of a file; without a
/// file, the slices are empty. Returns the vertices at its seams.
pub(super) fn examine(
    mesh: &Mesh,
    vertex_lines: &[u32],
    face_lines: &[u32],
    counts: &mut DiagnosticCounts,
) -> Vec<u32> {
    let line = |lines: &[u32], index: usize| lines.get(index).map(|&line| line as usize);
    for vertex in unused(mesh) {
        counts.add(ProblemKind::UnusedVertex, line(vertex_lines, vertex));
    }
    let sides = sides_of_faces(mesh);
    let at_seams: Vec<u32> = seams_of(mesh, &sides).into_iter().map(|[v, _]| v).collect();
    for &vertex in &at_seams {
        counts.add(ProblemKind::UnjoinedVertex, line(vertex_lines, vertex as usize));
    }
    for face in duplicates(mesh) {
        counts.add(ProblemKind::DuplicateFace, line(face_lines, face as usize));
    }
    for edge in sides.chunk_by(|a, b| a.ends == b.ends) {
        if let Some(kind) = problem_of(edge) {
            let face = edge.last().and_then(|side| side.face);
            counts.add(kind, face.and_then(|face| line(face_lines, face as usize)));
        }
    }
    at_seams
}

/// Returns the vertices that no element uses; none in a mesh without elements, a point set.
fn unused(mesh: &Mesh) -> Vec<usize> {
    let elements = [mesh.faces.indices(), mesh.curves.indices(), mesh.tets.as_flattened()];
    if elements.iter().all(|indices| indices.is_empty()) {
        return Vec::new();
    }
    let used = marked(
        mesh.positions.len(),
        elements.into_iter().flatten().chain(mesh.untouched.indices()),
    );
    (0..used.len()).filter(|&vertex| !used[vertex]).collect()
}

/// Returns the faces that have the same vertices, in any order, as an earlier face.
fn duplicates(mesh: &Mesh) -> Vec<u32> {
    let mut sorted = mesh.faces.clone();
    sorted.sort_rows();
    let mut faces: Vec<u32> = (0..sorted.len() as u32).collect();
    let row = |face: u32| sorted.row(face as usize);
    faces.sort_unstable_by(|&a, &b| row(a).cmp(row(b)).then(a.cmp(&b)));
    faces.windows(2).filter(|pair| row(pair[0]) == row(pair[1])).map(|pair| pair[1]).collect()
}

/// Returns the vertices exactly at an earlier one.
pub(super) fn coincident(positions: &[Point]) -> Vec<usize> {
    let is_number = |vertex: &usize| !positions[*vertex].iter().any(|x| x.is_nan());
    let mut vertices: Vec<usize> = (0..positions.len()).filter(is_number).collect();
    // Stable sorts by z, then y, then x give the lexicographic order (x, y, z, vertex).
    for axis in (0..3).rev() {
        // Adding zero turns -0 into +0.
        let keys = vertices.iter().map(|&vertex| key_of_number(positions[vertex][axis] + 0.0));
        vertices = argsort(keys).into_iter().map(|i| vertices[i as usize]).collect();
    }
    let same = |pair: &&[usize]| positions[pair[0]] == positions[pair[1]];
    vertices.windows(2).filter(same).map(|pair| pair[1]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Kinds and counts of the problems of these faces on `vertices` vertices.
    fn problems(vertices: usize, faces: &[&[u32]]) -> Vec<(ProblemKind, usize)> {
        let positions = (0..vertices).map(|i| [i as f64, 0.0, 0.0]).collect();
        let mesh = Mesh { positions, faces: faces.iter().collect(), ..Mesh::default() };
        diagnose(&mesh).iter().map(|problem| (problem.kind, problem.count)).collect()
    }

    #[test]
    fn a_sound_mesh_has_no_problems() {
        assert_eq!(problems(4, &[&[0, 1, 2], &[0, 2, 3]]), []);
        assert_eq!(problems(7, &[]), []);
    }

    #[test]
    fn each_problem_is_counted() {
        use ProblemKind::*;
        assert_eq!(problems(5, &[&[0, 1, 2]]), [(UnusedVertex, 2)]);
        assert_eq!(problems(4, &[&[0, 1, 2], &[0, 3, 2]]), [(FlippedNeighbour, 1)]);
        assert_eq!(problems(5, &[&[0, 1, 2], &[1, 0, 3], &[0, 1, 4]]), [(NonManifoldEdge, 1)]);
        assert_eq!(problems(3, &[&[0, 1, 2], &[2, 1, 0], &[2, 0, 1]])[0], (DuplicateFace, 2));
    }

    #[test]
    fn what_is_counted_is_found() {
        use ProblemKind::*;
        let faces: [&[u32]; 6] =
            [&[0, 1, 2], &[1, 0, 3], &[0, 1, 4], &[2, 1, 0], &[5, 6, 7], &[5, 8, 7]];
        let positions = (0..11).map(|i| [f64::from(i), 0.0, 0.0]).collect();
        let mesh = Mesh { positions, faces: faces.into_iter().collect(), ..Mesh::default() };
        for problem in diagnose(&mesh) {
            let ElementsWithProblem { vertices, edges, faces } =
                elements_with_problem(&mesh, problem.kind);
            assert_eq!(vertices.len() + edges.len() + faces.len(), problem.count);
        }
        assert_eq!(elements_with_problem(&mesh, UnusedVertex).vertices, [9, 10]);
        assert_eq!(elements_with_problem(&mesh, DuplicateFace).faces, [3]);
        assert_eq!(elements_with_problem(&mesh, NonManifoldEdge).edges, [[0, 1]]);
        assert_eq!(elements_with_problem(&mesh, FlippedNeighbour).edges, [[5, 7]]);
        assert_eq!(elements_with_problem(&mesh, UnknownStatement), ElementsWithProblem::default());
    }

    #[test]
    fn coincident_vertices_are_found_once_each() {
        let [p, q] = [[0.0, 1.0, -0.0], [1.0, 2.0, 3.0]];
        assert!(coincident(&[p, q]).is_empty());
        let mixed = [q, p, [f64::NAN; 3], [f64::NAN; 3], p, q, [-0.0, 1.0, 0.0]];
        assert_eq!(coincident(&mixed), [4, 6, 5]);
    }
}
