//! The cells of a grid that a part covers together with the space around it.

use crate::fabricate::panel::{direction_of, sides};
use crate::math::plane::{Point2, bounds};
use crate::math::sort_by_number;

/// Tolerance for rounding errors, in cells.
const ROUNDING: f64 = 1e-6;

/// Successive cells of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Run {
    /// The row, from below.
    pub row: u32,
    /// The first column.
    pub from: u32,
    /// The column after the last one.
    pub to: u32,
}

/// The cells with a point nearer than `reach` to a part, in units of the side of a cell; none is
/// missing. The box of its `outline` has its lower left corner at (`reach`, `reach`). Rows that are
/// far from each other come first, since they tell soonest that a part has no room.
pub(super) fn cells(outline: &[Point2], reach: f64) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    let mut add = |row: f64, [left, right]: [f64; 2]| {
        let (from, to) = (after(left), before(right));
        if from < to {
            runs.push(Run { row: row as u32, from: from as u32, to: to as u32 });
        }
    };
    for side in sides(outline) {
        near_side(side, reach, &mut add);
    }
    inside(outline, &mut add);
    runs.sort_unstable();
    let mut joined: Vec<Run> = Vec::new();
    for run in runs {
        match joined.last_mut() {
            Some(last) if last.row == run.row && run.from <= last.to => {
                last.to = last.to.max(run.to);
            }
            _ => joined.push(run),
        }
    }
    sort_by_number(&mut joined, |run| u64::from(u32::BITS - run.row.trailing_zeros()));
    joined
}

/// The first cell that begins a piece that starts here.
fn after(start: f64) -> f64 {
    (start + ROUNDING).floor().max(0.0)
}

/// The cell after a piece that ends here.
fn before(end: f64) -> f64 {
    (end - ROUNDING).ceil()
}

/// For each row, the ends of the points nearer than `reach` to a side.
fn near_side([p, q]: [Point2; 2], reach: f64, add: &mut impl FnMut(f64, [f64; 2])) {
    let (low, high) = (p[1].min(q[1]) - reach, p[1].max(q[1]) + reach);
    let mirrored = [p, q].map(|[x, y]| [-x, y]);
    let mut row = after(low);
    while row < before(high) {
        let band = [low.max(row), high.min(row + 1.0)];
        add(row, [-rightmost(mirrored, reach, band), rightmost([p, q], reach, band)]);
        row += 1.0;
    }
}

/// The greatest x of the points nearer than `reach` to a segment, of those with y in a band.
fn rightmost([p, q]: [Point2; 2], reach: f64, [low, high]: [f64; 2]) -> f64 {
    // The border on the right is concave, and farthest beside the end that is farthest.
    let far = if q[0] > p[0] { q } else { p };
    let y = far[1].max(low).min(high);
    let [below, above] = if p[1] <= q[1] { [p, q] } else { [q, p] };
    let [c, s] = direction_of(below, above);
    let ends = [below, above].map(|[x, y]| [x + s * reach, y - c * reach]);
    let height = above[1] - below[1];
    if height > 0.0 && y >= ends[0][1] && y <= ends[1][1] {
        return ends[0][0] + (y - ends[0][1]) / height * (ends[1][0] - ends[0][0]);
    }
    let end = match height > 0.0 {
        true if y < ends[0][1] => below,
        true => above,
        false => far,
    };
    let away = y - end[1];
    end[0] + (reach * reach - away * away).max(0.0).sqrt()
}

/// For each row, the ends of the pieces of its middle line inside an outline. Cells that no side
/// crosses are inside if their middle is.
fn inside(outline: &[Point2], add: &mut impl FnMut(f64, [f64; 2])) {
    let [low, high] = bounds(outline.iter().copied());
    let rows = before(high[1]).max(0.0) as usize;
    let mut crossings = vec![Vec::new(); rows];
    for [p, q] in sides(outline) {
        let (bottom, top) = (p[1].min(q[1]), p[1].max(q[1]));
        let mut row = (bottom - 0.5).ceil().max(0.0);
        while row + 0.5 < top {
            if row + 0.5 >= bottom {
                let share = (row + 0.5 - p[1]) / (q[1] - p[1]);
                crossings[row as usize].push(p[0] + share * (q[0] - p[0]));
            }
            row += 1.0;
        }
    }
    for (row, own) in crossings.iter_mut().enumerate().skip(after(low[1]) as usize) {
        own.sort_unstable_by(f64::total_cmp);
        own.as_chunks().0.iter().for_each(|&piece| add(row as f64, piece));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fabricate::panel::distance_to_outline;
    use crate::math::plane::is_inside;
    use crate::math::{cosine, sine};

    #[test]
    fn every_point_near_a_part_is_in_one_of_its_cells_and_few_others_are() {
        for (reach, teeth) in [(0.0, 3), (1.7, 4), (3.0, 7)] {
            let star: Vec<Point2> = (0..2 * teeth)
                .map(|k| {
                    let turns = f64::from(k) / f64::from(2 * teeth) + 0.03;
                    let radius = if k % 2 == 0 { 20.0 } else { 7.0 };
                    [radius * cosine(turns), radius * sine(turns)]
                })
                .collect();
            let [low, _] = bounds(star.iter().copied());
            let star: Vec<Point2> =
                star.iter().map(|point| [0, 1].map(|k| point[k] - low[k] + reach)).collect();
            let runs = cells(&star, reach);
            for i in 0..480 {
                for j in 0..480 {
                    let point = [0.1 * f64::from(i) + 0.05, 0.1 * f64::from(j) + 0.05];
                    let away = distance_to_outline(&star, point);
                    let is_near = is_inside(&star, point) || away < reach;
                    let cell = point.map(|x| x as u32);
                    let is_taken = runs
                        .iter()
                        .any(|run| run.row == cell[1] && (run.from..run.to).contains(&cell[0]));
                    assert!(is_taken || !is_near, "{point:?} {reach}");
                    // No point of a cell is farther than its diagonal from the others.
                    assert!(!is_taken || is_near || away < reach + 1.5, "{point:?} {reach}");
                }
            }
        }
    }

    #[test]
    fn a_part_that_fills_its_cells_takes_no_others() {
        let rectangle = [[0.0, 0.0], [3.0, 0.0], [3.0, 2.0], [0.0, 2.0]];
        let row = |row: u32| Run { row, from: 0, to: 3 };
        assert_eq!(cells(&rectangle, 0.0), [row(0), row(1)]);
    }
}
