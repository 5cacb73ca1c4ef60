//! Straight paths (geodesics) on a triangulated surface.

use super::field::{CurvatureField, SurfacePlace};
use crate::math::Vec3;

/// Maximum number of triangles that a path crosses before it is given up.
const MOST_CROSSINGS: usize = 10_000;

/// A place and a unit direction in the plane of its triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Heading {
    pub(super) place: SurfacePlace,
    pub(super) way: Vec3<f64>,
}

impl CurvatureField {
    /// Walks straight over `length`, unfolding each triangle into the plane of the one before;
    /// `None` if the path leaves the surface.
    pub(super) fn walk(&self, from: Heading, length: f64) -> Option<Heading> {
        let Heading { mut place, mut way } = from;
        let mut left = length;
        let mut entered = None;
        for _ in 0..MOST_CROSSINGS {
            let corners = self.corners(place.triangle);
            let normal = self.normal(place);
            let exits = (0..3).filter(|&k| entered != Some(k)).filter_map(|k| {
                let [a, b] = [corners[k], corners[(k + 1) % 3]];
                let outwards = (b - a).cross(normal);
                let speed = outwards.dot(way);
                let distance = outwards.dot(a - place.at).max(0.0);
                (speed > 0.0).then(|| (k, distance / speed))
            });
            let (side, distance) = exits.min_by(|(_, a), (_, b)| a.total_cmp(b))?;
            if distance >= left {
                place.at += way * left;
                return Some(Heading { place, way });
            }
            left -= distance;
            place.at += way * distance;
            let (next, back) = self.over(place.triangle, side)?;
            let (_, along) = (corners[(side + 1) % 3] - corners[side]).length_and_direction();
            let along = along?;
            let across = along.cross(normal);
            place.triangle = next;
            let (_, turned) = (along * along.dot(way)
                + along.cross(self.normal(place)) * across.dot(way))
            .length_and_direction();
            way = turned?;
            entered = Some(back);
        }
        None
    }
}
