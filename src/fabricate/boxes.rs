//! Boxes in the plane, sorted by size and place, so that those which meet another one are found
//! without a look at all of them, also beside a part far away.

use crate::math::plane::Point2;
use std::collections::BTreeMap;

/// The lower left and the upper right corner of an axis-parallel rectangle.
pub(super) type Corners = [Point2; 2];

/// Whether two rectangles have a common point.
pub(super) fn meet([low, high]: Corners, [under, over]: Corners) -> bool {
    (0..2).all(|k| low[k] <= over[k] && under[k] <= high[k])
}

/// The boxes in each cell, by row and column.
type Cells = BTreeMap<[i64; 2], Vec<(u32, Corners)>>;

/// Numbered boxes. Each is in one cell of one grid: that of its lower left corner, in the grid whose
/// cells are larger than it, but at most twice as large.
#[derive(Clone, Debug, Default)]
pub(super) struct Boxes {
    /// The cells for each binary logarithm of their size.
    grids: BTreeMap<i32, Cells>,
}

impl Boxes {
    /// The boxes numbered from 0 on.
    pub(super) fn of(boxes: impl IntoIterator<Item = Corners>) -> Boxes {
        let mut all = Boxes::default();
        boxes.into_iter().zip(0..).for_each(|(own, number)| all.insert(number, own));
        all
    }

    /// Adds a box.
    pub(super) fn insert(&mut self, number: u32, own: Corners) {
        self.cell(own).push((number, own));
    }

    /// Removes a box that was added.
    pub(super) fn remove(&mut self, number: u32, own: Corners) {
        self.cell(own).retain(|(other, _)| *other != number);
    }

    /// The boxes in the cell of a box.
    fn cell(&mut self, [low, high]: Corners) -> &mut Vec<(u32, Corners)> {
        let size = (high[0] - low[0]).max(high[1] - low[1]);
        // Not so small that the number of a cell has more digits than a coordinate.
        let far = low.into_iter().chain(high).fold(0.0, |far: f64, x| far.max(x.abs()));
        let grid = (logarithm(size) + 1).max(logarithm(far) - 40);
        let [column, row] = low.map(|x| cell(x, grid));
        self.grids.entry(grid).or_default().entry([row, column]).or_default()
    }

    /// The numbers of the boxes that have a point in common with another one.
    pub(super) fn meeting(&self, other: Corners) -> impl Iterator<Item = u32> {
        let near = self.near(other).filter(move |(_, own)| meet(*own, other));
        near.map(|&(number, _)| number)
    }

    /// All boxes of the cells that have one which may meet another box.
    fn near(&self, other: Corners) -> impl Iterator<Item = &(u32, Corners)> {
        let near = self.grids.iter().flat_map(move |(&grid, cells)| {
            // A box reaches into the cells after its own one.
            let [left, low] = other[0].map(|x| cell(x, grid) - 1);
            let [right, high] = other[1].map(|x| cell(x, grid));
            // All, if there are not even as many cells as rows.
            let few = (high - low) as u64 > cells.len() as u64;
            let rows = if few { low..=low } else { low..=high };
            let bounds = move |row: i64| match few {
                true => [low, left]..=[high, right],
                false => [row, left]..=[row, right],
            };
            rows.flat_map(move |row| cells.range(bounds(row)))
        });
        near.flat_map(|(_, own)| own)
    }
}

/// The binary logarithm of a number that is not negative, rounded down.
fn logarithm(x: f64) -> i32 {
    (x.to_bits() >> 52) as i32 - 1023
}

/// The row or column of a coordinate, of which two can be subtracted.
fn cell(x: f64, grid: i32) -> i64 {
    libm::scalbn(x, -grid).floor().clamp(-1e18, 1e18) as i64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn those_that_meet_a_box_are_found_whatever_their_sizes() {
        // Of all sizes, on both sides of zero, with points and lines among them, and one far away.
        let place = |k: u32, by: u32| f64::from(k * by % 997) / 31.0 - 16.0;
        let size = |k: u32, by: u32| f64::from(k * by % 13) * libm::scalbn(1.0, -((k % 9) as i32));
        let own = |k: u32| {
            let low = [place(k, 577), place(k, 211)];
            [low, [low[0] + size(k, 5), low[1] + size(k, 7)]]
        };
        let mut all: Vec<Corners> = (0..900).map(own).collect();
        all.push([[1e9; 2], [1e9 + 1.0; 2]]);
        all.push([[-1e9; 2], [1e9; 2]]);
        let boxes = Boxes::of(all.iter().copied());
        for asked in all.iter().step_by(7).chain(&all[899..]) {
            let mut found: Vec<u32> = boxes.meeting(*asked).collect();
            found.sort_unstable();
            let numbered = (0..).zip(&all).filter(|(_, own)| meet(**own, *asked));
            assert_eq!(found, numbered.map(|(k, _)| k).collect::<Vec<u32>>(), "{asked:?}");
        }
    }

    #[test]
    fn beside_a_part_far_away_few_boxes_are_looked_at() {
        let own = |k: u32| [k % 100, k / 100].map(f64::from);
        let mut boxes = Boxes::of((0..10_000).map(own).map(|low| [low, low.map(|x| x + 0.9)]));
        boxes.insert(10_000, [[1e9; 2], [1e9 + 1.0; 2]]);
        boxes.insert(10_001, [[-1e5; 2], [1e5; 2]]);
        for k in (0..10_000).step_by(77) {
            let near = boxes.near([own(k); 2]).count();
            assert!(near <= 5, "{k}: {near}");
        }
        boxes.remove(10_001, [[-1e5; 2], [1e5; 2]]);
        assert_eq!(boxes.meeting([[5.5, 7.5]; 2]).collect::<Vec<_>>(), [705]);
    }
}
