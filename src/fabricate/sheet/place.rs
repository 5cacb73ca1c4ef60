//! Position of a part on its sheet, and order of parts.

use crate::math::plane::{Point2, rotated};

/// A sheet of material, in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SheetSize {
    /// Width and height.
    pub size: [f64; 2],
    /// Free margin at the edges.
    pub margin: f64,
    /// Free gap between parts, at least the kerf.
    pub gap: f64,
}

/// Position of a part: rotated about the origin, then translated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The index of the part.
    pub part: usize,
    /// Rotation, as cosine and sine.
    pub turn: Point2,
    /// Translation, in mm from the lower left corner of the sheet.
    pub offset: Point2,
}

impl Place {
    /// Maps a point of the part to the sheet.
    pub fn to_sheet(&self, point: Point2) -> Point2 {
        let [x, y] = rotated(point, self.turn);
        [x + self.offset[0], y + self.offset[1]]
    }

    /// The inverse of [`Place::to_sheet`].
    pub fn to_part(&self, [x, y]: Point2) -> Point2 {
        let [c, s] = self.turn;
        rotated([x - self.offset[0], y - self.offset[1]], [c, -s])
    }

    /// The angle by which the part is rotated, in degrees.
    pub fn turn_deg(&self) -> f64 {
        libm::atan2(self.turn[1], self.turn[0]).to_degrees()
    }
}
