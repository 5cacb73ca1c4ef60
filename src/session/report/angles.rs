//! The angles at the corners of the faces, before and after (paper Fig. 7).

use super::face_measure::Shape;
use crate::mesh::angle_histogram;
use crate::session::state::Session;

/// Bins of equal width from 0 to 180 degrees.
const ANGLE_BINS: usize = 36;

impl Session {
    /// Corners of faces by their angles, in bins of five degrees from 0 to 180.
    pub fn angles(&self, shape: Shape) -> Vec<u32> {
        angle_histogram(&self.positions_of(shape), &self.mesh.faces, ANGLE_BINS)
    }

    /// One line per bin: the angles where it begins and ends, and how many corners of the original
    /// and of the current shape are in it.
    pub fn angles_csv(&self) -> String {
        let [original, now] = [Shape::Original, Shape::Now].map(|shape| self.angles(shape));
        let mut text = "from (°),to (°),original,now\n".to_owned();
        let width = 180 / ANGLE_BINS;
        for (bin, (original, now)) in original.iter().zip(&now).enumerate() {
            let from = bin * width;
            text.push_str(&format!("{from},{},{original},{now}\n", from + width));
        }
        text
    }
}
