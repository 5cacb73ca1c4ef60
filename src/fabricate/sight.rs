//! Directions of view on the building.

use crate::math::{self, Vec3};

/// A direction of view as unit vectors: right, up, and away from the viewer.
pub(super) type Sight = [Vec3<f64>; 3];

/// The axes of a mesh that point east, north and up, if z is up, or else y.
pub(super) fn compass(z_up: bool) -> Sight {
    let [x, y, z] = [Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.0, 0.0, 1.0)];
    if z_up { [x, y, z] } else { [x, -z, y] }
}

/// The view from above.
pub(super) fn from_above(z_up: bool) -> Sight {
    let [east, north, up] = compass(z_up);
    [east, north, -up]
}

/// The view of a camera that is turned about the upward axis and tilted down, in radians.
pub(super) fn from_camera(z_up: bool, camera: [f64; 2]) -> Sight {
    let [east, north, up] = compass(z_up);
    let turns = |radians: f64| radians / std::f64::consts::TAU;
    let [[sine, cosine], [down, level]] =
        camera.map(turns).map(|turns| [math::sine(turns), math::cosine(turns)]);
    let right = east * cosine + north * sine;
    let away = (north * cosine - east * sine) * level - up * down;
    [right, right.cross(away), away]
}
