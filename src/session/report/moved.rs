//! What the shape has cost the design: how far the vertices are from where they were, and how much the
//! edges have shrunk.

use crate::math::Vec3;
use crate::session::state::Session;
use serde::Serialize;

/// How far vertices are from their rest positions, units of the mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Moved {
    /// The farthest one.
    pub max: f64,
    /// On average.
    pub mean: f64,
}

impl Session {
    /// How far the vertices are from their rest positions.
    pub fn moved(&self) -> Moved {
        let ways = self.displacements();
        let max = ways.iter().copied().fold(0.0, f64::max);
        Moved { max, mean: ways.iter().sum::<f64>() / ways.len().max(1) as f64 }
    }

    /// The least length of an edge as a part of its length at rest; those without a length at rest do
    /// not count, and without edges it is 1.
    pub fn shortest_edge(&self) -> f64 {
        let now = self.positions();
        let rest = &self.mesh.positions;
        let squared = |of: &[[f64; 3]], [a, b]: [u32; 2]| {
            (Vec3::from(of[a as usize]) - Vec3::from(of[b as usize])).length_squared()
        };
        let edges = self.topology.edges().iter();
        let ratios = edges.filter_map(|&ends| match squared(rest, ends) {
            0.0 => None,
            before => Some(squared(&now, ends) / before),
        });
        ratios.reduce(f64::min).map_or(1.0, f64::sqrt)
    }

    /// Per vertex, its distance to its rest position: `#V`.
    pub(crate) fn displacements(&self) -> Vec<f64> {
        let pairs = self.solver.positions().zip(&self.mesh.positions);
        pairs.map(|(now, &rest)| (Vec3::from(now) - Vec3::from(rest)).length()).collect()
    }
}
