//! Closed loops of straight and arc sides, and the panels inside.

use super::declaration::{PlanError, PlanPoint, PlanSide, check};
use crate::math::plane::{Point2, area, cross, dot, is_inside, length, minus, rotated};
use crate::math::{angle, cosine, polygon_sides, sine};
use crate::mesh::Mesh;
use std::f64::consts::TAU;

/// Sides with a smaller bulge are straight.
const STRAIGHT: f64 = 1e-6;
/// The smallest turn at a sharp corner, in degrees.
pub(super) const SHARP: f64 = 20.0;

/// A side: straight, or an arc.
#[derive(Clone, Copy, Debug)]
pub(super) struct Side {
    pub(super) from: Point2,
    pub(super) to: Point2,
    pub(super) bulge: f64,
    /// The index of its first point in the given order.
    pub(super) point: usize,
    /// Whether its first point is marked as a corner.
    pub(super) is_corner: bool,
}

/// A loop, counterclockwise.
#[derive(Clone, Debug)]
pub(super) struct Loop {
    pub(super) sides: Vec<Side>,
    hole: Option<usize>,
}

/// A plan divided into panels.
pub(super) struct FlatPlan {
    pub(super) mesh: Mesh,
    /// The vertices on the outline.
    pub(super) outline: Vec<u32>,
    /// The vertices at marked corners; at a tip so narrow that it has no face, the nearest one on the loop.
    /// Each with the hole that it is a corner of, if any.
    pub(super) corners: Vec<(u32, Option<usize>)>,
}

/// `a + t b`.
pub(super) fn along(a: Point2, t: f64, b: Point2) -> Point2 {
    [a[0] + t * b[0], a[1] + t * b[1]]
}

/// The point of a segment that is nearest to `to`.
pub(super) fn closest([a, b]: [Point2; 2], to: Point2) -> Point2 {
    let by = minus(b, a);
    let t = dot(minus(to, a), by) / dot(by, by);
    if t > 0.0 { along(a, t.min(1.0), by) } else { a }
}

impl Side {
    /// The angle that the arc spans, in turns; negative if it bulges inwards.
    fn turns(&self) -> f64 {
        4.0 * self.bulge.signum() * angle(1.0, self.bulge.abs()).unwrap_or(0.0) / TAU
    }

    pub(super) fn is_straight(&self) -> bool {
        self.bulge.abs() < STRAIGHT
    }

    /// The length of its chord; 1 if its ends are at one place, as while it is drawn.
    pub(super) fn chord(&self) -> f64 {
        let chord = length(minus(self.to, self.from));
        if chord > 0.0 { chord } else { 1.0 }
    }

    /// The radius of the arc; negative if it bulges inwards.
    pub(super) fn radius(&self) -> f64 {
        self.chord() * (1.0 + self.bulge * self.bulge) / (4.0 * self.bulge)
    }

    /// The unit vector across its chord, to the right.
    pub(super) fn outward(&self) -> Point2 {
        let [x, y] = minus(self.to, self.from).map(|c| c / self.chord());
        [y, -x]
    }

    /// The point to the right of the middle of its chord by `rise`.
    pub(super) fn beside(&self, rise: f64) -> Point2 {
        let middle = along(self.from, 0.5, minus(self.to, self.from));
        along(middle, rise, self.outward())
    }

    pub(super) fn length(&self) -> f64 {
        if self.is_straight() {
            return self.chord();
        }
        self.radius() * self.turns() * TAU
    }

    /// The area between the arc and its chord; negative if it bulges inwards.
    fn segment_area(&self) -> f64 {
        if self.is_straight() {
            return 0.0;
        }
        let (radius, turns) = (self.radius(), self.turns());
        0.5 * radius * radius * (turns * TAU - sine(turns))
    }

    /// The point at the fraction `t` of its length.
    pub(super) fn at(&self, t: f64) -> Point2 {
        let chord = minus(self.to, self.from);
        if self.is_straight() || t == 0.0 || t == 1.0 {
            return if t == 1.0 { self.to } else { along(self.from, t, chord) };
        }
        let (radius, turns) = (self.radius(), (t - 0.5) * self.turns());
        let outward = self.outward();
        let centre = self.beside(0.5 * self.bulge * self.chord() - radius);
        let place = along(centre, radius * sine(turns), [-outward[1], outward[0]]);
        along(place, radius * cosine(turns), outward)
    }

    /// The unit tangents at its start and its end.
    fn ends(&self) -> [Point2; 2] {
        let [x, y] = self.outward();
        let half = if self.is_straight() { 0.0 } else { 0.5 * self.turns() };
        [-half, half].map(|by| rotated([-y, x], [cosine(by), sine(by)]))
    }

    /// Points of a polyline within `tolerance` of the side, without its end.
    fn flattened(&self, tolerance: f64) -> impl Iterator<Item = Point2> + '_ {
        let pieces = if self.is_straight() {
            1.0
        } else {
            let step = (8.0 * tolerance / self.radius().abs()).sqrt();
            (self.turns().abs() * TAU / step).ceil().clamp(2.0, 400.0)
        };
        (0..pieces as usize).map(move |k| self.at(k as f64 / pieces))
    }
}

impl Loop {
    /// The loop through these points: the outline, or a hole.
    pub(super) fn of(points: &[PlanPoint], hole: Option<usize>) -> Result<Loop, PlanError> {
        check(points, &hole.map_or("outline".into(), |hole| format!("holes[{hole}]")))?;
        let n = points.len();
        let places: Vec<Point2> = points.iter().map(|point| point.at).collect();
        let chords = area(&places);
        let arcs = points.iter().zip(polygon_sides(&places)).map(|(point, [from, to])| {
            Side { from, to, bulge: point.bulge, point: 0, is_corner: false }.segment_area()
        });
        // Bulges are outward of the polygon of the points. Large inward arcs turn the loop around.
        let is_turned = chords.abs() + arcs.sum::<f64>() < 0.0;
        let is_clockwise = (chords < 0.0) != is_turned;
        let side = |k: usize| {
            let (from, to, arc) = match is_clockwise {
                false => (k, (k + 1) % n, k),
                true => (n - 1 - k, (2 * n - 2 - k) % n, (2 * n - 2 - k) % n),
            };
            let [from_point, to_point] = [from, to].map(|v| points[v]);
            Side {
                from: from_point.at,
                to: to_point.at,
                bulge: if is_turned { -points[arc].bulge } else { points[arc].bulge },
                point: arc,
                is_corner: from_point.corner,
            }
        };
        Ok(Loop { sides: (0..n).map(side).collect(), hole })
    }

    /// For each side, whether the loop has a corner at its start: a marked one, or a sharp turn.
    pub(super) fn corner_flags(&self) -> Vec<bool> {
        let n = self.sides.len();
        let most = cosine(SHARP / 360.0);
        let is_sharp = |k: usize| {
            let [before, here] = [&self.sides[(k + n - 1) % n], &self.sides[k]];
            here.is_corner || dot(before.ends()[1], here.ends()[0]) < most
        };
        (0..n).map(is_sharp).collect()
    }

    /// Points of a polyline along the loop, each with its side.
    pub(super) fn flattened(&self, tolerance: f64) -> Vec<(Point2, usize)> {
        let of = |(k, side): (usize, &Side)| -> Vec<_> {
            side.flattened(tolerance).map(|place| (place, k)).collect()
        };
        self.sides.iter().enumerate().flat_map(of).collect()
    }

    /// Fails if loops (the outline first) cross themselves or each other, or a hole is outside the
    /// outline or inside another.
    pub(super) fn check_disjoint(loops: &[&Loop]) -> Result<(), PlanError> {
        let size = loops[0].sides.iter().map(Side::length).sum::<f64>();
        let mut segments = Vec::new();
        for (l, one) in loops.iter().enumerate() {
            let places = one.flattened(1e-4 * size);
            let n = places.len();
            segments.extend(
                (0..n).map(|k| ([places[k].0, places[(k + 1) % n].0], [l, k], (l, places[k].1, n))),
            );
        }
        for (i, (first, [l, k], (_, side, n))) in segments.iter().enumerate() {
            for (second, [m, j], (_, other, _)) in &segments[i + 1..] {
                let is_next = l == m && (k + 1 == *j || (j + 1) % n == *k);
                if !is_next && meet(*first, *second) {
                    let name = |l: usize, side: usize| PlanSide {
                        hole: loops[l].hole,
                        point: loops[l].sides[side].point,
                    };
                    return Err(PlanError::Crossing([name(*l, *side), name(*m, *other)]));
                }
            }
        }
        let polygon = |one: &Loop| -> Vec<Point2> {
            one.flattened(1e-4 * size).into_iter().map(|(place, _)| place).collect()
        };
        let polygons: Vec<Vec<Point2>> = loops.iter().map(|one| polygon(one)).collect();
        for (hole, inner) in loops[1..].iter().enumerate() {
            // No sides cross: a loop is inside another where its first point is.
            let is_in = |outer: &[Point2]| is_inside(outer, inner.sides[0].from);
            if !is_in(&polygons[0]) {
                return Err(PlanError::Outside(hole));
            }
            let mut others = (0..).zip(&polygons[1..]).filter(|(other, _)| *other != hole);
            if let Some((outer, _)) = others.find(|(_, polygon)| is_in(polygon)) {
                return Err(PlanError::Nested([hole, outer]));
            }
        }
        Ok(())
    }
}

/// Whether two segments have a common point.
fn meet([a, b]: [Point2; 2], [c, d]: [Point2; 2]) -> bool {
    let apart = |k: usize| a[k].max(b[k]) < c[k].min(d[k]) || c[k].max(d[k]) < a[k].min(b[k]);
    if apart(0) || apart(1) {
        return false;
    }
    let side = |p: Point2, q: Point2, r: Point2| cross(minus(q, p), minus(r, p));
    side(a, b, c) * side(a, b, d) <= 0.0 && side(c, d, a) * side(c, d, b) <= 0.0
}
