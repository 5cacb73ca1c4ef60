//! The circle or sphere with a radius within limits.
//!
//! If the radius of Thomas and Chan is within the limits, it is kept. Else the radius is the
//! nearest limit `r`, and the centre `c` minimises `sum (|v - c| - r)^2`. The centre starts at the
//! mean of `v - r u`, where the unit vectors `u` point away from the fitted centre, and takes a
//! fixed number of Newton steps with
//!
//! ```text
//! gradient  mean ((r - |v - c|) u),    Hessian  mean (u u^T + k (I - u u^T)),   k = 1 - r / |v - c|
//! ```
//!
//! Points inside the circle have a negative `k`, which is replaced by zero so that no step goes
//! uphill.

use super::nearest_centre::nearest_centre;
use super::round::{AT_CENTRE, STRAIGHT};
use crate::math::{Lane, PrincipalAxes, Round, Symmetric3, Vec3};

/// With noise of a tenth of the radius, five steps come within 1e-4 of the least distance, and
/// three within 1 %.
const STEPS: usize = 5;

/// Added to the Hessian, whose entries are of order one, so that it is invertible if all points are
/// in one direction.
const REGULARISATION: f64 = 1e-12;

/// The least determinant of the Hessian at which the closed form is used.
const LEAST_DETERMINANT: f64 = 1e-9;

/// Within these factors of the fitted radius, Newton's method finds the closest centre from there.
/// Points all around a circle much smaller than the limit are closest to one of several centres.
const NEAR: [f64; 2] = [0.5, 1.25];

/// A last step of more than this fraction of the radius has not converged.
const LAST_STEP: f64 = 1e-7;

/// A circle or sphere around the mean of its points whose radius is within limits.
#[derive(Clone, Copy, Debug)]
pub struct RoundWithin<S> {
    /// The fit without limits.
    round: Round<S>,
    /// One where the limits changed the radius, else zero.
    limited: S,
    /// The centre, where they did.
    centre: Vec3<S>,
    /// The radius, where they did.
    radius: S,
}

impl<S: Lane> RoundWithin<S> {
    /// Refines the fit `round` of mean-centred `points`. `normal` is the unit normal of the plane
    /// of the circle, or zero for a sphere; `clamp` returns the nearest radius within the limits.
    /// Sets `good` to zero in the lanes where the centre is not accurate; there a point at the
    /// centre counts as if it lay in the direction `chosen`.
    #[inline(always)]
    pub fn of(
        points: &[Vec3<S>],
        round: Round<S>,
        normal: Vec3<S>,
        clamp: impl Fn(S) -> S,
        chosen: Vec3<S>,
        good: &mut S,
    ) -> Self {
        let (zero, one) = (S::zero(), S::one());
        let free = round.d.if_greater(zero, round.reach / round.d, S::splat(f64::INFINITY));
        let radius = clamp(free);
        let limited = free.if_greater(radius, one, radius.if_greater(free, one, zero));
        let mut within = RoundWithin { round, limited, centre: Vec3::zero(), radius };
        if one.all_greater(limited) {
            return within;
        }

        let inverse_n = S::splat(1.0 / points.len() as f64);
        let mut accurate = *good;
        accurate = radius.if_greater(free * S::splat(NEAR[1]), zero, accurate);
        accurate = (free * S::splat(NEAR[0])).if_greater(radius, zero, accurate);
        let mut sum = Vec3::zero();
        for p in points {
            let from_centre = *p * round.d - round.a;
            let (_, u) = direction(from_centre, round.reach, chosen, &mut accurate);
            sum += u;
        }
        let mut centre = -sum * (radius * inverse_n);
        let mut step = Vec3::zero();
        for _ in 0..STEPS {
            let (mut sum, mut hessian) = (Vec3::zero(), [zero; 7]);
            for p in points {
                let (distance, u) = direction(*p - centre, radius, chosen, &mut accurate);
                // At most one also at the centre, where the quotient is infinite.
                let rest = (radius / distance).min(one);
                sum += u;
                let w = u * rest;
                let terms = [w.x * u.x, w.x * u.y, w.x * u.z, w.y * u.y, w.y * u.z, w.z * u.z];
                hessian.iter_mut().zip(terms.into_iter().chain([rest])).for_each(|(h, t)| *h += t);
            }
            let gradient = centre + sum * (radius * inverse_n);
            let [xx, xy, xz, yy, yz, zz, rest] = hessian.map(|h| h * inverse_n);
            // One along the normal of a circle, where the points carry no information.
            let out = normal * rest;
            let level = one - rest + S::splat(REGULARISATION);
            let hessian = Symmetric3 {
                xx: xx + out.x * normal.x + level,
                xy: xy + out.x * normal.y,
                xz: xz + out.x * normal.z,
                yy: yy + out.y * normal.y + level,
                yz: yz + out.y * normal.z,
                zz: zz + out.z * normal.z + level,
            };
            let adjugate = hessian.adjugate();
            let determinant = hessian.determinant(adjugate);
            step = adjugate.times(gradient) * (one / determinant);
            centre -= step;
            accurate = determinant.if_greater(S::splat(LEAST_DETERMINANT), accurate, zero);
        }
        let last = radius * S::splat(LAST_STEP);
        accurate = step.length_squared().if_greater(last * last, zero, accurate);
        *good = limited.if_greater(zero, accurate, *good);
        within.centre = centre;
        within
    }

    /// As [`Round::step_off_centre`].
    #[inline(always)]
    pub fn step_off_centre(&self, v: Vec3<S>, good: &mut S) -> Vec3<S> {
        let mut off_free = *good;
        let free = self.round.step_off_centre(v, &mut off_free);
        let mut off = *good;
        let zero = Vec3::zero();
        let limited = self.limited_step(v, zero, &mut off);
        *good = self.limited.if_greater(S::zero(), off, off_free);
        Vec3::if_greater(self.limited, S::zero(), limited, free)
    }

    /// The step in the lanes where the limits changed the radius.
    ///
    /// `r - |v - c| = (r^2 - |c|^2 + 2 v.c - |v|^2) / (r + |v - c|)`: the rounding error of the
    /// difference of the large numbers is the same for all points.
    #[inline(always)]
    fn limited_step(&self, v: Vec3<S>, chosen: Vec3<S>, good: &mut S) -> Vec3<S> {
        let RoundWithin { centre, radius, .. } = *self;
        let (distance, u) = direction(v - centre, radius, chosen, good);
        let vc = v.dot(centre);
        let square = radius * radius - centre.length_squared() + ((vc + vc) - v.length_squared());
        u * (square / (radius + distance))
    }
}

/// Returns the length of `v` and its unit vector. If `v` is nearer to zero than the rounding error
/// of points at this `radius`, the vector is `chosen`, and `good` becomes zero.
#[inline(always)]
fn direction<S: Lane>(v: Vec3<S>, radius: S, chosen: Vec3<S>, good: &mut S) -> (S, Vec3<S>) {
    let squared = v.length_squared();
    let distance = squared.sqrt();
    let bound = radius * S::splat(AT_CENTRE);
    let bound = bound * bound;
    *good = squared.if_greater(bound, *good, S::zero());
    (distance, Vec3::if_greater(squared, bound, v * (S::one() / distance), chosen))
}

impl RoundWithin<f64> {
    /// Centre and radius, on the same conditions as [`Round::centre_and_radius`].
    pub fn centre_and_radius(&self) -> Option<(Vec3<f64>, f64)> {
        if self.limited == 0.0 {
            return self.round.centre_and_radius();
        }
        let drawable = self.radius > 0.0 && !self.is_straight();
        drawable.then_some((self.centre, self.radius))
    }

    fn is_straight(&self) -> bool {
        self.radius > STRAIGHT * self.round.mean_square.sqrt()
    }
}

/// A circle or sphere fitted in principal axes: slower, but accurate for every input, and closest
/// to the points if the limits change the radius.
///
/// Collinear (for a sphere, coplanar) points that may not stay on their line bulge to one side. A
/// limit of more than a million times the size of the points gives a line along the longest axis (for
/// a sphere, a plane along the two longest). Coincident points stay. If the radius must be zero, all
/// points go to their mean.
#[derive(Clone, Copy, Debug)]
pub struct PrincipalRound {
    /// The principal axes of the points.
    pub axes: PrincipalAxes,
    within: RoundWithin<f64>,
    dimensions: usize,
    /// Zero is the only allowed radius: all points go to the centre, their mean.
    is_point: bool,
}

impl PrincipalRound {
    /// Fits mean-centred points, a circle for two `dimensions` and a sphere for three, and replaces
    /// the points by their principal coordinates. `clamp` returns the nearest radius within the
    /// limits.
    pub fn rotate(
        points: &mut [Vec3<f64>],
        dimensions: usize,
        clamp: impl Fn(f64) -> f64,
    ) -> PrincipalRound {
        let axes = PrincipalAxes::rotate(points);
        let round = Round::fit_principal(points, dimensions);
        let seen: Vec<_> = points.iter().map(|v| with_dimensions(*v, dimensions)).collect();
        let chosen = if round.reach > 0.0 { axis(0) } else { axis(dimensions - 1) };
        let normal = if dimensions == 2 { axis(2) } else { Vec3::zero() };
        let is_point = clamp(f64::INFINITY) == 0.0;
        let clamp = |radius: f64| {
            let in_space = radius * axes.scale;
            let clamped = clamp(in_space);
            if clamped == in_space { radius } else { clamped / axes.scale }
        };
        let mut within = RoundWithin::of(&seen, round, normal, clamp, chosen, &mut 1.0);
        if within.limited > 0.0 && !within.is_straight() && !is_point {
            within.centre = nearest_centre(&seen, dimensions, within.radius, within.centre);
        }
        PrincipalRound { axes, within, dimensions, is_point }
    }

    /// Returns the closest point, in space, to the point with principal coordinates `v`. A point at
    /// the centre goes to where the first axis meets the circle or sphere.
    pub fn closest(&self, v: Vec3<f64>) -> Vec3<f64> {
        let v = with_dimensions(v, self.dimensions);
        self.axes.point(v + self.step(v))
    }

    /// For a circle, as [`CircleFit::height_and_step`](crate::math::CircleFit::height_and_step), for the
    /// point with principal coordinates `v`. Lengths are those in space; the step is along the principal
    /// axes.
    pub fn height_and_step(&self, v: Vec3<f64>) -> (f64, Vec3<f64>) {
        let step = self.step(with_dimensions(v, 2));
        (v.z * self.axes.scale, step * self.axes.scale)
    }

    /// The displacement from `v`, in its dimensions, to its closest point, in principal coordinates.
    fn step(&self, v: Vec3<f64>) -> Vec3<f64> {
        let RoundWithin { round, limited, .. } = self.within;
        if self.is_point {
            -v
        } else if limited == 0.0 {
            round.step_or_chosen(v)
        } else if self.within.is_straight() {
            with_dimensions(v, self.dimensions - 1) - v
        } else {
            self.within.limited_step(v, axis(0), &mut 1.0)
        }
    }

    /// As [`Round::centre_and_radius`], in space.
    pub fn centre_and_radius(&self) -> Option<(Vec3<f64>, f64)> {
        let round = self.within.centre_and_radius();
        round.map(|(c, r)| (self.axes.point(c), r * self.axes.scale))
    }
}

/// The unit vector along principal axis `k`.
fn axis(k: usize) -> Vec3<f64> {
    let unit = |i| f64::from(u8::from(i == k));
    Vec3::new(unit(0), unit(1), unit(2))
}

/// Keeps the first `dimensions` coordinates and sets the others to zero.
fn with_dimensions(v: Vec3<f64>, dimensions: usize) -> Vec3<f64> {
    Vec3::new(v.x, if dimensions > 1 { v.y } else { 0.0 }, if dimensions > 2 { v.z } else { 0.0 })
}
