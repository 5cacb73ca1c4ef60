//! `L D L^T` of a symmetric positive definite matrix, by one of two numeric factorisations, in
//! panels of the requested precisions.
//!
//! # Which precisions are stored
//!
//! Accelerated steps need the factor in single precision, plain steps of small systems in double. A
//! [`Factor`] stores the precisions that were asked for, and all that it stores are of the same
//! matrix:
//!
//! ```text
//! stored            factor(p) of a matrix    single()          double()          keep_only(p)
//! none              p                        -                 -                 -
//! single            single and p             single            both, by again    p or none
//! double            double and p             both, by again    double            p or none
//! both              both                     both              both              p
//! ```
//!
//! `again` factors the same matrix for the missing precision, as when an accelerated step is
//! rejected and the plain one takes its place. The matrix has been accepted before, so its pivots
//! are not checked once more. An update changes all that is stored.
//!
//! One of the two is that of the crate `sprs-ldl`: one column after another, up-looking (Davis,
//! *Algorithm 849: a concise sparse Cholesky factorization package*, 2005).

use super::f32_factor::F32Factor;
use super::matrix::{SMALLEST_PIVOT, Singular, UpperTriangle, is_positive};
use super::panels::Panels;
use super::rank_one::Update;
use super::supernodal;
use super::supernodes::Supernodes;
use sprs::errors::LinalgError;
use sprs::{PermOwnedI, SymmetryCheck};
use sprs_ldl::{LdlNumeric, LdlSymbolic};
use std::rc::Rc;

/// The choice of numeric factorisation. All fill the same panels and agree to rounding error.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Factorization {
    /// `sprs-ldl` for systems of up to [`Factorization::MOST_SIMPLICIAL`] unknowns, supernodal for
    /// larger ones.
    #[default]
    Auto,
    /// Multifrontal, with dense blocks of columns that have the same rows.
    Supernodal,
    /// One column after another, by the crate `sprs-ldl`.
    SprsLdl,
}

impl Factorization {
    /// Greatest number of unknowns for which `sprs-ldl` is the default.
    pub const MOST_SIMPLICIAL: usize = 1000;

    /// Whether a system of `unknowns` is factored by `sprs-ldl`. The choice is made only here.
    fn is_simplicial(self, unknowns: usize) -> bool {
        match self {
            Factorization::Auto => unknowns <= Factorization::MOST_SIMPLICIAL,
            Factorization::Supernodal => false,
            Factorization::SprsLdl => true,
        }
    }
}

/// The precision in which a system is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Precision {
    /// See [`F32Factor`].
    Single,
    /// See [`Panels`].
    Double,
}

/// A factored symmetric positive definite matrix. Most scenes need only one of the two precisions;
/// a precision that was never requested is not stored.
pub(crate) struct Factor {
    supernodes: Rc<Supernodes>,
    /// None if the factor is supernodal.
    simplicial: Option<Simplicial>,
    pivots: Vec<f64>,
    single: Option<F32Factor>,
    double: Option<Panels<f64>>,
}

impl Factor {
    /// Creates an empty factor for matrices with these supernodes.
    pub(crate) fn new(supernodes: Rc<Supernodes>, factorization: Factorization) -> Factor {
        let is_simplicial = factorization.is_simplicial(supernodes.components().len());
        let simplicial = is_simplicial.then(Simplicial::default);
        Factor { supernodes, simplicial, pivots: Vec::new(), single: None, double: None }
    }

    /// Factors `matrix`, whose columns are in the elimination order, for solving with `precision`.
    /// The rows and columns marked `fixed` must be those of the identity.
    ///
    /// # Errors
    /// If the matrix is not positive definite to working precision. Another matrix must then be
    /// factored before solving.
    pub(crate) fn factor(
        &mut self,
        matrix: &UpperTriangle,
        fixed: &[bool],
        precision: Precision,
    ) -> Result<(), Singular> {
        let Factor { supernodes, simplicial, pivots, single, double } = self;
        let own = || Rc::clone(supernodes);
        match precision {
            Precision::Single => _ = single.get_or_insert_with(|| F32Factor::new(own())),
            Precision::Double => _ = double.get_or_insert_with(|| Panels::new(own())),
        }
        let mut to = Precisions { single: single.as_mut(), double: double.as_mut() };
        match simplicial {
            Some(simplicial) => to.fill(simplicial.factor(matrix, SMALLEST_PIVOT)?, fixed),
            None => to.factor(supernodes, matrix, fixed, SMALLEST_PIVOT, pivots)?,
        }
        Ok(())
    }

    /// Returns the double-precision factor of `matrix`, which must be the matrix factored last.
    pub(crate) fn double(&mut self, matrix: &UpperTriangle, fixed: &[bool]) -> &Panels<f64> {
        let Factor { supernodes, simplicial, pivots, double, .. } = self;
        double.get_or_insert_with(|| {
            let mut made = Panels::new(Rc::clone(supernodes));
            let to = Precisions { single: None, double: Some(&mut made) };
            to.again(supernodes, simplicial, matrix, fixed, pivots);
            made
        })
    }

    /// Returns the single-precision factor of `matrix`, which must be the matrix factored last.
    pub(crate) fn single(&mut self, matrix: &UpperTriangle, fixed: &[bool]) -> &F32Factor {
        let Factor { supernodes, simplicial, pivots, single, .. } = self;
        single.get_or_insert_with(|| {
            let mut made = F32Factor::new(Rc::clone(supernodes));
            let to = Precisions { single: Some(&mut made), double: None };
            to.again(supernodes, simplicial, matrix, fixed, pivots);
            made
        })
    }

    /// Whether the factor is stored in this precision.
    pub(crate) fn has(&self, precision: Precision) -> bool {
        match precision {
            Precision::Single => self.single.is_some(),
            Precision::Double => self.double.is_some(),
        }
    }

    /// Frees the memory of the other precision.
    pub(crate) fn keep_only(&mut self, precision: Precision) {
        match precision {
            Precision::Single => self.double = None,
            Precision::Double => self.single = None,
        }
    }

    /// Changes the factor to that of the updated matrix; see [`Panels::update`].
    pub(crate) fn update(&mut self, column: u32, update: Update) {
        if let Some(single) = &mut self.single {
            single.update(column, update);
        }
        if let Some(double) = &mut self.double {
            double.update(column, update);
        }
    }

    /// Number of nonzeros of `L` with its diagonal.
    pub(crate) fn nonzeros(&self) -> usize {
        self.supernodes.nonzeros()
    }
}

/// The panels to be filled.
struct Precisions<'a> {
    single: Option<&'a mut F32Factor>,
    double: Option<&'a mut Panels<f64>>,
}

impl Precisions<'_> {
    /// Fills them from the matrix that was factored last, whatever its pivots.
    fn again(
        mut self,
        supernodes: &Supernodes,
        simplicial: &mut Option<Simplicial>,
        matrix: &UpperTriangle,
        fixed: &[bool],
        pivots: &mut Vec<f64>,
    ) {
        const FACTORED: &str = "what has a factor in one precision has it in the other";
        const ANY: f64 = f64::NEG_INFINITY;
        match simplicial {
            Some(simplicial) => self.fill(simplicial.factor(matrix, ANY).expect(FACTORED), fixed),
            None => self.factor(supernodes, matrix, fixed, ANY, pivots).expect(FACTORED),
        }
    }

    /// Fills them with the supernodal factor.
    fn factor(
        &mut self,
        supernodes: &Supernodes,
        matrix: &UpperTriangle,
        fixed: &[bool],
        smallest: f64,
        pivots: &mut Vec<f64>,
    ) -> Result<(), Singular> {
        pivots.resize(matrix.cols(), 0.0);
        supernodal::factor(supernodes, matrix, fixed, smallest, pivots, &mut |s, front| {
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

    /// Fills them with the factor of `sprs-ldl`.
    fn fill(&mut self, numeric: &LdlNumeric<f64, u32>, fixed: &[bool]) {
        if let Some(single) = &mut self.single {
            single.panels().fill(numeric.l());
        }
        if let Some(double) = &mut self.double {
            double.fill(numeric.l());
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

/// The last factor, which is overwritten by that of the next matrix of the same pattern.
#[derive(Default)]
struct Simplicial {
    numeric: Option<Box<LdlNumeric<f64, u32>>>,
}

impl Simplicial {
    /// Factors a matrix, which must have the pattern of the previous one, if any. A pivot must
    /// exceed `smallest` times its diagonal entry.
    ///
    /// # Errors
    /// If the matrix is not positive definite to working precision.
    pub(crate) fn factor(
        &mut self,
        matrix: &UpperTriangle,
        smallest: f64,
    ) -> Result<&LdlNumeric<f64, u32>, Singular> {
        let exact_zero = |error| match error {
            LinalgError::SingularMatrix(info) => Singular { column: info.index },
            _ => Singular { column: 0 },
        };
        let numeric = match self.numeric.take() {
            Some(mut numeric) => {
                numeric.update(matrix.view()).map_err(exact_zero)?;
                numeric
            }
            None => {
                // The columns are already in order. Only the upper triangle is read; a symmetry
                // check would compare it with a lower one that is not stored.
                let symbolic = LdlSymbolic::new_perm(
                    matrix.view(),
                    PermOwnedI::identity(matrix.cols()),
                    SymmetryCheck::DontCheckSymmetry,
                );
                Box::new(symbolic.factor(matrix.view()).map_err(exact_zero)?)
            }
        };
        let numeric = self.numeric.insert(numeric);
        for (column, &pivot) in numeric.d().iter().enumerate() {
            let diagonal = matrix.data()[matrix.indptr().outer_inds_sz(column).end - 1];
            if !is_positive(pivot, diagonal, smallest) {
                return Err(Singular { column });
            }
        }
        Ok(numeric)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_size_of_the_system_chooses_unless_the_scene_does() {
        let most = Factorization::MOST_SIMPLICIAL;
        let chosen = |factorization: Factorization| {
            [most, most + 1].map(|unknowns| factorization.is_simplicial(unknowns))
        };
        assert_eq!(chosen(Factorization::Auto), [true, false]);
        assert_eq!(chosen(Factorization::SprsLdl), [true; 2]);
        assert_eq!(chosen(Factorization::Supernodal), [false; 2]);
    }
}
