//! Which triangles are near each triangle of a surface.
//!
//! If the closest point of one triangle is at distance `d` of `p`, whatever is nearer to `p` is
//! within `2 d` of that triangle. So where `d` is short against the triangle, a short list made
//! beforehand has all that can be nearer, and no tree needs to be searched.

use super::bvh::{Box3, Bvh};
use super::safe_region::TriangleSafeRegion;
use super::triangle::{Corners, Planes};
use crate::math::Lane;
use crate::mesh::Ragged;

/// How far the surroundings of a triangle reach, relative to the diagonal of its box.
const REACH: f64 = 0.5;

/// The same for what is close.
const CLOSE_REACH: f64 = 0.125;

/// A triangle with more surroundings than this has none listed, so that ten thousand triangles
/// around one corner do not cost ten thousand squared.
const MOST: usize = 64;

/// The triangles near each triangle.
#[derive(Clone, Debug)]
pub(crate) struct TriangleNeighbourhoods {
    clearings: Vec<TriangleSafeRegion>,
    /// For each triangle those in its reach, the close ones first.
    lists: Ragged,
    limits: Vec<Limits>,
}

/// For squared distances of a point to a triangle: how much of the list is needed.
#[derive(Clone, Debug)]
struct Limits {
    /// Up to this, the close ones.
    close: f64,
    /// Up to this, the list.
    listed: f64,
    /// How many of the list are close.
    n_close: u32,
}

impl TriangleNeighbourhoods {
    /// Lists the surroundings of all triangles. `boxes` are theirs, in the order of `tree`.
    pub(crate) fn new(
        bvh: &Bvh,
        boxes: &[Box3],
        planes: &[Planes],
        corners: &[Corners],
    ) -> TriangleNeighbourhoods {
        let mut lists = Ragged::new();
        let count = boxes.len();
        let (mut limits, mut clearings) = (Vec::with_capacity(count), Vec::with_capacity(count));
        // A negative limit allows nothing.
        let limit = |reach: f64| half(reach) * half(reach);
        let (mut close, mut others) = (Vec::new(), Vec::new());
        for t in 0..boxes.len() {
            let size = boxes[t].diagonal();
            let reach = REACH * size;
            let around = boxes[t].grown(reach);
            let mut region = TriangleSafeRegion::up_to(half(reach));
            close.clear();
            others.clear();
            bvh.meeting(&around, |leaf| {
                for s in leaf.filter(|&s| s != t && boxes[s].meets(&around)) {
                    let mut gap = 0.0;
                    if !corners[t].touches(&corners[s]) {
                        gap = planes[t].gap(&corners[s].at);
                        if gap <= reach {
                            gap = Lane::max(gap, planes[s].gap(&corners[t].at));
                        }
                    }
                    if gap <= reach {
                        let list = if gap <= CLOSE_REACH * size { &mut close } else { &mut others };
                        list.push(s as u32);
                        region.clear_of(&planes[t], &corners[t], &corners[s], half(gap));
                    }
                }
                close.len() + others.len() <= MOST
            });
            let n_close = close.len() as u32;
            close.append(&mut others);
            if close.len() > MOST || size == 0.0 {
                limits.push(Limits { close: -1.0, listed: -1.0, n_close: 0 });
                lists.push(&[]);
                clearings.push(TriangleSafeRegion::up_to(-1.0));
            } else {
                let (close_limit, listed) = (limit(CLOSE_REACH * size), limit(reach));
                limits.push(Limits { close: close_limit, listed, n_close });
                lists.push(&close);
                clearings.push(region);
            }
        }
        lists.shrink_to_fit();
        TriangleNeighbourhoods { clearings, lists, limits }
    }

    /// The clearing of triangle `t`.
    #[inline(always)]
    pub(crate) fn region(&self, t: usize) -> &TriangleSafeRegion {
        &self.clearings[t]
    }

    /// The triangles that can be nearer to a point than triangle `t`, from which it is at this
    /// squared distance; none when they are not listed.
    #[inline(always)]
    pub(crate) fn of(&self, t: usize, distance_squared: f64) -> Option<&[u32]> {
        let limits = &self.limits[t];
        let list = self.lists.row(t);
        if distance_squared <= limits.close {
            Some(&list[..limits.n_close as usize])
        } else if distance_squared <= limits.listed {
            Some(list)
        } else {
            None
        }
    }
}

/// A little less than half, which allows for rounding.
fn half(x: f64) -> f64 {
    (0.5 - 1e-9) * x
}
