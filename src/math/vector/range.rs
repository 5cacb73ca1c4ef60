//! Bounds of coordinates and squared lengths between which a closed form stays accurate.

use super::lane::Lane;
use super::vec3::Vec3;

/// Returns `flag` in the lanes where the squared lengths from `least` to `greatest` are between
/// 1e-60 and 1e60, so that their fourth powers neither overflow nor underflow; zero in the others,
/// among them those with a NaN.
#[inline(always)]
pub fn in_range<S: Lane>(least: S, greatest: S, flag: S) -> S {
    let not_tiny = least.if_greater(S::splat(1e-60), flag, S::zero());
    S::splat(1e60).if_greater(greatest, not_tiny, S::zero())
}

/// Returns the largest absolute coordinate of some points; zero without points.
pub fn largest_coordinate(points: &[Vec3<f64>]) -> f64 {
    points.iter().fold(0.0, |largest, point| point.largest_coordinate().max(largest))
}
