//! A scale bar of round length: exact in parallel projection, and at the pivot in perspective.

use crate::math::round_down;
use crate::view::camera::Camera;

/// A length and its size on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScaleBar {
    /// In the unit of the file.
    pub length: f64,
    /// CSS pixels.
    pub pixels: f64,
}

/// Returns the longest bar of round length that is at most `most` CSS pixels long.
pub fn scale_bar(camera: &Camera, most: f64) -> ScaleBar {
    let pixels_per_length = f64::from(camera.eye().focal) / f64::from(camera.distance);
    let length = round_down(most / pixels_per_length);
    ScaleBar { length, pixels: length * pixels_per_length }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::camera::CameraProjection;
    use glam::Vec2;

    #[test]
    fn the_bar_is_as_long_as_it_says() {
        let mut camera = Camera { canvas: Vec2::new(900.0, 600.0), ..Camera::default() };
        camera.projection = CameraProjection::Parallel { reach: 20.0 };
        for distance in [0.3, 4.0, 70.0] {
            camera.distance = distance;
            let bar = scale_bar(&camera, 120.0);
            assert!(bar.pixels <= 120.0 && bar.pixels > 0.4 * 120.0);
            let eye = camera.eye();
            let at = glam::Vec3::new(0.5, 0.2, -0.3);
            let end = at + eye.right * bar.length as f32;
            let seen = (eye.project(end).0 - eye.project(at).0).length();
            assert!((f64::from(seen) - bar.pixels).abs() < 0.1, "{seen} {bar:?}");
        }
    }
}
