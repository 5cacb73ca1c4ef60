//! The supernodes of a factor: runs of columns with (nearly) the same rows, which are factored, stored and
//! swept as one dense block (Ashcraft and Grimes 1989, relaxed supernodes).

use super::elimination_tree::{NONE, column_heights, elimination_tree};
use sprs::CsStructureI;
use std::iter::repeat_n;
use std::ops::Range;

/// Greatest share of zeros that a supernode of up to 4, 16, 48 and more columns may store, as
/// measured: fewer, wider supernodes save more than the zeros cost.
const MOST_ZEROS: [f64; 4] = [0.3, 0.15, 0.03, 0.01];

/// The supernodes of a factor.
pub(crate) struct Supernodes {
    /// First column of each supernode, then the number of columns.
    columns: Vec<u32>,
    /// Start of the rows of each supernode in `rows`, and the end of the last ones.
    row_starts: Vec<u32>,
    /// The rows of each supernode, its own columns first, ascending.
    rows: Vec<u32>,
    /// The parent of each supernode: the one with its first row below its columns.
    parents: Vec<u32>,
    /// The lower triangle of the matrix by columns, each with its diagonal first.
    lower: Lower,
    /// The root of the elimination tree of each column.
    components: Vec<u32>,
    nonzeros: usize,
}

/// The lower triangle of a symmetric matrix by columns, rows ascending.
struct Lower {
    /// `#columns + 1`.
    offsets: Vec<u32>,
    /// The row of each entry.
    rows: Vec<u32>,
    /// Index of each entry among the values of the upper triangle.
    places: Vec<u32>,
}

impl Lower {
    /// The transpose of the upper triangle.
    fn new(upper: &CsStructureI<u32>) -> Lower {
        let n = upper.cols();
        let mut offsets = vec![0u32; n + 1];
        for &row in upper.indices() {
            offsets[row as usize + 1] += 1;
        }
        for c in 0..n {
            offsets[c + 1] += offsets[c];
        }
        let mut next = offsets.clone();
        let mut rows = vec![0; upper.nnz()];
        let mut places = vec![0; upper.nnz()];
        for column in 0..n {
            for place in upper.indptr().outer_inds_sz(column) {
                let next = &mut next[upper.indices()[place] as usize];
                rows[*next as usize] = column as u32;
                places[*next as usize] = place as u32;
                *next += 1;
            }
        }
        Lower { offsets, rows, places }
    }

    #[inline]
    fn range(&self, column: usize) -> Range<usize> {
        self.offsets[column] as usize..self.offsets[column + 1] as usize
    }
}

impl Supernodes {
    /// Analyses the factor of a matrix, given by the pattern of its upper triangle. The columns
    /// must be in a postorder of its elimination tree.
    pub(crate) fn new(upper: &CsStructureI<u32>) -> Supernodes {
        let n = upper.cols();
        let column = |c| &upper.indices()[upper.indptr().outer_inds_sz(c)];
        let parents = elimination_tree(n, |c| column(c).iter().copied());
        let lower = Lower::new(upper);
        let heights = column_heights(&parents, |c| &lower.rows[lower.range(c)][1..]);
        let columns = supernodes(&parents, &heights);
        let nonzeros = heights.iter().map(|&height| height as usize + 1).sum();
        let mut components: Vec<u32> = (0..n as u32).collect();
        for c in (0..n).rev().filter(|&c| parents[c] != NONE) {
            components[c] = components[parents[c] as usize];
        }
        let mut analysed = Supernodes {
            row_starts: Vec::with_capacity(columns.len()),
            rows: Vec::new(),
            parents: vec![NONE; columns.len() - 1],
            columns,
            lower,
            components,
            nonzeros,
        };
        analysed.find_rows(n);
        analysed
    }

    /// Finds the rows of each supernode: those of the matrix in its columns, and those below its
    /// children.
    fn find_rows(&mut self, n: usize) {
        let count = self.count();
        let mut supernode_of = vec![0u32; n];
        for s in 0..count {
            supernode_of[self.columns(s)].fill(s as u32);
        }
        let (mut first_child, mut next_sibling) = (vec![NONE; count], vec![NONE; count]);
        let mut seen = vec![NONE; n];
        self.row_starts.push(0);
        for s in 0..count {
            let own = self.columns(s);
            self.rows.extend(own.clone().map(|c| c as u32));
            let first = self.rows.len();
            let Supernodes { rows, lower, row_starts, columns, parents, .. } = self;
            let mut take = |row: u32, rows: &mut Vec<u32>| {
                if row as usize >= own.end && seen[row as usize] != s as u32 {
                    seen[row as usize] = s as u32;
                    rows.push(row);
                }
            };
            for c in own.clone() {
                lower.rows[lower.range(c)].iter().for_each(|&row| take(row, rows));
            }
            let mut child = first_child[s];
            while child != NONE {
                let c = child as usize;
                let width = columns[c + 1] - columns[c];
                for k in row_starts[c] + width..row_starts[c + 1] {
                    take(rows[k as usize], rows);
                }
                child = next_sibling[c];
            }
            rows[first..].sort_unstable();
            row_starts.push(rows.len() as u32);
            if let Some(&row) = rows.get(first) {
                let parent = supernode_of[row as usize];
                parents[s] = parent;
                next_sibling[s] = std::mem::replace(&mut first_child[parent as usize], s as u32);
            }
        }
    }

    /// Returns the supernodes of the matrix in which every entry of this one is a block of `times`
    /// by `times`, given by the pattern of its upper triangle. Each column becomes `times`
    /// consecutive columns; tree and supernodes are the same.
    pub(crate) fn of_blocks(&self, times: u32, upper: &CsStructureI<u32>) -> Supernodes {
        let repeated = |indices: &[u32]| -> Vec<u32> {
            indices.iter().flat_map(|&i| (0..times).map(move |k| times * i + k)).collect()
        };
        let ends = |indices: &[u32]| -> Vec<u32> { indices.iter().map(|&i| times * i).collect() };
        let sizes = (0..self.count()).map(|s| {
            let wide = times as usize * self.columns(s).len();
            wide * times as usize * self.rows(s).len() - wide * (wide - 1) / 2
        });
        Supernodes {
            columns: ends(&self.columns),
            row_starts: ends(&self.row_starts),
            rows: repeated(&self.rows),
            parents: self.parents.clone(),
            lower: Lower::new(upper),
            components: self
                .components
                .iter()
                .flat_map(|&c| repeat_n(times * c, times as usize))
                .collect(),
            nonzeros: sizes.sum(),
        }
    }

    /// Number of supernodes.
    pub(crate) fn count(&self) -> usize {
        self.columns.len() - 1
    }

    /// The columns of supernode `s`.
    #[inline]
    pub(crate) fn columns(&self, s: usize) -> Range<usize> {
        self.columns[s] as usize..self.columns[s + 1] as usize
    }

    /// All rows of supernode `s`, its own columns first, ascending.
    #[inline]
    pub(crate) fn rows(&self, s: usize) -> &[u32] {
        &self.rows[self.row_starts[s] as usize..self.row_starts[s + 1] as usize]
    }

    /// The rows of supernode `s` below its columns.
    #[inline]
    pub(crate) fn rows_below(&self, s: usize) -> &[u32] {
        &self.rows(s)[self.columns(s).len()..]
    }

    /// Start of the rows of supernode `s` in [`Supernodes::all_rows`].
    pub(crate) fn row_start(&self, s: usize) -> u32 {
        self.row_starts[s]
    }

    /// The rows of all supernodes, one after another.
    pub(crate) fn all_rows(&self) -> &[u32] {
        &self.rows
    }

    /// The parent of supernode `s`, or [`NONE`].
    #[inline]
    pub(crate) fn parent(&self, s: usize) -> u32 {
        self.parents[s]
    }

    /// The supernode that contains column `c`.
    pub(crate) fn supernode_of(&self, c: u32) -> usize {
        self.columns.partition_point(|&first| first <= c) - 1
    }

    /// The entries of column `c` of the lower triangle, its diagonal first: the row of each, and
    /// its index among the values of the upper triangle.
    #[inline]
    pub(crate) fn lower(&self, c: usize) -> impl Iterator<Item = (u32, u32)> {
        let entries = self.lower.range(c);
        let rows = self.lower.rows[entries.clone()].iter().copied();
        rows.zip(self.lower.places[entries].iter().copied())
    }

    /// A number for each column that is shared within a connected component.
    pub(crate) fn components(&self) -> &[u32] {
        &self.components
    }

    /// Number of nonzeros of `L` with its diagonal.
    pub(crate) fn nonzeros(&self) -> usize {
        self.nonzeros
    }
}

/// Merges consecutive columns, each the parent of the one before, as long as few zeros are stored.
/// Returns the first column of each supernode, then the number of columns.
fn supernodes(parents: &[u32], heights: &[u32]) -> Vec<u32> {
    let n = parents.len();
    let mut starts = Vec::new();
    // Entries of the supernode so far.
    let mut entries = 0;
    for c in 0..n {
        let height = heights[c] as usize;
        if let Some(&start) = starts.last()
            && parents[c - 1] == c as u32
        {
            let width = c + 1 - start as usize;
            let stored = width * (width - 1) / 2 + width * height;
            let zeros = (stored - entries - height) as f64 / stored.max(1) as f64;
            let most = match width {
                0..=4 => MOST_ZEROS[0],
                5..=16 => MOST_ZEROS[1],
                17..=48 => MOST_ZEROS[2],
                _ => MOST_ZEROS[3],
            };
            if zeros <= most {
                entries += height;
                continue;
            }
        }
        starts.push(c as u32);
        entries = height;
    }
    starts.push(n as u32);
    starts
}
