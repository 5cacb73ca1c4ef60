//! Numeric factorisation `L D L^T`, multifrontal over supernodes (Duff and Reid 1983; Liu 1992).
//!
//! Each supernode has a front: a dense lower triangle over its rows, in which its columns of the
//! matrix and the update matrices of its children are summed. Its own columns are eliminated by the
//! kernels of [`dense`]; the Schur complement of the other rows waits on a stack for the parent.
//! Supernodes are in a postorder, so that children are on top of the stack.

use super::dense::{self, Quad};
use super::matrix::{Singular, UpperTriangle, is_positive};
use super::supernodes::Supernodes;

/// A supernode whose columns are factored, in panels of four columns (see [`dense`]).
pub(crate) struct Front<'a> {
    pub panels: &'a [Quad],
    /// Its rows, own columns included.
    pub height: usize,
}

impl Front<'_> {
    /// Returns the values of column `c`, by ascending rows from row `from` on.
    #[inline]
    pub(crate) fn column(&self, c: usize, from: usize) -> impl Iterator<Item = f64> {
        let panel = c / 4;
        let first = dense::start(panel, self.height) + from - 4 * panel;
        self.panels[first..][..self.height - from].iter().map(move |row| row[c % 4])
    }
}

/// Factors `matrix`: fills `pivots` and passes each factored supernode to `store`, in order. A
/// pivot must exceed `smallest` times its diagonal entry.
///
/// The rows and columns of `fixed` nodes must be those of the identity; their columns of `L` then
/// are too. If a supernode and its descendants have only fixed nodes, it has no front, and `store`
/// receives `None`.
///
/// # Errors
/// The first column whose pivot is too small.
pub(crate) fn factor(
    supernodes: &Supernodes,
    matrix: &UpperTriangle,
    fixed: &[bool],
    smallest: f64,
    pivots: &mut [f64],
    store: &mut dyn FnMut(usize, Option<&Front<'_>>),
) -> Result<(), Singular> {
    let mut workspace = Workspace::new(supernodes, pivots.len());
    for s in 0..supernodes.count() {
        let (columns, height) = (supernodes.columns(s), supernodes.rows(s).len());
        let width = columns.len();
        if !workspace.has_child(supernodes, s) && fixed[columns.clone()].iter().all(|fixed| *fixed)
        {
            pivots[columns].fill(1.0);
            store(s, None);
            continue;
        }
        workspace.assemble(supernodes, matrix, s);
        workspace.add_children(supernodes, s);
        let first = columns.start;
        let own = &mut pivots[columns];
        dense::factor(&mut workspace.own, width, height, own, |c, pivot| {
            let diagonal = matrix.data()[matrix.indptr().outer_inds_sz(first + c).end - 1];
            is_positive(pivot, diagonal, smallest)
        })
        .map_err(|c| Singular { column: first + c })?;
        // If all its columns are fixed, they are those of the identity and leave nothing to
        // subtract.
        if dense::has_below(&workspace.own, width, height) {
            dense::subtract_outer(&mut workspace.rest, &workspace.own, width, height, own);
        }
        store(s, Some(&Front { panels: &workspace.own, height }));
        if height > width {
            workspace.waiting.push((s, workspace.stack.len()));
            workspace.stack.extend_from_slice(&workspace.rest);
        }
    }
    Ok(())
}

/// The current front, and the update matrices that wait for later ones.
struct Workspace {
    /// Its own columns.
    own: Vec<Quad>,
    /// Its other columns.
    rest: Vec<Quad>,
    /// The position of each row in the front.
    place: Vec<u32>,
    /// The update matrices (Schur complements) of supernodes whose parents are yet to come, in
    /// order.
    stack: Vec<Quad>,
    /// These supernodes, and the start of the update matrix of each.
    waiting: Vec<(usize, usize)>,
    /// The positions in the front of the rows of one of them.
    places: Vec<u32>,
}

impl Workspace {
    /// Allocates room for the largest front and the deepest stack: vectors that grow while they are
    /// filled take up to three times as much.
    fn new(supernodes: &Supernodes, n_columns: usize) -> Workspace {
        let (mut own, mut rest, mut stack, mut deepest) = (0, 0, 0, 0);
        let mut waiting: Vec<(usize, usize)> = Vec::new();
        for s in 0..supernodes.count() {
            let (width, height) = (supernodes.columns(s).len(), supernodes.rows(s).len());
            while let Some((_, start)) =
                waiting.pop_if(|(child, _)| supernodes.parent(*child) == s as u32)
            {
                stack = start;
            }
            let left = dense::size(height - width, height - width);
            if height > width {
                waiting.push((s, stack));
                stack += left;
            }
            own = dense::size(width, height).max(own);
            (rest, deepest) = (left.max(rest), stack.max(deepest));
        }
        Workspace {
            own: Vec::with_capacity(own),
            rest: Vec::with_capacity(rest),
            place: vec![0; n_columns],
            stack: Vec::with_capacity(deepest),
            waiting: Vec::new(),
            places: Vec::new(),
        }
    }

    /// Starts the front of supernode `s` with its columns of the matrix.
    fn assemble(&mut self, supernodes: &Supernodes, matrix: &UpperTriangle, s: usize) {
        let (columns, rows) = (supernodes.columns(s), supernodes.rows(s));
        let (width, height, values) = (columns.len(), rows.len(), matrix.data());
        clear(&mut self.own, dense::size(width, height));
        clear(&mut self.rest, dense::size(height - width, height - width));
        for (k, &row) in rows.iter().enumerate() {
            self.place[row as usize] = k as u32;
        }
        for (c, column) in columns.enumerate() {
            let first = dense::start(c / 4, height);
            for (row, from) in supernodes.lower(column) {
                let row = self.place[row as usize] as usize - 4 * (c / 4);
                self.own[first + row][c % 4] = values[from as usize];
            }
        }
    }

    /// Whether a child of supernode `s` has left an update matrix.
    fn has_child(&self, supernodes: &Supernodes, s: usize) -> bool {
        self.waiting.last().is_some_and(|&(child, _)| supernodes.parent(child) == s as u32)
    }

    /// Adds the update matrices of the children of supernode `s`, and removes them from the stack.
    fn add_children(&mut self, supernodes: &Supernodes, s: usize) {
        let width = supernodes.columns(s).len();
        let height = supernodes.rows(s).len();
        while let Some(&(child, start)) = self.waiting.last()
            && supernodes.parent(child) == s as u32
        {
            self.places.clear();
            let rows = supernodes.rows_below(child).iter();
            self.places.extend(rows.map(|&row| self.place[row as usize]));
            let below = self.places.len();
            for panel in 0..below.div_ceil(4) {
                let left = &self.stack[start + dense::start(panel, below)..][..below - 4 * panel];
                let places = &self.places[4 * panel..];
                for lane in 0..places.len().min(4) {
                    let place = places[lane] as usize;
                    let (target, column, skipped, height) = if place < width {
                        (&mut self.own, place, 0, height)
                    } else {
                        (&mut self.rest, place - width, width, height - width)
                    };
                    let first = dense::start(column / 4, height);
                    let target = &mut target[first..];
                    let skipped = (skipped + 4 * (column / 4)) as u32;
                    add_column(target, column % 4, &left[lane..], lane, &places[lane..], skipped);
                }
            }
            self.stack.truncate(start);
            self.waiting.pop();
        }
    }
}

/// Adds lane `from` of the rows of `left` to lane `to` of the rows `places` of `target`, counted
/// from `skipped` on.
#[inline(never)]
fn add_column(
    target: &mut [Quad],
    to: usize,
    left: &[Quad],
    from: usize,
    places: &[u32],
    skipped: u32,
) {
    let (target, left) = (target.as_flattened_mut(), left.as_flattened());
    for (value, &place) in left[from..].iter().step_by(4).zip(places) {
        target[4 * (place - skipped) as usize + to] += value;
    }
}

#[inline]
fn clear(quads: &mut Vec<Quad>, size: usize) {
    quads.clear();
    quads.resize(size, [0.0; 4]);
}
