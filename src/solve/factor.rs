//! Sparse `L D L^T` of the normal matrix: factored by `sprs-ldl`, solved in [`Panels`].

use super::assemble::Normal;
use super::metric::Metric;
use super::panels::{Columns, Panels};
use sprs::{CsMatViewI, PermOwnedI, SymmetryCheck};
use sprs_ldl::{LdlNumeric, LdlSymbolic};

/// A pivot this small against its diagonal entry is what rounding leaves of a singular matrix.
/// `sprs-ldl` reports exact zeros only.
const SMALLEST_PIVOT: f64 = 1e-13;

/// With what precision a system is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Precision {
    /// See [`Metric`].
    Single,
    /// See [`Panels`].
    Double,
}

/// A factored symmetric positive definite matrix.
pub(super) struct Factor {
    numeric: LdlNumeric<f64, u32>,
    single: Lazy<Metric>,
    double: Lazy<Panels<f64>>,
}

/// What is made when it is first asked for, and refilled when it is asked for after a change: most
/// scenes need one of two precisions.
struct Lazy<T> {
    made: Option<T>,
    stale: bool,
}

impl<T> Lazy<T> {
    const EMPTY: Self = Lazy { made: None, stale: false };

    fn get(&mut self, make: impl FnOnce() -> T, refill: impl FnOnce(&mut T)) -> &T {
        if std::mem::take(&mut self.stale)
            && let Some(made) = &mut self.made
        {
            refill(made);
        }
        self.made.get_or_insert_with(make)
    }
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
        Ok(Factor { numeric, single: Lazy::EMPTY, double: Lazy::EMPTY })
    }

    /// Factors other values in the same pattern.
    ///
    /// # Errors
    /// When the matrix is not positive definite; the factor is then that of the last good one only
    /// in panels that were filled, and must be updated again before anything else.
    pub(super) fn update(&mut self, normal: &Normal) -> Result<(), Singular> {
        self.numeric.update(view(normal)).map_err(|_| Singular { column: 0 })?;
        check(self.numeric.d(), normal)?;
        self.single.stale = true;
        self.double.stale = true;
        Ok(())
    }

    /// The inverse, in double precision.
    pub(super) fn double(&mut self) -> &Panels<f64> {
        let Factor { numeric, double, .. } = self;
        with_columns(numeric, |l| {
            let pivots = numeric.d();
            double.get(|| Panels::new(l, pivots), |panels| panels.fill(l, pivots))
        })
    }

    /// The inverse, in single precision. Columns that are `fixed` are no unknowns.
    pub(super) fn single(&mut self, fixed: &[u32]) -> &Metric {
        let Factor { numeric, single, .. } = self;
        with_columns(numeric, |l| {
            let pivots = numeric.d();
            single.get(|| Metric::new(l, pivots, fixed), |metric| metric.fill(l, pivots, fixed))
        })
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
