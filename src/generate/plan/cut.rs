//! A straight grid cut to the outline and its holes.
//!
//! Grid vertices near a loop are moved onto it, one of them to each of its corners. Each grid edge
//! that a loop still crosses gets a vertex at the crossing. The part of each cell inside the
//! outline is a face: whole cells stay squares, and no face is a sliver.

use super::declaration::{MOST_CELLS, PlanError};
use super::kept::{boundary, is_kept};
use super::outline::{FlatPlan, Loop, along, closest};
use crate::generate::quads::check_face_count;
use crate::math::plane::{
    Point2, area, bounds, cross, crossings, distance, dot, is_inside, minus, rotated,
};
use crate::math::{cosine_and_sine_of_degrees, polygon_sides};
use crate::mesh::{Mesh, Ragged};
use std::collections::BTreeMap;

/// Grid vertices closer to a loop than this are moved onto it, in sides of a cell.
const NEAR: f64 = 0.3;
/// Smallest area of a face that has all its vertices on loops, in cells; smaller ones are dropped.
const SLIVER: f64 = 0.02;
/// Tolerance of the polylines that replace arcs, in sides of a cell.
const FLAT: f64 = 1e-3;

/// Position relative to the loops.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Location {
    Inside,
    Outside,
    /// On the loop of this index.
    On(usize),
}

/// The grid over the extent of a plan; its cells have side 1.
struct Grid {
    /// Number of cells in each direction.
    count: [usize; 2],
    /// The loops, the outline first.
    polygons: Vec<Vec<Point2>>,
    /// Positions of the grid vertices, then of the crossings.
    places: Vec<Point2>,
    locations: Vec<Location>,
    /// The vertex on each grid edge that a loop crosses.
    crossings: BTreeMap<[u32; 2], u32>,
}

/// The surface inside the first loop and outside the others.
pub(super) fn mesh(loops: &[&Loop], size: f64, turn: f64) -> Result<FlatPlan, PlanError> {
    let [c, s] = cosine_and_sine_of_degrees(turn);
    let flattened: Vec<Vec<(Point2, usize)>> =
        loops.iter().map(|one| one.flattened(FLAT * size)).collect();
    let [low, high] = bounds(flattened[0].iter().map(|&(place, _)| rotated(place, [c, -s])));
    let extent = minus(high, low);
    let count = extent.map(|length| (length / size).round().max(1.0));
    // Stretched a little, so that a whole number of cells fits.
    let step = [extent[0] / count[0], extent[1] / count[1]];
    let areas = flattened.iter().map(|places| {
        let places: Vec<Point2> = places.iter().map(|&(place, _)| place).collect();
        area(&places)
    });
    let inside = areas.reduce(|outline, hole| outline - hole).unwrap_or(0.0);
    check_face_count((inside / (step[0] * step[1])).round()).map_err(PlanError::TooManyFaces)?;
    if count[0] * count[1] > MOST_CELLS {
        return Err(PlanError::TooManyCells);
    }
    let to_grid = |place: Point2| {
        let place = minus(rotated(place, [c, -s]), low);
        [place[0] / step[0], place[1] / step[1]]
    };
    let polygons =
        flattened.iter().map(|places| places.iter().map(|&(place, _)| to_grid(place)).collect());
    let mut grid = Grid::new(count.map(|n| n as usize), polygons.collect());
    let mut corners = Vec::new();
    for (l, one) in loops.iter().enumerate() {
        let flags = one.corner_flags();
        for (side, _) in one.sides.iter().zip(flags).filter(|(_, is_sharp)| *is_sharp) {
            match grid.corner(to_grid(side.at(0.0)), l) {
                Some(v) if side.is_corner => corners.push((v, l.checked_sub(1))),
                None if side.is_corner => return Err(PlanError::TooCoarse(l.checked_sub(1))),
                _ => {}
            }
        }
    }
    grid.snap();
    grid.cross();
    let faces = grid.faces();
    // Cells that are cut count as whole ones here, and above by their parts.
    check_face_count(faces.len() as f64).map_err(PlanError::TooManyFaces)?;
    // A piece of the outline that is narrower than a cell can turn a face over.
    if faces.iter().any(|face| grid.area(face) <= 0.0) {
        return Err(PlanError::TooCoarse(None));
    }
    let boundary = boundary(&faces);
    for (l, polygon) in grid.polygons.iter().enumerate() {
        let on_it = boundary.iter().filter(|&&v| grid.locations[v as usize] == Location::On(l));
        if !is_kept(polygon, on_it.map(|&v| grid.places[v as usize])) {
            return Err(PlanError::TooCoarse(l.checked_sub(1)));
        }
    }
    let from_grid = |place: &Point2| {
        let place = [low[0] + place[0] * step[0], low[1] + place[1] * step[1]];
        rotated(place, [c, s])
    };
    Ok(grid.compact(&faces, &corners, from_grid))
}

impl Grid {
    fn new(count: [usize; 2], polygons: Vec<Vec<Point2>>) -> Grid {
        let [nx, ny] = count;
        let places: Vec<Point2> =
            (0..=ny).flat_map(|j| (0..=nx).map(move |i| [i as f64, j as f64])).collect();
        let mut locations = Vec::with_capacity(places.len());
        // The sides are visited once for each row.
        for j in 0..=ny {
            let row: Vec<Vec<f64>> =
                polygons.iter().map(|one| crossings(one, j as f64).collect()).collect();
            locations.extend((0..=nx).map(|i| {
                // As `is_inside`.
                let is_in =
                    |at: &Vec<f64>| at.iter().filter(|at| (i as f64) < **at).count() % 2 == 1;
                match is_in(&row[0]) && !row[1..].iter().any(is_in) {
                    true => Location::Inside,
                    false => Location::Outside,
                }
            }));
        }
        Grid { count, polygons, places, locations, crossings: BTreeMap::new() }
    }

    fn vertex(&self, i: usize, j: usize) -> u32 {
        (j * (self.count[0] + 1) + i) as u32
    }

    /// The grid vertices at most `steps` from the cell that contains `place`.
    fn around(&self, place: Point2, steps: f64) -> impl Iterator<Item = u32> + use<> {
        let [nx, ny] = self.count;
        let range = |x: f64, n: usize| {
            let low = (x.floor() - steps).max(0.0) as usize;
            low..=((x.floor() + 1.0 + steps).max(0.0) as usize).min(n)
        };
        let columns = range(place[0], nx);
        range(place[1], ny)
            .flat_map(move |j| columns.clone().map(move |i| (j * (nx + 1) + i) as u32))
    }

    /// Moves a grid vertex to a corner of the loop `on`: the nearest free one of its cell if it is
    /// near, else preferably one outside, whose faces are cut anyway. None if other corners use
    /// them all.
    fn corner(&mut self, place: Point2, on: usize) -> Option<u32> {
        let far = |&v: &u32| {
            let by = minus(self.places[v as usize], place);
            let is_kept = self.locations[v as usize] != Location::Outside;
            let square = dot(by, by);
            if square > NEAR * NEAR && is_kept { 4.0 + square } else { square }
        };
        let free = self
            .around(place, 0.0)
            .filter(|&v| !matches!(self.locations[v as usize], Location::On(_)));
        let nearest = free.min_by(|a, b| far(a).total_cmp(&far(b)))?;
        self.places[nearest as usize] = place;
        self.locations[nearest as usize] = Location::On(on);
        Some(nearest)
    }

    /// Moves vertices that are near a loop onto it.
    fn snap(&mut self) {
        let mut nearest: BTreeMap<u32, (f64, Point2, usize)> = BTreeMap::new();
        for (l, polygon) in self.polygons.iter().enumerate() {
            for [a, b] in polygon_sides(polygon) {
                let by = minus(b, a);
                // Cell by cell along the segment.
                let pieces = by[0].abs().max(by[1].abs()).ceil().max(1.0);
                for k in 0..pieces as usize {
                    for v in self.around(along(a, (k as f64 + 0.5) / pieces, by), 1.0) {
                        let place = self.places[v as usize];
                        let on = closest([a, b], place);
                        let away = minus(on, place);
                        let square = dot(away, away);
                        let is_nearest = nearest.get(&v).is_none_or(|(least, ..)| square < *least);
                        if square < NEAR * NEAR && is_nearest {
                            nearest.insert(v, (square, on, l));
                        }
                    }
                }
            }
        }
        for (v, (_, place, l)) in nearest {
            if !matches!(self.locations[v as usize], Location::On(_)) {
                self.places[v as usize] = place;
                self.locations[v as usize] = Location::On(l);
            }
        }
    }

    /// Inserts a vertex at each crossing of a loop with a grid edge from inside to outside.
    fn cross(&mut self) {
        let [nx, ny] = self.count;
        let across = (0..=ny).flat_map(|j| (0..nx).map(move |i| ([i, j], [i + 1, j])));
        let up = (0..ny).flat_map(|j| (0..=nx).map(move |i| ([i, j], [i, j + 1])));
        let edges: Vec<[u32; 2]> = across
            .chain(up)
            .map(|(a, b)| [a, b].map(|[i, j]| self.vertex(i, j)))
            .filter(|ends| {
                use Location::{Inside, Outside};
                let locations = ends.map(|v| self.locations[v as usize]);
                matches!(locations, [Inside, Outside] | [Outside, Inside])
            })
            .collect();
        for ends in edges {
            let (place, l) = self.crossing(ends);
            self.crossings.insert(ends, self.places.len() as u32);
            self.places.push(place);
            self.locations.push(Location::On(l));
        }
    }

    /// The crossing of a loop with an edge nearest to its inner end, and the loop.
    fn crossing(&self, ends: [u32; 2]) -> (Point2, usize) {
        let is_turned = self.locations[ends[0] as usize] == Location::Outside;
        let [p, q] = ends.map(|v| self.places[v as usize]);
        let [p, q] = if is_turned { [q, p] } else { [p, q] };
        let by = minus(q, p);
        let mut first = (f64::INFINITY, 0);
        for (l, polygon) in self.polygons.iter().enumerate() {
            for [a, b] in polygon_sides(polygon) {
                let side = minus(b, a);
                let turn = cross(by, side);
                let t = cross(minus(a, p), side) / turn;
                let s = cross(minus(a, p), by) / turn;
                if (0.0..=1.0).contains(&t) && (0.0..=1.0).contains(&s) && t < first.0 {
                    first = (t, l);
                }
            }
        }
        // The ends are on different sides of a loop: only rounding can hide the crossing.
        let t = if first.0.is_finite() { first.0 } else { 0.5 };
        (along(p, t, by), first.1)
    }

    /// The part of each cell inside the outline as a face, counterclockwise.
    fn faces(&self) -> Vec<Vec<u32>> {
        let [nx, ny] = self.count;
        let mut faces = Vec::new();
        for j in 0..ny {
            for i in 0..nx {
                let cell = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
                let cell = cell.map(|[i, j]| self.vertex(i, j));
                let mut face = Vec::new();
                for [a, b] in polygon_sides(&cell) {
                    if self.locations[a as usize] != Location::Outside {
                        face.push(a);
                    }
                    face.extend(self.crossings.get(&[a.min(b), a.max(b)]));
                }
                if face.len() > 2 {
                    self.push_face(&mut faces, face);
                }
            }
        }
        faces
    }

    fn area(&self, face: &[u32]) -> f64 {
        let places: Vec<Point2> = face.iter().map(|&v| self.places[v as usize]).collect();
        area(&places)
    }

    /// Adds the face of a cell: none if it lies outside, two if only two opposite corners are
    /// inside.
    fn push_face(&self, faces: &mut Vec<Vec<u32>>, face: Vec<u32>) {
        let share = 1.0 / face.len() as f64;
        let places = face.iter().map(|&v| self.places[v as usize]);
        let middle = places.fold([0.0; 2], |sum, place| along(sum, share, place));
        let is_middle_in = || {
            is_inside(&self.polygons[0], middle)
                && !self.polygons[1..].iter().any(|hole| is_inside(hole, middle))
        };
        let inner: Vec<usize> = (0..face.len())
            .filter(|&k| self.locations[face[k] as usize] == Location::Inside)
            .collect();
        if inner.is_empty() {
            if is_middle_in() && self.area(&face) > SLIVER {
                faces.push(face);
            }
        } else if face.len() == 6 && inner.len() == 2 && !is_middle_in() {
            let at = |k: usize| face[k % 6];
            faces.extend(inner.iter().map(|&k| vec![at(k + 5), at(k), at(k + 1)]));
        } else {
            faces.push(face);
        }
    }

    /// The surface, with only the vertices that faces use, in plan coordinates.
    fn compact(
        &self,
        faces: &[Vec<u32>],
        corners: &[(u32, Option<usize>)],
        from_grid: impl Fn(&Point2) -> Point2,
    ) -> FlatPlan {
        let mut name = vec![u32::MAX; self.places.len()];
        faces.iter().flatten().for_each(|&v| name[v as usize] = 0);
        let mut positions = Vec::new();
        for (name, place) in name.iter_mut().zip(&self.places).filter(|(name, _)| **name == 0) {
            *name = positions.len() as u32;
            let [x, y] = from_grid(place);
            positions.push([x, y, 0.0]);
        }
        let mut named = Ragged::from_iter(faces);
        named.rename(&name);
        let used_on = |on: Location| {
            (0..name.len())
                .filter(move |&v| self.locations[v] == on)
                .filter(|&v| name[v] != u32::MAX)
        };
        // A tip without a face is cut off: its foot is where the rest of the loop is nearest.
        let foot = |&(corner, hole): &(u32, Option<usize>)| {
            let corner = corner as usize;
            let away = |v: &usize| distance(self.places[*v], self.places[corner]);
            let nearest =
                used_on(self.locations[corner]).min_by(|a, b| away(a).total_cmp(&away(b)));
            nearest.map(|v| (name[v], hole))
        };
        FlatPlan {
            outline: used_on(Location::On(0)).map(|v| name[v]).collect(),
            corners: corners.iter().filter_map(foot).collect(),
            mesh: Mesh { positions, faces: named, ..Mesh::default() },
        }
    }
}
