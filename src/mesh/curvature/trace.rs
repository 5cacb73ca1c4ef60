//! Lines of curvature, traced by the midpoint method: each step is straight on the surface (a
//! geodesic), in the direction found halfway.

use super::field::{CurvatureField, Family, SurfacePoint};
use crate::math::Vec3;
use crate::mesh::Point;

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

/// Step length, as a fraction of the mean edge.
const STEP: f64 = 0.25;
/// A line is closed if it returns to its beginning within this fraction of the mean edge.
const CLOSED: f64 = 0.5;
/// A line ends if the curvatures differ by at most this fraction of the sum of their sizes. The
/// threshold for beginning one is larger.
const UMBILIC: f64 = 0.04;
/// Maximum number of steps in each direction.
const MOST_STEPS: usize = 20_000;

/// A line of curvature.
#[derive(Clone, Debug, PartialEq)]
pub struct CurvatureLine {
    /// The points along the line; a closed line repeats its first point at the end.
    pub points: Vec<SurfacePoint>,
    /// Whether the line is closed.
    pub closed: bool,
}

impl CurvatureLine {
    /// Returns the positions of the points, `#points by 3`.
    pub fn positions(&self) -> impl ExactSizeIterator<Item = Point> + '_ {
        self.points.iter().map(|point| Point::from(point.at))
    }
}

impl CurvatureField {
    /// Traces the line through a point to both sides until it closes, reaches the boundary or a point
    /// without a direction, or until `is_end` of the points so far, the newest last. `None` without a
    /// direction at the point.
    pub(super) fn line_until(
        &self,
        point: SurfacePoint,
        family: Family,
        mut is_end: impl FnMut(&[SurfacePoint]) -> bool,
    ) -> Option<CurvatureLine> {
        let direction = self.direction(point, family, super::edges::UMBILIC)?;
        let (ahead, closed) = self.half(Heading { point, direction }, family, &mut is_end);
        if closed {
            return Some(CurvatureLine { points: ahead, closed });
        }
        let (mut points, _) =
            self.half(Heading { point, direction: -direction }, family, &mut is_end);
        points.reverse();
        points.extend(&ahead[1..]);
        Some(CurvatureLine { points, closed })
    }

    /// Traces one side of a line; returns its points and whether it is closed.
    fn half(
        &self,
        begin: Heading,
        family: Family,
        is_end: &mut impl FnMut(&[SurfacePoint]) -> bool,
    ) -> (Vec<SurfacePoint>, bool) {
        let step = STEP * self.mean_edge();
        let near = CLOSED * self.mean_edge();
        let mut points = vec![begin.point];
        let mut heading = begin;
        let mut was_away = false;
        for _ in 0..MOST_STEPS {
            let Some(next) = self.step(heading, family, step) else { break };
            heading = next;
            let away = (heading.point.at - begin.point.at).length();
            was_away |= away > 2.0 * near;
            let is_back = was_away && away < near && heading.direction.dot(begin.direction) > 0.5;
            // The beginning is at most one step ahead, or behind.
            if is_back && (begin.point.at - heading.point.at).dot(heading.direction) <= step {
                points.extend([heading.point, begin.point]);
                return (points, true);
            }
            points.push(heading.point);
            if is_end(&points) {
                break;
            }
        }
        (points, false)
    }

    /// Takes one step. The direction of `from` only selects the sign of the principal direction.
    fn step(&self, from: Heading, family: Family, length: f64) -> Option<Heading> {
        let along = |heading: Heading| {
            let direction = self.direction(heading.point, family, UMBILIC)?;
            Some(if direction.dot(heading.direction) < 0.0 { -direction } else { direction })
        };
        let direction = along(from)?;
        let half = self.walk(Heading { direction, ..from }, 0.5 * length)?;
        let there = along(half)?;
        // Apply the turn of the direction halfway to the direction at the beginning.
        let (cosine, sine) =
            (half.direction.dot(there), half.direction.cross(there).dot(self.normal(half.point)));
        let turned = direction * cosine + self.normal(from.point).cross(direction) * sine;
        self.walk(Heading { direction: turned, ..from }, length)
    }
}

/// Whether the newest point is nearer than `distance` to an earlier part of the line, other than
/// its beginning.
pub(super) fn comes_back(points: &[SurfacePoint], distance: f64) -> bool {
    let [first, .., last] = points else { return false };
    if (first.at - last.at).length() < 2.0 * distance {
        return false;
    }
    let near = |point: &SurfacePoint| (point.at - last.at).length() < distance;
    // Skip the most recent points, which are near in any case.
    let before = points.iter().rposition(|point| !near(point)).unwrap_or(0);
    points[..before].iter().any(near)
}
