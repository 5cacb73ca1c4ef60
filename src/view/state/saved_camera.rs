//! The camera as numbers that can be saved and restored, also in a window of another size.

use super::view_state::ViewState;
use glam::DVec3;

/// Pivot in file coordinates (3 numbers), distance, turn, tilt, and whether it is framed (1 or 0).
pub const CAMERA_NUMBERS: usize = 7;

impl ViewState {
    /// Returns the camera as numbers.
    pub fn camera_numbers(&self) -> [f64; CAMERA_NUMBERS] {
        let [x, y, z] =
            (self.viewpoint.camera.pivot.as_dvec3() + self.content.mesh.centre).to_array();
        let [distance, turn, tilt] = [
            self.viewpoint.camera.distance,
            self.viewpoint.camera.turn,
            self.viewpoint.camera.tilt,
        ]
        .map(f64::from);
        [x, y, z, distance, turn, tilt, f64::from(u8::from(self.is_framed()))]
    }

    /// Restores the camera. Ignores numbers that are not a valid camera.
    pub fn place_camera(&mut self, numbers: &[f64]) {
        let Ok([x, y, z, distance, turn, tilt, framed]) =
            <[f64; CAMERA_NUMBERS]>::try_from(numbers)
        else {
            return;
        };
        if !numbers.iter().all(|number| number.is_finite()) || distance <= 0.0 {
            return;
        }
        self.viewpoint.camera.pivot = self.content.mesh.relative(DVec3::new(x, y, z));
        self.viewpoint.camera.distance = distance as f32;
        self.viewpoint.camera.turn = turn as f32;
        self.viewpoint.camera.tilt = tilt as f32;
        self.set_framed(framed != 0.0);
    }
}
