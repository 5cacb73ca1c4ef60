//! Panels larger than the sheet, cut into pieces that fit: along straight seams, in columns and rows of
//! the box of the panel. A plate behind each seam joins the two pieces at it, as butt blocks join the
//! planks of a boat: of flat sheet no lap can be cut.

use super::polygon::{are_apart, check_size, sides, smallest_box};
use crate::math::plane::{Point2, area, bounds, distance, is_inside};
use crate::math::sort_by_number;

/// Most columns, and most rows.
const MOST: usize = 6;
/// A plate ends so far from the outline and from other seams, in its widths: where seams meet, their
/// plates do not.
const END: f64 = 0.6;
/// Least length of a plate, and least width of a piece, in widths of a plate.
const SHORTEST: f64 = 0.5;
const NARROWEST: f64 = 1.5;
/// Points nearer than this, in mm, are one.
const SAME: f64 = 1e-6;

/// What lies beyond a side of a piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::fabricate) enum PieceSide {
    /// What lies beyond this side of the panel.
    Panel(usize),
    /// The piece with this number.
    Piece(usize),
}

/// A piece: its corners, each with the side that begins there, counterclockwise.
pub(in crate::fabricate) type Piece = Vec<(Point2, PieceSide)>;

/// A plate behind a seam, in mm of the sheet in the plane of the panel.
#[derive(Clone, Copy, Debug)]
pub(in crate::fabricate) struct SplicePlate {
    /// The pieces that it joins: the first has the smaller coordinates.
    pub pieces: [usize; 2],
    /// The axis across the seam, x or y.
    pub axis: usize,
    /// The lower left and the upper right corner.
    pub corners: [Point2; 2],
    /// The ends of the seam.
    pub seam: [Point2; 2],
}

/// A panel in pieces.
#[derive(Clone, Debug, Default)]
pub(in crate::fabricate) struct Spliced {
    pub pieces: Vec<Piece>,
    pub plates: Vec<SplicePlate>,
}

/// Cuts an outline, which is drawn half the kerf outside the panel, into the fewest pieces that fit, and
/// of equally few into the most even ones, with no seam and no plate across a hole. Plates have this width.
/// None if there are no such pieces.
pub(in crate::fabricate) fn spliced(
    outline: &[Point2],
    holes: &[Vec<Point2>],
    width: f64,
    kerf: f64,
    fits: impl Fn(&[Point2]) -> bool,
) -> Option<Spliced> {
    let mut grids: Vec<[usize; 2]> =
        (1..=MOST).flat_map(|columns| (1..=MOST).map(move |rows| [columns, rows])).collect();
    sort_by_number(&mut grids, |[columns, rows]| (columns * rows) as u64);
    let of_count = |equal: &[[usize; 2]]| {
        let all = equal.iter().filter_map(|&counts| {
            let own = Grid::new((outline, holes), counts, width, 0.5 * kerf).cut(&fits)?;
            let areas = || own.pieces.iter().map(|piece| area(&corners(piece)));
            let (least, most) =
                (areas().fold(f64::INFINITY, f64::min), areas().fold(0.0, f64::max));
            Some((least / most, own))
        });
        // In a tie the first wins regardless of rounding.
        all.reduce(|best, other| if other.0 > best.0 + SAME { other } else { best })
    };
    let mut by_count = grids[1..].chunk_by(|a, b| a[0] * a[1] == b[0] * b[1]);
    by_count.find_map(of_count).map(|(_, own)| own)
}

/// The corners of a piece.
pub(in crate::fabricate) fn corners(piece: &Piece) -> Vec<Point2> {
    piece.iter().map(|&(corner, _)| corner).collect()
}

/// Columns and rows of an outline.
struct Grid<'a> {
    outline: &'a [Point2],
    holes: &'a [Vec<Point2>],
    counts: [usize; 2],
    low: Point2,
    step: Point2,
    width: f64,
    /// Half the kerf.
    half: f64,
}

impl Grid<'_> {
    fn new<'a>(
        (outline, holes): (&'a [Point2], &'a [Vec<Point2>]),
        counts: [usize; 2],
        width: f64,
        half: f64,
    ) -> Grid<'a> {
        let [low, high] = bounds(outline.iter().copied());
        let step = [0, 1].map(|axis| (high[axis] - low[axis]) / counts[axis] as f64);
        Grid { outline, holes, counts, low, step, width, half }
    }

    /// The coordinate where a column or row begins.
    fn start(&self, axis: usize, number: usize) -> f64 {
        self.low[axis] + self.step[axis] * number as f64
    }

    fn cut(&self, fits: impl Fn(&[Point2]) -> bool) -> Option<Spliced> {
        let [columns, rows] = self.counts;
        let cell = |k: usize| [k / rows, k % rows];
        let cut: Vec<Piece> =
            (0..columns * rows).map(|k| self.piece(cell(k))).collect::<Option<_>>()?;
        // Cells beside the panel are no pieces.
        let mut number = vec![None; cut.len()];
        let there = (0..cut.len()).filter(|&k| !cut[k].is_empty());
        there.enumerate().for_each(|(own, k)| number[k] = Some(own));
        let mut found = Spliced::default();
        for (k, mut piece) in cut.into_iter().enumerate().filter(|(_, piece)| !piece.is_empty()) {
            for (_, side) in &mut piece {
                if let PieceSide::Piece(other) = side {
                    *other = number[*other]?;
                }
            }
            let outline = corners(&piece);
            let narrow = || smallest_box(&outline).1[1] < NARROWEST * self.width;
            let is_across = self.holes.iter().any(|hole| !are_apart(&outline, hole));
            if check_size(&outline).is_err() || !fits(&outline) || narrow() || is_across {
                return None;
            }
            for axis in [0, 1] {
                let mut beyond = cell(k);
                beyond[axis] += 1;
                let other = number.get(beyond[0] * rows + beyond[1]).copied().flatten();
                let Some(other) = other.filter(|_| beyond[axis] < self.counts[axis]) else {
                    continue;
                };
                let at = piece.iter().position(|(_, side)| *side == PieceSide::Piece(other));
                let Some(at) = at else { continue };
                let seam = [outline[at], outline[(at + 1) % outline.len()]];
                let pieces = [found.pieces.len(), other];
                let corners = self.plate(cell(k), axis)?;
                found.plates.push(SplicePlate { pieces, axis, corners, seam });
            }
            found.pieces.push(piece);
        }
        Some(found)
    }

    /// The piece in a cell, whose seams lead to cells; empty if there is none. None if a seam is not one
    /// line across the panel.
    fn piece(&self, cell: [usize; 2]) -> Option<Piece> {
        let all = self.outline.iter().zip(0..);
        let mut piece: Piece = all.map(|(&corner, k)| (corner, PieceSide::Panel(k))).collect();
        for axis in [0, 1] {
            let ends = [(cell[axis], -1.0), (cell[axis] + 1, 1.0)];
            for (number, sign) in ends {
                if number == 0 || number == self.counts[axis] {
                    continue;
                }
                let mut beyond = cell;
                beyond[axis] = if sign > 0.0 { number } else { number - 1 };
                let seam = PieceSide::Piece(beyond[0] * self.counts[1] + beyond[1]);
                // Half the kerf beyond the seam.
                let at = self.start(axis, number) + sign * self.half;
                piece = clipped(&piece, |point| sign * (point[axis] - at), seam)?;
            }
        }
        Some(piece)
    }

    /// The corners of the plate at the upper end of a cell: so long that it lies within the panel.
    fn plate(&self, cell: [usize; 2], axis: usize) -> Option<[Point2; 2]> {
        let along = 1 - axis;
        let across = self.start(axis, cell[axis] + 1);
        let ends = [across - 0.5 * self.width, across + 0.5 * self.width];
        // The outline is nearest at its corners, and at the long sides of the plate.
        let near =
            self.outline.iter().flat_map(|corner| [corner[axis] - SAME, corner[axis] + SAME]);
        let near = near.filter(|at| (ends[0]..=ends[1]).contains(at));
        let [first, last] = [cell[along], cell[along] + 1].map(|number| self.start(along, number));
        let [mut low, mut high] = [first, last];
        for at in ends.into_iter().chain(near) {
            let [from, to] = within(self.outline, axis, at)?;
            (low, high) = (low.max(from + self.half), high.min(to - self.half));
        }
        let [low, high] = [low + END * self.width, high - END * self.width];
        let corner = |across: f64, along: f64| match axis {
            0 => [across, along],
            _ => [along, across],
        };
        let is_long = high - low >= SHORTEST * self.width;
        let [low, high] = [corner(ends[0], low), corner(ends[1], high)];
        let plate = [low, [high[0], low[1]], high, [low[0], high[1]]];
        let is_beside = |hole: &Vec<Point2>| {
            are_apart(&plate, hole) && !is_inside(&plate, hole[0]) && !is_inside(hole, low)
        };
        (is_long && self.holes.iter().all(is_beside)).then_some([low, high])
    }
}

/// What is left of a polygon where `beyond` is not positive, with this side along the cut; none if it
/// falls apart.
fn clipped(polygon: &Piece, beyond: impl Fn(Point2) -> f64, seam: PieceSide) -> Option<Piece> {
    let n = polygon.len();
    let mut found: Piece = Vec::new();
    let mut leaves = 0;
    for (k, &(p, side)) in polygon.iter().enumerate() {
        let q = polygon[(k + 1) % n].0;
        let (from, to) = (beyond(p), beyond(q));
        if from <= SAME {
            found.push((p, side));
        }
        if (from <= SAME) != (to <= SAME) {
            let share = (from / (from - to)).clamp(0.0, 1.0);
            let is_leaving = from <= SAME;
            leaves += u32::from(is_leaving);
            let at = [0, 1].map(|x| p[x] + share * (q[x] - p[x]));
            found.push((at, if is_leaving { seam } else { side }));
        }
    }
    let corners = corners(&found);
    let n = corners.len();
    let mut has_length = (0..n).map(|k| distance(corners[k], corners[(k + 1) % n]) > SAME);
    found.retain(|_| has_length.next().unwrap_or(false));
    if found.len() < 3 {
        found.clear();
    }
    (leaves <= 1).then_some(found)
}

/// Between which coordinates a line across an axis is inside an outline; none if it enters it more than
/// once, or never.
fn within(outline: &[Point2], axis: usize, at: f64) -> Option<[f64; 2]> {
    let along = 1 - axis;
    let crosses = sides(outline).filter(|[p, q]| (p[axis] > at) != (q[axis] > at));
    let found = crosses
        .map(|[p, q]| p[along] + (at - p[axis]) / (q[axis] - p[axis]) * (q[along] - p[along]));
    match found.collect::<Vec<f64>>()[..] {
        [a, b] => Some([a.min(b), a.max(b)]),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{cosine, sine};

    /// A polygon with so many corners on an ellipse.
    fn around(corners: u32, [a, b]: [f64; 2]) -> Vec<Point2> {
        let corner = |k: u32| {
            let turns = f64::from(k) / f64::from(corners);
            [a * cosine(turns), b * sine(turns)]
        };
        (0..corners).map(corner).collect()
    }

    fn fits(piece: &[Point2]) -> bool {
        let size = smallest_box(piece).1;
        size[0] <= 410.0 && size[1] <= 287.0
    }

    #[test]
    fn pieces_cover_the_panel_once_and_plates_lie_in_it_across_the_seams() {
        for (outline, kerf, count) in [
            (vec![[0.0, 0.0], [500.0, 0.0], [500.0, 200.0], [0.0, 200.0]], 0.2, 2),
            (vec![[0.0, 0.0], [500.0, 0.0], [250.0, 433.0]], 0.0, 4),
            (around(6, [260.0, 300.0]), 1.5, 4),
            (around(17, [600.0, 130.0]), 0.0, 3),
        ] {
            let Spliced { pieces, plates } =
                spliced(&outline, &[], 12.0, kerf, fits).expect("it is cut");
            assert_eq!(pieces.len(), count);
            // Along each seam the pieces overlap by the kerf.
            let sum: f64 = pieces.iter().map(|piece| area(&corners(piece))).sum();
            let seams: f64 =
                plates.iter().map(|plate| distance(plate.seam[0], plate.seam[1])).sum();
            let more = sum - area(&outline) - kerf * seams;
            assert!(more.abs() < 5.0 * kerf * kerf + 1e-6, "{more}");
            for SplicePlate { pieces: own, axis, corners: [low, high], .. } in &plates {
                for at in [*low, *high, [low[0], high[1]], [high[0], low[1]]] {
                    assert!(is_inside(&outline, at), "{at:?}");
                }
                assert!((high[*axis] - low[*axis] - 12.0).abs() < 1e-9);
                // Each of the two names the other at one side.
                for (one, other) in [(own[0], own[1]), (own[1], own[0])] {
                    let to = |(_, side): &&(Point2, PieceSide)| *side == PieceSide::Piece(other);
                    assert_eq!(pieces[one].iter().filter(to).count(), 1);
                }
            }
            // Plates are apart.
            for (k, one) in plates.iter().enumerate() {
                for other in &plates[k + 1..] {
                    let apart = |x: usize| {
                        one.corners[1][x] < other.corners[0][x]
                            || other.corners[1][x] < one.corners[0][x]
                    };
                    assert!(apart(0) || apart(1));
                }
            }
        }
    }

    #[test]
    fn no_seam_and_no_plate_is_across_a_hole() {
        let outline = [[0.0, 0.0], [500.0, 0.0], [500.0, 200.0], [0.0, 200.0]];
        let hole = |x: f64| vec![[x, 80.0], [x + 40.0, 80.0], [x + 40.0, 120.0], [x, 120.0]];
        // The seam of two halves would cross the first hole, and its plate the second.
        for (x, count) in [(230.0, 3), (253.0, 3), (270.0, 2)] {
            let found = spliced(&outline, &[hole(x)], 12.0, 0.0, fits).expect("it is cut");
            assert_eq!(found.pieces.len(), count, "{x}");
            for SplicePlate { corners: [low, high], .. } in found.plates {
                assert!(high[0] < x || low[0] > x + 40.0);
            }
        }
    }

    #[test]
    fn a_panel_is_left_whole_that_no_pieces_of_it_fit_or_no_plate_can_join() {
        let huge = [[0.0, 0.0], [4000.0, 0.0], [4000.0, 200.0], [0.0, 200.0]];
        assert!(spliced(&huge, &[], 12.0, 0.0, fits).is_none());
        // Seams of 12 mm.
        let slender = [[0.0, 0.0], [600.0, 0.0], [600.0, 12.0], [0.0, 12.0]];
        assert!(spliced(&slender, &[], 12.0, 0.0, fits).is_none());
    }
}
