//! Sheets: parts with their lines and names, laid out beside each other in the smallest of several
//! arrangements in rows.

mod clearance;
mod label;
mod lettering;
mod part;
mod shelf;
mod text_box;
mod tiles;
mod waste;

pub(super) use label::upright;
pub use label::{Inscription, Labels, label};
pub use lettering::{height_within, strokes, text_width};
pub use part::{CutPart, Hole, NamePlace, Place, Role, SheetSize};
pub(super) use tiles::{Tile, tiles};
pub use waste::Waste;

use crate::math::plane::{Point2, rotated};
use crate::math::{key_of_number, sort_by_number};
use crate::scene::Order;
use shelf::{Resting, Shelves, resting};

/// A sheet with parts.
#[derive(Clone, Debug, Default)]
pub struct Sheet {
    /// In the order in which they were laid.
    pub places: Vec<Place>,
}

/// All sheets.
#[derive(Clone, Debug, Default)]
pub struct Layout {
    /// The sheets in order.
    pub sheets: Vec<Sheet>,
    /// The parts that are larger than a sheet. They are reported, never scaled.
    pub too_large: Vec<usize>,
}

impl Layout {
    /// For each of `parts` parts, the number of its sheet from 1, and its place there.
    pub fn places(&self, parts: usize) -> Vec<Option<(usize, Place)>> {
        let mut places = vec![None; parts];
        for (sheet, number) in self.sheets.iter().zip(1..) {
            sheet.places.iter().for_each(|place| places[place.part] = Some((number, *place)));
        }
        places
    }
}

/// Lays out all parts: in rows or columns, along their longer sides or across, whichever needs
/// fewest sheets and then least of the last one. In the order of names they lie in rows.
pub fn lay_out(parts: &[CutPart], sheet: SheetSize, order: Order) -> Layout {
    /// With more parts only the first arrangement is tried.
    const MOST_TRIED: usize = 3000;
    // Parts as large as the sheet fit despite rounding.
    let room = sheet.size.map(|size| (size - 2.0 * sheet.margin) * (1.0 + 1e-9));
    let mut found = resting(parts, room);
    if order == Order::Names {
        found.sort_by_cached_key(|own| name_key(&parts[own.part].name));
    }
    let tried = if order == Order::Names || parts.len() > MOST_TRIED { 1 } else { WAYS.len() };
    let all = WAYS[..tried].iter().map(|way| way.lay_out((parts, &found), (sheet, room), order));
    let best = all.reduce(|best, other| {
        let taken = |laid: &Laid| (laid.layout.too_large.len(), laid.layout.sheets.len());
        let is_less = taken(&other) < taken(&best)
            || (taken(&other) == taken(&best) && other.last < best.last - 1e-9);
        if is_less { other } else { best }
    });
    best.map_or_else(Layout::default, |laid| laid.layout)
}

/// The order of names: P2 before P10, and row Z before row AA.
fn name_key(name: &str) -> Vec<(usize, &[u8])> {
    let runs = name.as_bytes().chunk_by(|a, b| a.is_ascii_digit() == b.is_ascii_digit());
    runs.map(|run| (run.len(), run)).collect()
}

/// An arrangement of parts.
struct Way {
    /// In columns from the left; else in rows from below.
    in_columns: bool,
    /// Along the longer sides of parts; else across.
    along: bool,
}

const WAYS: [Way; 4] = [
    Way { in_columns: false, along: true },
    Way { in_columns: false, along: false },
    Way { in_columns: true, along: true },
    Way { in_columns: true, along: false },
];

/// Cosine and sine of the rotation from rows to columns.
const CLOCKWISE: Point2 = [0.0, -1.0];

/// A layout, and the used fraction of its last sheet.
struct Laid {
    layout: Layout,
    last: f64,
}

impl Way {
    fn lay_out(
        &self,
        (parts, resting): (&[CutPart], &[Resting]),
        (sheet, [width, height]): (SheetSize, [f64; 2]),
        order: Order,
    ) -> Laid {
        let mut layout = Layout::default();
        let room = if self.in_columns { [height, width] } else { [width, height] };
        let mut boxes: Vec<Resting> = Vec::new();
        // As its letters are upright, if they say how a part lies.
        let readable = |own: Resting| {
            let on_sheet = if self.in_columns { rotated(own.turn, CLOCKWISE) } else { own.turn };
            let is_upright = upright([1.0, 0.0], on_sheet) == [1.0, 0.0];
            match parts[own.part].is_oriented && !is_upright {
                true => own.turned([-1.0, 0.0]),
                false => own,
            }
        };
        for resting in resting {
            let stances = [resting.clone(), resting.quarter_turned()].map(readable);
            let fits = |own: &&Resting| own.size[0] <= room[0] && own.size[1] <= room[1];
            let mut own = stances.iter().filter(fits);
            match if self.along { own.next() } else { own.next_back() } {
                Some(own) => boxes.push(own.clone()),
                None => layout.too_large.push(resting.part),
            }
        }
        if order == Order::Size {
            // Highest first; parts of equal height stay in the order of their names.
            sort_by_number(&mut boxes, |own| key_of_number(-own.step()));
        }
        let mut shelves = Shelves::new(room, sheet.gap, order);
        for own in boxes {
            let (number, Place { part, mut turn, offset: [mut x, mut y] }) = shelves.lay(own);
            if self.in_columns {
                turn = rotated(turn, CLOCKWISE);
                [x, y] = [y, sheet.size[1] - 2.0 * sheet.margin - x];
            }
            layout.sheets.resize_with(layout.sheets.len().max(number + 1), Sheet::default);
            let offset = [x + sheet.margin, y + sheet.margin];
            layout.sheets[number].places.push(Place { part, turn, offset });
        }
        Laid { layout, last: shelves.height_of_last() / room[1] }
    }
}
