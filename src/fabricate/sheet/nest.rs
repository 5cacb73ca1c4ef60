//! Parts of any shape, also in the notches of others: each is laid where it reaches least high, and
//! there as far left as possible, tested on a grid of cells. A part covers all cells nearer than half
//! the gap to it, so that parts that share no cell keep the gap.

use super::bitmap::Bitmap;
use super::cells::{Run, cells};
use super::part::{CutPart, Place};
use super::shelf::Resting;
use crate::fabricate::panel::hull;
use crate::math::plane::{Point2, area, bounds, rotated};
use crate::math::{key_of_number, sort_by_number};

/// The side of a cell relative to the gap: on average half a cell between parts is lost.
const OF_GAP: f64 = 1.0 / 6.0;
/// Cells along the longer side of a sheet, at most.
const ALONG: f64 = 1024.0;
/// Rows of cells of all parts together, at most: what the parts take of memory.
const ROWS: f64 = 4e5;
/// Parts that fill more of their boxes than this are as well laid in rows.
const FULL: f64 = 0.75;

/// The weight of the height of the middle where two stances are equally high.
const TIE: f64 = 1e-6;

/// A rotation of a part in which it fits on a sheet.
struct Stance {
    /// The rotation, as cosine and sine.
    turn: Point2,
    /// The translation that then moves the lower left corner of its box to the origin.
    moved: Point2,
    /// Width and height of the box.
    size: [f64; 2],
    /// The height by which stances are compared: that of the box and, where two are equally high but
    /// for rounding, of the middle, so that a bow lies with its notch upwards.
    height: f64,
    /// What it covers.
    runs: Vec<Run>,
}

/// A part as cells.
struct Nested {
    part: usize,
    /// In quarter turns from its smallest box.
    stances: [Stance; 4],
    /// The number of cells that it covers.
    cells: usize,
    /// The area of its convex hull, and the length of its box.
    ranks: [f64; 2],
}

/// A position where a part has room.
struct Position<'a> {
    stance: &'a Stance,
    /// Column and row of its lower left cell.
    at: [usize; 2],
    /// How high it reaches by that height, and how far to the right.
    reach: [f64; 2],
}

/// What is laid first.
#[derive(Clone, Copy)]
pub(super) enum First {
    /// Parts with the largest hulls.
    Largest,
    /// Parts with the longest boxes.
    Longest,
}

/// Parts to be nested.
pub(super) struct Nester {
    parts: Vec<Nested>,
    gap: f64,
    cell: f64,
}

impl Nester {
    /// The parts as cells; none if they fill their boxes, so that rows are as good. All of them fit on
    /// a sheet with this much room.
    pub(super) fn new(
        parts: &[CutPart],
        resting: &[&Resting],
        room: [f64; 2],
        gap: f64,
    ) -> Option<Nester> {
        let sum = |of: &dyn Fn(&Resting) -> f64| resting.iter().map(|own| of(own)).sum::<f64>();
        let boxes = sum(&|own| own.size[0] * own.size[1]);
        if sum(&|own| area(&parts[own.part].outline)) > FULL * boxes {
            return None;
        }
        let around = sum(&|own| 2.0 * (own.size[0] + own.size[1]));
        let cell = (OF_GAP * gap).max(room[0].max(room[1]) / ALONG).max(around / ROWS);
        let nested = |own: &&Resting| {
            let outline = &parts[own.part].outline;
            let mut turn = own.turn;
            let stances = [(); 4].map(|()| {
                let stance = Stance::new(outline, turn, gap, cell);
                turn = rotated(turn, [0.0, 1.0]);
                stance
            });
            let cells = stances[0].runs.iter().map(|run| (run.to - run.from) as usize).sum();
            let ranks = [area(&hull(outline)), own.size[0].max(own.size[1])];
            Nested { part: own.part, stances, cells, ranks }
        };
        Some(Nester { parts: resting.iter().map(nested).collect(), gap, cell })
    }

    /// The places on each sheet with this much `room`, and the used height of the last sheet. None if
    /// more than `most` sheets are needed, or there are no more tests of runs of cells in the `budget`.
    pub(super) fn nest(
        &self,
        first: First,
        room: [f64; 2],
        most: usize,
        budget: &mut usize,
    ) -> Option<(Vec<Vec<Place>>, f64)> {
        let mut order: Vec<&Nested> = self.parts.iter().collect();
        sort_by_number(&mut order, |own| key_of_number(-own.ranks[first as usize]));
        let grid = room.map(|side| ((side + self.gap) / self.cell).ceil() as usize + 1);
        let least = order.iter().map(|own| own.cells).min().unwrap_or(0);
        // Without the cells of a sheet on which no part has room: thousands of them take hundreds of MB.
        let mut sheets: Vec<(Option<Bitmap>, Vec<Place>)> = Vec::new();
        let mut top: f64 = 0.0;
        for own in order {
            let found = sheets.iter().enumerate().find_map(|(s, (sheet, _))| {
                let sheet = sheet.as_ref().filter(|sheet| own.cells <= sheet.free)?;
                self.position(own, sheet, room, budget).map(|at| (s, at))
            });
            let (s, Position { stance, at, .. }) = match found {
                Some(found) => found,
                None => {
                    let sheet = Bitmap::new(grid);
                    let position = self.position(own, &sheet, room, budget)?;
                    sheets.push((Some(sheet), Vec::new()));
                    top = 0.0;
                    (sheets.len() - 1, position)
                }
            };
            if sheets.len() > most || *budget == 0 {
                return None;
            }
            let (sheet, places) = &mut sheets[s];
            if let Some(bitmap) = sheet {
                stance.runs.iter().for_each(|&run| bitmap.take(run, at));
            }
            *sheet = sheet.take().filter(|bitmap| bitmap.free >= least);
            let corner = at.map(|cells| cells as f64 * self.cell);
            let offset = [0, 1].map(|k| corner[k] + stance.moved[k]);
            places.push(Place { part: own.part, turn: stance.turn, offset });
            if s + 1 == sheets.len() {
                top = top.max(corner[1] + stance.size[1]);
            }
        }
        Some((sheets.into_iter().map(|(_, places)| places).collect(), top))
    }

    /// The position where a part reaches least high; of several the one farthest left.
    fn position<'a>(
        &self,
        own: &'a Nested,
        sheet: &Bitmap,
        room: [f64; 2],
        budget: &mut usize,
    ) -> Option<Position<'a>> {
        let mut best: Option<Position<'_>> = None;
        for stance in &own.stances {
            let most = [0, 1].map(|k| (room[k] - stance.size[k]) / self.cell);
            if most.iter().any(|most| *most < 0.0) {
                continue;
            }
            let [columns, rows] = most.map(|most| most as usize);
            let mut in_the_way = 0;
            for row in 0..=rows {
                let high = row as f64 * self.cell + stance.height;
                if best.as_ref().is_some_and(|best| high > best.reach[0]) {
                    break;
                }
                let column =
                    sheet.column_for(&stance.runs, (row, columns), &mut in_the_way, budget);
                if let Some(column) = column {
                    let reach = [high, column as f64 * self.cell + stance.size[0]];
                    if best.as_ref().is_none_or(|best| reach < best.reach) {
                        best = Some(Position { stance, at: [column, row], reach });
                    }
                    break;
                }
            }
        }
        best
    }
}

impl Stance {
    fn new(outline: &[Point2], turn: Point2, gap: f64, cell: f64) -> Stance {
        let turned: Vec<Point2> = outline.iter().map(|&point| rotated(point, turn)).collect();
        let [low, high] = bounds(turned.iter().copied());
        let reach = 0.5 * gap;
        let to_cells = |point: &Point2| [0, 1].map(|k| (point[k] - low[k] + reach) / cell);
        let in_cells: Vec<Point2> = turned.iter().map(to_cells).collect();
        let runs = cells(&in_cells, reach / cell);
        let sum = |of: fn(f64) -> f64| {
            let of_run = |run: &Run| f64::from(run.to - run.from) * of(f64::from(run.row));
            runs.iter().map(of_run).sum::<f64>()
        };
        let middle = cell * sum(|row| row) / sum(|_| 1.0);
        let size = [high[0] - low[0], high[1] - low[1]];
        Stance { turn, moved: low.map(|x| -x), size, height: size[1] + TIE * middle, runs }
    }
}
