//! A plan as it is drawn while somebody edits it: its sides, and the changes that a host makes by
//! dragging or typing.

use super::declaration::{Plan, PlanLayout, PlanPoint, Support};
use super::outline::{SHARP, Side, along};
use crate::math::cosine_and_sine_of_degrees;
use crate::math::plane::{Point2, area, bounds, cross, dot, minus};
use serde::{Deserialize, Serialize};

/// The roof of the first plan in metres: the corners, each with the bulge of the side that begins
/// there.
const FIRST: [(Point2, f64); 4] =
    [([0.0, 0.0], 0.2), ([20.0, 0.0], 0.0), ([20.0, 12.0], 0.0), ([0.0, 12.0], 0.0)];

/// The loops of a plan: the outline, then the holes.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PlanLoops(pub Vec<Vec<PlanPoint>>);

/// The loops of a plan, as they are drawn.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PlanDrawing {
    /// The sides of each loop; side `k` runs from point `k` to the next one.
    pub loops: Vec<Vec<DrawnSide>>,
    /// The least coordinates of the points and of the midpoints of the sides.
    pub low: Point2,
    /// The greatest coordinates.
    pub high: Point2,
}

/// A side of a plan, as it is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
pub struct DrawnSide {
    /// The length of its chord; 1 if its ends are at one place.
    pub chord: f64,
    /// How far its middle is outside its chord; negative if it bulges inwards.
    pub rise: f64,
    /// Its middle.
    pub middle: Point2,
    /// The radius of its arc; none if it is straight.
    pub radius: Option<f64>,
    /// Whether its arc runs clockwise, seen from above.
    pub clockwise: bool,
}

/// Whether the points run clockwise. Two points, joined by arcs only, do not.
fn is_clockwise(points: &[PlanPoint]) -> bool {
    let places: Vec<Point2> = points.iter().map(|point| point.at).collect();
    area(&places) < 0.0
}

/// The side of a loop that begins at point `k`, with the loop on its left; none if there is no such
/// point.
fn side(points: &[PlanPoint], k: usize, is_clockwise: bool) -> Option<Side> {
    let PlanPoint { at, bulge, corner: is_corner } = *points.get(k)?;
    let next = points[(k + 1) % points.len()].at;
    let [from, to] = if is_clockwise { [next, at] } else { [at, next] };
    Some(Side { from, to, bulge, point: k, is_corner })
}

impl DrawnSide {
    fn of(side: &Side, is_clockwise: bool) -> DrawnSide {
        let rise = 0.5 * side.bulge * side.chord();
        DrawnSide {
            chord: side.chord(),
            rise,
            middle: side.beside(rise),
            radius: (!side.is_straight()).then(|| side.radius().abs()),
            clockwise: (side.bulge > 0.0) == is_clockwise,
        }
    }
}

impl PlanDrawing {
    /// Returns the sides of the loops, and their extent.
    pub fn of(PlanLoops(loops): &PlanLoops) -> PlanDrawing {
        let sides = |points: &Vec<PlanPoint>| -> Vec<DrawnSide> {
            let is_clockwise = is_clockwise(points);
            let sides = (0..points.len()).filter_map(|k| side(points, k, is_clockwise));
            sides.map(|side| DrawnSide::of(&side, is_clockwise)).collect()
        };
        let drawn: Vec<Vec<DrawnSide>> = loops.iter().map(sides).collect();
        let middles = drawn.iter().flatten().map(|side| side.middle);
        let [low, high] = bounds(loops.iter().flatten().map(|point| point.at).chain(middles));
        PlanDrawing { loops: drawn, low, high }
    }
}

/// Returns the bulge of the side of a loop that begins at point `k` if its middle is pulled to the
/// place nearest to `through`; none if there is no such point.
pub fn bulge_through(points: &[PlanPoint], k: usize, through: Point2) -> Option<f64> {
    let side = side(points, k, is_clockwise(points))?;
    let rise = dot(minus(through, side.beside(0.0)), side.outward());
    Some(bulge_of(rise, side.chord()))
}

/// Returns the bulge of a side by its rise, limited to a half circle.
pub fn bulge_of(rise: f64, chord: f64) -> f64 {
    (2.0 * rise / chord).clamp(-1.0, 1.0)
}

/// Returns where the side that begins at point `k` ends if its chord gets another `length` in the same
/// direction; none if there is no such point, or for no length above 0.
pub fn end_of_side(points: &[PlanPoint], k: usize, length: f64) -> Option<Point2> {
    let side = side(points, k, false)?;
    let share = length / side.chord();
    (share > 0.0).then(|| along(side.from, share, minus(side.to, side.from)))
}

/// Returns a drawn loop, made counterclockwise, with straight sides. With `has_corners`, its sharp
/// convex turns become corners.
pub fn loop_through(places: &[Point2], has_corners: bool) -> Vec<PlanPoint> {
    let mut around = places.to_vec();
    if area(places) < 0.0 {
        around.reverse();
    }
    let n = around.len();
    let [cosine, sine] = cosine_and_sine_of_degrees(SHARP);
    let is_sharp = |k: usize| {
        let [before, here, after] = [around[(k + n - 1) % n], around[k], around[(k + 1) % n]];
        let (incoming, outgoing) = (minus(here, before), minus(after, here));
        // The cosine and the sine of the turn, up to a factor: it is to the left, and by more.
        let turn = [dot(incoming, outgoing), cross(incoming, outgoing)];
        turn[1] >= 0.0 && cosine * turn[1] > sine * turn[0]
    };
    (0..n)
        .map(|k| PlanPoint { at: around[k], bulge: 0.0, corner: has_corners && is_sharp(k) })
        .collect()
}

impl Plan {
    /// The plan to start with: a roof of 20 by 12 m with one arched side. `metre` is in its unit.
    pub fn first(metre: f64) -> Plan {
        let point = |(at, bulge): (Point2, f64)| PlanPoint { at, bulge, corner: true };
        let plan = Plan {
            outline: FIRST.map(point).to_vec(),
            holes: Vec::new(),
            layout: PlanLayout::Follow,
            size: 1.25,
            turn: 0.0,
            height: 5.0,
            support: Support::Corners,
        };
        plan.scaled(metre)
    }

    /// The same plan with all lengths multiplied by `factor`.
    pub fn scaled(mut self, factor: f64) -> Plan {
        for point in self.outline.iter_mut().chain(self.holes.iter_mut().flatten()) {
            point.at = point.at.map(|x| factor * x);
        }
        self.size *= factor;
        self.height *= factor;
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [Point2; 4] = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];

    fn points(places: &[Point2], bulge: impl Fn(usize) -> f64) -> Vec<PlanPoint> {
        let point = |(k, &at)| PlanPoint { at, bulge: bulge(k), corner: false };
        places.iter().enumerate().map(point).collect()
    }

    fn drawn(points: Vec<PlanPoint>) -> PlanDrawing {
        PlanDrawing::of(&PlanLoops(vec![points]))
    }

    #[test]
    fn an_arc_rises_outward_in_either_direction_of_the_loop() {
        let reversed: Vec<Point2> = SQUARE.iter().rev().copied().collect();
        for places in [SQUARE.to_vec(), reversed] {
            let points = points(&places, |_| 0.5);
            let drawing = drawn(points.clone());
            for (k, side) in drawing.loops[0].iter().enumerate() {
                assert_eq!(side.rise, 1.0);
                assert!(side.middle.iter().any(|&x| x == -1.0 || x == 5.0), "{side:?}");
                assert_eq!(bulge_through(&points, k, side.middle), Some(0.5));
                assert_eq!(bulge_through(&points, k, [2.0, 2.0]), Some(-1.0));
            }
            assert_eq!((drawing.low, drawing.high), ([-1.0; 2], [5.0; 2]));
        }
        assert_eq!(bulge_through(&points(&SQUARE, |_| 0.0), 4, [0.0; 2]), None);
    }

    #[test]
    fn a_half_circle_lies_on_the_outer_side_of_its_chord() {
        let first = |bulge| drawn(points(&SQUARE, |k| if k == 0 { bulge } else { 0.0 }));
        let outward = first(1.0).loops[0][0];
        // Below the square, from left to right: counterclockwise.
        assert_eq!((outward.radius, outward.clockwise), (Some(2.0), false));
        let inward = first(-1.0).loops[0][0];
        assert_eq!((inward.radius, inward.clockwise), (Some(2.0), true));
        assert_eq!(first(1.0).loops[0][1].radius, None, "a straight side has none");
    }

    #[test]
    fn a_drawn_loop_is_made_counterclockwise_and_its_sharp_convex_turns_become_corners() {
        let letter_l = [[0.0, 0.0], [0.0, 4.0], [2.0, 4.0], [2.0, 2.0], [4.0, 2.0], [4.0, 0.0]];
        let found = loop_through(&letter_l, true);
        let places: Vec<Point2> = found.iter().map(|point| point.at).collect();
        assert!(places.iter().eq(letter_l.iter().rev()));
        let inner: Vec<Point2> =
            found.iter().filter(|point| !point.corner).map(|point| point.at).collect();
        assert_eq!(inner, [[2.0, 2.0]]);
        assert!(loop_through(&letter_l, false).iter().all(|point| !point.corner));
        // Turns of 15 degrees are no corners, those of 45 are.
        let polygon = |n: u32| {
            let corner = |k: u32| cosine_and_sine_of_degrees(f64::from(360 * k / n));
            loop_through(&(0..n).map(corner).collect::<Vec<_>>(), true)
        };
        assert!(polygon(24).iter().all(|point| !point.corner));
        assert!(polygon(8).iter().all(|point| point.corner));
    }

    #[test]
    fn a_side_is_made_longer_at_its_end() {
        let points = points(&SQUARE, |_| 0.0);
        assert_eq!(end_of_side(&points, 0, 6.0), Some([6.0, 0.0]));
        assert_eq!(end_of_side(&points, 3, 1.0), Some([0.0, 3.0]));
        for nothing in [0.0, -1.0, f64::NAN] {
            assert_eq!(end_of_side(&points, 0, nothing), None);
        }
        assert_eq!([bulge_of(1.0, 4.0), bulge_of(-9.0, 4.0)], [0.5, -1.0]);
    }

    #[test]
    fn the_first_plan_is_a_roof_in_any_unit() {
        let [metres, millimetres] = [1.0, 1000.0].map(Plan::first);
        assert_eq!(millimetres, metres.clone().scaled(1000.0));
        assert_eq!(millimetres.outline[2].at, [20_000.0, 12_000.0]);
        assert!(metres.mesh().is_ok() && millimetres.mesh().is_ok());
    }
}
