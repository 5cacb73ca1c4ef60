//! Reliefs in inner corners, for tools that are round: a tool leaves material there, so that nothing
//! with a sharp corner fits into it. It is driven into the corner until it reaches the tip of it
//! (a dogbone).
//!
//! At a corner `F` of the finished part with the angle `2 a` beside it, a tool of radius `r` touches
//! `F` from the point `D = F + r b`, where `b` bisects that angle. What is drawn is the kerf's half `h`
//! away from the finished part, with its corner at `P = F + (h / sin a) b`, and the relief there is a
//! circle about `D` of the radius `r - h`. If the drawn line is the path of the tool, `h = r`, it is a
//! spur from `P` to `D` and back.

use super::build::Build;
use super::panel::direction_of;
use super::sheet::Hole;
use crate::math::plane::{Point2, cross, distance, dot, minus, rotated};
use crate::math::{cosine, sine};
use crate::scene::Product;

/// Less material than this, in mm, may be left in a corner.
const LEFT: f64 = 0.02;
/// Sides of half an arc.
const STEPS: i32 = 6;

/// An outline with reliefs.
struct Relieved {
    outline: Vec<Point2>,
    /// For each side, that of the outline without reliefs of which it is what is left.
    sides: Vec<Option<usize>>,
    /// Corners without room for a relief.
    dropped: usize,
}

/// The relief of one corner.
#[derive(Clone)]
enum Relief {
    None,
    /// To this point and back.
    Spur(Point2),
    /// Along these points, which begin and end so far from the corner.
    Arc(f64, Vec<Point2>),
}

/// An outline, counterclockwise, cut with a tool of this radius from outside or, a hole, from inside;
/// `half` is half the kerf.
fn relieved(outline: &[Point2], is_hole: bool, radius: f64, half: f64) -> Relieved {
    let n = outline.len();
    let side = |k: usize| [outline[k % n], outline[(k + 1) % n]];
    let reliefs: Vec<Relief> = (0..n)
        .map(|k| {
            let [before, after] = [side(k + n - 1), side(k)].map(|[p, q]| direction_of(p, q));
            let turn = cross(before, after) * if is_hole { 1.0 } else { -1.0 };
            match turn > 0.0 && side(k)[0] != side(k)[1] {
                true => relief(outline[k], [before, after], radius, half),
                false => Relief::None,
            }
        })
        .collect();
    let reach = |k: usize| if let Relief::Arc(reach, _) = &reliefs[k % n] { *reach } else { 0.0 };
    let has_room = |k: usize| {
        let [p, q] = side(k);
        reach(k) + reach(k + 1) < distance(p, q)
    };
    let (mut found, mut sides, mut dropped) = (Vec::new(), Vec::new(), 0);
    let mut last = Vec::new();
    for k in 0..n {
        let points = match &reliefs[k] {
            Relief::None => vec![outline[k]],
            Relief::Spur(tip) => vec![outline[k], *tip, outline[k]],
            Relief::Arc(_, points) if has_room(k) && has_room(k + n - 1) => points.clone(),
            Relief::Arc(..) => {
                dropped += 1;
                vec![outline[k]]
            }
        };
        // The outline begins with its first side.
        let begins = if k == 0 { points.len() - 1 } else { 0 };
        last.extend(points[..begins].iter().copied());
        let own = &points[begins..];
        found.extend(own.iter().copied());
        sides.extend(std::iter::repeat_n(None, own.len() - 1).chain([Some(k)]));
    }
    sides.extend(std::iter::repeat_n(None, last.len()));
    if !last.is_empty() {
        // What is left of the last side leads to the relief of the first corner.
        found.extend(last);
    }
    Relieved { outline: found, sides, dropped }
}

fn relief(corner: Point2, [before, after]: [Point2; 2], radius: f64, half: f64) -> Relief {
    let between = dot(before, after).clamp(-1.0, 1.0);
    let [cosine_a, sine_a] = [-1.0, 1.0].map(|sign| (0.5 * (1.0 + sign * between)).sqrt());
    let bisector = direction_of(before, after);
    // The tool is at least as wide as the cut.
    let radius = radius.max(half);
    if sine_a <= 0.0 || radius * (1.0 / sine_a - 1.0) < LEFT {
        return Relief::None;
    }
    let along = |by: f64| [0, 1].map(|x| corner[x] + by * bisector[x]);
    let (rest, off) = (radius - half, radius * sine_a - half);
    if rest <= 1e-9 || off.abs() >= rest {
        return Relief::Spur(along(half - half / sine_a));
    }
    let centre = along(radius - half / sine_a);
    let reach = (radius - half / sine_a) * cosine_a + (rest * rest - off * off).sqrt();
    let start = minus([0, 1].map(|x| corner[x] - reach * before[x]), centre);
    let middle = bisector.map(|x| -x);
    let turns = libm::atan2(cross(start, middle), dot(start, middle)) / std::f64::consts::TAU;
    let arc = (0..=2 * STEPS).map(|k| {
        let turns = turns * f64::from(k) / f64::from(STEPS);
        let at = rotated(start, [cosine(turns), sine(turns)]);
        [centre[0] + at[0], centre[1] + at[1]]
    });
    Relief::Arc(reach, arc.collect())
}

impl Build {
    /// Adds reliefs to all parts for the tool that is set, and counts the corners that have no room for
    /// one.
    pub(super) fn relieve(&mut self) {
        let radius = 0.5 * self.settings.tool;
        // Card is cut with a knife, whatever tool was set for other products.
        if radius <= 0.0 || self.settings.product == Product::Paper {
            return;
        }
        let half = 0.5 * self.settings.kerf;
        for part in &mut self.parts {
            let Relieved { outline, sides, dropped } = relieved(&part.outline, false, radius, half);
            self.left_out.dropped_reliefs += dropped;
            part.outline = outline;
            let name = |side: &Option<usize>| side.and_then(|k| part.neighbours.get(k)?.clone());
            let bevel = |side: &Option<usize>| side.and_then(|k| *part.bevels.get(k)?);
            (part.neighbours, part.bevels) =
                sides.iter().map(|side| (name(side), bevel(side))).unzip();
            for hole in &mut part.holes {
                let Some(slot) = &hole.slot else { continue };
                let Relieved { outline, sides, dropped } = relieved(slot, true, radius, half);
                self.left_out.dropped_reliefs += dropped;
                let name =
                    |side: &Option<usize>| side.and_then(|k| hole.neighbours.get(k)?.clone());
                let neighbours = match hole.as_opening() {
                    Some(_) => sides.iter().map(name).collect(),
                    None => Vec::new(),
                };
                *hole = Hole { neighbours, ..Hole::slot(outline) };
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fabricate::panel::{distance_to_outline, inset, sides};
    use crate::math::plane::{area, is_inside};

    /// A plate with a notch that is open upwards, and its inner corners.
    const NOTCHED: [Point2; 8] = [
        [0.0, 0.0],
        [60.0, 0.0],
        [60.0, 40.0],
        [40.0, 40.0],
        [40.0, 20.0],
        [22.0, 15.0],
        [20.0, 40.0],
        [0.0, 40.0],
    ];

    #[test]
    fn the_tool_reaches_every_inner_corner_and_no_other_is_changed() {
        for (kerf, tool) in [(0.0, 6.0), (2.0, 6.0), (6.0, 6.0), (0.2, 3.0)] {
            let drawn = inset(&NOTCHED, -0.5 * kerf).unwrap();
            let found = relieved(&drawn, false, 0.5 * tool, 0.5 * kerf);
            assert_eq!(found.dropped, 0);
            for (k, corner) in NOTCHED.into_iter().enumerate() {
                let away = distance_to_outline(&found.outline, corner);
                let is_inner = k == 4 || k == 5;
                // What is drawn comes as near to the corner as to a side.
                let reached = (away - 0.5 * kerf).abs() < 1e-9;
                assert!(reached || !is_inner, "{kerf} {tool} {k}: {away}");
                assert!(is_inner || found.outline.contains(&drawn[k]), "{k}");
            }
            // Each side is there once, on the line of its own.
            let named: Vec<usize> = found.sides.iter().flatten().copied().collect();
            assert_eq!(named, [0, 1, 2, 3, 4, 5, 6, 7]);
            for ([p, q], side) in sides(&found.outline).zip(&found.sides) {
                let Some(k) = side else { continue };
                let along = direction_of(drawn[*k], drawn[(k + 1) % 8]);
                assert!(cross(along, direction_of(p, q)).abs() < 1e-9, "{k}");
            }
        }
    }

    #[test]
    fn a_slot_is_relieved_outwards_where_its_sides_are_long_enough() {
        let slot = [[0.0, 0.0], [30.0, 0.0], [30.0, 10.0], [0.0, 10.0]];
        let found = relieved(&slot, true, 1.5, 0.0);
        assert!(found.dropped == 0 && area(&found.outline) > 300.0);
        assert!(slot.iter().all(|&p| distance_to_outline(&found.outline, p) < 1e-9));
        // The rectangle is within it, up to rounding.
        let within = [[0.01, 0.01], [29.99, 0.01], [29.99, 9.99], [0.01, 9.99]];
        assert!(within.iter().all(|&p| is_inside(&found.outline, p)));
        // Circles at both ends of a short side would meet; the path of a tool has room.
        assert_eq!(relieved(&slot, true, 4.0, 0.0).dropped, 4);
        assert_eq!(relieved(&inset(&slot, 4.0).unwrap(), true, 4.0, 4.0).dropped, 0);
    }

    #[test]
    fn an_outline_whose_first_corner_is_inner_begins_with_its_first_side() {
        let mut turned = NOTCHED;
        turned.rotate_left(4);
        let found = relieved(&turned, false, 3.0, 0.0);
        assert_eq!(found.sides[0], Some(0));
        let along = direction_of(turned[0], turned[1]);
        let own = direction_of(found.outline[0], found.outline[1]);
        assert!(cross(along, own).abs() < 1e-9 && dot(along, own) > 0.0);
        assert_eq!(found.sides.len(), found.outline.len());
    }
}
