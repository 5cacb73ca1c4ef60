//! The factor `L D L^T` copied into dense panels, and the two triangular sweeps over them.
//!
//! Columns with (nearly) the same rows form a supernode, and each supernode is cut into panels of a
//! few columns. A panel stores its values row by row without indices between them, so that
//! one load of `x` serves all its columns, and x, y and z are solved together. Rows are padded to four
//! values: one 128-bit register in single precision, two in double.

use super::scalar::Scalar;

/// The strict lower triangle of a factor in compressed columns, rows ascending.
#[derive(Clone, Copy)]
pub(super) struct Columns<'a> {
    /// `#columns + 1`.
    pub offsets: &'a [u32],
    /// Row of each entry.
    pub rows: &'a [u32],
    /// Value of each entry.
    pub values: &'a [f64],
}

impl<'a> Columns<'a> {
    fn column(&self, c: usize) -> (&'a [u32], &'a [f64]) {
        let entries = self.offsets[c] as usize..self.offsets[c + 1] as usize;
        (&self.rows[entries.clone()], &self.values[entries])
    }
}

struct Panel {
    /// Its first column.
    first: u32,
    /// Its columns.
    width: u32,
    /// Where its rows start in [`Panels::rows`].
    rows: u32,
    /// Its rows below its own columns.
    height: u32,
    /// Where its values start: the strict lower triangle of its own columns, row by row, then
    /// `height` by `width`, row by row.
    values: u32,
}

/// A factor in panels of single or double precision.
pub(super) struct Panels<S> {
    panels: Vec<Panel>,
    /// The rows of each supernode, its own columns first, ascending.
    rows: Vec<u32>,
    values: Vec<S>,
    /// `1 / D`, one for each column.
    inverse_pivots: Vec<S>,
    /// First column of each supernode, and the number of columns.
    supernodes: Vec<u32>,
    /// Where the rows of each supernode start in `rows`.
    row_starts: Vec<u32>,
}

impl<S: Scalar> Panels<S> {
    /// Lays out panels for the pattern of `l`, which is in a postorder of its elimination tree, and
    /// fills them.
    pub(super) fn new(l: Columns<'_>, pivots: &[f64]) -> Self {
        let supernodes = supernodes(l, S::MOST_ZEROS);
        let (mut rows, mut row_starts, mut panels) = (Vec::new(), Vec::new(), Vec::new());
        let mut n_values = 0;
        for supernode in supernodes.windows(2) {
            let (start, end) = (supernode[0], supernode[1]);
            row_starts.push(rows.len() as u32);
            rows.extend(start..end);
            rows.extend_from_slice(l.column(end as usize - 1).0);
            let mut first = start;
            while first < end {
                // Even widths rather than a full panel and a narrow rest.
                let left = (end - first) as usize;
                let width = left.div_ceil(left.div_ceil(S::PANEL_WIDTH)) as u32;
                let rows_start = row_starts[row_starts.len() - 1] + (first - start) + width;
                let height = rows.len() as u32 - rows_start;
                panels.push(Panel { first, width, rows: rows_start, height, values: n_values });
                n_values += width * (width - 1) / 2 + width * height;
                first += width;
            }
        }
        let mut laid_out = Panels {
            panels,
            rows,
            values: vec![S::ZERO; n_values as usize],
            inverse_pivots: vec![S::ZERO; pivots.len()],
            supernodes,
            row_starts,
        };
        laid_out.fill(l, pivots);
        laid_out
    }

    /// Fills the panels with other values in the same pattern.
    pub(super) fn fill(&mut self, l: Columns<'_>, pivots: &[f64]) {
        for (inverse, pivot) in self.inverse_pivots.iter_mut().zip(pivots) {
            *inverse = S::rounded(1.0 / pivot);
        }
        self.values.fill(S::ZERO);
        let mut panels = self.panels.iter();
        for (s, supernode) in self.supernodes.windows(2).enumerate() {
            let rows_end = self.row_starts.get(s + 1).map_or(self.rows.len(), |&r| r as usize);
            let mut first = supernode[0];
            while first < supernode[1] {
                let panel = panels.next().expect("the panels of a supernode cover its columns");
                let below = &self.rows[panel.rows as usize..rows_end];
                for c in 0..panel.width {
                    let (rows, values) = l.column((first + c) as usize);
                    let mut k = 0;
                    for (&row, &value) in rows.iter().zip(values) {
                        let place = if row < first + panel.width {
                            let a = row - first;
                            a * (a - 1) / 2 + c
                        } else {
                            while below[k] != row {
                                k += 1;
                            }
                            panel.width * (panel.width - 1) / 2 + k as u32 * panel.width + c
                        };
                        self.values[(panel.values + place) as usize] = S::rounded(value);
                    }
                }
                first += panel.width;
            }
        }
    }

    /// Solves `L D L^T x = b` in place for the three right-hand sides in the columns of `x`.
    pub(super) fn solve(&self, x: &mut [[S; 4]]) {
        assert_eq!(x.len(), self.inverse_pivots.len(), "one row for each column of the factor");
        for panel in &self.panels {
            match panel.width {
                1 => self.forward::<1>(panel, x),
                2 => self.forward::<2>(panel, x),
                3 => self.forward::<3>(panel, x),
                4 => self.forward::<4>(panel, x),
                5 if const { S::PANEL_WIDTH >= 5 } => self.forward::<5>(panel, x),
                6 if const { S::PANEL_WIDTH >= 6 } => self.forward::<6>(panel, x),
                width => unreachable!("no panel has {width} columns"),
            }
        }
        for panel in self.panels.iter().rev() {
            match panel.width {
                1 => self.backward::<1>(panel, x),
                2 => self.backward::<2>(panel, x),
                3 => self.backward::<3>(panel, x),
                4 => self.backward::<4>(panel, x),
                5 if const { S::PANEL_WIDTH >= 5 } => self.backward::<5>(panel, x),
                6 if const { S::PANEL_WIDTH >= 6 } => self.backward::<6>(panel, x),
                width => unreachable!("no panel has {width} columns"),
            }
        }
    }

    /// The rows below a panel, its triangle and its block of values.
    #[inline(always)]
    fn parts<const W: usize>(&self, panel: &Panel) -> (&[u32], &[S], &[[S; W]]) {
        let rows = &self.rows[panel.rows as usize..][..panel.height as usize];
        let size = W * (W - 1) / 2 + W * rows.len();
        let values = &self.values[panel.values as usize..][..size];
        let (triangle, block) = values.split_at(W * (W - 1) / 2);
        (rows, triangle, block.as_chunks().0)
    }

    /// `L x = b` for the columns of one panel.
    // Functions of their own: V8 replaces wasm functions by optimised code only between calls.
    #[inline(never)]
    fn forward<const W: usize>(&self, panel: &Panel, x: &mut [[S; 4]]) {
        let (rows, triangle, block) = self.parts::<W>(panel);
        let own: &mut [[S; 4]; W] = (&mut x[panel.first as usize..][..W])
            .try_into()
            .expect("a slice of W rows is an array of W rows");
        let mut t = 0;
        for a in 1..W {
            for b in 0..a {
                own[a] = minus(own[a], triangle[t], own[b]);
                t += 1;
            }
        }
        let own = *own;
        for (&row, values) in rows.iter().zip(block) {
            let mut sum = x[row as usize];
            for c in 0..W {
                sum = minus(sum, values[c], own[c]);
            }
            x[row as usize] = sum;
        }
    }

    /// `D L^T x = b` for the columns of one panel.
    #[inline(never)]
    fn backward<const W: usize>(&self, panel: &Panel, x: &mut [[S; 4]]) {
        let (rows, triangle, block) = self.parts::<W>(panel);
        let first = panel.first as usize;
        let mut own: [[S; 4]; W] = std::array::from_fn(|c| {
            x[first + c].map(|value| value * self.inverse_pivots[first + c])
        });
        for (&row, values) in rows.iter().zip(block) {
            let below = x[row as usize];
            for c in 0..W {
                own[c] = minus(own[c], values[c], below);
            }
        }
        for a in (1..W).rev() {
            for b in 0..a {
                own[b] = minus(own[b], triangle[a * (a - 1) / 2 + b], own[a]);
            }
        }
        x[first..first + W].copy_from_slice(&own);
    }
}

#[inline(always)]
fn minus<S: Scalar>(x: [S; 4], factor: S, y: [S; 4]) -> [S; 4] {
    std::array::from_fn(|i| x[i] - factor * y[i])
}

/// Merges consecutive columns, each the parent of the one before in the elimination tree, as long
/// as that stores few zeros: fewer, wider panels are faster than the zeros cost. Gives the first
/// column of each supernode, and the number of columns at the end.
fn supernodes(l: Columns<'_>, most_zeros: [f64; 4]) -> Vec<u32> {
    let n = l.offsets.len() - 1;
    let mut starts = Vec::new();
    // Entries of the supernode so far.
    let mut entries = 0;
    for c in 0..n {
        let height = l.column(c).0.len();
        if let Some(&start) = starts.last()
            && l.column(c - 1).0.first() == Some(&(c as u32))
        {
            let width = c + 1 - start as usize;
            let stored = width * (width - 1) / 2 + width * height;
            let zeros = (stored - entries - height) as f64 / stored.max(1) as f64;
            let most = match width {
                0..=4 => most_zeros[0],
                5..=16 => most_zeros[1],
                17..=48 => most_zeros[2],
                _ => most_zeros[3],
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
