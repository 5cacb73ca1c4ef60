//! The numeric factor `L D L^T` of the crate `sprs-ldl`: one column after another, up-looking (Davis,
//! *Algorithm 849: a concise sparse Cholesky factorization package*, 2005).

use super::matrix::{Singular, UpperTriangle, is_positive};
use sprs::{PermOwnedI, SymmetryCheck};
use sprs_ldl::{LdlNumeric, LdlSymbolic};

/// The last factor, which is overwritten by that of the next matrix of the same pattern.
#[derive(Default)]
pub(crate) struct Simplicial {
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
        let exact_zero = |_| Singular { column: 0 };
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
