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
    for _ in 0..ROUNDS {
        let before = smooth.clone();
        for v in (0..at.len()).filter(|&v| !is_boundary[v]) {
            let own = Vec3::from(before[v]);
            let ways =
                topology.body_neighbours(v as u32).map(|n| Vec3::from(before[n as usize]) - own);
            let (sum, count) = ways.fold((Vec3::zero(), 0.0), |(sum, n), way| (sum + way, n + 1.0));
            smooth[v] = (own + sum * (1.0 / f64::max(count, 1.0))).into();
        }
    }
    let corner = |&v: &u32| Vec3::from(smooth[v as usize]);
    let area = |face: &[u32]| 0.5 * twice_vector_area(face.iter().map(corner)).length();
    mesh.faces.iter().map(area).sum()
}
