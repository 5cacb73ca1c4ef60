//! A 3-vector whose components are lanes: its operations, the bounds within which closed forms stay
//! accurate, and points in lanes from rows of coordinates that are apart in memory.

use super::register::Register;
use crate::math::{LANES, Lane, Lanes};
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

    /// Returns the direction; zero of a zero vector.
    pub fn direction_or_zero(self) -> Self {
        self.length_and_direction().1.unwrap_or_else(Self::zero)
    }
}

/// Returns the mean of points, summed in their order; zero without any.
pub fn mean(points: impl IntoIterator<Item = Vec3<f64>>) -> Vec3<f64> {
    let (mut sum, mut count) = (Vec3::zero(), 0.0);
    for point in points {
        sum += point;
        count += 1.0;
    }
    sum * (1.0 / f64::max(count, 1.0))
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

/// Returns `flag` in the lanes where the squared lengths from `least` to `greatest` are between
/// 1e-60 and 1e60, so that their fourth powers neither overflow nor underflow; zero in the others,
/// among them those with a NaN.
#[inline(always)]
pub fn in_range<S: Lane>(least: S, greatest: S, flag: S) -> S {
    let not_tiny = least.if_greater(S::splat(1e-60), flag, S::zero());
    S::splat(1e60).if_greater(greatest, not_tiny, S::zero())
}

/// Returns the largest absolute coordinate of some points; zero without points.
pub fn largest_coordinate(points: &[Vec3<f64>]) -> f64 {
    points.iter().fold(0.0, |largest, point| point.largest_coordinate().max(largest))
}

impl Vec3<Lanes> {
    /// Gathers the points of these rows, one in each lane.
    #[inline(always)]
    pub fn of_rows(rows: &[[f64; 4]], at: &[u32; LANES]) -> Self {
        let mut points = Self::zero();
        for k in 0..LANES / 2 {
            let [a, b] = [rows[at[2 * k] as usize], rows[at[2 * k + 1] as usize]];
            let [xy, next_xy] = [Register::new(a[0], a[1]), Register::new(b[0], b[1])];
            points.x.0[k] = xy.lows(next_xy);
            points.y.0[k] = xy.highs(next_xy);
            points.z.0[k] = Register::new(a[2], b[2]);
        }
        points
    }

    /// Adds the vector of each lane to its row, one lane after another, since lanes may share a
    /// row.
    #[inline(always)]
    pub fn add_to_rows(self, rows: &mut [[f64; 4]], at: &[u32; LANES]) {
        for k in 0..LANES / 2 {
            let (x, y, z) = (self.x.0[k], self.y.0[k], self.z.0[k]);
            let halves = [(x.lows(y), z.low()), (x.highs(y), z.high())];
            for (half, (xy, z)) in halves.into_iter().enumerate() {
                let row = &mut rows[at[2 * k + half] as usize];
                let sum = Register::new(row[0], row[1]).add(xy);
                (row[0], row[1]) = (sum.low(), sum.high());
                row[2] += z;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::math::{LANES, Lane, Vec3};

    #[test]
    fn points_come_from_rows_and_sums_go_back_where_lanes_share_one() {
        let rows = [[1.0, 2.0, 3.0, 9.0], [4.0, 5.0, 6.0, 9.0], [7.0, 8.0, 10.0, 9.0]];
        let at: [u32; LANES] = [2, 0, 2, 1];
        let points = Vec3::of_rows(&rows, &at);
        for (lane, &row) in at.iter().enumerate() {
            assert_eq!(
                [points.x, points.y, points.z].map(|x| x.lane(lane)),
                rows[row as usize][..3]
            );
        }
        let mut sums = rows;
        points.add_to_rows(&mut sums, &at);
        let expected = [[2.0, 4.0, 6.0, 9.0], [8.0, 10.0, 12.0, 9.0], [21.0, 24.0, 30.0, 9.0]];
        assert_eq!(sums, expected);
    }
}
