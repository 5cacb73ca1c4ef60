//! Whether a surface that is cut from a grid has kept a loop, or closed it where it is narrow.

use crate::math::plane::Point2;
use crate::math::{Cells, Vec3, polygon_sides};
use crate::mesh::{Point, Polyline};
use std::collections::BTreeSet;

/// A loop is kept if each of its points is nearer than this to a vertex of the boundary on it, in sides
/// of a cell. Where it passes through a cell alone, it has one on the sides of the cell.
const NEAR: f64 = 1.75;
/// A corner of less than 30 degrees, between flanks that turn by less than that until they are a cell
/// apart, is a tip: it may be cut off, or filled, so far, since no cell is small enough for it. This is
/// the cosine.
const TIP: f64 = 0.866;
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
    let in_space = |[x, y]: Point2| [x, y, 0.0];
    let mut vertices = Cells::new(NEAR);
    on_it.for_each(|place| vertices.add(in_space(place).into(), ()));
    let has_near = |point: Point| vertices.near(point.into()).any(|(_, distance)| distance <= NEAR);
    let ring = polygon.iter().chain(polygon.first());
    let walk = Polyline::new(ring.map(|&place| in_space(place)), true);
    let whole = walk.length_to(polygon.len());
    let tips = tips(&walk, polygon.len());
    (0..polygon.len()).all(|k| {
        let [begins, ends] = [k, k + 1].map(|k| walk.length_to(k));
        let pieces = ((ends - begins) / STEP).ceil().max(1.0);
        (0..pieces as usize).all(|piece| {
            let at = begins + piece as f64 / pieces * (ends - begins);
            let is_in_tip = tips.iter().any(|&(tip, reach)| {
                let away = (at - tip).abs();
                away.min(whole - away) < reach
            });
            is_in_tip || has_near(walk.point(at))
        })
    })
}

/// The tips of a loop of `n` corners, as lengths along it, and how far from each the loop is nearer to itself
/// than a cell is wide. What is so narrow up to where its flanks end is no tip: smaller cells would keep it.
fn tips(walk: &Polyline, n: usize) -> Vec<(f64, f64)> {
    let at = |length: f64| Vec3::from(walk.point(length));
    let cosine =
        |a: Vec3<f64>, b: Vec3<f64>| a.dot(b) / (a.length_squared() * b.length_squared()).sqrt();
    let is_tip = |&k: &usize| {
        let [before, corner, after] = [k + n - 1, k, k + 1].map(|j| at(walk.length_to(j % n)));
        cosine(before - corner, after - corner) > TIP
    };
    let reach = |k: usize| {
        let tip = walk.length_to(k);
        let step = |way: f64, by: f64| at(tip + way + by) - at(tip + way);
        let has_turned = |way: f64, by: f64| cosine(step(0.0, by), step(way, by)) < TIP;
        let mut way = 0.0;
        loop {
            let is_over =
                way > 0.5 * walk.length_to(n) || has_turned(way, STEP) || has_turned(-way, -STEP);
            if is_over {
                return None;
            }
            way += STEP;
            if (at(tip + way) - at(tip - way)).length_squared() >= 1.0 {
                return Some((tip, way));
            }
        }
    };
    (0..n).filter(is_tip).filter_map(reach).collect()
}
