//! How far the result and the input are from each other.

use crate::math::Vec3;
use crate::mesh::{Mesh, Point, Surface};
use serde::Serialize;

/// Largest distances, in the unit of the mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct LargestDistances {
    /// From the vertices of the result to the input.
    pub to_input: f64,
    /// From the vertices of the input to the result.
    pub from_input: f64,
}

/// The distances between the vertices of the result and the input, both ways, in the unit of the mesh.
pub(in crate::quads) struct Distances {
    /// From the vertices of the result to the input.
    pub(in crate::quads) to_input: Vec<f64>,
    /// From the used vertices of the input to the result.
    pub(in crate::quads) from_input: Vec<f64>,
    /// The largest of both.
    pub(in crate::quads) largest: LargestDistances,
}

impl Distances {
    /// Measures the distances both ways between two meshes.
    pub(in crate::quads) fn between(result: &Mesh, input: &Mesh) -> Distances {
        let [to_input, from_input] = [distances(result, input), distances(input, result)];
        let largest = |all: &[f64]| all.iter().copied().fold(0.0, f64::max);
        let largest =
            LargestDistances { to_input: largest(&to_input), from_input: largest(&from_input) };
        Distances { to_input, from_input, largest }
    }
}

/// The distance of each used vertex of a mesh to the faces of another one.
fn distances(from: &Mesh, to: &Mesh) -> Vec<f64> {
    let surface = Surface::of_polygons(&to.positions, to);
    let mut hint = Surface::NO_HINT;
    let to_surface = |&point: &Point| {
        let closest = surface.closest(point, &mut hint);
        (Vec3::from(closest) - Vec3::from(point)).length()
    };
    from.used_positions().iter().map(to_surface).collect()
}
