//! Precomputed lists of the triangles near each triangle of a surface.
//!
//! If a triangle is at distance `d` from `p`, every triangle nearer to `p` is within `2 d` of it.
//! So if `d` is small relative to the triangle, a short list has all candidates, and the hierarchy
//! need not be searched.

use super::bvh::{Box3, Bvh};
use super::safe_region::{TriangleSafeRegion, across_corners, exact_distances};
use super::triangle::{self, Corners, Planes};
use crate::math::Lane;
use crate::mesh::{Point, Ragged};

/// Distance up to which neighbours are listed, relative to the diagonal of the triangle's box.
const REACH: f64 = 0.5;

/// The same for close neighbours, which come first in the list.
const CLOSE_REACH: f64 = 0.125;

/// Triangles with more neighbours than this get no list, so that ten thousand triangles around one
/// corner do not cost ten thousand squared.
const MOST: usize = 64;

/// Neighbour list and safe region of each triangle.
#[derive(Clone, Debug)]
pub(crate) struct TriangleNeighbourhoods {
    regions: Vec<TriangleSafeRegion>,
    /// Neighbours of each triangle, the close ones first.
    lists: Ragged,
    limits: Vec<Limits>,
}

/// Squared distances of a point to a triangle up to which parts of the list suffice.
#[derive(Clone, Debug)]
struct Limits {
    /// Up to this, the close neighbours suffice.
    close: f64,
    /// Up to this, the whole list suffices.
    listed: f64,
    /// Number of close neighbours in the list.
    n_close: u32,
}

impl TriangleNeighbourhoods {
    /// Lists the neighbours of all triangles; both slices are in the order of `bvh`.
    pub(crate) fn new(bvh: &Bvh, planes: &[Planes], corners: &[Corners]) -> TriangleNeighbourhoods {
        let boxes: Vec<Box3> =
            corners.iter().map(|corners| Box3::around(&corners.at.map(Point::from))).collect();
        let mut lists = Ragged::new();
        let count = boxes.len();
        let (mut limits, mut regions) = (Vec::with_capacity(count), Vec::with_capacity(count));
        let limit = |reach: f64| half(reach) * half(reach);
        let (mut close, mut others) = (Vec::new(), Vec::new());
        for t in 0..boxes.len() {
            let size = boxes[t].diagonal();
            let reach = REACH * size;
            let around = boxes[t].grown(reach);
            let mut region = TriangleSafeRegion::up_to(half(reach));
            let across = across_corners(&planes[t]);
            close.clear();
            others.clear();
            bvh.meeting(&around, |leaf| {
                for s in leaf.filter(|&s| s != t && boxes[s].meets(&around)) {
                    let mut distances = planes[t].distances_of(&corners[s]);
                    let mut gap = 0.0;
                    if corners[t].touches(&corners[s]) {
                        distances = exact_distances(distances, &corners[t], &corners[s]);
                    } else {
                        gap = triangle::gap(&distances);
                        if gap <= reach {
                            let others = planes[s].distances_of(&corners[t]);
                            gap = Lane::max(gap, triangle::gap(&others));
                        }
                    }
                    if gap <= reach {
                        let list = if gap <= CLOSE_REACH * size { &mut close } else { &mut others };
                        list.push(s as u32);
                        region.exclude(&distances, across, half(gap));
                    }
                }
                close.len() + others.len() <= MOST
            });
            let n_close = close.len() as u32;
            close.append(&mut others);
            if close.len() > MOST || size == 0.0 {
                // Negative limits admit no distance.
                limits.push(Limits { close: -1.0, listed: -1.0, n_close: 0 });
                lists.push(&[]);
                regions.push(TriangleSafeRegion::up_to(-1.0));
            } else {
                let (close_limit, listed) = (limit(CLOSE_REACH * size), limit(reach));
                limits.push(Limits { close: close_limit, listed, n_close });
                lists.push(&close);
                regions.push(region);
            }
        }
        lists.shrink_to_fit();
        TriangleNeighbourhoods { regions, lists, limits }
    }

    #[inline(always)]
    pub(crate) fn region(&self, t: usize) -> &TriangleSafeRegion {
        &self.regions[t]
    }

    /// Returns the triangles that can be nearer to a point than triangle `t`, given the squared
    /// distance of the point to `t`; `None` if the list does not suffice.
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

/// Returns slightly less than half of `x`, as a margin for rounding.
fn half(x: f64) -> f64 {
    (0.5 - 1e-9) * x
}
