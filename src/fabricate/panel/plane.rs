//! Least-squares planes.

use crate::math::{PrincipalAxes, Vec3};

/// The least-squares plane of some points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane {
    /// The mean of the points.
    pub(super) centre: Vec3<f64>,
    /// Unit normal, of either sign.
    pub(super) normal: Vec3<f64>,
    /// Largest distance of a point from the plane.
    pub(super) distance: f64,
}

impl Plane {
    /// Fits a plane to at least one point. Collinear points get some plane through them.
    pub(super) fn of(points: &[Vec3<f64>]) -> Plane {
        let mut own = points.to_vec();
        let centre = crate::math::centre(&mut own);
        let axes = PrincipalAxes::rotate(&mut own);
        let distance = own.iter().map(|point| point.z.abs()).fold(0.0, f64::max) * axes.scale;
        Plane { centre, normal: axes.axes[2], distance }
    }
}

/// The largest distance of some points from their least-squares plane.
pub(in crate::fabricate) fn plane_distance(points: &[Vec3<f64>]) -> f64 {
    Plane::of(points).distance
}
