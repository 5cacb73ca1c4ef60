//! All that tells whether the triangle that was closest to a point still is.
//!
//! A surface has this for each of its triangles, and points ask for it in another order: on large
//! surfaces waiting for memory takes longer than the arithmetic. Footings lie in the order of the points.

use super::safe_region::TriangleSafeRegion;
use super::triangle::{Planes, splat};
use crate::math::Vec3;

/// The triangle that was closest to a point last, and the region in which it stays the closest.
#[derive(Clone, Debug)]
pub struct ClosestPointCache {
    pub(crate) planes: Planes,
    pub(crate) region: TriangleSafeRegion,
}

impl ClosestPointCache {
    /// Nothing is known yet.
    pub fn unknown() -> ClosestPointCache {
        ClosestPointCache {
            planes: Planes::new([Vec3::zero(); 3]),
            region: TriangleSafeRegion::up_to(-1.0),
        }
    }

    /// The closest point to `p`, if that is known without a search.
    #[inline(always)]
    pub(crate) fn foot(&self, p: Vec3<f64>) -> Option<Vec3<f64>> {
        let over = self.planes.over(splat(p));
        self.region.holds(over).then(|| self.planes.foot(p, over))
    }
}
