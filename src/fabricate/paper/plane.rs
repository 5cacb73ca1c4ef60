//! Geometry of the plane: rigid motions, and an intersection test of convex polygons, by separating
//! axes.

use crate::fabricate::boxes::{Corners, meet};
use crate::fabricate::panel::direction_of;
use crate::math::plane::{Point2, bounds, minus, rotated};

/// A rotation about the origin, followed by a translation.
#[derive(Clone, Copy, Debug)]
pub struct Motion {
    /// Rotation, as cosine and sine.
    pub turn: Point2,
    /// Translation in mm.
    pub shift: Point2,
}

impl Motion {
    /// The image of a point.
    pub fn put(&self, point: Point2) -> Point2 {
        let [x, y] = rotated(point, self.turn);
        [x + self.shift[0], y + self.shift[1]]
    }

    /// The motion that maps the direction and the midpoint of one segment to those of another.
    pub fn between([p, q]: [Point2; 2], [r, s]: [Point2; 2]) -> Motion {
        let ([a, b], [c, d]) = (direction_of(p, q), direction_of(r, s));
        let turn = [a * c + b * d, a * d - b * c];
        let middle = rotated([0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])], turn);
        Motion { turn, shift: [0.5 * (r[0] + s[0]) - middle[0], 0.5 * (r[1] + s[1]) - middle[1]] }
    }

    /// This motion after another one.
    pub(in crate::fabricate) fn after(&self, first: &Motion) -> Motion {
        Motion { turn: rotated(first.turn, self.turn), shift: self.put(first.shift) }
    }
}

/// Gap between parts of a piece without a common corner, in mm: room for scissors.
const CLEARANCE: f64 = 0.5;
/// Corners closer than this are the same, in mm.
const SAME: f64 = 0.05;
/// Permitted overlap of parts with a common corner, in mm: the error of panels that count as flat.
const ROUNDING: f64 = 0.02;
/// Permitted overlap of parts that need not be apart, in mm: they touch along their hinge.
const TOUCHING: f64 = 1e-6;

/// Whether two corners are the same but for rounding.
pub(super) fn is_same_corner(p: Point2, q: Point2) -> bool {
    minus(p, q).iter().all(|x| x.abs() < SAME)
}

/// The box of what may overlap parts of a box that is `by` larger on all sides, or be too close.
pub(super) fn reach([low, high]: Corners, by: f64) -> Corners {
    let by = by + CLEARANCE;
    [low.map(|x| x - by), high.map(|x| x + by)]
}

/// Whether two convex counterclockwise polygons overlap, or, if they are to be `apart`, are too close
/// without a common corner.
pub(super) fn overlaps(a: &[Point2], b: &[Point2], apart: bool) -> bool {
    let [one, other] = [a, b].map(|polygon| bounds(polygon.iter().copied()));
    if !meet(reach(one, 0.0), other) {
        return false;
    }
    let share = || a.iter().any(|&p| b.iter().any(|&q| is_same_corner(p, q)));
    let allowed = match apart {
        false => TOUCHING,
        true if share() => ROUNDING,
        true => -CLEARANCE,
    };
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
