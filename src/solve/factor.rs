//! Sparse `L D L^T` of the normal matrix: factored by `sprs-ldl`, solved in [`Panels`].

use super::assemble::Normal;
use super::panels::{Columns, Panels};
use crate::constraint::Row;
use sprs::{CsMatViewI, PermOwnedI, SymmetryCheck};
use sprs_ldl::{LdlNumeric, LdlSymbolic};

/// A pivot this small against its diagonal entry is what rounding leaves of a singular matrix.
/// `sprs-ldl` reports exact zeros only.
const SMALLEST_PIVOT: f64 = 1e-13;

/// A factored symmetric positive definite matrix.
pub(super) struct Factor {
    numeric: LdlNumeric<f64, u32>,
    panels: Panels,
}

/// Why a matrix has no factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Singular {
    /// The column whose pivot is not positive.
    pub column: usize,
}

impl Factor {
    /// Factors `normal`, whose columns are in the order of elimination.
    ///
    /// # Errors
    /// When it is not positive definite to working precision.
    pub(super) fn new(normal: &Normal) -> Result<Factor, Singular> {
        let view = view(normal);
        // The columns are in order already. The upper triangle is all that is read, and its
        // symmetry check would compare it with a lower one that is not there.
        let symbolic = LdlSymbolic::new_perm(
            view,
            PermOwnedI::identity(view.cols()),
            SymmetryCheck::DontCheckSymmetry,
        );
        let numeric = symbolic.factor(view).map_err(|_| Singular { column: 0 })?;
        check(numeric.d(), normal)?;
        let panels = with_columns(&numeric, |l| Panels::new(l, numeric.d()));
        Ok(Factor { numeric, panels })
    }

    /// Factors other values in the same pattern.
    ///
    /// # Errors
    /// When the matrix is not positive definite; the factor is then that of the last good one only
    /// in [`Factor::solve`], and must be updated again before anything else.
    pub(super) fn update(&mut self, normal: &Normal) -> Result<(), Singular> {
        self.numeric.update(view(normal)).map_err(|_| Singular { column: 0 })?;
        check(self.numeric.d(), normal)?;
        let Factor { numeric, panels } = self;
        with_columns(numeric, |l| panels.fill(l, numeric.d()));
        Ok(())
    }

    /// Solves in place for the right-hand sides in the columns of `x`, `#unknowns` rows.
    pub(super) fn solve(&self, x: &mut [Row]) {
        self.panels.solve(x);
    }

    /// Nonzeros of `L` with its diagonal.
    pub(super) fn nonzeros(&self) -> usize {
        self.numeric.nnz() + self.numeric.problem_size()
    }
}

fn view(normal: &Normal) -> CsMatViewI<'_, f64, u32> {
    let n = normal.columns.len() - 1;
    CsMatViewI::new_csc((n, n), &normal.columns, &normal.rows, &normal.values)
}

fn with_columns<T>(numeric: &LdlNumeric<f64, u32>, f: impl FnOnce(Columns<'_>) -> T) -> T {
    let l = numeric.l();
    let offsets = l.indptr();
    f(Columns { offsets: offsets.raw_storage(), rows: l.indices(), values: l.data() })
}

fn check(pivots: &[f64], normal: &Normal) -> Result<(), Singular> {
    for (column, &pivot) in pivots.iter().enumerate() {
        let diagonal = normal.values[normal.columns[column + 1] as usize - 1];
        // Written so that NaN fails.
        if !(pivot > SMALLEST_PIVOT * diagonal && diagonal > 0.0) {
            return Err(Singular { column });
        }
    }
    Ok(())
}
