//! Motions of the plane.

use crate::fabricate::panel::{Point2, direction_of, rotated};

/// How a facet is moved: turned about the origin, then shifted.
#[derive(Clone, Copy, Debug)]
pub struct Motion {
    /// Cosine and sine.
    pub turn: Point2,
    /// In mm.
    pub shift: Point2,
}

impl Motion {
    /// Where a point comes to lie.
    pub fn put(&self, point: Point2) -> Point2 {
        let [x, y] = rotated(point, self.turn);
        [x + self.shift[0], y + self.shift[1]]
    }

    /// The motion that brings one segment onto another, middle on middle, with its direction.
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
