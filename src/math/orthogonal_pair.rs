//! Two vectors of equal length at right angles, which define a square or a regular polygon.
//!
//! The pair closest to `p` and `q` is the polar factor of the 3x2 matrix `[p q]`, scaled by the
//! mean of its singular values (Umeyama 1991). In space it needs no eigenvectors: with the unit
//! normal `n` of the plane of `p` and `q`, it is the mean of the pair and of the pair obtained by
//! turning each vector by a right angle towards the other,
//!
//! ```text
//! u = (p + q x n) / 2,   w = (q + n x p) / 2,   n = p x q / |p x q|
//! ```

use crate::math::{Lane, PrincipalAxes, Vec3, in_range};

/// The least `|p x q|`, relative to `|p|^2 + |q|^2`, at which the closed form is used. The normal
/// is off by about an ulp divided by this.
const LEAST_SINE: f64 = 1e-4;

/// Two vectors of equal length at right angles.
#[derive(Clone, Copy, Debug)]
pub struct OrthogonalPair<S> {
    /// The one close to `p`.
    pub u: Vec3<S>,
    /// The one close to `q`.
    pub w: Vec3<S>,
}

impl<S: Lane> OrthogonalPair<S> {
    /// Returns the closest pair to `p` and `q`, and one in the lanes where it is accurate, else
    /// zero: there `p` and `q` are nearly parallel, or near the limits of the range of `f64`.
    #[inline(always)]
    pub fn closest(p: Vec3<S>, q: Vec3<S>) -> (Self, S) {
        let area = p.cross(q);
        let square = area.length_squared();
        let n = area * (S::one() / square.sqrt());
        let half = S::splat(0.5);
        let pair = OrthogonalPair { u: (p + q.cross(n)) * half, w: (q + n.cross(p)) * half };

        let size = p.length_squared() + q.length_squared();
        let good = in_range(size, size, S::one());
        let bound = S::splat(LEAST_SINE) * size;
        (pair, square.if_greater(bound * bound, good, S::zero()))
    }
}

impl OrthogonalPair<f64> {
    /// Returns the closest pair, accurate for every finite input. If `p` and `q` are parallel, one
    /// of the planes through their line is chosen, which are equally good; if both are zero, so is
    /// the pair.
    pub fn closest_robust(p: Vec3<f64>, q: Vec3<f64>) -> Self {
        let mut rows = [p, q];
        let axes = PrincipalAxes::rotate(&mut rows);
        // In principal coordinates p and q are the columns of a matrix whose rows are orthogonal,
        // with the singular values as lengths; the third row is zero.
        let [p, q] = rows;
        let greatest = (p.x * p.x + q.x * q.x).sqrt();
        if greatest == 0.0 {
            return OrthogonalPair { u: Vec3::zero(), w: Vec3::zero() };
        }
        let least = (p.y * p.y + q.y * q.y).sqrt();
        let (c, s) = (p.x / greatest, q.x / greatest);
        let sense = if p.x * q.y < q.x * p.y { -1.0 } else { 1.0 };
        let mean = 0.5 * (greatest + least);
        OrthogonalPair {
            u: axes.point(Vec3::new(c * mean, -sense * s * mean, 0.0)),
            w: axes.point(Vec3::new(s * mean, sense * c * mean, 0.0)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::OrthogonalPair;
    use crate::math::Vec3;

    #[test]
    fn both_ways_agree_down_to_small_angles() {
        for sine in [1.0, 0.1, 1e-3] {
            for along in [0.3, -1.0, 0.0] {
                let p = Vec3::new(0.6, 0.8, -0.5);
                let q = p * along + Vec3::new(-0.2, 0.9, 0.4) * sine;
                let (pair, accurate) = OrthogonalPair::closest(p, q);
                assert_eq!(accurate, 1.0);
                let slow = OrthogonalPair::closest_robust(p, q);
                assert!((pair.u - slow.u).length() < 1e-12, "{p:?}, {q:?}");
                assert!((pair.w - slow.w).length() < 1e-12, "{p:?}, {q:?}");
            }
        }
    }

    #[test]
    fn the_careful_way_takes_every_input() {
        let e = Vec3::new(0.3, -1.2, 0.4);
        for (p, q) in [(e, e), (e, Vec3::zero()), (Vec3::zero(), e * 1e-300), (e * 1e290, -e)] {
            let (_, accurate) = OrthogonalPair::closest(p, q);
            assert_eq!(accurate, 0.0, "{p:?}, {q:?}");
            let OrthogonalPair { u, w } = OrthogonalPair::closest_robust(p, q);
            let scale = 1.0 / [u.x, u.y, u.z].iter().fold(0.0f64, |m, x| m.max(x.abs()));
            let (u, w) = (u * scale, w * scale);
            assert!((u.length() - w.length()).abs() <= 1e-15 * u.length(), "{p:?}, {q:?}");
            assert!(u.dot(w).abs() <= 1e-15 * u.length_squared(), "{p:?}, {q:?}");
        }
        let pair = OrthogonalPair::closest_robust(Vec3::zero(), Vec3::zero());
        assert_eq!((pair.u, pair.w), (Vec3::zero(), Vec3::zero()));
    }
}
