//! How far the vertices are from where they were, and how much the edges have shrunk.

use crate::math::Vec3;
use crate::session::state::{RestMesh, SolvedScene};
use crate::solve::Moved;

/// Distances of the vertices from their rest positions, in the unit of the mesh.
pub(crate) fn moved(scene: &SolvedScene, rest: &RestMesh) -> Moved {
    rest.moved_by(scene.positions())
}

/// The least length of an edge as a part of its length at rest; those without a length at rest do not
/// count, and without edges it is 1.
pub(crate) fn shortest_edge(scene: &SolvedScene, rest: &RestMesh) -> f64 {
    let squared = |of: &[[f64; 3]], [a, b]: [u32; 2]| {
        (Vec3::from(of[a as usize]) - Vec3::from(of[b as usize])).length_squared()
    };
    let edges = rest.topology().edges().iter();
    let ratios = edges.filter_map(|&ends| match squared(rest.positions(), ends) {
        0.0 => None,
        before => Some(squared(scene.positions(), ends) / before),
    });
    ratios.reduce(f64::min).map_or(1.0, f64::sqrt)
}

/// The distance of each vertex from its rest position, `#V`, in the unit of the mesh.
pub(super) fn displacements(scene: &SolvedScene, rest: &RestMesh) -> Vec<f64> {
    rest.displacements(scene.positions()).collect()
}
