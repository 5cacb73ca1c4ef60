//! The movement of the camera from one view to another: it turns the shorter way round, and its
//! distance changes by equal factors.

use super::orbit_camera::Camera;
use glam::Vec3;
use std::f32::consts::{PI, TAU};

/// The start and the end of a camera movement.
#[derive(Clone, Copy, Debug)]
pub struct Flight {
    from: Camera,
    to: Camera,
    /// The camera after the last move; if it differs now, something else has moved it.
    at: Camera,
}

impl Flight {
    /// Creates a flight that has not begun.
    pub fn new(from: Camera, to: Camera) -> Flight {
        Flight { from, to, at: from }
    }

    /// Moves the camera to a fraction `part` of the flight, from 0 to 1, with easing. Returns
    /// whether the flight continues: it ends on arrival, or when something else moved the camera.
    pub fn go(&mut self, camera: &mut Camera, part: f32) -> bool {
        if pose(camera) != pose(&self.at) {
            return false;
        }
        let part = part.clamp(0.0, 1.0);
        let (from, to) = (&self.from, &self.to);
        let eased = part * part * (3.0 - 2.0 * part);
        let turn = (to.turn - from.turn + PI).rem_euclid(TAU) - PI;
        camera.pivot = from.pivot.lerp(to.pivot, eased);
        camera.distance = from.distance * (to.distance / from.distance).powf(eased);
        camera.turn = (from.turn + turn * eased).rem_euclid(TAU);
        camera.tilt = from.tilt + (to.tilt - from.tilt) * eased;
        self.at = *camera;
        part < 1.0
    }
}

/// Returns position and direction of a camera, without canvas and projection.
fn pose(camera: &Camera) -> (Vec3, [f32; 3]) {
    (camera.pivot, [camera.distance, camera.turn, camera.tilt])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ends() -> [Camera; 2] {
        let from = Camera { turn: 6.0, tilt: 0.4, distance: 2.0, ..Camera::default() };
        let to = Camera { turn: 0.5, tilt: -0.2, distance: 8.0, pivot: Vec3::X, ..from };
        [from, to]
    }

    #[test]
    fn a_flight_ends_where_it_should_and_turns_the_shorter_way() {
        let [from, to] = ends();
        let mut camera = from;
        let mut flight = Flight::new(from, to);
        assert!(flight.go(&mut camera, 0.5));
        assert!((camera.distance - 4.0).abs() < 1e-4);
        // From 6.0 over a whole turn to 0.5: the midpoint is near 0.11, not 3.25.
        assert!((camera.turn - (3.25 - PI)).abs() < 1e-3, "{}", camera.turn);
        assert!(!flight.go(&mut camera, 1.0));
        assert!((camera.pivot - to.pivot).length() < 1e-5);
        assert!((camera.turn - to.turn).abs() < 1e-5 && (camera.distance - 8.0).abs() < 1e-4);
    }

    #[test]
    fn who_takes_the_camera_ends_the_flight() {
        let [from, to] = ends();
        let mut camera = from;
        let mut flight = Flight::new(from, to);
        assert!(flight.go(&mut camera, 0.3));
        camera.orbit(5.0, 0.0);
        let taken = camera;
        assert!(!flight.go(&mut camera, 0.4));
        assert_eq!(camera, taken);
    }
}
