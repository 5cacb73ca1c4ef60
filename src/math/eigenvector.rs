//! Closed-form eigenvectors of a symmetric 3x3 matrix, for the smallest and the greatest
//! eigenvalue.
//!
//! Newton's method on the characteristic cubic `p(l) = l^3 - l^2 + c l - d` (unit trace) converges
//! monotonically to the smallest root from 0 and to the greatest from 1, since all roots are real
//! and lie between. The adjugate of `A - l I` is then `p'(l) e e^T`; its largest column gives the
//! eigenvector `e`.
//!
//! If two eigenvalues are close, Newton's method is slow and the adjugate is small, so every result
//! is checked. With the residual `r = |A e - (e.A e) e|`, the angle between `e` and the true
//! eigenvector is at most `r / gap` (Davis and Kahan 1970). The gap to the next eigenvalue is at
//! least `|p'(l)|`, which is the product of both gaps, since no gap exceeds the trace. The residual
//! is taken to be at least one ulp, so that a gap that is itself rounding error never passes. `p'`
//! is negative only at the middle eigenvalue, so its sign rejects that one.

use crate::math::{Lane, Symmetric3, Vec3};

/// Enough for eigenvalues that differ by a factor of four; closer ones fail the check.
const NEWTON_STEPS: usize = 5;

/// Upper bound of the error, in radians, of a vector that passes the check.
const ANGLE: f64 = 1e-12;

/// An eigenvector, and whether it is accurate.
#[derive(Clone, Copy, Debug)]
pub struct Eigenvector<S> {
    /// The eigenvector, of unit length, of either sign.
    pub vector: Vec3<S>,
    /// Its eigenvalue.
    pub value: S,
    /// One in the lanes where `vector` is off by at most 1e-12 radians, else zero. In lanes with
    /// zero the vector must not be used: see [`crate::math::PrincipalAxes`].
    pub accurate: S,
}

impl<S: Lane> Symmetric3<S> {
    /// The eigenvector of the smallest eigenvalue of a positive semidefinite matrix of unit trace.
    #[inline(always)]
    pub fn smallest_eigenvector(self) -> Eigenvector<S> {
        let (c, d) = self.characteristic();
        self.extreme_eigenvector(c, d, d / c)
    }

    /// The eigenvector of the greatest eigenvalue of a positive semidefinite matrix of unit trace.
    #[inline(always)]
    pub fn greatest_eigenvector(self) -> Eigenvector<S> {
        let (c, d) = self.characteristic();
        self.extreme_eigenvector(c, d, S::one() - (c - d) / (S::one() + c))
    }

    /// The coefficients `c` and `d` of the characteristic cubic.
    #[inline(always)]
    fn characteristic(self) -> (S, S) {
        let adjugate = self.adjugate();
        (adjugate.trace(), self.determinant(adjugate))
    }

    /// Returns the eigenvector of the root to which Newton's method converges from its first
    /// iterate `l`.
    ///
    /// Not inlined: it needs all registers for itself.
    #[inline(never)]
    fn extreme_eigenvector(self, c: S, d: S, mut l: S) -> Eigenvector<S> {
        for _ in 1..NEWTON_STEPS {
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
        let slope = (S::splat(3.0) * value - S::splat(2.0)) * value + c;
        let bound = S::splat(ANGLE) * slope;
        let rounding = S::splat(f64::EPSILON * f64::EPSILON);
        let accurate = (bound * bound).if_greater(residual + rounding, S::one(), S::zero());
        let accurate = slope.if_greater(S::zero(), accurate, S::zero());
        Eigenvector { vector, value, accurate }
    }
}

#[cfg(test)]
mod tests {
    use crate::math::{Scatter, Symmetric3, Vec3};
    use nalgebra::{Matrix3, SymmetricEigen, Vector3};

    /// Park and Miller's generator, between -1 and 1.
    fn uniform(state: &mut u64) -> f64 {
        *state = *state * 48_271 % 0x7fff_ffff;
        *state as f64 / f64::from(0x3fff_ffff) - 1.0
    }

    fn cloud(state: &mut u64, extents: [f64; 3]) -> Vec<Vec3<f64>> {
        let axes = [(); 3].map(|()| [(); 3].map(|()| uniform(state)));
        (0..6)
            .map(|_| {
                let x = extents.map(|e| e * uniform(state));
                Vec3::from([0, 1, 2].map(|k| (0..3).map(|j| axes[j][k] * x[j]).sum::<f64>()))
            })
            .collect()
    }

    /// The sine of the angle between `e` and nalgebra's eigenvector, smallest or greatest.
    fn off(m: Symmetric3<f64>, e: Vec3<f64>, smallest: bool) -> f64 {
        let eigen =
            SymmetricEigen::new(Matrix3::new(m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz));
        let k = if smallest { eigen.eigenvalues.imin() } else { eigen.eigenvalues.imax() };
        Vector3::new(e.x, e.y, e.z).cross(&eigen.eigenvectors.column(k)).norm()
    }

    #[test]
    fn agrees_with_nalgebra_wherever_it_says_so() {
        let mut state = 1;
        let (mut smallest, mut greatest, mut total) = (0, 0, 0);
        for extents in [[1.0, 1.0, 1.0], [1.0, 1.0, 0.1], [1.0, 0.2, 0.01], [1.0, 1e-3, 1e-3]] {
            for _ in 0..5000 {
                let m = Scatter::of(&cloud(&mut state, extents)).unit;
                total += 1;
                let e = m.smallest_eigenvector();
                if e.accurate > 0.0 {
                    smallest += 1;
                    assert!(off(m, e.vector, true) <= 2e-12, "{m:?}");
                }
                let e = m.greatest_eigenvector();
                if e.accurate > 0.0 {
                    greatest += 1;
                    assert!(off(m, e.vector, false) <= 2e-12, "{m:?}");
                }
            }
        }
        assert!(2 * smallest > total && 2 * greatest > total, "{smallest}, {greatest} of {total}");
    }

    #[test]
    fn says_when_there_is_no_answer() {
        let line = [-1.0, 0.25, 0.75].map(|x| Vec3::new(x, 2.0 * x, -x));
        let cross = [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0]];
        assert_eq!(Scatter::of(&line).unit.smallest_eigenvector().accurate, 0.0);
        assert_eq!(Scatter::of(&line).unit.greatest_eigenvector().accurate, 1.0);
        assert_eq!(Scatter::of(&cross.map(Vec3::from)).unit.smallest_eigenvector().accurate, 1.0);
        assert_eq!(Scatter::of(&cross.map(Vec3::from)).unit.greatest_eigenvector().accurate, 0.0);
        for x in [0.0, 1e-200, 1e200, f64::NAN] {
            let scatter = Scatter::of(&line.map(|v| v * x));
            assert_eq!(scatter.in_range, 0.0, "{x}");
        }
    }
}
