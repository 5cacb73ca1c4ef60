//! A drag of handles by the pointer: freely, in a plane, or along an axis.
//!
//! In a plane, the dragged point follows the intersection with the ray through the pointer; along
//! an axis, the point of the axis nearest to that ray. Both start from the point under the pointer,
//! with the eye at the start of the drag, so that nothing jumps and nothing drifts.

use crate::view::camera::{Camera, Eye, UpAxis};
use crate::view::model::ViewError;
use glam::{Vec2, Vec3};

/// Sine of the angle below which an axis counts as pointing at the eye, or a plane as seen edge-on.
const EDGE_ON: f32 = 0.1;
/// Maximum distance of a drag, in multiples of the depth of the dragged point.
const FARTHEST: f32 = 20.0;

/// The axis or plane to which a drag is restricted, in file coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DragDirection {
    /// The plane that faces the eye.
    Screen,
    /// Along an axis: 0, 1, 2.
    Axis(usize),
    /// In the plane perpendicular to an axis: 0, 1, 2.
    Plane(usize),
}

/// Names of planes by the axis perpendicular to them.
const PLANES: [&str; 3] = ["yz", "zx", "xy"];
const AXES: [&str; 3] = ["x", "y", "z"];

impl DragDirection {
    /// Returns the direction with this name: `screen`, `x`, `y`, `z`, `xy`, `yz`, `zx`, or relative
    /// to the up axis `horizontal`, `vertical`.
    ///
    /// # Errors
    /// Any other name.
    pub fn named(name: &str, up: UpAxis) -> Result<DragDirection, ViewError> {
        let vertical = match up {
            UpAxis::Z => 2,
            UpAxis::Y => 1,
        };
        let place = |names: [&str; 3]| names.iter().position(|known| *known == name);
        match name {
            "screen" => Ok(DragDirection::Screen),
            "horizontal" => Ok(DragDirection::Plane(vertical)),
            "vertical" => Ok(DragDirection::Axis(vertical)),
            _ => {
                let direction = place(AXES)
                    .map(DragDirection::Axis)
                    .or(place(PLANES).map(DragDirection::Plane));
                direction.ok_or_else(|| ViewError::Word {
                    what: "drag direction",
                    got: name.to_owned(),
                    known: "screen, horizontal, vertical, x, y, z, xy, yz or zx",
                })
            }
        }
    }

    /// Returns its name, which [`DragDirection::named`] reads.
    pub fn name(self) -> &'static str {
        match self {
            DragDirection::Screen => "screen",
            DragDirection::Axis(axis) => AXES[axis],
            DragDirection::Plane(axis) => PLANES[axis],
        }
    }
}

/// A point held by the pointer.
#[derive(Clone, Copy, Debug)]
pub struct DragConstraint {
    eye: Eye,
    /// The dragged point, relative to the view's centre.
    held: Vec3,
    /// Position of the pointer at the start, CSS pixels.
    from: Vec2,
}

impl DragConstraint {
    /// Begins to hold a point, with the pointer somewhere near it on the screen.
    pub fn new(camera: &Camera, held: Vec3, from: Vec2) -> DragConstraint {
        DragConstraint { eye: camera.eye(), held, from }
    }

    /// Returns the displacement of the held point for a pointer displacement of `by` CSS pixels;
    /// `None` if the ray does not determine one, or one out of all proportion. Components that the
    /// direction forbids are exactly zero.
    pub fn displacement(&self, direction: DragDirection, by: Vec2) -> Option<Vec3> {
        let to = self.from + by;
        let displacement = match direction {
            DragDirection::Screen => Some(self.on_screen(to)),
            DragDirection::Axis(axis) => {
                let start = self.along(axis, self.from)?;
                let end = self.along(axis, to)?;
                Some(axis_of(axis) * (end - start))
            }
            DragDirection::Plane(axis) => self.in_plane(axis, to),
        }?;
        let depth = |point: Vec3| self.eye.project(point).1;
        let limit = FARTHEST * depth(self.held);
        (depth(self.held + displacement) > 0.0 && displacement.length() < limit)
            .then_some(displacement)
    }

    /// Returns the screen position of the held point after a displacement, CSS pixels.
    pub fn place(&self, by: Vec3) -> Vec2 {
        self.eye.project(self.held + by).0
    }

    fn on_screen(&self, to: Vec2) -> Vec3 {
        let (_, depth) = self.eye.project(self.held);
        self.eye.across(to - self.from, depth)
    }

    /// Returns the point of the axis nearest to the ray, as a coordinate from the held point.
    fn along(&self, axis: usize, at: Vec2) -> Option<f32> {
        let along = axis_of(axis);
        let (from, sight) = self.eye.ray(at);
        let sight = sight.normalize();
        let part = along.dot(sight);
        let across = 1.0 - part * part;
        if across < EDGE_ON * EDGE_ON {
            return None;
        }
        let offset = from - self.held;
        let far = (offset.dot(along) - part * offset.dot(sight)) / across;
        // Accepted only if the nearest point of the ray is in front of the eye.
        (self.held + along * far - from).dot(sight).is_sign_positive().then_some(far)
    }

    /// Returns the displacement in the plane perpendicular to an axis.
    fn in_plane(&self, axis: usize, to: Vec2) -> Option<Vec3> {
        let normal = axis_of(axis);
        let meet = |at: Vec2| {
            let (from, sight) = self.eye.ray(at);
            let sight = sight.normalize();
            let slope = sight.dot(normal);
            let far = (self.held - from).dot(normal) / slope;
            (slope.abs() >= EDGE_ON * 0.2 && far > 0.0).then(|| from + sight * far)
        };
        let (_, sight) = self.eye.ray(self.from);
        let mut displacement = if sight.normalize().dot(normal).abs() < EDGE_ON {
            // Edge-on, a plane is a line: vertical screen movement determines nothing in it.
            self.on_screen(to)
        } else {
            meet(to)? - meet(self.from)?
        };
        displacement[axis] = 0.0;
        Some(displacement)
    }
}

/// Returns the unit vector along an axis.
pub fn axis_of(axis: usize) -> Vec3 {
    Vec3::AXES[axis]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::camera::CameraProjection;

    const HELD: Vec3 = Vec3::new(0.3, -0.2, 0.4);

    fn camera(turn: f32, tilt: f32) -> Camera {
        Camera { turn, tilt, distance: 6.0, canvas: Vec2::new(900.0, 700.0), ..Camera::default() }
    }

    fn views() -> impl Iterator<Item = Camera> {
        let turns = [-2.8, -1.0, 0.4, 0.9, 2.2];
        let cameras = turns
            .into_iter()
            .flat_map(|turn| [-1.2, -0.5, 0.35, 0.8].map(|tilt| camera(turn, tilt)));
        cameras.flat_map(|camera| {
            let parallel = CameraProjection::Parallel { reach: 10.0 };
            [camera, Camera { projection: parallel, ..camera }]
        })
    }

    /// Holds a point from beside it, and moves the pointer by the screen displacement of `by`.
    fn drag(camera: &Camera, direction: DragDirection, by: Vec3) -> Option<Vec3> {
        let eye = camera.eye();
        let beside = Vec2::new(9.0, -6.0);
        let on_screen = |point| eye.project(point).0 + beside;
        DragConstraint::new(camera, HELD, on_screen(HELD))
            .displacement(direction, on_screen(HELD + by) - on_screen(HELD))
    }

    #[test]
    fn what_is_dragged_along_an_axis_stays_under_the_pointer_and_on_the_axis() {
        for camera in views() {
            for axis in 0..3 {
                let by = axis_of(axis) * 0.7;
                let Some(moved) = drag(&camera, DragDirection::Axis(axis), by) else {
                    panic!("{camera:?} sees the axis {axis}");
                };
                assert!((moved - by).length() < 0.05, "{camera:?} {axis} {moved}");
                assert!((0..3).all(|other| other == axis || moved[other] == 0.0));
            }
        }
    }

    #[test]
    fn what_is_dragged_in_a_plane_stays_under_the_pointer_and_in_the_plane() {
        for camera in views() {
            for axis in 0..3 {
                let mut by = Vec3::new(0.3, -0.25, 0.2);
                by[axis] = 0.0;
                let eye = camera.eye();
                let seen = (HELD - eye.at).normalize()[axis].abs();
                let Some(moved) = drag(&camera, DragDirection::Plane(axis), by) else {
                    panic!("{camera:?} sees the plane across {axis}");
                };
                assert_eq!(moved[axis], 0.0);
                if seen > 0.3 {
                    assert!((moved - by).length() < 0.12, "{camera:?} {axis} {moved}");
                }
            }
        }
    }

    #[test]
    fn taken_exactly_at_the_point_it_follows_exactly() {
        for camera in views() {
            let eye = camera.eye();
            let drag = DragConstraint::new(&camera, HELD, eye.project(HELD).0);
            for (direction, by) in [
                (DragDirection::Axis(2), Vec3::new(0.0, 0.0, 0.5)),
                (DragDirection::Plane(2), Vec3::new(0.4, -0.3, 0.0)),
                (DragDirection::Screen, eye.right * 0.3 - eye.up * 0.2),
            ] {
                let went = drag
                    .displacement(direction, eye.project(HELD + by).0 - eye.project(HELD).0)
                    .unwrap();
                assert!((went - by).length() < 2e-5, "{direction:?} {went} {by}");
            }
        }
    }

    #[test]
    fn an_axis_that_points_at_the_eye_says_nothing() {
        let above = camera(0.0, std::f32::consts::FRAC_PI_2);
        let at = above.eye().project(HELD).0;
        let drag = DragConstraint::new(&above, HELD, at);
        assert_eq!(drag.displacement(DragDirection::Axis(2), Vec2::splat(40.0)), None);
        // A plane seen edge-on still moves to the right.
        let front = camera(0.0, 0.0);
        let at = front.eye().project(Vec3::ZERO).0;
        let drag = DragConstraint::new(&front, Vec3::ZERO, at);
        let moved = drag.displacement(DragDirection::Plane(2), Vec2::new(50.0, -30.0)).unwrap();
        assert!(moved.x > 0.0 && moved.y.abs() < 1e-6 && moved.z == 0.0, "{moved}");
    }

    #[test]
    fn beyond_the_horizon_there_is_nothing() {
        let low = camera(0.3, 0.3);
        let at = low.eye().project(HELD).0;
        let drag = DragConstraint::new(&low, HELD, at);
        assert!(drag.displacement(DragDirection::Plane(2), Vec2::new(0.0, -30.0)).is_some());
        assert_eq!(drag.displacement(DragDirection::Plane(2), Vec2::new(0.0, -2000.0)), None);
    }

    #[test]
    fn names_are_read_as_they_are_written() {
        for direction in [
            DragDirection::Screen,
            DragDirection::Axis(0),
            DragDirection::Axis(1),
            DragDirection::Plane(0),
            DragDirection::Plane(2),
        ] {
            assert_eq!(DragDirection::named(direction.name(), UpAxis::Z).unwrap(), direction);
        }
        assert_eq!(DragDirection::named("horizontal", UpAxis::Y).unwrap(), DragDirection::Plane(1));
        assert_eq!(DragDirection::named("vertical", UpAxis::Z).unwrap(), DragDirection::Axis(2));
        assert!(
            DragDirection::named("sideways", UpAxis::Z)
                .unwrap_err()
                .to_string()
                .contains("sideways")
        );
    }
}
