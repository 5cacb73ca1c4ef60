//! Parts on sheets: in shelves of their smallest boxes, on the first sheet and shelf that has room.

use super::label::upright;
use super::part::CutPart;
use crate::fabricate::panel::{Point2, rotated, smallest_box};
use crate::math::{key_of_number, sort_by_number};
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

    /// The angle by which the part is turned, in degrees.
    pub fn turn_deg(&self) -> f64 {
        libm::atan2(self.turn[1], self.turn[0]).to_degrees()
    }
}

/// A sheet with parts.
#[derive(Clone, Debug, Default)]
pub struct Sheet {
    /// In the order in which they were laid.
    pub places: Vec<Place>,
}

/// All sheets.
#[derive(Clone, Debug, Default)]
pub struct Layout {
    /// Sheets in order.
    pub sheets: Vec<Sheet>,
    /// The parts that are larger than a sheet. They are named, never scaled.
    pub too_large: Vec<usize>,
}

impl Layout {
    /// Of each of so many parts the number of its sheet, from 1, and its place there.
    pub fn places(&self, parts: usize) -> Vec<Option<(usize, Place)>> {
        let mut places = vec![None; parts];
        for (sheet, number) in self.sheets.iter().zip(1..) {
            sheet.places.iter().for_each(|place| places[place.part] = Some((number, *place)));
        }
        places
    }
}

/// A row of boxes on a sheet.
struct Shelf {
    sheet: usize,
    low: f64,
    height: f64,
    /// Where the next box begins.
    next: f64,
}

/// Lays out all parts.
pub fn lay_out(parts: &[CutPart], sheet: SheetSize, order: Order) -> Layout {
    let [width, height] = sheet.size.map(|size| size - 2.0 * sheet.margin);
    let mut layout = Layout::default();
    let mut boxes: Vec<(usize, Point2, [f64; 2])> = Vec::new();
    for (k, part) in parts.iter().enumerate() {
        let (turn, size) = smallest_box(&part.outline);
        // Wide, else high; either way names stand on their feet.
        let wide = (upright(turn), size);
        let high = (upright([-turn[1], turn[0]]), [size[1], size[0]]);
        let fits = |size: [f64; 2]| size[0] <= width && size[1] <= height;
        match [wide, high].into_iter().find(|(_, size)| fits(*size)) {
            Some((turn, size)) => boxes.push((k, turn, size)),
            None => layout.too_large.push(k),
        }
    }
    if order == Order::Size {
        // The highest first.
        sort_by_number(&mut boxes, |(_, _, size)| key_of_number(-size[1]));
    }
    let mut shelves: Vec<Shelf> = Vec::new();
    // Above the highest shelf of each sheet.
    let mut free: Vec<f64> = Vec::new();
    for (k, turn, size) in boxes {
        let has_room = |shelf: &Shelf| size[1] <= shelf.height && shelf.next + size[0] <= width;
        let found = match order {
            Order::Size => shelves.iter().position(has_room),
            // Only the last one, which nothing is above: it may grow.
            Order::Names => shelves.len().checked_sub(1).filter(|&last| {
                let Shelf { low, next, .. } = shelves[last];
                next + size[0] <= width && low + size[1] <= height
            }),
        };
        let own = found.unwrap_or_else(|| {
            let from = match order {
                Order::Size => 0,
                Order::Names => free.len().saturating_sub(1),
            };
            let sheet_of = (from..free.len()).find(|&s| free[s] + size[1] <= height);
            let s = sheet_of.unwrap_or_else(|| {
                free.push(0.0);
                layout.sheets.push(Sheet::default());
                free.len() - 1
            });
            shelves.push(Shelf { sheet: s, low: free[s], height: 0.0, next: 0.0 });
            shelves.len() - 1
        });
        let shelf = &mut shelves[own];
        shelf.height = shelf.height.max(size[1]);
        free[shelf.sheet] = free[shelf.sheet].max(shelf.low + shelf.height + sheet.gap);
        let low = lower_left(&parts[k].outline, turn);
        let corner = [sheet.margin + shelf.next, sheet.margin + shelf.low];
        let offset = [corner[0] - low[0], corner[1] - low[1]];
        layout.sheets[shelf.sheet].places.push(Place { part: k, turn, offset });
        shelf.next += size[0] + sheet.gap;
    }
    layout
}

fn lower_left(outline: &[Point2], turn: Point2) -> Point2 {
    let mut low = [f64::INFINITY; 2];
    for point in outline {
        let point = rotated(*point, turn);
        low = [low[0].min(point[0]), low[1].min(point[1])];
    }
    low
}
