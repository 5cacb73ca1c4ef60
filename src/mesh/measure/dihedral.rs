//! Dihedral angles: between the normals of two faces with a common edge.

use crate::math::{Vec3, angle, polygon_sides, twice_vector_area};
use crate::mesh::{Mesh, Point, Ragged, Topology};

/// Two faces with a common edge.
pub(super) struct Neighbours {
    pub(super) faces: [u32; 2],
    /// -1 if they traverse the edge in the same direction, so that their orientations are opposite.
    sign: f64,
}

impl Neighbours {
    /// Returns the two faces of each edge that has two.
    pub(super) fn all<'a>(
        mesh: &'a Mesh,
        topology: &'a Topology,
    ) -> impl Iterator<Item = Neighbours> + 'a {
        let pairs = topology.edge_faces().iter().zip(topology.edges());
        pairs.filter_map(|(faces, &[start, end])| {
            let &[a, b] = faces else { return None };
            let runs = |face: u32| {
                polygon_sides(mesh.faces.row(face as usize))
                    .any(|[from, to]| [from, to] == [start, end])
            };
            let sign = if runs(a) == runs(b) { -1.0 } else { 1.0 };
            Some(Neighbours { faces: [a, b], sign })
        })
    }

    /// Returns the cosine of their angle; 0 if a face has no area.
    pub(super) fn cosine(&self, normals: &[Vec3<f64>]) -> f64 {
        let [a, b] = self.faces.map(|face| normals[face as usize]);
        self.sign * a.dot(b)
    }

    /// Returns their angle in radians; 0 if a face has no area.
    fn angle(&self, normals: &[Vec3<f64>]) -> f64 {
        let [a, b] = self.faces.map(|face| normals[face as usize]);
        angle(self.sign * a.dot(b), a.cross(b).length())
    }
}

/// Returns the unit normal of each face; zero for a face without area.
pub(super) fn unit_normals(faces: &Ragged, at: &[Point]) -> Vec<Vec3<f64>> {
    let normal = |face: &[u32]| {
        let area = twice_vector_area(face.iter().map(|&v| Vec3::from(at[v as usize])));
        let length = area.length();
        if length > 0.0 { area * (1.0 / length) } else { Vec3::zero() }
    };
    faces.iter().map(normal).collect()
}

/// Returns the mean angle in degrees between the normals of neighbouring faces at the positions
/// `at` (`#V by 3`); 0 if no edge has two faces.
pub fn mean_dihedral_angle(mesh: &Mesh, topology: &Topology, at: &[Point]) -> f64 {
    let normals = unit_normals(&mesh.faces, at);
    let (mut sum, mut count) = (0.0, 0.0);
    for pair in Neighbours::all(mesh, topology) {
        sum += pair.angle(&normals);
        count += 1.0;
    }
    if count > 0.0 { f64::to_degrees(sum / count) } else { 0.0 }
}
