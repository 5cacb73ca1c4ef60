//! The circle or sphere that fits centred points best in the sense of Thomas and Chan, "A simple
//! approach for the estimation of circular arc center and its radius", 1989 (paper section 3.1), in
//! homogeneous form.
//!
//! They minimise `sum (|v - c|^2 - r^2)^2`. With centred points, `M = mean v v^T`,
//! `h = mean |v|^2 v / 2` and `s = mean |v|^2`, the centre is `c = M^-1 h` and `r^2 = s + |c|^2`.
//! Near a line (or a plane) the centre goes to infinity. We therefore store `a = adj(M) h` and
//! `d = det M`, or any common multiple of them, instead of `c = a / d`. The point of the circle
//! closest to `v` is
//!
//! ```text
//! v' = v + (d v - a) q / (D (R + D)),   D = |d v - a|,  R = (d^2 s + |a|^2)^1/2 = d r,
//!                                       q = d (s - |v|^2) + 2 v.a = (R^2 - D^2) / d
//! ```
//!
//! No divisor vanishes with `d`. At `d = 0` it is the projection onto the line (or plane) through
//! the mean that is orthogonal to `a`, the limit circle.

use crate::math::{Lane, Vec3};

/// An extent below this fraction of the longest is rounding error: the points are collinear (or
/// coplanar).
const FLAT: f64 = 32.0 * f64::EPSILON;

/// A point nearer to the centre than this fraction of the radius counts as at the centre, since its
/// direction is rounding error.
pub(crate) const AT_CENTRE: f64 = 1e-14;

/// The least `R`, relative to the points (unit trace, lengths over `s^1/2`), at which the closed
/// form is used. Its rounding error is a few ulp divided by this: about 1e-12 of the size of the
/// points, and more only for points near the centre, by the ratio of the radius to their distance
/// from it.
const LEAST_REACH: f64 = 1e-4;

/// A radius that exceeds this times the size of the points (the root mean square of their distances
/// to the mean) counts as that of a line or plane.
pub(super) const STRAIGHT: f64 = 1e6;

/// A fitted circle or sphere around the mean of its points, or the line or plane that is its limit.
#[derive(Clone, Copy, Debug)]
pub struct Round<S> {
    /// The centre times `d`.
    pub a: Vec3<S>,
    /// Not negative; zero if the circle is a line (or the sphere a plane).
    pub d: S,
    /// The radius times `d`.
    pub reach: S,
    /// The mean of `|v|^2`.
    pub(crate) mean_square: S,
}

impl<S: Lane> Round<S> {
    /// From `a = adj(M) h`, `d = det M`, or a common multiple of them, and `s = mean |v|^2`.
    #[inline(always)]
    pub fn new(a: Vec3<S>, d: S, mean_square: S) -> Self {
        let reach = (d * d * mean_square + a.length_squared()).sqrt();
        Round { a, d, reach, mean_square }
    }

    /// Returns `flag` in the lanes where `a` and `d`, computed from a scatter matrix of unit trace,
    /// are accurate; zero in the others (nearly collinear or coplanar points).
    #[inline(always)]
    pub fn accurate(&self, flag: S) -> S {
        let s = self.mean_square;
        let bound = S::splat(LEAST_REACH * LEAST_REACH) * (s * s * s);
        (self.reach * self.reach).if_greater(bound, flag, S::zero())
    }

    /// `R^2 - D^2` divided by `d`.
    #[inline(always)]
    fn q(&self, v: Vec3<S>) -> S {
        let va = v.dot(self.a);
        self.d * (self.mean_square - v.length_squared()) + (va + va)
    }

    /// The displacement from `v` (for a circle, in its plane) to its closest point, which keeps
    /// more digits than the difference of the two. Not finite if `v` is at the centre.
    #[inline(always)]
    pub fn step(&self, v: Vec3<S>) -> Vec3<S> {
        self.step_off_centre(v, &mut S::zero())
    }

    /// As [`Round::step`]; also sets `good` to zero in the lanes where `v` is at the centre.
    #[inline(always)]
    pub fn step_off_centre(&self, v: Vec3<S>, good: &mut S) -> Vec3<S> {
        let from_centre = v * self.d - self.a;
        let squared = from_centre.length_squared();
        let bound = self.reach * S::splat(AT_CENTRE);
        *good = squared.if_greater(bound * bound, *good, S::zero());
        let distance = squared.sqrt();
        from_centre * (self.q(v) / (distance * (self.reach + distance)))
    }
}

impl Round<f64> {
    /// Fits points given in principal coordinates, using the first `dimensions` of them: two for a
    /// circle, three for a sphere.
    ///
    /// `M` is then diagonal, with the squared extents `e_k^2`. Dividing `a` and `d` by the product
    /// of these, but for one factor `e_min`, gives `d = e_min` and
    /// `a_k = (e_min / e_k) mean(|v|^2 v_k / e_k) / 2`, which loses no digits even if `e_min` is
    /// 1e-12 of the longest extent.
    pub fn fit_principal(points: &[Vec3<f64>], dimensions: usize) -> Self {
        let inverse_n = 1.0 / points.len() as f64;
        let coordinates = |v: &Vec3<f64>| [v.x, v.y, if dimensions == 3 { v.z } else { 0.0 }];
        let mut squares = [0.0; 3];
        for v in points {
            let x = coordinates(v);
            for k in 0..3 {
                squares[k] += x[k] * x[k] * inverse_n;
            }
        }
        let mut extents = squares.map(f64::sqrt);
        for k in 1..3 {
            if extents[k] <= FLAT * extents[0] {
                extents[k] = 0.0;
            }
        }
        let least = extents[dimensions - 1];
        let mut a = [0.0; 3];
        for k in 0..dimensions {
            if extents[k] > 0.0 {
                for v in points {
                    let x = coordinates(v);
                    let square = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
                    a[k] += square * (x[k] / extents[k]);
                }
                a[k] *= 0.5 * inverse_n * (least / extents[k]);
            }
        }
        Round::new(Vec3::from(a), least, squares.iter().sum())
    }

    /// The displacement from `v` to its closest point, defined everywhere. Points that are all on a
    /// line (for a sphere, in a plane) stay; a point at the centre goes to where the first axis meets
    /// the circle.
    pub fn step_or_chosen(&self, v: Vec3<f64>) -> Vec3<f64> {
        if self.reach == 0.0 {
            return Vec3::zero();
        }
        let mut off_centre = 1.0;
        let step = self.step_off_centre(v, &mut off_centre);
        if off_centre > 0.0 { step } else { Vec3::new(self.reach / self.d, 0.0, 0.0) }
    }

    /// Returns centre and radius, unless the points count as straight or all coincide.
    pub fn centre_and_radius(&self) -> Option<(Vec3<f64>, f64)> {
        let drawable =
            self.reach > 0.0 && self.reach <= STRAIGHT * self.d * self.mean_square.sqrt();
        drawable.then(|| {
            let c = Vec3::new(self.a.x / self.d, self.a.y / self.d, self.a.z / self.d);
            (c, self.reach / self.d)
        })
    }
}
