//! The region above and below a triangle in which no other triangle is nearer.
//!
//! It is part of the cell of the triangle in the Voronoi diagram of all triangles, bounded by
//! planes so that a point is tested with a few products.
//!
//! Let `p` be at height `d` above a triangle, with its foot at least `a` inside one side, so that
//! it is at the distance `d`. Let another triangle lie entirely beyond that side and rise from it
//! towards `p` by an angle of at most `theta`, which is 90 degrees or less. Across the side:
//!
//! ```text
//!            p = (-a, d)        . theta
//!            |               .
//!            | d          .      the other triangle is below this ray
//!            |         .
//!  triangle -+------- 0 -------- beyond the side
//!                 a
//! ```
//!
//! The distance from `p` to the ray is `sqrt(a^2 + d^2)` if its start `0` is nearest, and otherwise
//! `a sin(theta) + d cos(theta)`. The first is never less than `d`. The second is not if
//! `d (1 - cos(theta)) <= a sin(theta)`, that is
//!
//! ```text
//! d tan(theta / 2) <= a,
//! ```
//!
//! the half-space below the bisecting plane. So the largest `tan(theta / 2)` of all triangles
//! beyond a side is enough for the side.
//!
//! A triangle that shares only a corner may lie beyond neither side of that corner, but beyond a
//! line across the corner: that through it which is perpendicular to the sum of the outward normals
//! `n_i + n_j` of both sides. The distance inside it is `(a_i + a_j) / |n_i + n_j|`, so that the
//! condition is `d tan(theta / 2) |n_i + n_j| <= a_i + a_j`. A triangle beyond none of these lines
//! limits the height instead. On a surface with small dihedral angles, few points lie outside the
//! region.
//!
//! A surface stores them per triangle. Points access them in another order, and on large surfaces
//! the cache misses cost more than the arithmetic, so each point has a copy of its own.

use super::triangle::{Corners, PlaneDistances, Planes, splat};
use crate::math::{Lane, Vec3};

/// Safe region of a triangle; index 0 is for points above it, index 1 for points below it.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct TriangleSafeRegion {
    /// Largest `tan(theta / 2)` of the triangles beyond the sides ab, bc, ca.
    beyond_sides: [[f32; 3]; 2],
    /// The same for triangles beyond the corners a, b, c, multiplied by `|n_i + n_j|`.
    beyond_corners: [[f32; 3]; 2],
    /// Heights up to which the region is valid; negative if it is empty.
    heights: [f32; 2],
}

/// The two sides that meet in each corner.
const MEETING: [[usize; 2]; 3] = [[2, 0], [0, 1], [1, 2]];

impl TriangleSafeRegion {
    /// Returns the region of a triangle without neighbours, valid up to `height`.
    pub(crate) fn up_to(height: f64) -> TriangleSafeRegion {
        let nothing = [[0.0; 3]; 2];
        let heights = [rounded_down(height); 2];
        TriangleSafeRegion { beyond_sides: nothing, beyond_corners: nothing, heights }
    }

    /// Removes the points that are nearer to `other` than to the triangle `of` this region. Below the
    /// height `far`, there are none.
    pub(crate) fn exclude(&mut self, of: &TriangleSides<'_>, other: &Corners, far: f64) {
        let TriangleSides { planes, corners, across } = of;
        let distances = other.at.map(|corner| exact_distances(planes, corners, corner));
        for (side, sign) in [1.0, -1.0].into_iter().enumerate() {
            let heights = distances.map(|of| sign * of.height);
            if heights.iter().all(|&height| height <= 0.0) {
                continue;
            }
            // Of the lines that `other` is beyond, take the one from which it rises least.
            let mut least = (f64::INFINITY, 0.0, &mut self.heights[side]);
            let lines = self.beyond_sides[side].iter_mut().chain(&mut self.beyond_corners[side]);
            for (k, known) in lines.enumerate() {
                let (out, times) = match k {
                    0..3 => (distances.map(|of| of.out[k]), 1.0),
                    _ => {
                        let [i, j] = MEETING[k - 3];
                        (distances.map(|of| of.out[i] + of.out[j]), across[k - 3])
                    }
                };
                if times > 0.0 && out.iter().all(|&out| out >= 0.0) {
                    let rise = |i: usize| half_tangent(heights[i], out[i] / times);
                    let rise = Lane::max(rise(0), Lane::max(rise(1), rise(2)));
                    if rise < least.0 {
                        least = (rise, times, known);
                    }
                }
            }
            let (rise, times, known) = least;
            if rise < f64::INFINITY {
                *known = known.max(rounded_up(rise * times));
            } else {
                *known = known.min(rounded_down(far));
            }
        }
    }

    /// Whether the point with these distances to the planes of the triangle is in the region.
    #[inline(always)]
    pub(crate) fn contains(&self, distances: PlaneDistances) -> bool {
        let side = usize::from(distances.height < 0.0);
        let height = distances.height.abs();
        let inside = distances.out.map(|out| -out);
        let beyond_sides = &self.beyond_sides[side];
        let beyond_corners = &self.beyond_corners[side];
        let below_side = |k: usize| height * f64::from(beyond_sides[k]) <= inside[k];
        let below_corner = |k: usize| {
            let [i, j] = MEETING[k];
            height * f64::from(beyond_corners[k]) <= inside[i] + inside[j]
        };
        (height <= f64::from(self.heights[side]))
            & (below_side(0) & below_side(1) & below_side(2))
            & (below_corner(0) & below_corner(1) & below_corner(2))
    }
}

/// A triangle, and for each corner the length of the sum of the outward normals of its sides.
pub(crate) struct TriangleSides<'a> {
    planes: &'a Planes,
    corners: &'a Corners,
    across: [f64; 3],
}

impl<'a> TriangleSides<'a> {
    pub(crate) fn new(planes: &'a Planes, corners: &'a Corners) -> TriangleSides<'a> {
        let normals = planes.side_normals();
        let across = MEETING.map(|[i, j]| (normals[i] + normals[j]).length());
        TriangleSides { planes, corners, across }
    }
}

/// Returns the distances of a corner of another triangle; exactly zero if it is a shared corner.
#[inline(always)]
fn exact_distances(planes: &Planes, corners: &Corners, corner: Vec3<f64>) -> PlaneDistances {
    let mut distances = planes.distances(splat(corner));
    for k in (0..3).filter(|&k| corners.at[k] == corner) {
        distances.height = 0.0;
        MEETING[k].into_iter().for_each(|side| distances.out[side] = 0.0);
    }
    distances
}

/// Returns `tan(theta / 2)` of the elevation angle of a point at this height and distance.
#[inline(always)]
fn half_tangent(height: f64, away: f64) -> f64 {
    if height > 0.0 { height / (away + (away * away + height * height).sqrt()) } else { 0.0 }
}

fn rounded_up(x: f64) -> f32 {
    (x * (1.0 + 1e-6)) as f32
}

/// Rounds a height down; -1 if it is not above the smallest normal `f32`.
fn rounded_down(x: f64) -> f32 {
    let small = f64::from(f32::MIN_POSITIVE);
    if x > small { Lane::min(x * (1.0 - 1e-6), f64::from(f32::MAX)) as f32 } else { -1.0 }
}

/// The last closest triangle of a point, and the region in which it remains the closest.
#[derive(Clone, Debug)]
pub struct ClosestPointCache {
    pub(crate) planes: Planes,
    pub(crate) region: TriangleSafeRegion,
}

impl ClosestPointCache {
    /// Returns a cache without a triangle.
    pub fn unknown() -> ClosestPointCache {
        ClosestPointCache {
            planes: Planes::new([Vec3::zero(); 3]),
            region: TriangleSafeRegion::up_to(-1.0),
        }
    }

    /// Returns the closest point to `p` if `p` is in the cached region.
    #[inline(always)]
    pub(crate) fn foot(&self, p: Vec3<f64>) -> Option<Vec3<f64>> {
        let distances = self.planes.distances(splat(p));
        self.region.contains(distances).then(|| self.planes.foot(p, distances))
    }
}
