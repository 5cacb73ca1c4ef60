//! Whether a surface that is cut from a grid has kept a loop, or closed it where it is narrow.

use super::outline::along;
use crate::math::plane::{Point2, dot, minus};
use crate::math::{Cells, Vec3, polygon_sides};
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
    let in_space = |[x, y]: Point2| Vec3::new(x, y, 0.0);
    let mut vertices = Cells::new(NEAR);
    on_it.for_each(|place| vertices.add(in_space(place), ()));
    let has_near =
        |place: Point2| vertices.near(in_space(place)).any(|(_, distance)| distance <= NEAR);
    let walk = Walk::new(polygon);
    let tips = walk.tips();
    let mut so_far = 0.0;
    polygon_sides(polygon).all(|[a, b]| {
        let by = minus(b, a);
        let length = dot(by, by).sqrt();
        let pieces = (length / STEP).ceil().max(1.0);
        let begins = so_far;
        so_far += length;
        (0..pieces as usize).all(|k| {
            let part = k as f64 / pieces;
            let is_in_tip = tips.iter().any(|&(tip, reach)| {
                let away = (begins + part * length - tip).abs();
                away.min(walk.length - away) < reach
            });
            is_in_tip || has_near(along(a, part, by))
        })
    })
}

/// A loop, by the length of the way from its first corner.
struct Walk<'a> {
    polygon: &'a [Point2],
    /// The length at each corner.
    at_corner: Vec<f64>,
    length: f64,
}

impl<'a> Walk<'a> {
    fn new(polygon: &'a [Point2]) -> Walk<'a> {
        let mut length = 0.0;
        let at_corner = polygon_sides(polygon)
            .map(|[a, b]| {
                let (begins, by) = (length, minus(b, a));
                length += dot(by, by).sqrt();
                begins
            })
            .collect();
        Walk { polygon, at_corner, length }
    }

    /// The point after a length, which may be negative.
    fn at(&self, length: f64) -> Point2 {
        let length = length.rem_euclid(self.length);
        let k = self.at_corner.partition_point(|&at| at <= length).max(1) - 1;
        let [a, b] = [0, 1].map(|next| self.polygon[(k + next) % self.polygon.len()]);
        let end = self.at_corner.get(k + 1).copied().unwrap_or(self.length);
        let side = end - self.at_corner[k];
        let part = if side > 0.0 { (length - self.at_corner[k]) / side } else { 0.0 };
        along(a, part, minus(b, a))
    }

    /// The tips, and how far from each the loop is nearer to itself than a cell is wide. What is so
    /// narrow up to where its flanks end is no tip: smaller cells would keep it.
    fn tips(&self) -> Vec<(f64, f64)> {
        let n = self.polygon.len();
        let is_tip = |&k: &usize| {
            let corner = self.polygon[k];
            let [before, after] = [k + n - 1, k + 1].map(|j| minus(self.polygon[j % n], corner));
            let lengths = (dot(before, before) * dot(after, after)).sqrt();
            lengths > 0.0 && dot(before, after) > TIP * lengths
        };
        let reach = |k: usize| {
            let tip = self.at_corner[k];
            let step = |way: f64, by: f64| minus(self.at(tip + way + by), self.at(tip + way));
            let has_turned = |way: f64, by: f64| {
                let (first, last) = (step(0.0, by), step(way, by));
                dot(first, last) < TIP * (dot(first, first) * dot(last, last)).sqrt()
            };
            let mut way = 0.0;
            loop {
                let is_over =
                    way > 0.5 * self.length || has_turned(way, STEP) || has_turned(-way, -STEP);
                if is_over {
                    return None;
                }
                way += STEP;
                let between = minus(self.at(tip + way), self.at(tip - way));
                if dot(between, between) >= 1.0 {
                    return Some((tip, way));
                }
            }
        };
        (0..n).filter(is_tip).filter_map(reach).collect()
    }
}
