//! Whether a surface that is cut from a grid has kept a loop, or closed it where it is narrow.

use super::outline::along;
use crate::math::plane::{Point2, dot, minus};
use crate::math::polygon_sides;
use std::collections::{BTreeMap, BTreeSet};

/// A loop is kept if each of its points is nearer than this to a vertex of the boundary on it, in sides
/// of a cell. Where it passes through a cell, it has one on the sides of the cell.
const NEAR: f64 = 1.75;
/// Distance of the points of a loop that are tried.
const STEP: f64 = 0.5;

/// The vertices at the boundary of some faces, where neighbours traverse a side in opposite directions.
pub(super) fn boundary(faces: &[Vec<u32>]) -> BTreeSet<u32> {
    let sides = || faces.iter().flat_map(|face| polygon_sides(face));
    let all: BTreeSet<[u32; 2]> = sides().collect();
    sides().filter(|&[a, b]| !all.contains(&[b, a])).flatten().collect()
}

/// Whether a loop is kept by a surface with these boundary vertices on it; cells have side 1.
pub(super) fn is_kept(polygon: &[Point2], on_it: impl Iterator<Item = Point2>) -> bool {
    let cell = |[x, y]: Point2| [x.floor() as i64, y.floor() as i64];
    let mut cells: BTreeMap<[i64; 2], Vec<Point2>> = BTreeMap::new();
    on_it.for_each(|place| cells.entry(cell(place)).or_default().push(place));
    let reach = NEAR.ceil() as i64;
    let has_near = |place: Point2| {
        let [x, y] = cell(place);
        let around = (x - reach..=x + reach)
            .flat_map(|x| (y - reach..=y + reach).map(move |y| [x, y]))
            .filter_map(|cell| cells.get(&cell));
        around.flatten().any(|&vertex| {
            let away = minus(vertex, place);
            dot(away, away) <= NEAR * NEAR
        })
    };
    polygon_sides(polygon).all(|[a, b]| {
        let by = minus(b, a);
        let pieces = (dot(by, by).sqrt() / STEP).ceil().max(1.0);
        (0..pieces as usize).all(|k| has_near(along(a, k as f64 / pieces, by)))
    })
}
