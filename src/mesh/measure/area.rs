//! The area of a surface without its wrinkles.

use crate::math::{Vec3, marked, twice_vector_area};
use crate::mesh::{Mesh, Point, Topology};

/// Number of times that each vertex is replaced by the mean of its neighbours: it removes wrinkles of
/// the length of an edge or two.
const ROUNDS: usize = 3;

/// Returns the area of the faces at `at` (`#V by 3`) after smoothing, with the boundary kept. A
/// surface that crumples keeps its area but loses this one.
pub fn smoothed_area(mesh: &Mesh, topology: &Topology, at: &[Point]) -> f64 {
    let mut smooth = at.to_vec();
    let is_boundary = marked(at.len(), topology.boundary_loops().indices());
    let around = |v: usize| topology.neighbours().row(v);
    for _ in 0..ROUNDS {
        let before = smooth.clone();
        for v in (0..at.len()).filter(|&v| !is_boundary[v] && !around(v).is_empty()) {
            let own = Vec3::from(before[v]);
            let ways = around(v).iter().map(|&n| Vec3::from(before[n as usize]) - own);
            let sum = ways.fold(Vec3::zero(), |sum, way| sum + way);
            smooth[v] = (own + sum * (1.0 / around(v).len() as f64)).into();
        }
    }
    let corner = |&v: &u32| Vec3::from(smooth[v as usize]);
    let area = |face: &[u32]| 0.5 * twice_vector_area(face.iter().map(corner)).length();
    mesh.faces.iter().map(area).sum()
}
