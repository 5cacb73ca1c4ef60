//! The plane of a beam: through its edge and its upward direction.

use crate::fabricate::offset::across_edge;
use crate::fabricate::surface::{PanelSurface, unit};
use crate::math::Vec3;
use crate::math::plane::Point2;

/// The plane of the beam along an edge, in which its fin is laid flat.
#[derive(Clone, Copy, Debug)]
pub struct BeamPlane {
    /// The first node of the edge.
    pub origin: Vec3<f64>,
    /// The unit vector along the edge; zero if it has no length.
    pub along: Vec3<f64>,
    /// The upward direction `P_e (n_i + n_j)`, normalised; zero if there is none.
    pub up: Vec3<f64>,
}

impl BeamPlane {
    /// The plane of an edge with these node axes (`#V`).
    pub fn of(surface: &PanelSurface, axes: &[Vec3<f64>], edge: u32) -> BeamPlane {
        let own = &surface.edges[edge as usize];
        let [n, m] = own.ends.map(|v| axes[v as usize]);
        let along = surface.direction(own);
        let up = unit(across_edge(n + m, along));
        BeamPlane { origin: surface.at(own.ends[0]), along, up }
    }

    /// A point of the outline of a fin, in space.
    pub fn in_space(&self, [x, y]: Point2) -> Vec3<f64> {
        self.origin + self.along * x + self.up * y
    }

    /// The part of a vector in the plane, along the edge and upwards.
    pub fn flat(&self, vector: Vec3<f64>) -> Point2 {
        [vector.dot(self.along), vector.dot(self.up)]
    }
}
