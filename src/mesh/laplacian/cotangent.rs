//! Clamped cotangents of angles.

use crate::math::Vec3;
use crate::mesh::Point;

/// Bound to which cotangents are clamped, the cotangent of 0.057 degrees. Triangles with a smaller
/// angle or without area then have finite weights. The bound is independent of scale.
pub const LARGEST_COTANGENT: f64 = 1e3;

/// Returns the clamped cotangent of the angle at the first point.
pub(super) fn cotangent([at, a, b]: [Point; 3]) -> f64 {
    let at = Vec3::from(at);
    let (u, v) = (Vec3::from(a) - at, Vec3::from(b) - at);
    let (cos, sin) = (u.dot(v), u.cross(v).length());
    if cos.abs() > LARGEST_COTANGENT * sin {
        LARGEST_COTANGENT.copysign(cos)
    } else if sin > 0.0 {
        cos / sin
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cotangents_of_known_angles() {
        let o = [0.0; 3];
        assert_eq!(cotangent([o, [2.0, 0.0, 0.0], [0.0, 3.0, 0.0]]), 0.0);
        assert_eq!(cotangent([o, [2.0, 0.0, 0.0], [3.0, 3.0, 0.0]]), 1.0);
        assert_eq!(cotangent([o, [2.0, 0.0, 0.0], [-3.0, 0.0, 3.0]]), -1.0);
    }

    #[test]
    fn cotangents_of_degenerate_triangles_are_finite() {
        let (o, x) = ([0.0; 3], [1.0, 0.0, 0.0]);
        assert_eq!(cotangent([o, x, [2.0, 0.0, 0.0]]), LARGEST_COTANGENT);
        assert_eq!(cotangent([o, x, [-2.0, 0.0, 0.0]]), -LARGEST_COTANGENT);
        assert_eq!(cotangent([o, o, x]), 0.0);
        assert_eq!(cotangent([o, o, o]), 0.0);
    }
}
