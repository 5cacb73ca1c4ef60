//! Pairs of integer points and lines that rounding has put onto each other: singular vertices on one point,
//! or on the wrong side of a feature. Nothing unfolds a map there; so the integers between them are
//! given before rounding again.

use super::seams::{Seams, turned};
use crate::math::{Vec3, key_of_number, sort_by_number};
use crate::quads::surface::Prepared;
use crate::quads::{Side, Triangulation};
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// Pairs farther apart than this many panels are not looked at.
const REACH: f64 = 1.5;
/// Lines nearer than this many panels are in front of what faces them, whatever the seamless map says.
const NEAR: f64 = 1.0;
/// Others if it puts them at this part of their distance at least.
const IN_FRONT: f64 = 0.25;

/// A sum of free unknowns of the seams, all integers, that must have a value.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Separation {
    pub row: Vec<(u32, f64)>,
    pub value: f64,
    /// The sides of creases on which one of the two lies.
    pub creases: Vec<Side>,
    /// Distance of the two, in the unit of the mesh; near pairs go first.
    distance: f64,
}

/// Where a triangle's coordinates lie in the chart of the first one: turned, then shifted.
#[derive(Clone)]
struct Chart {
    turns: u8,
    shift: [Vec<(u32, f64)>; 2],
}

/// Finds pairs near the `flipped` triangles that `rounded` values put together, although those of the
/// seamless map, `free`, are apart.
pub(super) fn separations(
    prepared: &Prepared,
    seams: &Seams,
    flipped: &[usize],
    free: &[f64],
    rounded: &[f64],
) -> Vec<Separation> {
    let surface = &prepared.surface;
    let reach = REACH * prepared.size;
    let finder = Finder {
        surface,
        seams,
        reach,
        size: prepared.size,
        charts: charts_over_cuts(seams),
        free,
        rounded,
        seen: RefCell::new(vec![false; surface.triangles.len()]),
    };
    let mut found: Vec<Separation> = Vec::new();
    // Integer points within reach of flipped triangles.
    let is_near =
        |at: Vec3<f64>| flipped.iter().any(|&t| (surface.at(t, 0) - at).length() <= reach);
    let mut seen = BTreeSet::new();
    for (t, corners) in surface.triangles.iter().enumerate() {
        for (corner, &v) in corners.iter().enumerate() {
            if finder.is_integer_point(t, corner)
                && seen.insert(v)
                && is_near(surface.at(t, corner))
            {
                finder.of_point(t, corner, &mut found);
            }
        }
    }
    // Lines around flipped triangles, of which one stands for those near it.
    let mut centres: Vec<Vec3<f64>> = Vec::new();
    for &t in flipped {
        let at = surface.at(t, 0);
        if centres.iter().all(|&other| (other - at).length() > 0.5 * prepared.size) {
            centres.push(at);
            finder.of_lines(&finder.near(t, at), &mut found);
        }
    }
    // Both points of a pair find it.
    sort_by_number(&mut found, |one| key_of_number(one.distance));
    let mut unique: Vec<Separation> = Vec::new();
    for one in found {
        let negative: Vec<(u32, f64)> = one.row.iter().map(|&(k, c)| (k, -c)).collect();
        if unique.iter().all(|other| other.row != one.row && other.row != negative) {
            unique.push(one);
        }
    }
    unique
}

/// The shift over each cut side, as sums: the same from both sides.
fn charts_over_cuts(seams: &Seams) -> BTreeMap<Side, Chart> {
    let mut charts = BTreeMap::new();
    for (&[side, back], &turns) in seams.cut.iter().zip(&seams.quarter_turns) {
        for (from, to, turns) in [(side, back, turns), (back, side, (4 - turns) % 4)] {
            // x_from = R^-1 (x_to - t), that is the chart of `to` in that of `from`.
            let inverse = (4 - turns) % 4;
            let shift = [0, 1].map(|axis| {
                let here = seams.corner(from.triangle, from.side, axis).to_vec();
                let (k, sign) = turned(inverse, axis);
                let there = seams.corner(to.triangle, to.side + 1, k);
                sum(&here, there, -sign)
            });
            charts.insert(from, Chart { turns: inverse, shift });
        }
    }
    charts
}

struct Finder<'a> {
    surface: &'a Triangulation,
    seams: &'a Seams,
    reach: f64,
    size: f64,
    charts: BTreeMap<Side, Chart>,
    free: &'a [f64],
    rounded: &'a [f64],
    /// `#T`: marks of a search, none between searches.
    seen: RefCell<Vec<bool>>,
}

impl Finder<'_> {
    /// Triangles within reach of a point, from a triangle on, not over features; with their charts.
    fn near(&self, first: usize, at: Vec3<f64>) -> Vec<(usize, Rc<Chart>)> {
        let start = Chart { turns: 0, shift: [Vec::new(), Vec::new()] };
        let mut found = vec![(first, Rc::new(start))];
        let mut seen = self.seen.borrow_mut();
        seen[first] = true;
        let mut next = 0;
        while next < found.len() {
            let (triangle, chart) = found[next].clone();
            next += 1;
            for side in (0..3).map(|side| Side { triangle, side }) {
                let Some(back) = self.surface.across(side) else { continue };
                let is_near = |k| {
                    let corner = self.surface.at(back.triangle, k);
                    (corner - at).length_squared() <= self.reach * self.reach
                };
                if seen[back.triangle] || self.surface.is_feature(side) || !(0..3).any(is_near) {
                    continue;
                }
                seen[back.triangle] = true;
                let chart = match self.charts.get(&side) {
                    None => Rc::clone(&chart),
                    Some(over) => Rc::new(self.joined(&chart, over)),
                };
                found.push((back.triangle, chart));
            }
        }
        found.iter().for_each(|&(triangle, _)| seen[triangle] = false);
        found
    }

    /// The chart `inner` of a neighbour seen from the first triangle.
    fn joined(&self, outer: &Chart, inner: &Chart) -> Chart {
        let shift = [0, 1].map(|axis| {
            let (k, sign) = turned(outer.turns, axis);
            sum(&outer.shift[axis], &inner.shift[k], sign)
        });
        Chart { turns: (outer.turns + inner.turns) % 4, shift }
    }

    /// A coordinate of a corner in the chart of the first triangle.
    fn coordinate(&self, chart: &Chart, t: usize, corner: usize, axis: usize) -> Vec<(u32, f64)> {
        let (k, sign) = turned(chart.turns, axis);
        sum(&chart.shift[axis], self.seams.corner(t, corner, k), sign)
    }

    fn is_integer(&self, row: &[(u32, f64)]) -> bool {
        row.iter().all(|&(k, _)| self.seams.is_integer[k as usize])
    }

    /// Whether both coordinates of a corner are integers.
    fn is_integer_point(&self, t: usize, corner: usize) -> bool {
        (0..2).all(|axis| self.is_integer(self.seams.corner(t, corner, axis)))
    }

    /// Finds the points and lines that are rounded onto an integer point.
    fn of_point(&self, t: usize, corner: usize, found: &mut Vec<Separation>) {
        let at = self.surface.at(t, corner);
        let vertex = self.surface.triangles[t][corner];
        let own = [0, 1].map(|axis| self.seams.corner(t, corner, axis));
        let near = self.near(t, at);
        for &(near, ref chart) in &near {
            for k in (0..3).filter(|&k| self.surface.triangles[near][k] != vertex) {
                let distance = (self.surface.at(near, k) - at).length();
                if distance > self.reach || !self.is_integer_point(near, k) {
                    continue;
                }
                let apart =
                    [0, 1].map(|axis| sum(&self.coordinate(chart, near, k, axis), own[axis], -1.0));
                let [u, v] = [0, 1].map(|axis| value(&apart[axis], self.free));
                if apart.iter().any(|row| value(row, self.rounded).abs() > 0.5) {
                    continue;
                }
                let first = usize::from(v.abs() > u.abs());
                let axis = if apart[first].is_empty() { 1 - first } else { first };
                let row = apart[axis].clone();
                if !row.is_empty() {
                    let value = value(&row, self.free).signum();
                    found.push(Separation { row, value, creases: Vec::new(), distance });
                }
            }
        }
        for line in self.lines(&near) {
            let (distance, end) = distance_to_segment(at, line.ends);
            let apart = sum(own[line.axis], &line.row, -1.0);
            if self.faces(&line, end, at) {
                self.add_ahead(apart, line.inward, distance, &[line.side], found);
            }
        }
    }

    /// Finds pairs of lines that face each other.
    fn of_lines(&self, near: &[(usize, Rc<Chart>)], found: &mut Vec<Separation>) {
        let lines = self.lines(near);
        for (k, a) in lines.iter().enumerate() {
            for b in &lines[..k] {
                if a.axis != b.axis || a.inward != -b.inward || a.row == b.row {
                    continue;
                }
                let middle = (b.ends[0] + b.ends[1]) * 0.5;
                let (distance, end) = distance_to_segment(middle, a.ends);
                if self.faces(a, end, middle) {
                    let apart = sum(&b.row, &a.row, -1.0);
                    self.add_ahead(apart, a.inward, distance, &[a.side, b.side], found);
                }
            }
        }
    }

    /// The feature sides of triangles, as lines of the chart.
    fn lines(&self, near: &[(usize, Rc<Chart>)]) -> Vec<FeatureLine> {
        let mut lines = Vec::new();
        for (triangle, chart) in near {
            for side in (0..3).map(|side| Side { triangle: *triangle, side }) {
                let Some(run) = self.seams.runs[side.triangle][side.side] else { continue };
                // The surface lies to the left of its sides.
                let [x, y] = turned_unit((run + 1 + chart.turns) % 4);
                let (axis, inward) = if x == 0.0 { (1, y) } else { (0, x) };
                let row = self.coordinate(chart, side.triangle, side.side, axis);
                if self.is_integer(&row) {
                    let ends =
                        [side.side, side.side + 1].map(|k| self.surface.at(side.triangle, k));
                    lines.push(FeatureLine { side, axis, inward, row, ends });
                }
            }
        }
        lines
    }

    /// Whether a point lies in front of a line, its foot being at one of the ends of the line, or
    /// between them. The line goes on beyond an end unless it has a corner there. What lies behind it
    /// is seen around a hole.
    fn faces(&self, line: &FeatureLine, end: Option<usize>, at: Vec3<f64>) -> bool {
        let Side { triangle, side } = line.side;
        let [a, b] = line.ends;
        let along = b - a;
        let inside = self.surface.at(triangle, side + 2) - a;
        let inside = inside * along.length_squared() - along * along.dot(inside);
        (at - a).dot(inside) > 0.0
            && end.is_none_or(|end| !self.is_integer_point(triangle, side + end))
    }

    /// Adds that `apart` must be on the side `inward` of zero, if it is not.
    fn add_ahead(
        &self,
        apart: Vec<(u32, f64)>,
        inward: f64,
        distance: f64,
        sides: &[Side],
        found: &mut Vec<Separation>,
    ) {
        let behind = value(&apart, self.rounded) * inward < 0.5;
        let ahead = value(&apart, self.free) * inward * self.size >= IN_FRONT * distance;
        let is_near = distance <= if ahead { REACH } else { NEAR } * self.size;
        if behind && is_near && !apart.is_empty() && self.is_integer(&apart) {
            let is_crease = |side: &&Side| self.surface.across(**side).is_some();
            let creases = sides.iter().filter(is_crease).copied().collect();
            found.push(Separation { row: apart, value: inward, creases, distance });
        }
    }
}

/// A feature side in a chart: the coordinate `axis` is the sum `row` on it, and the surface lies in
/// the direction `inward` along that axis.
struct FeatureLine {
    side: Side,
    axis: usize,
    inward: f64,
    row: Vec<(u32, f64)>,
    ends: [Vec3<f64>; 2],
}

/// The first axis turned by quarters.
fn turned_unit(quarter_turns: u8) -> [f64; 2] {
    [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]][quarter_turns as usize]
}

/// The sum `a + factor b` of two sums, all ascending by unknown.
fn sum(a: &[(u32, f64)], b: &[(u32, f64)], factor: f64) -> Vec<(u32, f64)> {
    let mut terms = Vec::with_capacity(a.len() + b.len());
    let (mut i, mut j) = (0, 0);
    while i < a.len() || j < b.len() {
        let [first, second] = [a.get(i), b.get(j)].map(|term| term.map_or(u32::MAX, |one| one.0));
        let mut coefficient = 0.0;
        if first <= second {
            coefficient += a[i].1;
            i += 1;
        }
        if second <= first {
            coefficient += factor * b[j].1;
            j += 1;
        }
        if coefficient != 0.0 {
            terms.push((first.min(second), coefficient));
        }
    }
    terms
}

fn value(row: &[(u32, f64)], values: &[f64]) -> f64 {
    row.iter().map(|&(k, c)| c * values[k as usize]).sum()
}

/// The distance of a point from a segment, and the end at which its foot lies, if it does.
fn distance_to_segment(p: Vec3<f64>, [a, b]: [Vec3<f64>; 2]) -> (f64, Option<usize>) {
    let along = b - a;
    let t = (p - a).dot(along) / along.length_squared().max(f64::MIN_POSITIVE);
    let end = if t < 0.01 {
        Some(0)
    } else if t > 0.99 {
        Some(1)
    } else {
        None
    };
    ((a + along * t.clamp(0.0, 1.0) - p).length(), end)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_cancel() {
        assert_eq!(
            sum(&[(1, 1.0), (4, -2.0)], &[(1, 1.0), (2, 1.0)], -1.0),
            [(2, -1.0), (4, -2.0)]
        );
    }
}
