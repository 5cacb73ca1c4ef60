//! The factor `L D L^T` in dense panels, and the two triangular sweeps over them.
//!
//! Each supernode is cut into panels of a few columns. A panel stores its values row by row without
//! indices, so that one load of a row of `x` serves all its columns, and x, y and z are solved
//! together. Rows of `x` are padded to four values: one 128-bit register in single precision, two
//! in double.

use super::matrix::Scalar;
use super::supernodal::Front;
use super::supernodes::Supernodes;
use sprs::CsMatViewI;
use std::rc::Rc;

/// Greatest number of columns of a panel in either precision.
pub(crate) const MOST_COLUMNS: usize = 6;

pub(crate) struct Panel {
    /// Its first column.
    pub first: u32,
    /// Number of its columns.
    pub width: u32,
    /// Start of its rows in [`Supernodes::all_rows`].
    pub rows: u32,
    /// Number of its rows below its own columns.
    pub height: u32,
    /// Start of its values: the strict lower triangle of its own columns, row by row, then `height`
    /// by `width`, row by row.
    pub values: u32,
}

impl Panel {
    /// Number of its values.
    fn size(&self) -> usize {
        let width = self.width as usize;
        width * (width - 1) / 2 + width * self.height as usize
    }
}

/// A factor in panels of single or double precision.
pub(crate) struct Panels<S> {
    pub(crate) supernodes: Rc<Supernodes>,
    pub(crate) panels: Vec<Panel>,
    /// Start of the panels of each supernode, and the end of the last ones.
    pub(crate) starts: Vec<u32>,
    pub(crate) values: Vec<S>,
    /// `1 / D`, one for each column.
    pub(crate) inverse_pivots: Vec<S>,
}

impl<S: Scalar> Panels<S> {
    /// Lays out panels for the supernodes of a factor; their values are yet to be stored or filled.
    pub(crate) fn new(supernodes: Rc<Supernodes>) -> Self {
        let (mut panels, mut starts) = (Vec::new(), vec![0]);
        let (mut n_values, mut n_columns) = (0, 0);
        for s in 0..supernodes.count() {
            let (columns, height) = (supernodes.columns(s), supernodes.rows(s).len());
            n_columns = columns.end;
            let mut first = columns.start;
            while first < columns.end {
                // Even widths rather than full panels and a narrow rest.
                let left = columns.end - first;
                let width = left.div_ceil(left.div_ceil(S::PANEL_WIDTH));
                let above = first - columns.start + width;
                let below = height - above;
                panels.push(Panel {
                    first: first as u32,
                    width: width as u32,
                    rows: supernodes.row_start(s) + above as u32,
                    height: below as u32,
                    values: n_values as u32,
                });
                n_values += width * (width - 1) / 2 + width * below;
                first += width;
            }
            starts.push(panels.len() as u32);
        }
        Panels {
            supernodes,
            panels,
            starts,
            values: vec![S::ZERO; n_values],
            inverse_pivots: vec![S::ZERO; n_columns],
        }
    }

    /// Stores supernode `s`, whose columns are factored. Without a front they are those of the
    /// identity.
    pub(crate) fn store(&mut self, s: usize, front: Option<&Front<'_>>) {
        let Some(front) = front else {
            let panels = &self.panels[self.starts[s] as usize..self.starts[s + 1] as usize];
            let start = panels[0].values as usize;
            let size = panels.iter().map(Panel::size).sum::<usize>();
            self.values[start..start + size].fill(S::ZERO);
            return;
        };
        let start = self.supernodes.columns(s).start;
        for panel in &self.panels[self.starts[s] as usize..self.starts[s + 1] as usize] {
            let (first, width) = (panel.first as usize - start, panel.width as usize);
            let values = &mut self.values[panel.values as usize..];
            let (triangle, block) = values.split_at_mut(width * (width - 1) / 2);
            for c in 0..width {
                let mut column = front.column(first + c, first + c + 1);
                for (a, value) in (c + 1..width).zip(&mut column) {
                    triangle[a * (a - 1) / 2 + c] = S::rounded(value);
                }
                let to = block.iter_mut().skip(c).step_by(width);
                to.zip(column).for_each(|(to, value)| *to = S::rounded(value));
            }
        }
    }

    /// Replaces `D`.
    pub(crate) fn set_pivots(&mut self, pivots: &[f64]) {
        for (inverse, pivot) in self.inverse_pivots.iter_mut().zip(pivots) {
            *inverse = S::rounded(1.0 / pivot);
        }
    }

    /// Stores all of `L`, given as its strict lower triangle in compressed columns, rows ascending.
    pub(crate) fn fill(&mut self, l: CsMatViewI<'_, f64, u32>) {
        self.values.fill(S::ZERO);
        let rows = self.supernodes.all_rows();
        for panel in &self.panels {
            let below = &rows[panel.rows as usize..][..panel.height as usize];
            let (first, width) = (panel.first, panel.width);
            for c in 0..width {
                let entries = l.indptr().outer_inds_sz((first + c) as usize);
                let (rows, values) = (&l.indices()[entries.clone()], &l.data()[entries]);
                let mut k = 0;
                for (&row, &value) in rows.iter().zip(values) {
                    let place = if row < first + width {
                        let a = row - first;
                        a * (a - 1) / 2 + c
                    } else {
                        while below[k] != row {
                            k += 1;
                        }
                        width * (width - 1) / 2 + k as u32 * width + c
                    };
                    self.values[(panel.values + place) as usize] = S::rounded(value);
                }
            }
        }
    }

    /// Solves `L D L^T x = b` in place for the right-hand sides in the columns of `x`.
    pub(crate) fn solve<const R: usize>(&self, x: &mut [[S; R]]) {
        assert_eq!(x.len(), self.inverse_pivots.len(), "one row for each column of the factor");
        for panel in &self.panels {
            match panel.width {
                1 => self.forward::<1, R>(panel, x),
                2 => self.forward::<2, R>(panel, x),
                3 => self.forward::<3, R>(panel, x),
                4 => self.forward::<4, R>(panel, x),
                5 if const { S::PANEL_WIDTH >= 5 } => self.forward::<5, R>(panel, x),
                6 if const { S::PANEL_WIDTH >= 6 } => self.forward::<6, R>(panel, x),
                width => unreachable!("no panel has {width} columns"),
            }
        }
        for panel in self.panels.iter().rev() {
            match panel.width {
                1 => self.backward::<1, R>(panel, x),
                2 => self.backward::<2, R>(panel, x),
                3 => self.backward::<3, R>(panel, x),
                4 => self.backward::<4, R>(panel, x),
                5 if const { S::PANEL_WIDTH >= 5 } => self.backward::<5, R>(panel, x),
                6 if const { S::PANEL_WIDTH >= 6 } => self.backward::<6, R>(panel, x),
                width => unreachable!("no panel has {width} columns"),
            }
        }
    }

    /// Returns the rows below a panel, its triangle and its block of values.
    #[inline(always)]
    fn parts<const W: usize>(&self, panel: &Panel) -> (&[u32], &[S], &[[S; W]]) {
        let rows = &self.supernodes.all_rows()[panel.rows as usize..][..panel.height as usize];
        let size = W * (W - 1) / 2 + W * rows.len();
        let values = &self.values[panel.values as usize..][..size];
        let (triangle, block) = values.split_at(W * (W - 1) / 2);
        (rows, triangle, block.as_chunks().0)
    }

    /// Solves `L x = b` for the columns of one panel.
    // Not inlined: V8 replaces wasm functions by optimised code only between calls.
    #[inline(never)]
    fn forward<const W: usize, const R: usize>(&self, panel: &Panel, x: &mut [[S; R]]) {
        let (rows, triangle, block) = self.parts::<W>(panel);
        let own: &mut [[S; R]; W] = (&mut x[panel.first as usize..][..W])
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

    /// Solves `D L^T x = b` for the columns of one panel.
    #[inline(never)]
    fn backward<const W: usize, const R: usize>(&self, panel: &Panel, x: &mut [[S; R]]) {
        let (rows, triangle, block) = self.parts::<W>(panel);
        let first = panel.first as usize;
        let mut own: [[S; R]; W] = std::array::from_fn(|c| {
            x[first + c].map(|value| value * self.inverse_pivots[first + c])
        });
        let height = rows.len();
        for k in 0..height {
            let k = if S::FROM_LAST_ROW { height - 1 - k } else { k };
            let (below, values) = (x[rows[k] as usize], &block[k]);
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

// A loop, because `array::from_fn` may not be inlined.
#[inline(always)]
fn minus<S: Scalar, const R: usize>(mut x: [S; R], factor: S, y: [S; R]) -> [S; R] {
    for i in 0..R {
        x[i] = x[i] - factor * y[i];
    }
    x
}
