//! The layout of parts on sheets: the smallest of several arrangements in rows, or nested in each other.

use super::lettering::upright;
use super::nest::{First, Nester};
use super::part::{CutPart, Place, SheetSize};
use super::shelf::{Resting, Shelves, resting};
use crate::math::plane::{Point2, rotated};
use crate::math::{key_of_number, sort_by_number};
use crate::scene::Order;

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

/// Lays out all parts: in rows or columns, along their longer sides or across, or nested in each other,
/// whichever needs fewest sheets and then least of the last one. In the order of names they lie in
/// rows.
pub fn lay_out(parts: &[CutPart], sheet: SheetSize, order: Order) -> Layout {
    /// With more parts only the first arrangement is tried.
    const MOST_TRIED: usize = 3000;
    // Parts as large as the sheet fit despite rounding.
    let room = sheet.size.map(|size| (size - 2.0 * sheet.margin) * (1.0 + 1e-9));
    let mut found = resting(parts, room);
    if order == Order::Names {
        found.sort_by_cached_key(|own| name_key(&parts[own.part].name));
    }
    let is_first_only = order == Order::Names || parts.len() > MOST_TRIED;
    let tried = if is_first_only { 1 } else { WAYS.len() };
    let all = WAYS[..tried].iter().map(|way| way.lay_out((parts, &found), (sheet, room), order));
    let Some(best) = all.reduce(Laid::better) else { return Layout::default() };
    if is_first_only { best.layout } else { nested(best, parts, &found, (sheet, room)).layout }
}

/// The parts nested in each other, if that is better than the `best` so far.
fn nested(
    mut best: Laid,
    parts: &[CutPart],
    resting: &[Resting],
    (sheet, room): (SheetSize, [f64; 2]),
) -> Laid {
    /// Tests of runs of cells, of all attempts together: 0.7 s natively.
    const MOST_TESTS: usize = 60_000_000;
    let fits = |own: &&Resting| !best.layout.too_large.contains(&own.part);
    let resting: Vec<&Resting> = resting.iter().filter(fits).collect();
    let Some(nester) = Nester::new(parts, &resting, room, sheet.gap) else { return best };
    let mut budget = MOST_TESTS;
    for direction in [Direction::Rows, Direction::Columns] {
        let room = direction.room(room);
        for first in [First::Largest, First::Longest] {
            let most = best.layout.sheets.len();
            let Some((sheets, top)) = nester.nest(first, room, most, &mut budget) else { continue };
            let on_sheet = |places: Vec<Place>| {
                let on_sheet = |place| direction.on_sheet(sheet, place);
                Sheet { places: places.into_iter().map(on_sheet).collect() }
            };
            let sheets = sheets.into_iter().map(on_sheet).collect();
            let layout = Layout { sheets, too_large: best.layout.too_large.clone() };
            best = best.better(Laid { layout, last: (top + sheet.gap) / room[1] });
        }
    }
    best
}

/// The order of names: P2 before P10, and row Z before row AA.
fn name_key(name: &str) -> Vec<(usize, &[u8])> {
    let runs = name.as_bytes().chunk_by(|a, b| a.is_ascii_digit() == b.is_ascii_digit());
    runs.map(|run| (run.len(), run)).collect()
}

/// The direction in which a sheet is filled.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Direction {
    /// In rows from below.
    Rows,
    /// In columns from the left: in rows on a sheet that is then rotated clockwise.
    Columns,
}

impl Direction {
    /// The room for rows.
    fn room(self, [width, height]: [f64; 2]) -> [f64; 2] {
        match self {
            Direction::Rows => [width, height],
            Direction::Columns => [height, width],
        }
    }

    /// The place on the sheet of a part that is placed in the room for rows.
    fn on_sheet(self, sheet: SheetSize, Place { part, turn, offset: [x, y] }: Place) -> Place {
        let [x, y] = match self {
            Direction::Rows => [x, y],
            Direction::Columns => [y, sheet.size[1] - 2.0 * sheet.margin - x],
        };
        let turn = self.turned(turn);
        Place { part, turn, offset: [x + sheet.margin, y + sheet.margin] }
    }

    /// The rotation on the sheet of a part with this rotation in the room for rows.
    fn turned(self, turn: Point2) -> Point2 {
        match self {
            Direction::Rows => turn,
            Direction::Columns => rotated(turn, [0.0, -1.0]),
        }
    }
}

/// An arrangement of parts in rows.
struct Way {
    direction: Direction,
    /// Along the longer sides of parts; else across.
    along: bool,
}

const WAYS: [Way; 4] = [
    Way { direction: Direction::Rows, along: true },
    Way { direction: Direction::Rows, along: false },
    Way { direction: Direction::Columns, along: true },
    Way { direction: Direction::Columns, along: false },
];

/// A layout, and the used fraction of its last sheet.
struct Laid {
    layout: Layout,
    last: f64,
}

impl Laid {
    /// The one that needs fewer sheets, or as many and less of the last one; else the first.
    fn better(self, other: Laid) -> Laid {
        let taken = |laid: &Laid| (laid.layout.too_large.len(), laid.layout.sheets.len());
        let is_less = taken(&other) < taken(&self)
            || (taken(&other) == taken(&self) && other.last < self.last - 1e-9);
        if is_less { other } else { self }
    }
}

impl Way {
    fn lay_out(
        &self,
        (parts, resting): (&[CutPart], &[Resting]),
        (sheet, room): (SheetSize, [f64; 2]),
        order: Order,
    ) -> Laid {
        let mut layout = Layout::default();
        let room = self.direction.room(room);
        let mut boxes: Vec<Resting> = Vec::new();
        // As its letters are upright, if they say how a part lies.
        let readable = |own: Resting| {
            let is_upright = upright([1.0, 0.0], self.direction.turned(own.turn)) == [1.0, 0.0];
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
            let (number, place) = shelves.lay(own);
            layout.sheets.resize_with(layout.sheets.len().max(number + 1), Sheet::default);
            layout.sheets[number].places.push(self.direction.on_sheet(sheet, place));
        }
        Laid { layout, last: shelves.height_of_last() / room[1] }
    }
}
