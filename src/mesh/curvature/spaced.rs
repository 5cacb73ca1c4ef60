//! Lines of curvature at an even distance from each other (Jobard and Lefer 1997): each line gives places for the next
//! ones at both of its sides, and ends where it comes near another.

use super::field::{CurvatureField, Family, SurfacePlace};
use super::trace::{CurvatureLine, comes_back};
use super::walk::Heading;
use crate::math::Vec3;

/// A line begins no nearer to others than this part of the distance, and ends at that one.
const BEGIN: f64 = 0.9;
const END: f64 = 0.5;
/// Shorter lines are not kept: so many distances.
const SHORT: f64 = 0.75;

impl CurvatureField {
    /// Lines of one family, about `distance` apart, in the unit of the mesh, over the whole surface; those of the faces
    /// that come first are first.
    ///
    /// # Panics
    /// When the distance is not positive.
    pub fn spaced_lines(&self, family: Family, distance: f64) -> Vec<CurvatureLine> {
        assert!(distance > 0.0, "lines have a distance");
        let mut lines: Vec<CurvatureLine> = Vec::new();
        let mut taken = Cells::new(distance);
        for middle in self.middles() {
            // Those beside the lines that came last, then the next face.
            let mut next = vec![middle];
            while let Some(place) = next.pop() {
                let Some(line) = self.line_beside(place, family, distance, &taken) else {
                    continue;
                };
                line.places.iter().for_each(|place| taken.add(place.at));
                next.extend(self.beside(&line, distance));
                lines.push(line);
            }
        }
        lines
    }

    /// The line through a place until it comes near what is taken, or near an earlier part of itself; none where it
    /// begins there, and where it is short.
    fn line_beside(
        &self,
        place: SurfacePlace,
        family: Family,
        distance: f64,
        taken: &Cells,
    ) -> Option<CurvatureLine> {
        if taken.is_near(place.at, BEGIN * distance) {
            return None;
        }
        let end = END * distance;
        let line = self.line_until(place, family, |places| {
            places.last().is_some_and(|last| taken.is_near(last.at, end)) || comes_back(places, end)
        })?;
        let length: f64 =
            line.places.windows(2).map(|ends| (ends[1].at - ends[0].at).length()).sum();
        (line.closed || length >= SHORT * distance).then_some(line)
    }

    /// Places at both sides of a line, so far from it.
    fn beside(&self, line: &CurvatureLine, distance: f64) -> Vec<SurfacePlace> {
        let mut found = Vec::new();
        let mut since = 0.0;
        for ends in line.places.windows(2) {
            let (length, way) = (ends[1].at - ends[0].at).length_and_direction();
            since += length;
            let Some(way) = way.filter(|_| since >= distance) else { continue };
            since = 0.0;
            let place = ends[0];
            let (_, across) = self.normal(place).cross(way).length_and_direction();
            let both = across.into_iter().flat_map(|across| [across, -across]);
            found.extend(both.filter_map(|way| {
                self.walk(Heading { place, way }, distance).map(|heading| heading.place)
            }));
        }
        found
    }
}

/// Points by the cells of a grid whose sides are as long as the distance that is asked for.
struct Cells {
    side: f64,
    /// Cells that share a place in the table are told apart by the distance itself.
    table: Vec<Vec<Vec3<f64>>>,
}

impl Cells {
    const SIZE: usize = 1 << 12;

    fn new(side: f64) -> Cells {
        Cells { side, table: vec![Vec::new(); Self::SIZE] }
    }

    fn add(&mut self, point: Vec3<f64>) {
        let cell = self.cell(point);
        self.table[Self::place(cell)].push(point);
    }

    /// Whether a point is nearer than `distance`, at most the side of a cell.
    fn is_near(&self, point: Vec3<f64>, distance: f64) -> bool {
        let [x, y, z] = self.cell(point);
        let around = |from: i64| from - 1..=from + 1;
        around(x).any(|x| {
            around(y).any(|y| {
                around(z).any(|z| {
                    let near = |other: &Vec3<f64>| (*other - point).length() < distance;
                    self.table[Self::place([x, y, z])].iter().any(near)
                })
            })
        })
    }

    fn cell(&self, point: Vec3<f64>) -> [i64; 3] {
        [point.x, point.y, point.z].map(|coordinate| (coordinate / self.side).floor() as i64)
    }

    fn place([x, y, z]: [i64; 3]) -> usize {
        let mixed = x
            .wrapping_mul(73_856_093)
            .wrapping_add(y.wrapping_mul(19_349_663))
            .wrapping_add(z.wrapping_mul(83_492_791));
        mixed.rem_euclid(Self::SIZE as i64) as usize
    }
}
