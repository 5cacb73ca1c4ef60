//! Shapes fitted to points, for drawing.

use crate::math::Vec3;

/// A fitted shape, drawn over the mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fitted {
    /// A circle in space.
    Circle {
        /// Centre.
        centre: Vec3<f64>,
        /// Unit normal of its plane.
        normal: Vec3<f64>,
        /// Radius, positive and finite.
        radius: f64,
    },
    /// A sphere.
    Sphere {
        /// Centre.
        centre: Vec3<f64>,
        /// Radius, positive and finite.
        radius: f64,
    },
}

/// Largest radius that is drawn, relative to the extent of the points; beyond, the shape is
/// practically a line or a plane there.
const LARGEST_DRAWN: f64 = 4.0;

impl Fitted {
    /// The numbers that the view reads: 0 for a circle or 1 for a sphere, centre, normal, radius.
    pub fn numbers(&self) -> [f64; 8] {
        match *self {
            Fitted::Circle { centre: c, normal: n, radius } => {
                [0.0, c.x, c.y, c.z, n.x, n.y, n.z, radius]
            }
            Fitted::Sphere { centre: c, radius } => [1.0, c.x, c.y, c.z, 0.0, 0.0, 1.0, radius],
        }
    }

    /// Whether its radius is at most [`LARGEST_DRAWN`] times the extent of its points.
    pub(super) fn is_of_the_size_of(&self, points: &[Vec3<f64>]) -> bool {
        let (Fitted::Circle { radius, .. } | Fitted::Sphere { radius, .. }) = *self;
        let extent = points.iter().map(|&p| (p - points[0]).length()).fold(0.0, f64::max);
        radius <= LARGEST_DRAWN * extent
    }
}
