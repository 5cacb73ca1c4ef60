//! Parts in rows: each is pushed to the left until it touches the row, upright or upside down,
//! whichever leaves more room, so that trapezoids alternate and arcs nest.

use super::clearance::min_shift;
use super::part::{CutPart, Place};
use crate::fabricate::panel::{hull, sides, smallest_box_within};
use crate::math::plane::{Point2, area, bounds, rotated};
use crate::scene::Order;

/// Step of the heights of shelves, in mm.
const STEP: f64 = 0.01;
/// Number of parts without room after which a shelf is full.
const MOST_MISSES: u32 = 30;
/// Tolerance for rounding errors in heights, in units of [`STEP`].
const ROUNDING: f64 = 1e-3;

/// A part that rests on its smallest bounding box.
#[derive(Clone)]
pub(super) struct Resting {
    /// The index of the part.
    pub part: usize,
    /// Cosine and sine of its rotation.
    pub turn: Point2,
    /// Convex polygons that cover the rotated part; the lower left corner of its box is at the
    /// origin.
    cover: Vec<Vec<Point2>>,
    /// The translation that moved it there.
    moved: Point2,
    /// Width and height of the box.
    pub size: [f64; 2],
}

impl Resting {
    fn new(part: usize, turn: Point2, turned: Vec<Vec<Point2>>) -> Resting {
        let [low, high] = bounds(turned.iter().flatten().copied());
        let moved = low.map(|x| -x);
        let put = |polygon: Vec<Point2>| polygon.into_iter().map(|p| plus(p, moved)).collect();
        let cover = turned.into_iter().map(put).collect();
        Resting { part, turn, cover, moved, size: [high[0] - low[0], high[1] - low[1]] }
    }

    /// Rotated further.
    pub(super) fn turned(&self, by: Point2) -> Resting {
        let put = |polygon: &Vec<Point2>| {
            let back = polygon.iter().map(|&[x, y]| [x - self.moved[0], y - self.moved[1]]);
            back.map(|point| rotated(point, by)).collect()
        };
        Resting::new(self.part, rotated(self.turn, by), self.cover.iter().map(put).collect())
    }

    /// Its height in steps, rounded so that parts of equal height have equal steps.
    pub(super) fn step(&self) -> f64 {
        (self.size[1] / STEP - ROUNDING).ceil()
    }

    /// Standing on a shorter side of its box.
    pub(super) fn quarter_turned(&self) -> Resting {
        self.turned([0.0, 1.0])
    }
}

/// All parts, along the longer sides of their smallest boxes that fit into this room.
pub(super) fn resting(parts: &[CutPart], [width, height]: [f64; 2]) -> Vec<Resting> {
    let most = [width.max(height), width.min(height)];
    let rest = |(k, part): (usize, &CutPart)| {
        let (turn, _) = smallest_box_within(&part.outline, most);
        let turned: Vec<_> = part.outline.iter().map(|&point| rotated(point, turn)).collect();
        Resting::new(k, turn, cover(&turned))
    };
    parts.iter().enumerate().map(rest).collect()
}

/// Convex polygons that cover an outline: its hull, or hulls of slices across it if the hull is
/// much larger.
fn cover(outline: &[Point2]) -> Vec<Vec<Point2>> {
    const SLICES: u32 = 12;
    const LARGER: f64 = 1.15;
    let whole = hull(outline);
    if area(&whole) <= LARGER * area(outline) {
        return vec![whole];
    }
    let [low, high] = bounds(outline.iter().copied());
    // The last bound is the right end itself: rounding must not leave a corner outside.
    let at = |k: u32| match k {
        SLICES => high[0],
        _ => low[0] + f64::from(k) / f64::from(SLICES) * (high[0] - low[0]),
    };
    let slice = |k: u32| {
        let [from, to] = [at(k), at(k + 1)];
        let mut points: Vec<Point2> =
            outline.iter().copied().filter(|[x, _]| (from..=to).contains(x)).collect();
        for [p, q] in sides(outline) {
            let crossing = |x: f64| {
                let share = (x - p[0]) / (q[0] - p[0]);
                (0.0..=1.0).contains(&share).then(|| [x, p[1] + share * (q[1] - p[1])])
            };
            points.extend([from, to].into_iter().filter_map(crossing));
        }
        hull(&points)
    };
    (0..SLICES).map(slice).filter(|own| own.len() > 2).collect()
}

fn plus([a, b]: Point2, [c, d]: Point2) -> Point2 {
    [a + c, b + d]
}

/// A row of parts on a sheet.
struct Shelf {
    sheet: usize,
    low: f64,
    /// Its height, in steps.
    step: f64,
    /// The height of its highest part.
    height: f64,
    /// The right end of its parts.
    right: f64,
    /// Number of parts tried that had no room.
    misses: u32,
    /// Convex polygons relative to its lower left corner, each with its right end.
    laid: Vec<(f64, Vec<Point2>)>,
}

/// A possible position on a shelf.
struct Found {
    /// The right end of the part.
    right: f64,
    resting: Resting,
    at: Point2,
}

impl Shelf {
    /// The position of a part that leaves most room; none without room.
    fn room_for(&mut self, own: &Resting, width: f64, gap: f64, may_grow: bool) -> Option<Found> {
        let [w, h] = own.size;
        // A part nests between others by at most this fraction of its width.
        let overlap = if own.cover.len() > 1 { 1.0 } else { 0.5 };
        if (own.step() > self.step && !may_grow) || self.right + (1.0 - overlap) * w > width {
            return None;
        }
        // Full: otherwise every part would be tried on every shelf.
        if self.misses >= MOST_MISSES && !may_grow {
            return None;
        }
        let mut best: Option<Found> = None;
        for resting in [own.clone(), own.turned([-1.0, 0.0])] {
            let heights = [0.0, self.height - h];
            for &y in &heights[..if heights[1] > 0.0 { 2 } else { 1 }] {
                let raised = resting
                    .cover
                    .iter()
                    .map(|own| own.iter().map(|&point| plus(point, [0.0, y])).collect::<Vec<_>>());
                let mut shift: f64 = 0.0;
                for moving in raised {
                    let left = moving.iter().map(|point| point[0]).fold(f64::INFINITY, f64::min);
                    for (right, laid) in self.laid.iter().rev() {
                        // Otherwise it is to the left already.
                        if right + gap > shift + left {
                            shift = shift.max(min_shift(laid, &moving, gap).unwrap_or(0.0));
                        }
                    }
                }
                let right = shift + w;
                // In a tie the first wins regardless of rounding.
                let is_better = best.as_ref().is_none_or(|best| right < best.right - 1e-9 * w);
                if right <= width && is_better {
                    best = Some(Found { right, resting: resting.clone(), at: [shift, y] });
                }
            }
        }
        self.misses += u32::from(best.is_none());
        best
    }

    fn lay(&mut self, Found { right, resting, at }: Found) {
        for own in &resting.cover {
            let polygon: Vec<Point2> = own.iter().map(|&point| plus(point, at)).collect();
            let end = polygon.iter().map(|point| point[0]).fold(f64::NEG_INFINITY, f64::max);
            self.laid.push((end, polygon));
        }
        self.right = self.right.max(right);
        self.step = self.step.max(resting.step());
        self.height = self.height.max(resting.size[1]);
    }
}

/// Rows on as many sheets as needed.
pub(super) struct Shelves {
    room: [f64; 2],
    gap: f64,
    order: Order,
    shelves: Vec<Shelf>,
    /// The height above which each sheet is free.
    free: Vec<f64>,
}

impl Shelves {
    /// Empty sheets with this much room.
    pub(super) fn new(room: [f64; 2], gap: f64, order: Order) -> Shelves {
        Shelves { room, gap, order, shelves: Vec::new(), free: Vec::new() }
    }

    /// The used height of the last sheet.
    pub(super) fn height_of_last(&self) -> f64 {
        self.free.last().copied().unwrap_or(0.0)
    }

    /// Lays a part that fits on an empty sheet on the first shelf with room; returns the index of
    /// the sheet and the place.
    pub(super) fn lay(&mut self, own: Resting) -> (usize, Place) {
        let [width, height] = self.room;
        let gap = self.gap;
        let found = match self.order {
            Order::Size => self
                .shelves
                .iter_mut()
                .enumerate()
                .find_map(|(s, shelf)| Some((s, shelf.room_for(&own, width, gap, false)?))),
            // Only the last shelf, which may grow because nothing is above it.
            Order::Names => {
                let last = self.shelves.len().checked_sub(1);
                last.filter(|&s| self.shelves[s].low + own.size[1] <= height)
                    .and_then(|s| Some((s, self.shelves[s].room_for(&own, width, gap, true)?)))
            }
        };
        let (s, found) = found.unwrap_or_else(|| {
            let from = match self.order {
                Order::Size => 0,
                Order::Names => self.free.len().saturating_sub(1),
            };
            let sheet = (from..self.free.len()).find(|&s| self.free[s] + own.size[1] <= height);
            let sheet = sheet.unwrap_or_else(|| {
                self.free.push(0.0);
                self.free.len() - 1
            });
            let low = self.free[sheet];
            let (step, height) = (own.step(), own.size[1]);
            let (right, misses, laid) = (0.0, 0, Vec::new());
            let shelf = Shelf { sheet, low, step, height, right, misses, laid };
            self.shelves.push(shelf);
            let right = own.size[0];
            (self.shelves.len() - 1, Found { right, resting: own, at: [0.0; 2] })
        });
        let shelf = &mut self.shelves[s];
        let Resting { part, turn, moved, .. } = found.resting;
        let [x, y] = found.at;
        let offset = [x + moved[0], shelf.low + y + moved[1]];
        let sheet = shelf.sheet;
        shelf.lay(found);
        // As high as any part of the same step.
        let top = shelf.low + (shelf.step + ROUNDING) * STEP;
        self.free[sheet] = self.free[sheet].max(top + gap);
        (sheet, Place { part, turn, offset })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fabricate::panel::direction_of;
    use crate::math::{cosine, sine};

    #[test]
    fn every_corner_of_an_outline_with_notches_is_covered() {
        let mut state = 1_u64;
        let mut random = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        for _ in 0..500 {
            let star: Vec<Point2> = (0..9)
                .map(|k| {
                    let turns = (f64::from(k) + 0.8 * random()) / 9.0;
                    let radius = if k % 2 == 0 { 40.0 } else { 12.0 } * (0.5 + random());
                    [radius * cosine(turns), radius * sine(turns)]
                })
                .collect();
            let own = cover(&star);
            for corner in &star {
                let holds = |polygon: &Vec<Point2>| {
                    sides(polygon).all(|[p, q]| {
                        let [x, y] = direction_of(p, q);
                        x * (corner[1] - p[1]) - y * (corner[0] - p[0]) > -1e-9
                    })
                };
                assert!(own.iter().any(holds), "{corner:?} of {star:?}");
            }
        }
    }
}
