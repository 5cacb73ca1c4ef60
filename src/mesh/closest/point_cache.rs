//! Per-point copy of the data that decides whether the last closest triangle is still closest.
//!
//! A surface stores the same data per triangle, but points access it in another order, and on large
//! surfaces the cache misses cost more than the arithmetic. The copies are in the order of the
//! points.

use super::safe_region::TriangleSafeRegion;
use super::triangle::{Planes, splat};
use crate::math::Vec3;

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
