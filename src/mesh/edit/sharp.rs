//! Sharp edges (the boundary and creases) and corners, which a subdivision keeps.

use crate::math::{Vec3, angle_between};
use crate::mesh::{Mesh, Topology, crease_edges};

pub(super) struct Sharp {
    /// `#E`: edges that are smoothed as curves only.
    pub(super) edges: Vec<bool>,
    /// `#V`: vertices that stay fixed.
    pub(super) corners: Vec<bool>,
}

impl Sharp {
    /// Marks as sharp the edges without exactly two faces and those with a fold of more than
    /// `degrees`. Corners are the vertices where two sharp edges turn by more than `degrees`, where
    /// more than two meet, and vertices without a face where fewer meet.
    pub(super) fn of(mesh: &Mesh, topology: &Topology, degrees: f64) -> Sharp {
        let at = |v: u32| Vec3::from(mesh.positions[v as usize]);
        let most = degrees.to_radians();
        let mut edges = crease_edges(mesh, topology, degrees);
        for (is_sharp, faces) in edges.iter_mut().zip(topology.edge_faces().iter()) {
            *is_sharp |= faces.len() != 2;
        }
        let is_corner = |v: u32| match *sharp_neighbours(&edges, topology, v) {
            // A sharp edge that ends inside the surface does not make a corner.
            [] | [_] => topology.vertex_faces().row(v as usize).is_empty(),
            [a, b] => angle_between(at(v) - at(a), at(b) - at(v)).is_some_and(|turn| turn > most),
            _ => true,
        };
        let corners = (0..mesh.positions.len() as u32).map(is_corner).collect();
        Sharp { edges, corners }
    }

    /// Returns the sharp edges and corners after a subdivision with the vertex `first + e` on edge
    /// `e`.
    pub(super) fn subdivided(&self, before: &Topology, first: u32, after: &Topology) -> Sharp {
        let mut edges: Vec<bool> =
            after.edge_faces().iter().map(|faces| faces.len() != 2).collect();
        let sharp = (first..).zip(before.edges()).zip(&self.edges).filter(|(_, sharp)| **sharp);
        for ((middle, ends), _) in sharp {
            for half in ends.iter().filter_map(|&end| after.edge(end, middle)) {
                edges[half as usize] = true;
            }
        }
        let mut corners = self.corners.clone();
        corners.resize(after.neighbours().len(), false);
        Sharp { edges, corners }
    }

    pub(super) fn neighbours(&self, topology: &Topology, v: u32) -> Vec<u32> {
        sharp_neighbours(&self.edges, topology, v)
    }
}

/// The vertices to which sharp edges lead; from a vertex of faces none along a curve beside them, which
/// changes nothing of the surface.
fn sharp_neighbours(edges: &[bool], topology: &Topology, v: u32) -> Vec<u32> {
    let is_of_curve = topology.vertex_faces().row(v as usize).is_empty();
    let counts = |e: u32| is_of_curve || !topology.edge_faces().row(e as usize).is_empty();
    let all = topology.vertex_edges().row(v as usize).iter();
    let sharp = all.filter(|&&e| edges[e as usize] && counts(e));
    sharp.map(|&e| topology.other_end(e, v)).collect()
}
