//! Closed-form eigenvectors of a symmetric 3x3 matrix, for the smallest and the greatest
//! eigenvalue.
//!
//! Newton's method on the characteristic cubic `p(l) = l^3 - l^2 + c l - d` (unit trace) runs
//! monotonically to the smallest root from 0 and to the greatest from 1, as all roots are real and
//! lie between. The adjugate of `A - l I` is then `p'(l) e e^T`; its largest column is the
//! eigenvector `e`.
//!
//! Where two eigenvalues are close, Newton's method is slow and the adjugate is small: the result
//! cannot be trusted. It is checked, not hoped for: with the residual `r = |A e - (e.A e) e|`, the
//! angle between `e` and the true eigenvector is at most `r / gap` (Davis and Kahan 1970), and the
//! gap to the next eigenvalue is at least `|p'(l)|`, as that is the product of both gaps and no gap
//! exceeds the trace.

use super::{Lane, Symmetric3, Vec3};

/// Enough for eigenvalues that differ by a factor of four; closer ones fail the check.
const NEWTON_STEPS: usize = 5;

/// The greatest angle, in radians, by which a vector that passes the check can be off.
const ANGLE: f64 = 1e-12;

/// An eigenvector and how far it can be trusted.
#[derive(Clone, Copy, Debug)]
pub struct Eigenvector<S> {
    /// The eigenvector, of unit length, of either sign.
    pub vector: Vec3<S>,
    /// Its eigenvalue.
    pub value: S,
    /// One in the lanes where `vector` is off by at most 1e-12 radians, else zero. There the
    /// vector is not to be used, and may be anything: see [`super::PrincipalAxes`].
    pub accurate: S,
}

impl<S: Lane> Symmetric3<S> {
    /// The eigenvector of the smallest eigenvalue of a positive semidefinite matrix of unit trace.
    #[inline(always)]
    pub fn smallest_eigenvector(self) -> Eigenvector<S> {
        self.extreme_eigenvector(S::zero())
    }

    /// The eigenvector of the greatest eigenvalue of a positive semidefinite matrix of unit trace.
    #[inline(always)]
    pub fn greatest_eigenvector(self) -> Eigenvector<S> {
        self.extreme_eigenvector(S::one())
    }

    /// The eigenvector of the root to which Newton's method runs from `start`.
    #[inline(always)]
    fn extreme_eigenvector(self, start: S) -> Eigenvector<S> {
        let adjugate = self.adjugate();
        let (c, d) = (adjugate.trace(), self.determinant(adjugate));
        let mut l = start;
        for _ in 0..NEWTON_STEPS {
            let p = ((l - S::one()) * l + c) * l - d;
            let slope = (S::splat(3.0) * l - S::splat(2.0)) * l + c;
            l -= p / slope;
        }

        let b = self.shifted(l).adjugate();
        let mut column = Vec3::new(b.xx, b.xy, b.xz);
        let mut largest = b.xx.abs();
        column = Vec3::if_greater(b.yy.abs(), largest, Vec3::new(b.xy, b.yy, b.yz), column);
        largest = largest.max(b.yy.abs());
        column = Vec3::if_greater(b.zz.abs(), largest, Vec3::new(b.xz, b.yz, b.zz), column);
        let vector = column * (S::one() / column.length());

        let image = self.times(vector);
        let value = image.dot(vector);
        let residual = (image - vector * value).length_squared();
        let bound = S::splat(ANGLE) * b.trace();
        let accurate = (bound * bound).if_greater(residual, S::one(), S::zero());
        Eigenvector { vector, value, accurate }
    }
}
