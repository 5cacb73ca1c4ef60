//! Clearance between two convex parts.

use crate::fabricate::panel::{direction_of, sides};
use crate::math::plane::{Point2, dot};

/// Directions with a smaller x are vertical.
const VERTICAL: f64 = 1e-12;

/// The least shift along x that brings `moving` to the right of `fixed` with this gap between them;
/// none if it is above or below for any shift. Both are convex and counterclockwise.
///
/// The gap is measured along the normals of sides; between corners the actual distance is a little
/// larger.
pub(super) fn min_shift(fixed: &[Point2], moving: &[Point2], gap: f64) -> Option<f64> {
    // Quick test by bounding boxes: above or below.
    let range = |polygon: &[Point2]| {
        let ys = || polygon.iter().map(|point| point[1]);
        [ys().fold(f64::INFINITY, f64::min), ys().fold(f64::NEG_INFINITY, f64::max)]
    };
    let ([low, high], [under, over]) = (range(fixed), range(moving));
    if under >= high + gap || low >= over + gap {
        return None;
    }
    let normals = sides(fixed).map(|[p, q]| outwards(p, q));
    let opposite = sides(moving).map(|[p, q]| outwards(p, q).map(|x| -x));
    let mut least = f64::INFINITY;
    for normal in normals.chain(opposite).chain([[1.0, 0.0]]) {
        let far = fixed.iter().map(|&p| dot(p, normal)).fold(f64::NEG_INFINITY, f64::max);
        let near = moving.iter().map(|&p| dot(p, normal)).fold(f64::INFINITY, f64::min);
        let missing = gap - (near - far);
        match normal[0] {
            x if x > VERTICAL => least = least.min(missing / x),
            x if x > -VERTICAL && missing <= 0.0 => return None,
            _ => {}
        }
    }
    Some(least)
}

/// The outward unit normal of a side.
fn outwards(p: Point2, q: Point2) -> Point2 {
    let [x, y] = direction_of(p, q);
    [y, -x]
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [Point2; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];

    #[test]
    fn a_box_comes_to_lie_beside_a_box_and_passes_above_it() {
        assert_eq!(min_shift(&SQUARE, &SQUARE, 0.25), Some(1.25));
        let above = SQUARE.map(|[x, y]| [x, y + 1.5]);
        assert_eq!(min_shift(&SQUARE, &above, 0.25), None);
        assert_eq!(min_shift(&SQUARE, &above, 0.75), Some(1.75));
    }

    #[test]
    fn a_triangle_on_its_head_slides_under_the_slope_of_another() {
        let upright = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0]];
        let on_its_head = [[0.0, 1.0], [1.0, 0.0], [2.0, 1.0]];
        let shift = min_shift(&upright, &on_its_head, 0.1).unwrap();
        assert!((shift - (1.0 + 0.1 * 2.0_f64.sqrt())).abs() < 1e-12, "{shift}");
    }
}
