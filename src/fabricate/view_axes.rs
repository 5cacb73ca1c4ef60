//! Directions of view on the building, and the building seen in one.

use super::panel::direction_of;
use super::surface::PanelSurface;
use crate::math::plane::{Point2, bounds, length};
use crate::math::{self, Vec3};

/// A direction of view as unit vectors: right, up, and away from the viewer.
pub(super) type ViewAxes = [Vec3<f64>; 3];

/// The axes of a mesh that point east, north and up, if z is up, or else y.
pub(super) fn compass(z_up: bool) -> ViewAxes {
    let [x, y, z] = [Vec3::new(1.0, 0.0, 0.0), Vec3::new(0.0, 1.0, 0.0), Vec3::new(0.0, 0.0, 1.0)];
    if z_up { [x, y, z] } else { [x, -z, y] }
}

/// Sine of the slope up to which a part counts as level, 5 degrees: which way it rises is not seen.
const LEVEL: f64 = 0.0872;

/// The unit vector in a plane with these axes that points upwards, or if it is level, to the top of the
/// view from above.
pub(super) fn upwards_in(axes: [Vec3<f64>; 2], z_up: bool) -> Point2 {
    let [_, north, up] = compass(z_up);
    let within = |way: Vec3<f64>| axes.map(|axis| way.dot(axis));
    let steepest = within(up);
    let way = if length(steepest) > LEVEL { steepest } else { within(north) };
    direction_of([0.0; 2], way)
}

/// The view from above.
pub(super) fn from_above(z_up: bool) -> ViewAxes {
    let [east, north, up] = compass(z_up);
    [east, north, -up]
}

/// The view of a camera that is turned about the upward axis and tilted down, in radians.
pub(super) fn from_camera(z_up: bool, camera: [f64; 2]) -> ViewAxes {
    let [east, north, up] = compass(z_up);
    let turns = |radians: f64| radians / std::f64::consts::TAU;
    let [[sine, cosine], [down, level]] =
        camera.map(turns).map(|turns| [math::sine(turns), math::cosine(turns)]);
    let right = east * cosine + north * sine;
    let away = (north * cosine - east * sine) * level - up * down;
    [right, right.cross(away), away]
}

/// The vertices of a surface in a picture, in the unit of the mesh.
pub(super) struct Seen {
    /// Where they are, `#V`.
    pub points: Vec<Point2>,
    /// How far away they are, `#V`.
    pub depths: Vec<f64>,
    /// The lower left corner of the box of all panels.
    pub low: Point2,
    /// Width and height of that box.
    pub size: [f64; 2],
}

impl Seen {
    pub(super) fn new(surface: &PanelSurface, [right, up, away]: ViewAxes) -> Seen {
        let at = &surface.positions;
        let points: Vec<Point2> = at.iter().map(|p| [p.dot(right), p.dot(up)]).collect();
        let [low, high] = bounds(surface.faces.indices().iter().map(|&v| points[v as usize]));
        let depths = at.iter().map(|p| p.dot(away)).collect();
        Seen { points, depths, low, size: [high[0] - low[0], high[1] - low[1]] }
    }
}
