//! `L D L^T` of the normal matrix, swept in panels of the precision that is asked for.
//!
//! The factor is that of [`supernodal`], or of `sprs-ldl`, which is the reference.

use super::assemble::Normal;
use super::metric::Metric;
use super::panels::{Columns, Panels};
use super::rank_one::Change;
use super::supernodal;
use super::symbolic::Symbolic;
use crate::scene::Factorization;
use sprs::{CsMatViewI, PermOwnedI, SymmetryCheck};
use sprs_ldl::{LdlNumeric, LdlSymbolic};
use std::rc::Rc;

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

/// A symmetric positive definite matrix, factored. Most scenes need one of two precisions: what was
/// never asked for is not there.
pub(super) struct Factor {
    symbolic: Rc<Symbolic>,
    method: Method,
    pivots: Vec<f64>,
    single: Option<Metric>,
    double: Option<Panels<f64>>,
}

enum Method {
    Supernodal,
    /// With the last factor, if there is one.
    SprsLdl(Option<Box<LdlNumeric<f64, u32>>>),
}

/// Why a matrix has no factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Singular {
    /// The column whose pivot is not positive.
    pub column: usize,
}

impl Factor {
    /// For matrices with this pattern.
    pub(super) fn new(symbolic: Rc<Symbolic>, factorization: Factorization) -> Factor {
        let method = match factorization {
            Factorization::Supernodal => Method::Supernodal,
            Factorization::SprsLdl => Method::SprsLdl(None),
        };
        Factor { symbolic, method, pivots: Vec::new(), single: None, double: None }
    }

    /// Factors `normal`, whose columns are in the order of elimination, to be solved with
    /// `precision`. Columns that are `fixed` are no unknowns.
    ///
    /// # Errors
    /// When it is not positive definite to working precision. Another matrix must be factored then before
    /// anything is solved.
    pub(super) fn factor(
        &mut self,
        normal: &Normal,
        fixed: &[bool],
        precision: Precision,
    ) -> Result<(), Singular> {
        let Factor { symbolic, single, double, .. } = self;
        match precision {
            Precision::Single => _ = single.get_or_insert_with(|| Metric::new(Rc::clone(symbolic))),
            Precision::Double => _ = double.get_or_insert_with(|| Panels::new(Rc::clone(symbolic))),
        }
        self.pivots.resize(normal.pattern.columns.len() - 1, 0.0);
        match &mut self.method {
            Method::Supernodal => {
                let mut to = Precisions { single: single.as_mut(), double: double.as_mut() };
                to.factor(symbolic, normal, fixed, SMALLEST_PIVOT, &mut self.pivots)
            }
            Method::SprsLdl(numeric) => {
                sprs_ldl(numeric, normal)?;
                let numeric = numeric.as_ref().expect("it was just made");
                check(numeric.d(), normal)?;
                let mut to = Precisions { single: single.as_mut(), double: double.as_mut() };
                to.fill(numeric, fixed);
                Ok(())
            }
        }
    }

    /// The inverse, in double precision, of the matrix that was factored last: `normal`.
    pub(super) fn double(&mut self, normal: &Normal, fixed: &[bool]) -> &Panels<f64> {
        let Factor { symbolic, method, pivots, double, .. } = self;
        double.get_or_insert_with(|| {
            let mut made = Panels::new(Rc::clone(symbolic));
            let mut to = Precisions { single: None, double: Some(&mut made) };
            match method {
                Method::Supernodal => to
                    .factor(symbolic, normal, fixed, f64::NEG_INFINITY, pivots)
                    .expect("what has a factor in one precision has it in the other"),
                Method::SprsLdl(numeric) => to.fill(numeric.as_ref().expect(FACTORED), fixed),
            }
            made
        })
    }

    /// The inverse, in single precision, of the matrix that was factored last: `normal`. Columns
    /// that are `fixed` are no unknowns.
    pub(super) fn single(&mut self, normal: &Normal, fixed: &[bool]) -> &Metric {
        let Factor { symbolic, method, pivots, single, .. } = self;
        single.get_or_insert_with(|| {
            let mut made = Metric::new(Rc::clone(symbolic));
            let mut to = Precisions { single: Some(&mut made), double: None };
            match method {
                Method::Supernodal => to
                    .factor(symbolic, normal, fixed, f64::NEG_INFINITY, pivots)
                    .expect("what has a factor in one precision has it in the other"),
                Method::SprsLdl(numeric) => to.fill(numeric.as_ref().expect(FACTORED), fixed),
            }
            made
        })
    }

    /// Whether it can be solved with this precision at once.
    pub(super) fn has(&self, precision: Precision) -> bool {
        match precision {
            Precision::Single => self.single.is_some(),
            Precision::Double => self.double.is_some(),
        }
    }

    /// Gives the memory of the other precision back.
    pub(super) fn keep_only(&mut self, precision: Precision) {
        match precision {
            Precision::Single => self.double = None,
            Precision::Double => self.single = None,
        }
    }

    /// Whether [`Factor::change`] works.
    pub(super) fn changes(&self) -> bool {
        matches!(self.method, Method::Supernodal)
    }

    /// Changes the factor to that of a matrix in which the node `column` is held.
    pub(super) fn change(&mut self, column: u32, change: Change) {
        if let Some(single) = &mut self.single {
            single.change(column, change);
        }
        if let Some(double) = &mut self.double {
            double.change(column, change);
        }
    }

    /// Nonzeros of `L` with its diagonal.
    pub(super) fn nonzeros(&self) -> usize {
        self.symbolic.nonzeros()
    }
}

const FACTORED: &str = "a system is factored before it is solved";

/// The panels that are to be filled.
struct Precisions<'a> {
    single: Option<&'a mut Metric>,
    double: Option<&'a mut Panels<f64>>,
}

impl Precisions<'_> {
    /// With the supernodal factor.
    fn factor(
        &mut self,
        symbolic: &Symbolic,
        normal: &Normal,
        fixed: &[bool],
        smallest: f64,
        pivots: &mut [f64],
    ) -> Result<(), Singular> {
        supernodal::factor(symbolic, normal, fixed, smallest, pivots, &mut |s, front| {
            if let Some(single) = &mut self.single {
                single.panels().store(s, front);
            }
            if let Some(double) = &mut self.double {
                double.store(s, front);
            }
        })?;
        self.set_pivots(pivots, fixed);
        Ok(())
    }

    /// With the factor of `sprs-ldl`.
    fn fill(&mut self, numeric: &LdlNumeric<f64, u32>, fixed: &[bool]) {
        let l = numeric.l();
        let offsets = l.indptr();
        let l = Columns { offsets: offsets.raw_storage(), rows: l.indices(), values: l.data() };
        if let Some(single) = &mut self.single {
            single.panels().fill(l);
        }
        if let Some(double) = &mut self.double {
            double.fill(l);
        }
        self.set_pivots(numeric.d(), fixed);
    }

    fn set_pivots(&mut self, pivots: &[f64], fixed: &[bool]) {
        if let Some(single) = &mut self.single {
            single.set_pivots(pivots, fixed);
        }
        if let Some(double) = &mut self.double {
            double.set_pivots(pivots);
        }
    }
}

/// Factors `normal`, in the pattern of the last factor if there is one.
fn sprs_ldl(
    numeric: &mut Option<Box<LdlNumeric<f64, u32>>>,
    normal: &Normal,
) -> Result<(), Singular> {
    let n = normal.pattern.columns.len() - 1;
    let view =
        CsMatViewI::new_csc((n, n), &normal.pattern.columns, &normal.pattern.rows, &normal.values);
    let exact_zero = |_| Singular { column: 0 };
    match numeric {
        Some(numeric) => numeric.update(view).map_err(exact_zero),
        None => {
            // The columns are in order already. The upper triangle is all that is read, and its
            // symmetry check would compare it with a lower one that is not there.
            let symbolic = LdlSymbolic::new_perm(
                view,
                PermOwnedI::identity(n),
                SymmetryCheck::DontCheckSymmetry,
            );
            *numeric = Some(Box::new(symbolic.factor(view).map_err(exact_zero)?));
            Ok(())
        }
    }
}

fn check(pivots: &[f64], normal: &Normal) -> Result<(), Singular> {
    for (column, &pivot) in pivots.iter().enumerate() {
        let diagonal = normal.values[normal.pattern.column(column).end - 1];
        // Written so that NaN fails.
        if !(pivot > SMALLEST_PIVOT * diagonal && diagonal > 0.0) {
            return Err(Singular { column });
        }
    }
    Ok(())
}
