//! Shapes that are fitted to points, to be drawn.

use crate::math::Vec3;

/// A fitted shape, to be drawn over the mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fitted {
    /// A circle in space: centre, unit normal, radius.
    Circle {
        /// Centre.
        centre: Vec3<f64>,
        /// Unit normal of its plane.
        normal: Vec3<f64>,
        /// Radius, positive and finite.
        radius: f64,
    },
    /// A sphere: centre, radius.
    Sphere {
        /// Centre.
        centre: Vec3<f64>,
        /// Radius, positive and finite.
        radius: f64,
    },
}

/// A shape whose radius is so many times the extent of its points is all but a line or a plane there.
const LARGEST_DRAWN: f64 = 4.0;

impl Fitted {
    /// As the view takes it: 0 for a circle and 1 for a sphere, centre, normal, radius.
    pub fn numbers(&self) -> [f64; 8] {
        match *self {
            Fitted::Circle { centre: c, normal: n, radius } => {
                [0.0, c.x, c.y, c.z, n.x, n.y, n.z, radius]
            }
            Fitted::Sphere { centre: c, radius } => [1.0, c.x, c.y, c.z, 0.0, 0.0, 1.0, radius],
        }
    }

    /// Whether its radius is not many times the extent of its points.
    pub(super) fn is_of_the_size_of(&self, points: &[Vec3<f64>]) -> bool {
        let (Fitted::Circle { radius, .. } | Fitted::Sphere { radius, .. }) = *self;
        let extent = points.iter().map(|&p| (p - points[0]).length()).fold(0.0, f64::max);
        radius <= LARGEST_DRAWN * extent
    }
}
