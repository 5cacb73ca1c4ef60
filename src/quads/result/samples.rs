//! Normals and curvature of the surface at the nodes of the grid.

use crate::math::Vec3;
use crate::mesh::Tensor;
use crate::quads::extract::{Node, Place};
use crate::quads::surface::Prepared;

/// The surface at each node.
pub(in crate::quads) struct Samples {
    /// `#N`: unit normals, interpolated from those of vertices; zero where there is none.
    pub(in crate::quads) normals: Vec<Vec3<f64>>,
    /// `#N`: second fundamental forms.
    pub(in crate::quads) tensors: Vec<Tensor>,
}

impl Samples {
    /// Interpolates linearly in the triangles.
    pub(in crate::quads) fn of(prepared: &Prepared, nodes: &[Node]) -> Samples {
        let surface = &prepared.surface;
        let mut at_vertices = vec![Vec3::zero(); surface.positions.len()];
        for (t, triangle) in surface.triangles.iter().enumerate() {
            triangle.iter().for_each(|&v| at_vertices[v] += surface.area_vector(t));
        }
        let at_vertices: Vec<Vec3<f64>> =
            at_vertices.into_iter().map(Vec3::direction_or_zero).collect();
        let mut samples = Samples { normals: Vec::new(), tensors: Vec::new() };
        for node in nodes {
            let weights = weights(prepared, node);
            let parts = || weights.iter().filter(|(_, weight)| *weight != 0.0);
            let normal = parts().fold(Vec3::zero(), |sum, &(v, w)| sum + at_vertices[v] * w);
            let mut tensor = [0.0; 6];
            for &(v, weight) in parts() {
                let added = tensor.iter_mut().zip(prepared.tensors[v]);
                added.for_each(|(sum, value)| *sum += weight * value);
            }
            samples.normals.push(normal.direction_or_zero());
            samples.tensors.push(tensor);
        }
        samples
    }
}

/// The vertices around a node with their barycentric coordinates.
fn weights(prepared: &Prepared, node: &Node) -> [(usize, f64); 3] {
    let surface = &prepared.surface;
    match node.place {
        Place::Vertex(v) => [(v, 1.0), (v, 0.0), (v, 0.0)],
        Place::Side(side) => {
            let [a, b] = [0, 1].map(|k| surface.corner(side.triangle, side.side + k));
            let along = surface.along(side);
            let to_node = node.position - surface.positions[a];
            let share = (to_node.dot(along) / along.length_squared()).clamp(0.0, 1.0);
            [(a, 1.0 - share), (b, share), (b, 0.0)]
        }
        Place::Inside(t) => {
            let weights = surface.barycentric(t, node.position);
            [0, 1, 2].map(|k| (surface.corner(t, k), weights[k]))
        }
    }
}
