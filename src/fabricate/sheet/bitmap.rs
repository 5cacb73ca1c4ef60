//! The cells of a sheet: which are taken, and where a part has room.

use super::cells::Run;

/// Columns in a word.
const BITS: usize = u64::BITS as usize;

/// A sheet as cells, a bit each: those of a row are tested by the word.
pub(super) struct Bitmap {
    /// Words in a row.
    words: usize,
    /// The taken cells, row by row from below, each from the left.
    taken: Vec<u64>,
    /// The number of free cells.
    pub free: usize,
}

impl Bitmap {
    /// A free sheet with this many columns and rows.
    pub(super) fn new([columns, rows]: [usize; 2]) -> Bitmap {
        let words = columns.div_ceil(BITS);
        Bitmap { words, taken: vec![0; words * rows], free: columns * rows }
    }

    /// Takes cells that are free; `column` and `row` are those of the lower left cell of the part.
    pub(super) fn take(&mut self, run: Run, [column, row]: [usize; 2]) {
        let [from, to] = [run.from, run.to].map(|at| at as usize + column);
        let start = (run.row as usize + row) * self.words;
        for k in from / BITS..=(to - 1) / BITS {
            self.taken[start + k] |= mask(k, from, to);
        }
        self.free -= to - from;
    }

    /// The last taken cell of a row among the columns `from..to`.
    fn last_taken(&self, row: usize, from: usize, to: usize) -> Option<usize> {
        let row = &self.taken[row * self.words..(row + 1) * self.words];
        (from / BITS..=(to - 1) / BITS).rev().find_map(|k| {
            let found = row[k] & mask(k, from, to);
            (found != 0).then(|| k * BITS + BITS - 1 - found.leading_zeros() as usize)
        })
    }

    /// The first column from 0 to `most` where a part has room with its lowest cells in this row.
    /// The search begins at run `first`, which becomes the last that was in the way: it is likely to
    /// be so in the next row too. Every test of a run is counted down in `budget`.
    pub(super) fn column_for(
        &self,
        runs: &[Run],
        (row, most): (usize, usize),
        first: &mut usize,
        budget: &mut usize,
    ) -> Option<usize> {
        let (mut column, mut passed, mut k) = (0, 0, *first);
        while passed < runs.len() {
            let Run { row: above, from, to } = runs[k];
            let [from, to] = [from, to].map(|at| at as usize);
            *budget = budget.saturating_sub(1);
            match self.last_taken(row + above as usize, column + from, column + to) {
                // No position before the one beyond that cell has room.
                Some(taken) => {
                    (column, passed, *first) = (taken + 1 - from, 0, k);
                    if column > most {
                        return None;
                    }
                }
                None => {
                    passed += 1;
                    k = if k + 1 < runs.len() { k + 1 } else { 0 };
                }
            }
        }
        Some(column)
    }
}

/// The bits of word `k` of a row that are of the columns `from..to`, of which some are.
fn mask(k: usize, from: usize, to: usize) -> u64 {
    let low = from.saturating_sub(k * BITS);
    let high = (to - k * BITS).min(BITS);
    (u64::MAX >> (BITS - (high - low))) << low
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_goes_to_the_first_column_where_none_of_its_cells_is_taken() {
        let mut state = 7_u64;
        let mut random = |most: u32| {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 33) as u32 % most
        };
        for _ in 0..300 {
            let mut sheet = Bitmap::new([200, 6]);
            let mut taken = [[false; 200]; 6];
            for row in 0..6 {
                let from = random(40);
                let mut at = from;
                while at < 190 {
                    let to = at + 1 + random(9);
                    sheet.take(Run { row: 0, from: at, to }, [0, row]);
                    (at..to).for_each(|k| taken[row][k as usize] = true);
                    at = to + 1 + random(70);
                }
            }
            assert_eq!(sheet.free, taken.as_flattened().iter().filter(|taken| !**taken).count());
            // A U: two legs on a base.
            let [leg, between] = [1 + random(5), random(70)];
            let width = 2 * leg + between;
            let run = |row, from, to| Run { row, from, to };
            let runs = [run(0, 0, width), run(1, 0, leg), run(1, leg + between, width)];
            let most = 200 - width as usize;
            for row in 0..5 {
                let is_free = |column: &usize| {
                    let free = |run: &Run| {
                        (run.from..run.to)
                            .all(|k| !taken[row + run.row as usize][column + k as usize])
                    };
                    runs.iter().all(free)
                };
                let expected = (0..=most).find(is_free);
                for mut first in 0..runs.len() {
                    let found = sheet.column_for(&runs, (row, most), &mut first, &mut 10_000);
                    assert_eq!(found, expected);
                }
            }
        }
    }
}
