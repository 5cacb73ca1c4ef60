//! A 3-vector whose components are lanes.

use crate::math::Lane;
use std::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

/// A 3-vector; with [`crate::math::Lanes`] one vector for each of several constraints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vec3<S> {
    /// First component.
    pub x: S,
    /// Second component.
    pub y: S,
    /// Third component.
    pub z: S,
}

impl<S: Lane> Vec3<S> {
    /// The vector (x, y, z).
    #[inline(always)]
    pub fn new(x: S, y: S, z: S) -> Self {
        Vec3 { x, y, z }
    }
    /// The zero vector.
    #[inline(always)]
    pub fn zero() -> Self {
        Vec3::new(S::zero(), S::zero(), S::zero())
    }
    /// Inner product.
    #[inline(always)]
    pub fn dot(self, o: Self) -> S {
        self.x * o.x + self.y * o.y + self.z * o.z
    }
    /// Cross product.
    #[inline(always)]
    pub fn cross(self, o: Self) -> Self {
        Vec3::new(
            self.y * o.z - self.z * o.y,
            self.z * o.x - self.x * o.z,
            self.x * o.y - self.y * o.x,
        )
    }
    /// Squared Euclidean length.
    #[inline(always)]
    pub fn length_squared(self) -> S {
        self.dot(self)
    }
    /// Euclidean length.
    #[inline(always)]
    pub fn length(self) -> S {
        self.dot(self).sqrt()
    }
    /// A unit vector orthogonal to this unit vector, in its plane with one of the coordinate axes
    /// farthest from it.
    #[inline(always)]
    pub fn across(self) -> Self {
        let (zero, one) = (S::zero(), S::one());
        let [x, y, z] = [self.x.abs(), self.y.abs(), self.z.abs()];
        let of_two = Self::if_greater(x, y, Vec3::new(zero, one, zero), Vec3::new(one, zero, zero));
        let axis = Self::if_greater(x.min(y), z, Vec3::new(zero, zero, one), of_two);
        let across = axis - self * self.dot(axis);
        across * (one / across.length())
    }
    /// Lane by lane: `yes` where `key > bound`, else `no`.
    #[inline(always)]
    pub fn if_greater(key: S, bound: S, yes: Self, no: Self) -> Self {
        Vec3::new(
            key.if_greater(bound, yes.x, no.x),
            key.if_greater(bound, yes.y, no.y),
            key.if_greater(bound, yes.z, no.z),
        )
    }
    /// The same vector in every lane.
    #[inline(always)]
    pub fn splat(v: Vec3<f64>) -> Self {
        Vec3::new(S::splat(v.x), S::splat(v.y), S::splat(v.z))
    }
    /// The vector of lane `i`.
    #[inline(always)]
    pub fn lane(self, i: usize) -> Vec3<f64> {
        Vec3::new(self.x.lane(i), self.y.lane(i), self.z.lane(i))
    }
    /// Replaces the vector of lane `i`.
    #[inline(always)]
    pub fn set_lane(&mut self, i: usize, v: Vec3<f64>) {
        self.x.set_lane(i, v.x);
        self.y.set_lane(i, v.y);
        self.z.set_lane(i, v.z);
    }
}

impl Vec3<f64> {
    /// Returns the largest absolute coordinate.
    pub fn largest_coordinate(self) -> f64 {
        self.x.abs().max(self.y.abs()).max(self.z.abs())
    }

    /// Returns the length, and the direction unless the vector is zero, without overflow or
    /// underflow.
    pub fn length_and_direction(self) -> (f64, Option<Self>) {
        let scale = self.largest_coordinate();
        if scale == 0.0 {
            return (0.0, None);
        }
        let v = Vec3::new(self.x / scale, self.y / scale, self.z / scale);
        let length = v.length();
        (length * scale, Some(v * (1.0 / length)))
    }
}

/// Subtracts the mean from the points, `N_i` of paper Eq. 5, and returns the mean.
#[inline(always)]
pub fn centre<S: Lane>(points: &mut [Vec3<S>]) -> Vec3<S> {
    let mut sum = Vec3::zero();
    for point in &*points {
        sum += *point;
    }
    let mean = sum * S::splat(1.0 / points.len() as f64);
    for point in points {
        *point -= mean;
    }
    mean
}

impl From<[f64; 3]> for Vec3<f64> {
    #[inline(always)]
    fn from([x, y, z]: [f64; 3]) -> Self {
        Vec3 { x, y, z }
    }
}

impl From<Vec3<f64>> for [f64; 3] {
    #[inline(always)]
    fn from(v: Vec3<f64>) -> Self {
        [v.x, v.y, v.z]
    }
}

impl<S: Lane> Add for Vec3<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        Vec3::new(self.x + o.x, self.y + o.y, self.z + o.z)
    }
}

impl<S: Lane> Sub for Vec3<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        Vec3::new(self.x - o.x, self.y - o.y, self.z - o.z)
    }
}

impl<S: Lane> Mul<S> for Vec3<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, s: S) -> Self {
        Vec3::new(self.x * s, self.y * s, self.z * s)
    }
}

impl<S: Lane> Neg for Vec3<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Vec3::new(-self.x, -self.y, -self.z)
    }
}

impl<S: Lane> AddAssign for Vec3<S> {
    #[inline(always)]
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}

impl<S: Lane> SubAssign for Vec3<S> {
    #[inline(always)]
    fn sub_assign(&mut self, o: Self) {
        *self = *self - o;
    }
}
