//! Elements of the mesh that have a problem, so that a host can show them.

use crate::math::Vec3;
use crate::mesh::{ElementsWithProblem, Point, ProblemKind};
use crate::session::Session;
use crate::session::state::RestMesh;
use crate::solve::coordinate_rounding;

/// Name of a problem of the current shape, not of the file: faces of zero area.
pub const ZERO_SIZE_FACES: &str = "zero-size-faces";
/// Name of the faces that are folded or dented in the current shape but not at rest.
pub const FOLDED_FACES: &str = "folded-faces";

/// A face thinner than this fraction of the mesh size has no area except by rounding.
const ROUNDING: f64 = 1e-12;

/// Problems whose elements are still in the mesh, with their names in queries.
const PROBLEMS: &[(&str, ProblemKind)] = &[
    ("unused-vertices", ProblemKind::UnusedVertex),
    ("unjoined-vertices", ProblemKind::UnjoinedVertex),
    ("duplicate-faces", ProblemKind::DuplicateFace),
    ("crowded-edges", ProblemKind::NonManifoldEdge),
    ("flipped-edges", ProblemKind::FlippedNeighbour),
];

/// Returns the query name of a problem; none if its elements are not in the mesh.
pub fn flaw_of(kind: ProblemKind) -> Option<&'static str> {
    PROBLEMS.iter().find(|(_, other)| *other == kind).map(|(name, _)| *name)
}

impl Session {
    /// Returns the elements with the problem `name`, of [`flaw_of`], [`FOLDED_FACES`] or
    /// [`ZERO_SIZE_FACES`], at the current positions; none for any other name.
    pub fn elements_with_problem(&self, name: &str) -> Option<ElementsWithProblem> {
        let (positions, rest) = (self.scene.positions(), &self.rest);
        let found = match name {
            ZERO_SIZE_FACES => Some(zero_size_faces(positions, rest)),
            FOLDED_FACES => Some(rest.folded_by(positions)),
            _ => None,
        };
        if let Some(faces) = found {
            return Some(ElementsWithProblem { faces, ..ElementsWithProblem::default() });
        }
        let (_, kind) = PROBLEMS.iter().find(|(other, _)| *other == name)?;
        Some(crate::mesh::elements_with_problem(rest.mesh(), *kind))
    }
}

/// Returns the faces whose corners are collinear or coincident.
fn zero_size_faces(positions: &[Point], rest: &RestMesh) -> Vec<u32> {
    let at = |v: u32| Vec3::from(positions[v as usize]);
    // Corners far from the origin have the rounding of their coordinates.
    let least = (ROUNDING * rest.diameter()).max(coordinate_rounding(rest.mesh()));
    let is_flat = |corners: &[u32]| {
        let first = at(corners[0]);
        let offsets = corners.iter().map(|&v| at(v) - first);
        let farthest =
            offsets.clone().max_by(|a, b| a.length_squared().total_cmp(&b.length_squared()));
        let Some(farthest) = farthest else { return true };
        let length = farthest.length();
        offsets.clone().all(|offset| offset.cross(farthest).length() <= least * length)
    };
    let faces = (0..).zip(rest.mesh().faces.iter());
    faces.filter(|(_, corners)| is_flat(corners)).map(|(face, _)| face).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Mesh;
    use crate::scene::{MeshSource, Scene};

    /// A square, a collinear triangle, a triangle in one point, and an unused vertex.
    fn session(scale: f64) -> Session {
        session_at(|corner| corner.map(|x| scale * x))
    }

    /// The same, with other corners.
    fn session_at(place: impl Fn([f64; 3]) -> [f64; 3]) -> Session {
        let corners: [[f64; 3]; 8] = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, 1.0, 0.0],
            [0.0, 1.0, 0.0],
            [2.0, 0.0, 0.0],
            [1.0, 1.0, 0.0],
            [1.0, 1.0, 0.0],
            [5.0, 5.0, 0.0],
        ];
        let faces: [&[u32]; 3] = [&[0, 1, 2, 3], &[0, 4, 1], &[2, 5, 6]];
        let mesh = Mesh {
            positions: corners.into_iter().map(place).collect(),
            faces: faces.into_iter().collect(),
            ..Mesh::default()
        };
        let scene = Scene::new(MeshSource::File(String::new()));
        Session::open(scene, mesh).expect("it opens")
    }

    #[test]
    fn faces_without_an_area_are_found_at_every_scale() {
        for scale in [1e-3, 1.0, 1e3] {
            let found = session(scale).elements_with_problem(ZERO_SIZE_FACES).expect("it is known");
            assert_eq!(found.faces, [1, 2]);
        }
    }

    #[test]
    fn faces_without_an_area_are_found_far_from_the_origin_too() {
        // The rounding of such coordinates was taken for an area.
        let on_site = |[x, y, z]: [f64; 3]| {
            [0.1 * x + 0.3 * y + 5_482_113.7, 0.7 * x - 0.2 * y + 465_220.1, 0.9 * x + z]
        };
        let found = session_at(on_site).elements_with_problem(ZERO_SIZE_FACES);
        assert_eq!(found.expect("it is known").faces, [1, 2]);
    }

    #[test]
    fn problems_of_the_mesh_name_their_elements() {
        let session = session(1.0);
        let name = flaw_of(ProblemKind::UnusedVertex).expect("it is in the mesh");
        assert_eq!(session.elements_with_problem(name).expect("it is known").vertices, [7]);
        assert_eq!(flaw_of(ProblemKind::UnknownStatement), None);
        assert_eq!(session.elements_with_problem("beauty"), None);
        let edges = session.topology().edges();
        let found = session.edges_between(&[[0, 1], [2, 3]]);
        assert_eq!(found.len(), 2);
        assert!(found.iter().all(|&e| [[0, 1], [2, 3]].contains(&edges[e as usize])));
    }
}
