//! Rank-1 updates of the factor after one diagonal entry of the matrix has grown.
//!
//! Adding `weight e e^T` changes only the columns of `L` on the path from that column to the root
//! of the elimination tree (Gill, Golub, Murray and Saunders 1974, method C1; Davis and Hager
//! 1999). Adding a weight only makes pivots larger, so the update is stable. Removing one (a
//! downdate) is not; the matrix is then factored again.

use super::elimination_tree::NONE;
use super::matrix::Scalar;
use super::panels::{MOST_COLUMNS, Panels};

/// A change of the row and column of an unknown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Update {
    /// Adds this positive weight to the diagonal entry.
    Weight(f64),
    /// Removes the unknown: its row and column become those of the identity, which is the limit of
    /// an infinite weight.
    Fix,
}

impl<S: Scalar> Panels<S> {
    /// Changes the factor to that of the updated matrix; the caller updates the matrix itself.
    ///
    /// The inverse pivot of a fixed column becomes zero, so that a solve leaves zero there.
    pub(crate) fn update(&mut self, column: u32, update: Update) {
        // `alpha w w^T` remains to be added to the columns not yet visited.
        let mut w = vec![0.0; self.inverse_pivots.len()];
        w[column as usize] = 1.0;
        let mut alpha = match update {
            Update::Weight(weight) => weight,
            Update::Fix => match self.inverse_pivots[column as usize].wide() {
                // Already fixed.
                0.0 => return,
                _ => f64::INFINITY,
            },
        };
        let mut s = self.supernodes.supernode_of(column);
        loop {
            for p in self.starts[s] as usize..self.starts[s + 1] as usize {
                let panel = &self.panels[p];
                if panel.first + panel.width > column {
                    alpha = self.update_panel(p, alpha, &mut w);
                }
            }
            match self.supernodes.parent(s) {
                NONE => break,
                parent => s = parent as usize,
            }
        }
    }

    /// Adds `alpha w w^T` to the columns of a panel, and returns the remaining `alpha`.
    fn update_panel(&mut self, p: usize, mut alpha: f64, w: &mut [f64]) -> f64 {
        let panel = &self.panels[p];
        let (first, width) = (panel.first as usize, panel.width as usize);
        let rows = &self.supernodes.all_rows()[panel.rows as usize..][..panel.height as usize];
        let size = width * (width - 1) / 2 + width * rows.len();
        let values = &mut self.values[panel.values as usize..][..size];
        let (triangle, block) = values.split_at_mut(width * (width - 1) / 2);
        // Per column: its entry of `w`, and the multiple of `w` that is added to it.
        let mut factors = [[0.0; 2]; MOST_COLUMNS];
        for c in 0..width {
            let own = w[first + c];
            if own == 0.0 {
                continue;
            }
            let inverse = self.inverse_pivots[first + c].wide();
            let taken;
            if alpha == f64::INFINITY {
                // The limit of the branch below.
                taken = 1.0 / own;
                alpha = 1.0 / (own * own * inverse);
                self.inverse_pivots[first + c] = S::ZERO;
            } else {
                let grown = 1.0 + alpha * own * own * inverse;
                taken = alpha * own * (inverse / grown);
                alpha /= grown;
                self.inverse_pivots[first + c] = S::rounded(inverse / grown);
            }
            factors[c] = [own, taken];
            for a in c + 1..width {
                let l = &mut triangle[a * (a - 1) / 2 + c];
                let left = w[first + a] - own * l.wide();
                w[first + a] = left;
                *l = S::rounded(l.wide() + taken * left);
            }
        }
        for (&row, values) in rows.iter().zip(block.chunks_exact_mut(width)) {
            let mut left = w[row as usize];
            for (l, [own, taken]) in values.iter_mut().zip(&factors) {
                left -= own * l.wide();
                *l = S::rounded(l.wide() + taken * left);
            }
            w[row as usize] = left;
        }
        alpha
    }
}
