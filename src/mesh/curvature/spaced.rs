//! Evenly spaced lines of curvature (Jobard and Lefer 1997): each line seeds the next ones on both
//! sides, and ends where it comes close to another. Or, for a picture that needs no tracing, two
//! short strokes on each face.

use super::field::{CurvatureField, Family, SurfacePoint};
use super::trace::{CurvatureLine, Heading, comes_back};
use crate::math::Vec3;
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
        let mut taken = Cells::new(distance);
        for centre in self.centres() {
            // Seeds beside the newest lines come before the next face.
            let mut next = vec![centre];
            while let Some(point) = next.pop() {
                let Some(line) = self.line_beside(point, family, distance, &taken) else {
                    continue;
                };
                line.points.iter().for_each(|point| taken.add(point.at));
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
        taken: &Cells,
    ) -> Option<CurvatureLine> {
        if taken.is_near(point.at, BEGIN * distance) {
            return None;
        }
        let end = END * distance;
        let line = self.line_until(point, family, |points| {
            points.last().is_some_and(|last| taken.is_near(last.at, end)) || comes_back(points, end)
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

/// Hash grid of points.
struct Cells {
    side: f64,
    /// Cells with the same hash share an entry; the distance test sorts their points out.
    table: Vec<Vec<Vec3<f64>>>,
}

impl Cells {
    const SIZE: usize = 1 << 12;

    fn new(side: f64) -> Cells {
        Cells { side, table: vec![Vec::new(); Self::SIZE] }
    }

    fn add(&mut self, point: Vec3<f64>) {
        let cell = self.cell(point);
        self.table[Self::bucket(cell)].push(point);
    }

    /// Whether a stored point is nearer than `distance`, which is at most the side of a cell.
    fn is_near(&self, point: Vec3<f64>, distance: f64) -> bool {
        let [x, y, z] = self.cell(point);
        let around = |from: i64| from - 1..=from + 1;
        around(x).any(|x| {
            around(y).any(|y| {
                around(z).any(|z| {
                    let near = |other: &Vec3<f64>| (*other - point).length() < distance;
                    self.table[Self::bucket([x, y, z])].iter().any(near)
                })
            })
        })
    }

    fn cell(&self, point: Vec3<f64>) -> [i64; 3] {
        [point.x, point.y, point.z].map(|coordinate| (coordinate / self.side).floor() as i64)
    }

    fn bucket([x, y, z]: [i64; 3]) -> usize {
        let mixed = x
            .wrapping_mul(73_856_093)
            .wrapping_add(y.wrapping_mul(19_349_663))
            .wrapping_add(z.wrapping_mul(83_492_791));
        mixed.rem_euclid(Self::SIZE as i64) as usize
    }
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
