//! Rigid motions of the plane.

use crate::fabricate::panel::direction_of;
use crate::math::plane::{Point2, rotated};

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
    pub(super) fn after(&self, first: &Motion) -> Motion {
        Motion { turn: rotated(first.turn, self.turn), shift: self.put(first.shift) }
    }
}
