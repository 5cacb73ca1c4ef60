//! Straight paths (geodesics) on a triangulated surface.

use super::field::{CurvatureField, SurfacePoint};
use crate::math::Vec3;

/// Maximum number of triangles that a path crosses before it is given up.
const MOST_CROSSINGS: usize = 10_000;

/// A point and a unit direction in the plane of its triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Heading {
    pub(super) point: SurfacePoint,
    pub(super) direction: Vec3<f64>,
}

impl CurvatureField {
    /// Walks straight over `length`, unfolding each triangle into the plane of the one before;
    /// `None` if the path leaves the surface.
    pub(super) fn walk(&self, from: Heading, length: f64) -> Option<Heading> {
        let Heading { mut point, mut direction } = from;
        let mut left = length;
        let mut entered = None;
        for _ in 0..MOST_CROSSINGS {
            let corners = self.corners(point.triangle);
            let normal = self.normal(point);
            let exits = (0..3).filter(|&k| entered != Some(k)).filter_map(|k| {
                let [a, b] = [corners[k], corners[(k + 1) % 3]];
                let outwards = (b - a).cross(normal);
                let speed = outwards.dot(direction);
                let distance = outwards.dot(a - point.at).max(0.0);
                (speed > 0.0).then(|| (k, distance / speed))
            });
            let (side, distance) = exits.min_by(|(_, a), (_, b)| a.total_cmp(b))?;
            if distance >= left {
                point.at += direction * left;
                return Some(Heading { point, direction });
            }
            left -= distance;
            point.at += direction * distance;
            let (next, back) = self.across(point.triangle, side)?;
            let (_, along) = (corners[(side + 1) % 3] - corners[side]).length_and_direction();
            let along = along?;
            let across = along.cross(normal);
            point.triangle = next;
            let (_, turned) = (along * along.dot(direction)
                + along.cross(self.normal(point)) * across.dot(direction))
            .length_and_direction();
            direction = turned?;
            entered = Some(back);
        }
        None
    }
}
