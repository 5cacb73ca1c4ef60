//! The camera as numbers, to be kept and put back later, in a window of another size too.

use super::view_state::ViewState;
use glam::DVec3;

/// The pivot in file coordinates (3), distance, turn, tilt, and whether everything is framed (1 or 0).
pub const CAMERA_NUMBERS: usize = 7;

impl ViewState {
    /// Where the camera is.
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

    /// Puts the camera where it was. What is not a place of a camera leaves it where it is.
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
