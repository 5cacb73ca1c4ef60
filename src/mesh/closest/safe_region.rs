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
    /// Largest `tan(theta / 2)` of the triangles beyond the sides ab, bc, ca and the corners a, b, c;
    /// those of the corners multiplied by `|n_i + n_j|`.
    beyond: [[f32; 6]; 2],
    /// Heights up to which the region is valid; negative if it is empty.
    heights: [f32; 2],
}

/// The two sides that meet in each corner.
const MEETING: [[usize; 2]; 3] = [[2, 0], [0, 1], [1, 2]];

impl TriangleSafeRegion {
    /// Returns the region of a triangle without neighbours, valid up to `height`.
    pub(crate) fn up_to(height: f64) -> TriangleSafeRegion {
        TriangleSafeRegion { beyond: [[0.0; 6]; 2], heights: [rounded_down(height); 2] }
    }

    /// Removes the points that are nearer to another triangle than to that of this region, given the
    /// distances of the other's corners to the planes of this one, and for each corner of this one the
    /// length `across` of the sum of the outward normals of its sides. Below the height `far`, there
    /// are none.
    #[inline(always)]
    pub(crate) fn exclude(&mut self, other: &[PlaneDistances; 3], across: [f64; 3], far: f64) {
        for (side, sign) in [1.0, -1.0].into_iter().enumerate() {
            let heights = other.map(|of| sign * of.height);
            if heights.iter().all(|&height| height <= 0.0) {
                continue;
            }
            let above = heights.map(|height| height > 0.0);
            let inverse = heights.map(|height| 1.0 / height);
            // Of the lines that the triangle is beyond, take the one from which it rises least.
            let (mut widest, mut scale, mut line) = (-1.0, 0.0, 6);
            let mut compare = |k: usize, out: [f64; 3], times: f64| {
                if times > 0.0 && out.iter().all(|&out| out >= 0.0) {
                    let cot = |i: usize| if above[i] { out[i] * inverse[i] } else { f64::INFINITY };
                    let cot = Lane::min(cot(0), Lane::min(cot(1), cot(2))) / times;
                    if cot > widest {
                        (widest, scale, line) = (cot, times, k);
                    }
                }
            };
            for k in 0..3 {
                compare(k, other.map(|of| of.out[k]), 1.0);
                let [i, j] = MEETING[k];
                compare(3 + k, other.map(|of| of.out[i] + of.out[j]), across[k]);
            }
            if let Some(known) = self.beyond[side].get_mut(line) {
                *known = known.max(rounded_up(scale * half_tangent(widest)));
            } else {
                let known = &mut self.heights[side];
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
        let beyond = &self.beyond[side];
        let below_side = |k: usize| height * f64::from(beyond[k]) <= inside[k];
        let below_corner = |k: usize| {
            let [i, j] = MEETING[k];
            height * f64::from(beyond[3 + k]) <= inside[i] + inside[j]
        };
        (height <= f64::from(self.heights[side]))
            & (below_side(0) & below_side(1) & below_side(2))
            & (below_corner(0) & below_corner(1) & below_corner(2))
    }
}

/// Returns for each corner of a triangle the length of the sum of the outward normals of its sides.
pub(crate) fn across_corners(planes: &Planes) -> [f64; 3] {
    let normals = planes.side_normals();
    MEETING.map(|[i, j]| (normals[i] + normals[j]).length())
}

/// Returns the distances of the corners of another triangle; exactly zero where they are shared.
#[inline(always)]
pub(crate) fn exact_distances(
    mut distances: [PlaneDistances; 3],
    corners: &Corners,
    other: &Corners,
) -> [PlaneDistances; 3] {
    for (distances, corner) in distances.iter_mut().zip(&other.at) {
        for k in (0..3).filter(|&k| corners.at[k] == *corner) {
            distances.height = 0.0;
            MEETING[k].into_iter().for_each(|side| distances.out[side] = 0.0);
        }
    }
    distances
}

/// Returns `tan(theta / 2)` of `cot(theta)`, for angles of at most 90 degrees.
#[inline(always)]
fn half_tangent(cot: f64) -> f64 {
    1.0 / (cot + (1.0 + cot * cot).sqrt())
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
