//! Polygons in the plane, counterclockwise.

use crate::math::plane::{
    Point2, area, bounds, cross, distance, dot, is_inside, length, minus, rotated,
};
use crate::math::{cosine, key_of_number, sine, sort_by_number};

/// The sides of a polygon.
pub(in crate::fabricate) fn sides(polygon: &[Point2]) -> impl Iterator<Item = [Point2; 2]> + '_ {
    crate::math::polygon_sides(polygon)
}

/// An outline without the corners that coincide with the next one.
pub(in crate::fabricate) fn distinct_corners(outline: &[Point2]) -> Vec<Point2> {
    let next = outline.iter().cycle().skip(1);
    outline.iter().zip(next).filter(|(own, next)| own != next).map(|(own, _)| *own).collect()
}

/// The length of the outline.
pub fn perimeter(polygon: &[Point2]) -> f64 {
    sides(polygon).map(|[p, q]| distance(p, q)).sum()
}

/// The unit vector from one point to another; the x direction if they coincide.
pub(in crate::fabricate) fn direction_of(from: Point2, to: Point2) -> Point2 {
    let step = minus(to, from);
    let l = length(step);
    if l > 0.0 { [step[0] / l, step[1] / l] } else { [1.0, 0.0] }
}

/// Whether no two sides cross or touch, except neighbours at their corner. Sides without length are
/// ignored.
pub fn is_simple(polygon: &[Point2]) -> bool {
    let all: Vec<[Point2; 2]> = sides(polygon).filter(|[a, b]| a != b).collect();
    let n = all.len();
    let turns_left =
        |k: usize| cross(minus(all[k][1], all[k][0]), minus(all[(k + 1) % n][1], all[k][1])) > 0.0;
    // If all sides turn left, and once around in total, the polygon is convex.
    let wraps = |k: usize| {
        let (a, b) = (minus(all[k][1], all[k][0]), minus(all[(k + 1) % n][1], all[k][1]));
        (a[1] < 0.0) != (b[1] < 0.0)
    };
    if (0..n).all(turns_left) && (0..n).filter(|&k| wraps(k)).count() == 2 {
        return true;
    }
    for i in 0..n {
        for j in i + 1..n {
            let neighbours = j == i + 1 || (i == 0 && j == n - 1);
            if !neighbours && cross_each_other(all[i], all[j]) {
                return false;
            }
        }
    }
    true
}

/// Whether no two sides of two polygons cross or touch.
pub(in crate::fabricate) fn are_apart(one: &[Point2], other: &[Point2]) -> bool {
    sides(one).all(|own| sides(other).all(|side| !cross_each_other(own, side)))
}

fn cross_each_other([a, b]: [Point2; 2], [c, d]: [Point2; 2]) -> bool {
    let side = |p: Point2, q: Point2, r: Point2| cross(minus(q, p), minus(r, p));
    let (u, v) = (side(a, b, c), side(a, b, d));
    let (w, x) = (side(c, d, a), side(c, d, b));
    // Rounding puts the ends of sides on one line on either side of it.
    u * v <= 0.0 && w * x <= 0.0 && overlap([a, b], [c, d])
}

/// Whether two segments overlap in the direction of the first.
fn overlap([a, b]: [Point2; 2], [c, d]: [Point2; 2]) -> bool {
    let axis = minus(b, a);
    let at = |p: Point2| dot(minus(p, a), axis);
    let (low, high) = (at(c).min(at(d)), at(c).max(at(d)));
    low <= at(b) && high >= 0.0
}

/// The convex hull, counterclockwise, by Andrew's monotone chain.
pub fn hull(points: &[Point2]) -> Vec<Point2> {
    let mut sorted = points.to_vec();
    for axis in [1, 0] {
        // Of -0 and 0 the other coordinate must decide: they are one place.
        sort_by_number(&mut sorted, |point| key_of_number(point[axis] + 0.0));
    }
    sorted.dedup();
    if sorted.len() < 3 {
        return sorted;
    }
    let chain = |points: &mut dyn Iterator<Item = Point2>| {
        let mut chain: Vec<Point2> = Vec::new();
        for point in points {
            while let [.., p, q] = chain[..]
                && cross(minus(q, p), minus(point, p)) <= 0.0
            {
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut all = chain(&mut sorted.iter().copied());
    all.extend(chain(&mut sorted.iter().rev().copied()));
    all
}

/// The rotation (cosine and sine) that gives the polygon its box of least area, wider than high,
/// and the width and height of that box. One side of it lies along an edge of the hull.
pub fn smallest_box(polygon: &[Point2]) -> (Point2, [f64; 2]) {
    smallest_box_within(polygon, [f64::INFINITY; 2])
}

/// As [`smallest_box`], but of the boxes at most as wide and as high as `most`, if there are any. If
/// none of those along an edge of the hull is, boxes at other angles are tried: a slender part may
/// fit on the diagonal.
pub(in crate::fabricate) fn smallest_box_within(
    polygon: &[Point2],
    most: [f64; 2],
) -> (Point2, [f64; 2]) {
    /// Number of other angles in a quarter turn.
    const ANGLES: u32 = 360;
    let hull = hull(polygon);
    let mut best: Option<((bool, f64), Point2, [f64; 2])> = None;
    let at_angle = |k: u32| {
        let turns = 0.25 * f64::from(k) / f64::from(ANGLES);
        [cosine(turns), sine(turns)]
    };
    let along_edges = sides(&hull).map(|[p, q]| direction_of(p, q));
    let others = (0..ANGLES).map(at_angle);
    for ([c, s], is_other) in
        along_edges.map(|own| (own, false)).chain(others.map(|own| (own, true)))
    {
        if is_other && best.is_some_and(|((fits, _), ..)| fits) {
            break;
        }
        let turn = [c, -s];
        let [low, high] = bounds(hull.iter().map(|&point| rotated(point, turn)));
        let [width, height] = minus(high, low);
        let (turn, size) = match width >= height {
            true => (turn, [width, height]),
            false => ([s, c], [height, width]),
        };
        let fits = size[0] <= most[0] && size[1] <= most[1];
        // In a tie the first edge wins regardless of rounding.
        let is_better = best.is_none_or(|((did_fit, area), ..)| {
            (fits && !did_fit) || (fits == did_fit && width * height < area * (1.0 - 1e-9))
        });
        if is_better {
            best = Some(((fits, width * height), turn, size));
        }
    }
    best.map_or(([1.0, 0.0], [0.0; 2]), |(_, turn, size)| (turn, size))
}

/// Checks that a part, in mm, is not so small or narrow that no machine can cut it, and files have no
/// digits for it.
///
/// # Errors
/// If it is, in words.
pub(in crate::fabricate) fn check_size(part: &[Point2]) -> Result<(), &'static str> {
    const LEAST: f64 = 0.1;
    const NARROWEST: f64 = 0.01;
    let [low, high] = bounds(part.iter().copied());
    let diagonal = distance(low, high);
    if diagonal < LEAST {
        return Err("it is smaller than 0.1 mm on the sheet");
    }
    // No box is lower than the area over the diagonal.
    if area(part) < NARROWEST * diagonal && smallest_box(part).1[1] < NARROWEST {
        return Err("it is narrower than 0.01 mm on the sheet");
    }
    Ok(())
}

/// The distance of a point from the outline.
pub(in crate::fabricate) fn distance_to_outline(polygon: &[Point2], point: Point2) -> f64 {
    let to = |[p, q]: [Point2; 2]| {
        let (along, at) = (minus(q, p), minus(point, p));
        let squared = dot(along, along);
        let share = if squared > 0.0 { (dot(at, along) / squared).clamp(0.0, 1.0) } else { 0.0 };
        length(minus(at, [share * along[0], share * along[1]]))
    };
    sides(polygon).map(to).fold(f64::INFINITY, f64::min)
}

/// The point inside that is farthest from the outline, and its distance: a grid, refined around its
/// best point. For labels a hundredth is accurate enough.
pub fn roomiest_point(polygon: &[Point2]) -> (Point2, f64) {
    roomiest_point_beside(polygon, &[])
}

/// As [`roomiest_point`], outside of some holes.
pub(in crate::fabricate) fn roomiest_point_beside(
    polygon: &[Point2],
    holes: &[&[Point2]],
) -> (Point2, f64) {
    const STEPS: i32 = 4;
    let [low, high] = bounds(polygon.iter().copied());
    let mut centre = [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])];
    let mut half = [0.5 * (high[0] - low[0]), 0.5 * (high[1] - low[1])];
    let room = |point: Point2| {
        let outlines = holes.iter().copied().chain([polygon]);
        let away =
            outlines.map(|own| distance_to_outline(own, point)).fold(f64::INFINITY, f64::min);
        let is_on = is_inside(polygon, point) && !holes.iter().any(|own| is_inside(own, point));
        if is_on { away } else { -away }
    };
    let mut best = (centre, room(centre));
    for _ in 0..6 {
        for i in -STEPS..=STEPS {
            for j in -STEPS..=STEPS {
                let share = |k: i32, half: f64| f64::from(k) / f64::from(STEPS) * half;
                let point = [centre[0] + share(i, half[0]), centre[1] + share(j, half[1])];
                let found = room(point);
                // In a tie the centre wins, so that labels stay in place.
                if found > best.1 * (1.0 + 1e-9) + f64::MIN_POSITIVE {
                    best = (point, found);
                }
            }
        }
        centre = best.0;
        half = half.map(|half| 0.4 * half);
    }
    (best.0, best.1.max(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    const NOTCHED: [Point2; 5] = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [2.0, 1.0], [0.0, 3.0]];

    #[test]
    fn area_outline_and_hull_of_a_notched_polygon() {
        assert_eq!(area(&NOTCHED), 8.0);
        assert_eq!(perimeter(&NOTCHED), 10.0 + 2.0 * 8.0_f64.sqrt());
        assert_eq!(hull(&NOTCHED).len(), 4);
        assert!(is_simple(&NOTCHED));
        assert!(!is_simple(&[[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]]));
    }

    #[test]
    fn a_hull_has_all_corners_although_some_are_at_minus_zero() {
        let points =
            [[-0.0, 0.0], [-6.0, -6.0], [-6.0, -85.0], [0.0, -85.0], [-7.0, 0.0], [-0.0, -85.0]];
        let hull = hull(&points);
        assert!(hull.len() == 4 && hull.contains(&[0.0, 0.0]), "{hull:?}");
    }

    #[test]
    fn the_smallest_box_of_a_turned_rectangle_is_the_rectangle() {
        let turn = [0.8, 0.6];
        let turned = [[0.0, 0.0], [5.0, 0.0], [5.0, 2.0], [0.0, 2.0]].map(|p| rotated(p, turn));
        let (back, [width, height]) = smallest_box(&turned);
        assert!((width - 5.0).abs() < 1e-12 && (height - 2.0).abs() < 1e-12);
        assert!((back[0].abs() - 0.8).abs() < 1e-12 && (back[1].abs() - 0.6).abs() < 1e-12);
    }

    #[test]
    fn a_label_goes_where_there_is_room() {
        let (point, room) = roomiest_point(&NOTCHED);
        assert!(is_inside(&NOTCHED, point) && room > 0.75, "{point:?} {room}");
        let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
        assert_eq!(roomiest_point(&square), ([1.0, 1.0], 1.0));
    }
}
