//! Evenly spaced lines of curvature (Jobard and Lefer 1997): each line seeds the next ones on both
//! sides, and ends where it comes close to another. Or, for a picture that needs no tracing, two
//! short strokes on each face.

use super::field::{CurvatureField, Family, SurfacePoint};
use super::trace::{CurvatureLine, Heading, comes_back};
use crate::math::{Cells, Vec3};
use crate::mesh::Point;

/// Least distance to other lines at the beginning of a line, as a fraction of the spacing.
const BEGIN: f64 = 0.9;
/// Distance to other lines at which a line ends, as a fraction of the spacing.
const END: f64 = 0.5;
/// Length below which lines are dropped, as a fraction of the spacing.
const SHORT: f64 = 0.75;

impl CurvatureField {
    /// Traces lines of one family over the whole surface, about `distance` apart, in the unit of
    /// the mesh, seeded from the faces in order.
    ///
    /// # Panics
    /// If the distance is not positive.
    pub fn spaced_lines(&self, family: Family, distance: f64) -> Vec<CurvatureLine> {
        assert!(distance > 0.0, "lines have a distance");
        let mut lines: Vec<CurvatureLine> = Vec::new();
        let mut taken = Cells::new(BEGIN * distance);
        for centre in self.centres() {
            // Seeds beside the newest lines come before the next face.
            let mut next = vec![centre];
            while let Some(point) = next.pop() {
                let Some(line) = self.line_beside(point, family, distance, &taken) else {
                    continue;
                };
                line.points.iter().for_each(|point| taken.add(point.at, ()));
                next.extend(self.beside(&line, distance));
                lines.push(line);
            }
        }
        lines
    }

    /// Traces the line through a point until it comes near a taken point or an earlier part of
    /// itself; `None` if it would begin near a taken point, or is too short.
    fn line_beside(
        &self,
        point: SurfacePoint,
        family: Family,
        distance: f64,
        taken: &Cells<()>,
    ) -> Option<CurvatureLine> {
        if is_near(taken, point.at, BEGIN * distance) {
            return None;
        }
        let end = END * distance;
        let line = self.line_until(point, family, |points| {
            points.last().is_some_and(|last| is_near(taken, last.at, end))
                || comes_back(points, end)
        })?;
        let length: f64 =
            line.points.windows(2).map(|ends| (ends[1].at - ends[0].at).length()).sum();
        (line.closed || length >= SHORT * distance).then_some(line)
    }

    /// Returns points on both sides of a line, at this distance from it.
    fn beside(&self, line: &CurvatureLine, distance: f64) -> Vec<SurfacePoint> {
        let mut found = Vec::new();
        let mut since = 0.0;
        for ends in line.points.windows(2) {
            let (length, direction) = (ends[1].at - ends[0].at).length_and_direction();
            since += length;
            let Some(direction) = direction.filter(|_| since >= distance) else { continue };
            since = 0.0;
            let point = ends[0];
            let (_, across) = self.normal(point).cross(direction).length_and_direction();
            let both = across.into_iter().flat_map(|across| [across, -across]);
            found.extend(both.filter_map(|direction| {
                self.walk(Heading { point, direction }, distance).map(|heading| heading.point)
            }));
        }
        found
    }
}

/// Whether a taken point is nearer than `distance`.
fn is_near(taken: &Cells<()>, point: Vec3<f64>, distance: f64) -> bool {
    taken.near(point).any(|(_, other)| other < distance)
}

/// Half the length of a stroke, as a fraction of the mean edge.
const HALF: f64 = 0.3;

impl CurvatureField {
    /// Returns the ends of a stroke through the centre of each face along the direction of a
    /// family. Faces where the surface is flat or umbilic have no stroke.
    pub fn strokes(&self, family: Family) -> Vec<[Point; 2]> {
        let half = HALF * self.mean_edge();
        let centres = self.centres();
        let directed = centres.filter_map(|point| {
            let direction = self.direction(point, family, super::edges::UMBILIC)?;
            Some([point.at - direction * half, point.at + direction * half].map(Point::from))
        });
        directed.collect()
    }
}
