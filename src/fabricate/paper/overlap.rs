//! Intersection test of convex polygons, by separating axes.

use crate::fabricate::panel::direction_of;
use crate::math::plane::{Point2, minus};

/// Gap between parts of a piece without a common corner, in mm: room for scissors.
const CLEARANCE: f64 = 0.5;
/// Corners closer than this are the same, in mm.
const SAME: f64 = 0.05;
/// Permitted overlap of parts with a common corner, in mm: the error of panels that count as flat.
const ROUNDING: f64 = 0.02;

/// Whether two corners are the same but for rounding.
pub(super) fn is_same_corner(p: Point2, q: Point2) -> bool {
    minus(p, q).iter().all(|x| x.abs() < SAME)
}

/// Whether two convex counterclockwise polygons overlap, or are too close without a common corner.
pub(super) fn overlaps(a: &[Point2], b: &[Point2]) -> bool {
    let boxes = [a, b].map(|polygon| {
        let range = |k: usize| {
            let values = polygon.iter().map(|point| point[k]);
            [values.clone().fold(f64::INFINITY, f64::min), values.fold(f64::NEG_INFINITY, f64::max)]
        };
        [range(0), range(1)]
    });
    let is_far = (0..2).any(|k| {
        boxes[0][k][1] + CLEARANCE < boxes[1][k][0] || boxes[1][k][1] + CLEARANCE < boxes[0][k][0]
    });
    if is_far {
        return false;
    }
    let share = a.iter().any(|&p| b.iter().any(|&q| is_same_corner(p, q)));
    let allowed = if share { ROUNDING } else { -CLEARANCE };
    deepest(a, b) > allowed && deepest(b, a) > allowed
}

/// The depth of the second polygon behind a side of the first, minimised over the sides.
fn deepest(a: &[Point2], b: &[Point2]) -> f64 {
    let behind = |k: usize| {
        let (p, q) = (a[k], a[(k + 1) % a.len()]);
        if p == q {
            return f64::INFINITY;
        }
        let [c, s] = direction_of(p, q);
        b.iter().map(|r| c * (r[1] - p[1]) - s * (r[0] - p[0])).fold(f64::NEG_INFINITY, f64::max)
    };
    (0..a.len()).map(behind).fold(f64::INFINITY, f64::min)
}
