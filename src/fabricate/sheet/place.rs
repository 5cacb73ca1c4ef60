//! Where a part is on its sheet, and in which order parts are laid out.

use crate::fabricate::panel::{Point2, rotated};
use serde::{Deserialize, Serialize};

/// In which order parts are laid out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub enum Order {
    /// The highest first: fewest sheets.
    #[default]
    Size,
    /// As they are named: neighbours stay together.
    Names,
}

/// A sheet of material, in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SheetSize {
    /// Width and height.
    pub size: [f64; 2],
    /// What stays free at its edges.
    pub margin: f64,
    /// What stays free between parts, at least the kerf.
    pub gap: f64,
}

/// Where a part is: turned about the origin, then moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Which of the parts.
    pub part: usize,
    /// Cosine and sine.
    pub turn: Point2,
    /// By how much it is moved, in mm from the lower left corner of the sheet.
    pub offset: Point2,
}

impl Place {
    /// Where a point of the part is on the sheet.
    pub fn put(&self, point: Point2) -> Point2 {
        let [x, y] = rotated(point, self.turn);
        [x + self.offset[0], y + self.offset[1]]
    }

    /// The inverse of [`Place::put`].
    pub fn back(&self, [x, y]: Point2) -> Point2 {
        let [c, s] = self.turn;
        rotated([x - self.offset[0], y - self.offset[1]], [c, -s])
    }

    /// The angle by which the part is turned, in degrees.
    pub fn turn_deg(&self) -> f64 {
        libm::atan2(self.turn[1], self.turn[0]).to_degrees()
    }
}
