//! Displacements of the vertices, and shrinking of the edges.

use crate::math::Vec3;
use crate::session::state::{RestMesh, SolvedScene};
use crate::solve::Moved;

/// Returns the distances of the vertices from their rest positions, in the unit of the mesh.
pub(crate) fn moved(scene: &SolvedScene, rest: &RestMesh) -> Moved {
    rest.moved_by(scene.positions())
}

/// Returns the smallest ratio of an edge length to its rest length. Ignores edges of zero rest
/// length; 1 without edges.
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

/// Returns the distance of each vertex from its rest position, `#V`, in the unit of the mesh.
pub(super) fn displacements(scene: &SolvedScene, rest: &RestMesh) -> Vec<f64> {
    rest.displacements(scene.positions()).collect()
}
