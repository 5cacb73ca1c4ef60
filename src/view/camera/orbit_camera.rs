//! A turntable camera, in perspective or parallel projection: it turns and tilts, but never rolls.
//!
//! Points are relative to the view's centre; screen positions are CSS pixels from the upper left
//! corner of the canvas.

use super::section::Section;
use crate::view::model::ViewError;
use glam::{Mat4, Vec2, Vec3, Vec4};
use std::f32::consts::{FRAC_1_SQRT_2, FRAC_PI_2, FRAC_PI_4};

/// Half the vertical angle of view, radians. A long lens keeps verticals nearly parallel.
const HALF_ANGLE: f32 = 0.28;
/// Turn per CSS pixel of an orbiting drag, radians.
const TURN_PER_PIXEL: f32 = 0.006;
/// Turn and tilt of the three-quarter view in which every mesh is first shown, radians.
const HOME: (f32, f32) = (0.55, 0.65);
/// Tangent of the tilt at which the edges of a cube look equally long, in parallel projection.
const ISOMETRIC: f32 = FRAC_1_SQRT_2;

/// The axis of the file that points up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum UpAxis {
    /// As in architecture, Rhino, Blender.
    #[default]
    Z,
    /// As in games and animation.
    Y,
}

impl UpAxis {
    /// Returns the directions right, away, and up, as seen from the front.
    pub fn axes(self) -> [Vec3; 3] {
        match self {
            UpAxis::Z => [Vec3::X, Vec3::Y, Vec3::Z],
            UpAxis::Y => [Vec3::X, Vec3::NEG_Z, Vec3::Y],
        }
    }
}

/// The projection of the camera.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum CameraProjection {
    /// Objects farther away are smaller.
    #[default]
    Perspective,
    /// Everything has the size that it has at the pivot in perspective; rays are parallel.
    Parallel {
        /// Upper bound on distances from the view's centre, which places the eye behind everything.
        reach: f32,
    },
}

/// Position and direction of the camera. [`Camera::tilt`] must stay within a quarter turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The point at the centre of the canvas, about which the eye turns.
    pub pivot: Vec3,
    /// Distance from the pivot to the eye.
    pub distance: f32,
    /// Angle about the vertical, radians; 0 looks from the front, increasing to the right.
    pub turn: f32,
    /// Angle above the horizon, radians, from -pi/2 to pi/2.
    pub tilt: f32,
    /// Vertical axis.
    pub up: UpAxis,
    /// Perspective or parallel.
    pub projection: CameraProjection,
    /// Size of the canvas, CSS pixels.
    pub canvas: Vec2,
    /// Heights of the strips at the upper and lower edge of the canvas that framing leaves free, CSS
    /// pixels.
    pub covered: [f32; 2],
    /// The section plane; without one the whole model is drawn.
    pub section: Option<Section>,
}

/// The position and axes of the camera, computed once per use.
#[derive(Clone, Copy, Debug)]
pub struct Eye {
    /// Position; in parallel projection a point behind everything, at the centre of the canvas.
    pub at: Vec3,
    /// The direction to the right on the screen.
    pub right: Vec3,
    /// The upward direction of the screen.
    pub up: Vec3,
    /// The direction into the screen.
    pub forward: Vec3,
    /// CSS pixels of a unit length at depth 1.
    pub focal: f32,
    /// The centre of the canvas, CSS pixels.
    pub middle: Vec2,
    /// In parallel projection, the depth that sets the scale everywhere.
    pub parallel: Option<f32>,
}

impl Default for Camera {
    fn default() -> Self {
        Camera {
            pivot: Vec3::ZERO,
            distance: 4.0,
            turn: HOME.0,
            tilt: HOME.1,
            up: UpAxis::Z,
            projection: CameraProjection::Perspective,
            canvas: Vec2::new(300.0, 150.0),
            covered: [0.0; 2],
            section: None,
        }
    }
}

impl Camera {
    /// Computes the eye of the camera.
    pub fn eye(&self) -> Eye {
        let [x, y, z] = self.up.axes();
        let (sin_turn, cos_turn) = self.turn.sin_cos();
        let (sin_tilt, cos_tilt) = self.tilt.sin_cos();
        let right = x * cos_turn + y * sin_turn;
        let forward = (y * cos_turn - x * sin_turn) * cos_tilt - z * sin_tilt;
        let (back, parallel) = match self.projection {
            CameraProjection::Perspective => (self.distance, None),
            CameraProjection::Parallel { reach } => {
                (self.pivot.length() + reach, Some(self.distance))
            }
        };
        Eye {
            at: self.pivot - forward * back,
            right,
            up: right.cross(forward),
            forward,
            focal: 0.5 * self.canvas.y / HALF_ANGLE.tan(),
            middle: self.canvas * 0.5,
            parallel,
        }
    }

    /// Returns whether the section keeps a point.
    pub fn keeps(&self, point: Vec3) -> bool {
        self.section.is_none_or(|section| section.within(point) >= 0.0)
    }

    /// Turns the eye about the pivot by a drag in CSS pixels.
    pub fn orbit(&mut self, dx: f32, dy: f32) {
        self.turn = (self.turn - dx * TURN_PER_PIXEL).rem_euclid(std::f32::consts::TAU);
        self.tilt = (self.tilt + dy * TURN_PER_PIXEL).clamp(-FRAC_PI_2, FRAC_PI_2);
    }

    /// Turns by a drag in CSS pixels about `anchor`, which keeps its screen position. The direction
    /// of view changes as in [`Camera::orbit`].
    pub fn orbit_about(&mut self, anchor: Vec3, dx: f32, dy: f32) {
        let before = self.eye();
        let offset = self.pivot - anchor;
        let [right, up, forward] =
            [before.right, before.up, before.forward].map(|axis| offset.dot(axis));
        self.orbit(dx, dy);
        let after = self.eye();
        self.pivot = anchor + after.right * right + after.up * up + after.forward * forward;
    }

    /// Turns the model about the vertical axis through `anchor`, in radians; its front moves right.
    pub fn spin(&mut self, anchor: Vec3, angle: f32) {
        self.orbit_about(anchor, angle / TURN_PER_PIXEL, 0.0);
    }

    /// Slides the picture by a drag in CSS pixels: the plane of the pivot follows the cursor.
    pub fn pan(&mut self, dx: f32, dy: f32) {
        let eye = self.eye();
        self.pivot -= eye.across(Vec2::new(dx, dy), self.distance);
    }

    /// Moves `factor` times nearer to `anchor`, which keeps its screen position. `nearest` and
    /// `farthest` bound the distance from the pivot.
    pub fn zoom(&mut self, factor: f32, anchor: Vec3, nearest: f32, farthest: f32) {
        let distance = (self.distance / factor).clamp(nearest, farthest);
        let shrink = distance / self.distance;
        self.pivot = anchor + (self.pivot - anchor) * shrink;
        self.distance = distance;
    }

    /// Returns the point under a screen position in the plane through the pivot that faces the eye.
    pub fn on_pivot_plane(&self, screen: Vec2) -> Vec3 {
        let eye = self.eye();
        self.pivot + eye.across(screen - eye.middle, self.distance)
    }

    /// Looks from a named side: `top`, `bottom`, `front`, `back`, `left`, `right`, `isometric`, or
    /// `home`, the three-quarter view. Pivot and distance stay.
    ///
    /// # Errors
    /// Any other name.
    pub fn look_from(&mut self, side: &str) -> Result<(), ViewError> {
        let half = std::f32::consts::PI;
        (self.turn, self.tilt) = match side {
            "top" => (0.0, FRAC_PI_2),
            "bottom" => (0.0, -FRAC_PI_2),
            "front" => (0.0, 0.0),
            "back" => (half, 0.0),
            "right" => (FRAC_PI_2, 0.0),
            "left" => (half + FRAC_PI_2, 0.0),
            "isometric" => (FRAC_PI_4, ISOMETRIC.atan()),
            "home" => HOME,
            _ => {
                return Err(ViewError::Word {
                    what: "view",
                    got: side.to_owned(),
                    known: "top, bottom, front, back, left, right, isometric or home",
                });
            }
        };
        Ok(())
    }

    /// Looks against a direction, which must not be zero. Pivot and distance stay.
    pub fn look_against(&mut self, direction: Vec3) {
        let direction = direction.normalize();
        let [right, back, up] = self.up.axes().map(|axis| axis.dot(direction));
        self.turn = right.atan2(-back).rem_euclid(std::f32::consts::TAU);
        self.tilt = up.clamp(-1.0, 1.0).asin();
    }

    /// Returns the matrix from scene to clip coordinates (x and y from -w to w, z from 0 to w) for
    /// the given near and far depths.
    pub fn clip_from_scene(&self, near: f32, far: f32) -> Mat4 {
        let eye = self.eye();
        let row = |axis: Vec3, scale: f32| axis.extend(-axis.dot(eye.at)) * scale;
        let depth = row(eye.forward, 1.0);
        // Maps depths from near to far to 0..w: in perspective w is the depth, else 1.
        let (size, stretch, w) = match eye.parallel {
            None => (eye.focal, far / (far - near), depth),
            Some(scale) => (eye.focal / scale, 1.0 / (far - near), Vec4::W),
        };
        Mat4::from_cols(
            row(eye.right, size / eye.middle.x),
            row(eye.up, size / eye.middle.y),
            depth * stretch - Vec4::new(0.0, 0.0, 0.0, stretch * near),
            w,
        )
        .transpose()
    }
}

impl Eye {
    /// Returns the depth that determines the size of objects at `depth`.
    pub fn scale_depth(&self, depth: f32) -> f32 {
        self.parallel.unwrap_or(depth)
    }

    /// Returns the screen position and depth of a point; the position is valid for positive depths.
    pub fn project(&self, point: Vec3) -> (Vec2, f32) {
        let from_eye = point - self.at;
        let depth = from_eye.dot(self.forward);
        let offset = Vec2::new(from_eye.dot(self.right), -from_eye.dot(self.up));
        (self.middle + offset * (self.focal / self.scale_depth(depth)), depth)
    }

    /// Returns the displacement parallel to the screen that covers `pixels` at a depth.
    pub fn across(&self, pixels: Vec2, depth: f32) -> Vec3 {
        (self.right * pixels.x - self.up * pixels.y) * (self.scale_depth(depth) / self.focal)
    }

    /// Returns the origin and the direction of the ray through a screen position. The direction has
    /// depth 1, not length 1.
    pub fn ray(&self, screen: Vec2) -> (Vec3, Vec3) {
        let across = self.across(screen - self.middle, 1.0);
        match self.parallel {
            None => (self.at, self.forward + across),
            Some(_) => (self.at + across, self.forward),
        }
    }

    /// Returns the origin of the ray to a point.
    pub fn seen_from(&self, point: Vec3) -> Vec3 {
        match self.parallel {
            None => self.at,
            Some(_) => point - self.forward * (point - self.at).dot(self.forward),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera() -> Camera {
        Camera {
            pivot: Vec3::new(1.0, -2.0, 0.5),
            distance: 7.0,
            canvas: Vec2::new(800.0, 600.0),
            ..Camera::default()
        }
    }

    fn cameras() -> [Camera; 2] {
        let parallel = Camera { projection: CameraProjection::Parallel { reach: 4.0 }, ..camera() };
        [camera(), parallel]
    }

    #[test]
    fn the_matrix_and_the_projection_agree() {
        for camera in cameras() {
            let eye = camera.eye();
            let matrix = camera.clip_from_scene(0.5, 50.0);
            for point in [Vec3::ZERO, Vec3::new(0.3, 1.0, -0.7), camera.pivot] {
                let (screen, depth) = eye.project(point);
                let clip = matrix * point.extend(1.0);
                let expected = Vec2::new(clip.x, -clip.y) / clip.w * eye.middle + eye.middle;
                assert!((screen - expected).length() < 1e-2, "{screen} {expected}");
                let w = if eye.parallel.is_some() { 1.0 } else { depth };
                assert!((clip.w - w).abs() < 1e-5);
                assert!(clip.z > 0.0 && clip.z < clip.w);
            }
            assert!((eye.project(camera.pivot).0 - eye.middle).length() < 1e-3);
        }
    }

    #[test]
    fn the_sky_is_up_and_sides_are_where_they_should_be() {
        for (up, sky, side) in [(UpAxis::Z, Vec3::Z, Vec3::NEG_Y), (UpAxis::Y, Vec3::Y, Vec3::Z)] {
            let mut camera = Camera { up, ..camera() };
            for (name, towards) in [
                ("front", side),
                ("right", Vec3::X),
                ("left", Vec3::NEG_X),
                ("top", sky),
                ("bottom", -sky),
            ] {
                camera.look_from(name).unwrap();
                let eye = camera.eye();
                let from = (eye.at - camera.pivot).normalize();
                assert!((from - towards).length() < 1e-5, "{name}: {from}");
                assert!(eye.up.dot(sky) > -1e-6, "{name}");
            }
        }
        assert!(camera().look_from("above").unwrap_err().to_string().contains("\"above\""));
    }

    #[test]
    fn tilt_stops_at_the_pole_and_nothing_rolls() {
        let mut camera = camera();
        camera.orbit(130.0, 1e6);
        assert_eq!(camera.tilt, FRAC_PI_2);
        camera.orbit(-77.0, -300.0);
        let eye = camera.eye();
        assert!(eye.right.z.abs() < 1e-6);
        assert!((eye.right.cross(eye.forward) - eye.up).length() < 1e-6);
    }

    #[test]
    fn a_pan_carries_the_pivot_plane_with_the_cursor() {
        for mut camera in cameras() {
            let grabbed = camera.on_pivot_plane(Vec2::new(200.0, 150.0));
            camera.pan(60.0, -35.0);
            let (screen, _) = camera.eye().project(grabbed);
            assert!((screen - Vec2::new(260.0, 115.0)).length() < 1e-2);
        }
    }

    #[test]
    fn an_orbit_about_a_point_holds_it_on_the_screen() {
        for mut camera in cameras() {
            let anchor = Vec3::new(0.3, -1.0, 1.0);
            let (before, depth) = camera.eye().project(anchor);
            let (turn, tilt) = (camera.turn, camera.tilt);
            camera.orbit_about(anchor, 120.0, -45.0);
            let (after, deeper) = camera.eye().project(anchor);
            assert!((after - before).length() < 1e-2);
            let eye = camera.eye();
            assert!(eye.parallel.is_some() || (deeper - depth).abs() < 1e-4);
            camera.orbit(-120.0, 45.0);
            assert!((camera.turn - turn).abs() < 1e-5 && (camera.tilt - tilt).abs() < 1e-5);
        }
    }

    #[test]
    fn a_zoom_holds_the_point_under_the_cursor() {
        for mut camera in cameras() {
            let anchor = Vec3::new(0.0, -1.0, 1.0);
            let (before, depth) = camera.eye().project(anchor);
            camera.zoom(1.5, anchor, 0.1, 100.0);
            let (after, nearer) = camera.eye().project(anchor);
            assert!((after - before).length() < 1e-2);
            let eye = camera.eye();
            assert!(eye.parallel.is_some() || (nearer - depth / 1.5).abs() < 1e-4);
            camera.zoom(1e9, anchor, 0.1, 100.0);
            assert!((camera.distance - 0.1).abs() < 1e-6);
        }
    }

    #[test]
    fn a_ray_through_a_projection_meets_the_point() {
        for camera in cameras() {
            let eye = camera.eye();
            let point = Vec3::new(-0.4, 0.9, 0.2);
            let (screen, depth) = eye.project(point);
            let (from, direction) = eye.ray(screen);
            assert!((from + direction * depth - point).length() < 1e-4);
            assert!((eye.seen_from(point) - from).length() < 1e-4);
        }
    }

    #[test]
    fn in_parallel_projection_lengths_do_not_depend_on_depth() {
        let [perspective, parallel] = cameras();
        let step = Vec3::new(0.2, 0.1, 0.3);
        let on_screen = |camera: &Camera, at: Vec3| {
            let eye = camera.eye();
            eye.project(at + step).0 - eye.project(at).0
        };
        for at in [Vec3::ZERO, Vec3::new(1.0, 2.0, -1.0), Vec3::new(-2.0, 0.5, 2.0)] {
            let seen = on_screen(&parallel, at);
            assert!((seen - on_screen(&parallel, parallel.pivot)).length() < 1e-2);
        }
        // At the pivot, sizes stay the same when the projection changes.
        let across = perspective.eye().right * 0.5;
        for camera in cameras() {
            let eye = camera.eye();
            let seen = eye.project(camera.pivot + across).0 - eye.middle;
            assert!((seen.x - 0.5 * eye.focal / 7.0).abs() < 1e-2 && seen.y.abs() < 1e-2);
        }
    }

    #[test]
    fn a_cube_has_equal_edges_in_the_isometric_view() {
        let [_, mut camera] = cameras();
        camera.look_from("isometric").unwrap();
        let eye = camera.eye();
        let lengths = [Vec3::X, Vec3::Y, Vec3::Z]
            .map(|edge| (eye.project(edge).0 - eye.project(Vec3::ZERO).0).length());
        assert!(lengths.iter().all(|length| (length - lengths[0]).abs() < 1e-2), "{lengths:?}");
    }
}
