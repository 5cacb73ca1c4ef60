//! Angles at the corners of the faces, of the original and the current shape (paper Fig. 7).

use super::measuring::{Shape, positions};
use crate::mesh::angle_histogram;
use crate::session::state::{RestMesh, SolvedScene};

/// Number of bins of equal width from 0 to 180 degrees.
const ANGLE_BINS: usize = 36;

/// Histogram of the face angles, in bins of five degrees from 0 to 180.
pub(crate) fn angles(scene: &SolvedScene, rest: &RestMesh, shape: Shape) -> Vec<u32> {
    angle_histogram(&positions(scene, rest, shape), &rest.mesh().faces, ANGLE_BINS)
}

/// One line per bin: its lower and upper angle, and the number of corners of the original and of
/// the current shape in it.
pub(crate) fn angles_csv(scene: &SolvedScene, rest: &RestMesh) -> String {
    let [original, now] = [Shape::Original, Shape::Now].map(|shape| angles(scene, rest, shape));
    let mut text = "from (°),to (°),original,now\n".to_owned();
    let width = 180 / ANGLE_BINS;
    for (bin, (original, now)) in original.iter().zip(&now).enumerate() {
        let from = bin * width;
        text.push_str(&format!("{from},{},{original},{now}\n", from + width));
    }
    text
}
