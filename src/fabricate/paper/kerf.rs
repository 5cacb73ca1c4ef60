//! The line that is cut around a piece, half the kerf outside its outline, so that what is left is as large
//! as it should be.
//!
//! A piece has slits, and it may touch itself: outlines that are moved by the same distance everywhere would
//! cross each other there. A point of the outline is therefore moved outwards, at right angles to its side,
//! by half the kerf `h` or by the radius of the largest disc that touches it from outside and has nothing of
//! the outline inside, whichever is less. In a gap narrower than the kerf both sides are then cut by one
//! line along its middle, as often as the outline passes there (lines that are passed twice are cut once:
//! [`crate::fabricate::file`]); that cut takes from both sides what the gap is too narrow for. Corners are
//! mitred, as those of panels are. A slit whose sides enclose the angle `2 a` is followed until the cut
//! reaches its end, `h` before it, unless the material that is left there otherwise, `h (1/sin a - 1)`, is
//! too little to matter.

use super::touching::{Contact, Outline, ROUNDING, SAME, Side, TOUCHING};
use crate::fabricate::panel::direction_of;
use crate::math::plane::{Point2, bounds, cross, distance, dot, minus, rotated};
use crate::math::{cosine, key_of_number, sine, sort_by_number};

/// Mitres end within this many halves of the kerf from their corner; sharper ones are cut off.
const LONGEST: f64 = 2.5;
/// Less material than this, in mm, may be left at the end of a slit.
const LEFT: f64 = 0.1;
/// Steps around a corner without room for its mitre, in radians.
const STEP: f64 = 0.25;

/// How far the line that is cut may be outside the outline, in mm.
pub(in crate::fabricate) fn reach(kerf: f64) -> f64 {
    0.5 * LONGEST * kerf
}

/// The line that is cut around a counterclockwise outline, which may touch itself, with a cut that is
/// `kerf` mm wide.
pub(in crate::fabricate) fn cut_line(outline: &[Point2], kerf: f64) -> Vec<Point2> {
    if kerf <= 0.0 || outline.len() < 3 {
        return outline.to_vec();
    }
    let mut line = Line::new(Outline::new(outline), 0.5 * kerf);
    for k in 0..line.outline.sides.len() {
        line.move_side(k);
        line.move_corner(k);
    }
    line.into_points()
}

struct Line {
    outline: Outline,
    half: f64,
    /// The points of each side, with how far along it they are.
    of_sides: Vec<Vec<(f64, Point2)>>,
    /// The points around the start of each side, with their direction from there as an angle.
    of_corners: Vec<Vec<(f64, Point2)>>,
}

impl Line {
    fn new(outline: Outline, half: f64) -> Line {
        let none = vec![Vec::new(); outline.sides.len()];
        Line { outline, half, of_sides: none.clone(), of_corners: none }
    }

    fn add_at_corner(&mut self, k: usize, point: Point2) {
        let Outline { sides, .. } = &self.outline;
        let (from, to) = (sides[self.outline.before(k)].outwards, minus(point, sides[k].start));
        let angle = libm::atan2(cross(from, to), dot(from, to));
        self.of_corners[k].push((angle, point));
    }

    /// Adds the centre of a disc to the other side that it touches, or to a corner.
    fn add_contact(&mut self, centre: Point2, contact: Option<Contact>) {
        let Some((v, along)) = contact else { return };
        let corner = match along {
            0.0 => Some(v),
            along if along == self.outline.sides[v].length => Some(self.outline.after(v)),
            _ => None,
        };
        match corner.filter(|&k| !self.outline.is_concave(k)) {
            Some(k) => self.add_at_corner(k, centre),
            None => self.of_sides[v].push((along, centre)),
        }
    }

    /// Adds the point beside a place on a side.
    fn add_beside(&mut self, k: usize, along: f64) {
        let side = &self.outline.sides[k];
        let (base, way) = (side.at(along), side.outwards);
        let (by, contact) = self.outline.disc(base, way, &self.outline.own(k), self.half);
        let centre = [0, 1].map(|x| base[x] + by * way[x]);
        self.of_sides[k].push((along, centre));
        self.add_contact(centre, contact);
    }

    /// Adds the points beside a side: where it begins and ends, and where what is nearest to it changes.
    fn move_side(&mut self, k: usize) {
        let half = self.half;
        let side = &self.outline.sides[k];
        let ends = [k, self.outline.after(k)];
        let is_concave = ends.map(|k| self.outline.is_concave(k));
        // At the end of a slit the cut reaches it from half the kerf before it.
        let [from, to] = [0, 1].map(|end| match is_concave[end] {
            true => {
                let next = &self.outline.sides[[self.outline.before(k), ends[1]][end]];
                half * (0.5 * (1.0 - dot(side.along, next.along))).max(0.0).sqrt()
            }
            false => 0.0,
        });
        let mut places: Vec<f64> = match from + to < side.length {
            true => self.changes(k),
            false => Vec::new(),
        };
        let range = match from + to < side.length {
            true => [from, side.length - to],
            // Too short for both: where they meet.
            false => [side.length * from / (from + to); 2],
        };
        places.retain(|&along| along > range[0] && along < range[1]);
        places.extend((0..2).filter(|&end| is_concave[end]).map(|end| range[end]));
        places.into_iter().for_each(|along| self.add_beside(k, along));
    }

    /// The places along a side where the distance to its cut may change otherwise than evenly.
    fn changes(&self, k: usize) -> Vec<f64> {
        /// To either side of a corner that touches the side, in mm.
        const BESIDE: f64 = 1e-3;
        let (half, own) = (self.half, self.outline.own(k));
        let Side { start, along, outwards, length } = self.outline.sides[k];
        let [low, high] = bounds([start, self.outline.sides[k].at(length)]);
        let by = 2.0 * half + TOUCHING;
        let around = [low.map(|x| x - by), high.map(|x| x + by)];
        let mut found = Vec::new();
        for v in self.outline.boxes.meeting(around).map(|v| v as usize) {
            if own.contains(&v) {
                continue;
            }
            let side = &self.outline.sides[v];
            let (away, facing) = (minus(start, side.start), dot(outwards, side.outwards));
            if facing < 1.0 - ROUNDING {
                // The distance from a place to its cut, and the place opposite it, are linear along both.
                let (before, slope) = (dot(away, side.outwards), dot(along, side.outwards));
                let share = dot(outwards, side.along) / (1.0 - facing);
                let opposite = dot(away, side.along) + before * share;
                let rate = dot(along, side.along) + slope * share;
                let mut solve = |rate: f64, value: f64| {
                    if rate.abs() > ROUNDING {
                        found.push(value / rate);
                    }
                };
                solve(slope, half * (1.0 - facing) - before);
                solve(rate, -opposite);
                solve(rate, side.length - opposite);
            }
            for end in [side.start, side.at(side.length)] {
                let to = minus(end, start);
                let (at, ahead) = (dot(to, along), dot(to, outwards));
                if ahead > -TOUCHING && ahead < 2.0 * half {
                    let reach = (ahead * (2.0 * half - ahead)).max(0.0).sqrt().max(BESIDE);
                    found.extend([at - reach, at, at + reach]);
                }
            }
        }
        found
    }

    /// Adds the points around the start of a side, if it is an outer corner.
    fn move_corner(&mut self, k: usize) {
        if self.outline.is_concave(k) {
            return;
        }
        let (half, before) = (self.half, self.outline.before(k));
        let own = [before, k];
        let corner = self.outline.sides[k].start;
        let at = |way: Point2, by: f64| [0, 1].map(|x| corner[x] + by * way[x]);
        let ways = own.map(|k| self.outline.sides[k].outwards);
        let turn = libm::atan2(cross(ways[0], ways[1]), dot(ways[0], ways[1]));
        let way = |share: f64| {
            let turns = share * turn / std::f64::consts::TAU;
            rotated(ways[0], [cosine(turns), sine(turns)])
        };
        // The mitre, or where it is cut off at right angles to its middle.
        let half_turn = cosine(0.5 * turn / std::f64::consts::TAU);
        let (shares, by) = match half_turn * LONGEST >= 1.0 {
            true => (&[0.5][..], half / half_turn),
            false => (&[0.25, 0.75][..], half / cosine(0.25 * turn / std::f64::consts::TAU)),
        };
        let has_room = |way: Point2, by: f64| self.outline.disc(corner, way, &own, by).1.is_none();
        let is_alone = self.outline.is_alone(k);
        if is_alone
            && ways.iter().all(|&way| has_room(way, half))
            && shares.iter().all(|&share| has_room(way(share), by))
        {
            self.of_corners[k]
                .extend(shares.iter().map(|&share| (share * turn, at(way(share), by))));
            return;
        }
        // Around the corner, as far as there is room. Corners at one place share what is around them.
        let steps = if is_alone { (turn / STEP).ceil().max(1.0) } else { 1.0 };
        for step in 0..=steps as u32 {
            let (way, angle) = (way(f64::from(step) / steps), f64::from(step) / steps * turn);
            let (by, contact) = self.outline.disc(corner, way, &own, half);
            self.of_corners[k].push((angle, at(way, by)));
            self.add_contact(at(way, by), contact);
        }
    }

    fn into_points(self) -> Vec<Point2> {
        let Line { mut of_sides, mut of_corners, .. } = self;
        let mut points: Vec<Point2> = Vec::new();
        for (corner, side) in of_corners.iter_mut().zip(&mut of_sides) {
            for own in [corner, side] {
                sort_by_number(own, |place| key_of_number(place.0));
                points.extend(own.iter().map(|(_, point)| *point));
            }
        }
        without_short_ends(simplified(points))
    }
}

/// A closed line without points that coincide with the one before or lie on the way to the next one.
fn simplified(points: Vec<Point2>) -> Vec<Point2> {
    let mut found: Vec<Point2> = Vec::new();
    let is_on_the_way = |p: Point2, at: Point2, q: Point2| {
        let (before, after) = (minus(at, p), minus(q, at));
        let along = direction_of(p, q);
        dot(before, after) > 0.0 && cross(along, before).abs() < ROUNDING
    };
    for point in points {
        if found.last().is_some_and(|last| distance(*last, point) < SAME) {
            continue;
        }
        while let [.., p, at] = found[..]
            && is_on_the_way(p, at, point)
        {
            found.pop();
        }
        found.push(point);
    }
    while found.len() > 1 && distance(found[0], found[found.len() - 1]) < SAME {
        found.pop();
    }
    // The first and the last point.
    while let [p, q, .., before, last] = found[..] {
        if is_on_the_way(before, last, p) {
            found.pop();
        } else if is_on_the_way(last, p, q) {
            found.remove(0);
        } else {
            break;
        }
    }
    found
}

/// A closed line without short ways to a point and back.
fn without_short_ends(mut points: Vec<Point2>) -> Vec<Point2> {
    let mut tip = 0;
    while tip < points.len() {
        let n = points.len();
        let ahead = |k: usize| points[(tip + k) % n];
        let behind = |k: usize| points[(tip + n - k % n) % n];
        let is_same = |k: usize| distance(ahead(k), behind(k)) < SAME;
        let steps = (1..n / 2).take_while(|&k| is_same(k)).count();
        let length: f64 = (0..steps).map(|k| distance(ahead(k), ahead(k + 1))).sum();
        if steps == 0 || length >= LEFT {
            tip += 1;
            continue;
        }
        // The way back goes with the tip.
        points.rotate_left((tip + n + 1 - steps) % n);
        points.drain(..2 * steps);
        tip = 0;
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fabricate::panel::distance_to_outline;
    use crate::math::plane::area;

    const KERF: f64 = 0.2;

    #[test]
    fn outer_and_inner_corners_are_moved_as_those_of_panels() {
        let notched = [
            [0.0, 0.0],
            [9.0, 0.0],
            [9.0, 9.0],
            [6.0, 9.0],
            [6.0, 5.0],
            [3.0, 5.0],
            [3.0, 9.0],
            [0.0, 9.0],
        ];
        let found = cut_line(&notched, KERF);
        let expected = crate::fabricate::panel::inset(&notched, -0.5 * KERF).expect("it has room");
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for point in expected {
            assert!(found.iter().any(|own| distance(*own, point) < 1e-12), "{point:?}");
        }
    }

    #[test]
    fn a_slit_is_cut_to_its_end_in_the_middle_where_it_is_narrow() {
        // Open by twice 3 degrees, by half the kerf, and not at all.
        for open in [0.524, 0.1, 0.0] {
            let slit = [
                [0.0, 0.0],
                [20.0, 0.0],
                [20.0, 10.0],
                [10.0 + open, 10.0],
                [10.0, 5.0],
                [10.0 - open, 10.0],
                [0.0, 10.0],
            ];
            let found = cut_line(&slit, KERF);
            let sine = open / (open * open + 25.0_f64).sqrt();
            // The cut reaches the end of the slit and not beyond it.
            let end = distance_to_outline(&found, [10.0, 5.0]);
            assert!((end - 0.5 * KERF).abs() < 1e-9, "{open}: {end}");
            // It leaves the slit where that is as wide as the cut.
            let from = 5.0 + 0.5 * KERF / sine;
            let middle: Vec<&Point2> =
                found.iter().filter(|point| (point[0] - 10.0).abs() < 1e-9).collect();
            let top = middle.iter().map(|point| point[1]).fold(0.0, f64::max);
            let expected = if from < 10.0 { from } else { 10.0 };
            assert!((top - expected).abs() < 0.11, "{open}: {top} {expected}");
            // The panels keep what is farther from the slit.
            for y in [5.5, 7.0, 9.0] {
                let beside = open * (y - 5.0) / 5.0;
                let kept = distance_to_outline(&found, [10.0 + beside, y]);
                let expected = (0.5 * KERF).min(beside);
                assert!((kept - expected).abs() < 0.01, "{open} {y}: {kept} {expected}");
            }
        }
    }

    #[test]
    fn an_outline_that_touches_itself_is_passed_where_it_does() {
        // Around a ring, with a slit without width.
        let ring = [
            [0.0, 0.0],
            [10.0, 0.0],
            [10.0, 10.0],
            [0.0, 10.0],
            [0.0, 0.0],
            [3.0, 3.0],
            [3.0, 6.0],
            [6.0, 6.0],
            [6.0, 3.0],
            [3.0, 3.0],
        ];
        let found = cut_line(&ring, KERF);
        let expected = (10.0 + KERF) * (10.0 + KERF) - (3.0 - KERF) * (3.0 - KERF);
        assert!((area(&found) - expected).abs() < 0.05, "{} {found:?}", area(&found));
        // Two tips that touch.
        let tips = [
            [0.0, 0.0],
            [30.0, 0.0],
            [30.0, 10.0],
            [0.0, 10.0],
            [0.0, 9.0],
            [10.0, 5.0],
            [20.0, 9.0],
            [20.0, 1.0],
            [10.0, 5.0],
            [0.0, 1.0],
        ];
        let found = cut_line(&tips, KERF);
        assert!(distance_to_outline(&found, [10.0, 5.0]) < 1e-9, "{found:?}");
        for point in [[0.0, 9.0], [15.0, 7.0], [20.0, 5.0], [30.0, 0.0]] {
            assert!(distance_to_outline(&found, point) > 0.5 * KERF - 1e-9, "{point:?}");
        }
    }

    #[test]
    fn a_sharp_tip_is_cut_off_beyond_half_the_kerf() {
        let tip = [[0.0, 0.0], [20.0, 0.0], [0.0, 5.0]];
        let found = cut_line(&tip, KERF);
        assert_eq!(found.len(), 4, "{found:?}");
        assert!((distance_to_outline(&found, [20.0, 0.0]) - 0.5 * KERF).abs() < 1e-12);
        let farthest = found.iter().map(|point| distance_to_outline(&tip, *point));
        assert!(farthest.fold(0.0, f64::max) <= reach(KERF));
    }
}
