//! A polygon as triangles, and what lies inside it.

use super::key_of_number;
use super::plane::{Point2, bounds, distance};
use super::polygon::{polygon_sides, twice_vector_area};
use super::vec3::Vec3;
use std::collections::BTreeSet;

/// Distance from a line within which a corner lies on it, as a fraction of the size of the polygon.
const STRAIGHT: f64 = 1e-9;

/// Cuts off ears, the one with the shortest diagonal first: triangles as corners, counterclockwise.
/// A straight corner is never the tip of an ear, whatever its rounding.
pub fn ears(polygon: &[Point2]) -> Vec<[usize; 3]> {
    ears_by(polygon, |a, c| {
        let [a, c] = [a, c].map(|corner| polygon[corner]);
        (c[0] - a[0]) * (c[0] - a[0]) + (c[1] - a[1]) * (c[1] - a[1])
    })
}

/// The same for a polygon in space, seen along its normal; lengths of diagonals are those in space.
pub fn ears_in_space(corners: &[Vec3<f64>]) -> Vec<[usize; 3]> {
    ears_by(&along_normal(corners), |a, c| (corners[c] - corners[a]).length_squared())
}

/// Whether every side of a polygon in space is seen from the mean of its corners, looking along its
/// normal, so that triangles around the mean neither overlap nor lack area.
pub fn is_seen_from_mean(corners: &[Vec3<f64>]) -> bool {
    let flat = along_normal(corners);
    let share = 1.0 / flat.len() as f64;
    let mean = [0, 1].map(|axis| flat.iter().map(|p| share * p[axis]).sum());
    let [low, high] = bounds(flat.iter().copied());
    let least = STRAIGHT * distance(low, high);
    let mut sides = polygon_sides(&flat);
    sides.all(|[p, q]| p == q || turn(p, q, mean) > least * distance(p, q))
}

/// Whether the segment between two corners of a polygon in space, seen along its normal, lies inside and
/// meets no other corner.
pub fn is_diagonal_inside(corners: &[Vec3<f64>], [a, b]: [usize; 2]) -> bool {
    let flat = along_normal(corners);
    let n = flat.len();
    let is_between = |from: usize, to: usize| {
        let [before, at, after] = [from + n - 1, from, from + 1].map(|k| flat[k % n]);
        let left = [turn(at, flat[to], before) > 0.0, turn(at, after, flat[to]) > 0.0];
        if turn(before, at, after) > 0.0 { left == [true; 2] } else { left != [false; 2] }
    };
    let crosses = |[p, q]: [Point2; 2]| {
        let [a, b] = [flat[a], flat[b]];
        turn(p, q, a) * turn(p, q, b) < 0.0 && turn(a, b, p) * turn(a, b, q) < 0.0
    };
    let [low, high] = bounds(flat.iter().copied());
    let least = STRAIGHT * distance(low, high);
    // A corner at the place of an end, as at the ends of a slit, is not between them.
    let meets = |&p: &Point2| {
        let [a, b] = [flat[a], flat[b]];
        let is_beside = p != a && p != b && distance(a, p).max(distance(p, b)) < distance(a, b);
        is_beside && turn(a, b, p).abs() <= least * distance(a, b)
    };
    let is_clear = !flat.iter().any(meets) && !polygon_sides(&flat).any(crosses);
    is_between(a, b) && is_between(b, a) && is_clear
}

/// A polygon in space seen along its normal.
fn along_normal(corners: &[Vec3<f64>]) -> Vec<Point2> {
    let normal = twice_vector_area(corners.iter().copied()).direction_or_zero();
    let steps = polygon_sides(corners).map(|[p, q]| q - p);
    let along = steps.map(|step| (step - normal * step.dot(normal)).direction_or_zero());
    let x = along.reduce(|a, b| if a == Vec3::zero() { b } else { a }).unwrap_or(Vec3::zero());
    let y = normal.cross(x);
    // Relative to a corner: far away, rounding would exceed what is straight.
    let origin = corners.first().copied().unwrap_or(Vec3::zero());
    corners.iter().map(|&p| [(p - origin).dot(x), (p - origin).dot(y)]).collect()
}

/// Cuts off ears by the squared length of the `diagonal` between two corners.
fn ears_by(polygon: &[Point2], diagonal: impl Fn(usize, usize) -> f64) -> Vec<[usize; 3]> {
    let n = polygon.len();
    let [low, high] = bounds(polygon.iter().copied());
    let least = STRAIGHT * distance(low, high);
    // The corners that are left, as a ring, and their diagonals by length.
    let mut before: Vec<usize> = (0..n).map(|k| (k + n - 1) % n).collect();
    let mut after: Vec<usize> = (0..n).map(|k| (k + 1) % n).collect();
    let key = |a: usize, k: usize, c: usize| (key_of_number(diagonal(a, c)), k);
    let mut by_length: BTreeSet<(u64, usize)> =
        (0..n).map(|k| key(before[k], k, after[k])).collect();
    let mut first = 0;
    let mut found = Vec::new();
    while by_length.len() > 3 {
        let ear = |k: usize| [before[k], k, after[k]];
        let turns_left = |k: usize| {
            let [a, b, c] = ear(k).map(|corner| polygon[corner]);
            turn(a, b, c) > least * distance(a, c)
        };
        let is_whole = |k: usize| {
            let [a, b, c] = ear(k).map(|corner| polygon[corner]);
            let holds = |p: Point2| {
                let is_left =
                    |&[p0, p1]: &[Point2; 2]| turn(p0, p1, p) >= -least * distance(p0, p1);
                [[a, b], [b, c], [c, a]].iter().all(is_left)
            };
            // Another corner at the same point, as at the ends of a slit, is not in the ear.
            let is_other = |&p: &Point2| p != a && p != b && p != c;
            let mut others = std::iter::successors(Some(after[k]), |&at| Some(after[at]))
                .take_while(|&at| at != k)
                .map(|corner| polygon[corner]);
            !others.any(|p| is_other(&p) && holds(p))
        };
        // Most of the first ones are whole; to test all would take the cube of their number.
        let mut shortest = by_length.iter().map(|&(_, k)| k);
        // A polygon that crosses itself may have no ear: cut off any triangle.
        let k = shortest.find(|&k| turns_left(k) && is_whole(k)).unwrap_or(first);
        let [a, _, c] = ear(k);
        found.push([a, k, c]);
        for own in [a, k, c] {
            by_length.remove(&key(before[own], own, after[own]));
        }
        (after[a], before[c]) = (c, a);
        by_length.extend([a, c].map(|own| key(before[own], own, after[own])));
        if k == first {
            first = c;
        }
    }
    if by_length.len() == 3 {
        found.push([first, after[first], before[first]]);
    }
    found
}

/// A polygon in space as triangles: a fan around the first corner for which no triangle is flipped,
/// or, if there is none, the triangles of the polygon seen along its normal.
pub fn triangles_in_space(corners: &[Vec3<f64>]) -> Vec<[usize; 3]> {
    let n = corners.len();
    let outside = twice_vector_area(corners.iter().copied());
    let around = |from: usize| (2..n).map(move |k| [from, (from + k - 1) % n, (from + k) % n]);
    let has_sense = |from: &usize| {
        around(*from).all(|own| {
            let [a, b, c] = own.map(|k| corners[k]);
            (b - a).cross(c - a).dot(outside) >= 0.0
        })
    };
    if let Some(from) = (0..n).find(has_sense) {
        return around(from).collect();
    }
    ears_in_space(corners)
}

/// Twice the signed area of a triangle, positive if counterclockwise.
pub fn turn(a: Point2, b: Point2, c: Point2) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quad_is_cut_along_its_shorter_diagonal_and_a_notch_is_left_out() {
        let kite = [[0.0, 0.0], [3.0, -1.0], [6.0, 0.0], [3.0, 1.0]];
        let found = ears(&kite);
        assert_eq!(found.len(), 2);
        assert!(found.iter().all(|own| own.contains(&1) && own.contains(&3)));
        let notched = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [2.0, 1.0], [0.0, 3.0]];
        let areas =
            ears(&notched).into_iter().map(|[a, b, c]| turn(notched[a], notched[b], notched[c]));
        let areas: Vec<f64> = areas.collect();
        assert!(areas.iter().all(|twice| *twice > 0.0));
        assert_eq!(areas.iter().sum::<f64>(), 16.0);
    }

    #[test]
    fn corners_at_one_point_do_not_block_each_other() {
        // A notched polygon with its tip and another corner twice.
        let notched =
            [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [4.0, 3.0], [2.0, 1.0], [2.0, 1.0], [0.0, 3.0]];
        let found = ears(&notched);
        let areas = || found.iter().map(|&[a, b, c]| turn(notched[a], notched[b], notched[c]));
        assert!(areas().all(|twice| twice >= 0.0), "{found:?}");
        assert_eq!((found.len(), areas().sum::<f64>()), (5, 16.0));
    }

    #[test]
    fn many_corners_take_no_longer_than_their_square() {
        // A comb, and the cap of a cylinder: to try all ears for each took minutes.
        let comb = (0..10_000).map(|k| [f64::from(k), f64::from(1 + k % 2)]);
        let comb: Vec<Point2> =
            [[9_999.0, 0.0], [0.0, 0.0]].into_iter().chain(comb).rev().collect();
        let area = |found: &[[usize; 3]], of: &[Point2]| -> f64 {
            found.iter().map(|&[a, b, c]| turn(of[a], of[b], of[c])).sum()
        };
        let found = ears(&comb);
        assert_eq!(found.len(), 10_000);
        assert!((area(&found, &comb) - 2.0 * 1.5 * 9_999.0).abs() < 2.0);
        let cap: Vec<Point2> = (0..10_000)
            .map(|k| libm::sincos(f64::from(k) * std::f64::consts::TAU / 1e4))
            .map(|(s, c)| [c, s])
            .collect();
        assert!((area(&ears(&cap), &cap) - std::f64::consts::TAU).abs() < 1e-5);
    }

    #[test]
    fn far_away_no_triangle_is_without_area() {
        // With a corner in the middle of a side, whose rounding was larger than what counts as straight.
        let notched = [[0.0, 0.0], [0.2, 0.0], [0.4, 0.0], [0.4, 0.3], [0.2, 0.1], [0.0, 0.3]];
        for far in [0.0, 1e6, 1e7] {
            let corners = notched.map(|[x, y]| Vec3::new(far + x, y - far, 2.0 * far));
            let found = ears_in_space(&corners);
            let area = |own: &[usize; 3]| {
                let [a, b, c] = own.map(|k| corners[k]);
                (b - a).cross(c - a).z
            };
            assert!(
                found.len() == 4 && found.iter().all(|own| area(own) > 1e-3),
                "{far} {found:?}"
            );
        }
    }

    #[test]
    fn a_straight_corner_gives_no_triangle_without_area() {
        // A quad with corners in the middle of two of its sides, at many angles.
        let quad = [[0.0, 0.0], [1.5, 0.0], [3.0, 0.0], [3.2, 2.0], [1.55, 2.45], [-0.1, 2.9]];
        for k in 0..200 {
            let (s, c) = libm::sincos(0.1 + 0.37 * f64::from(k));
            let turned = quad.map(|[x, y]| [7.1 + c * x - s * y, s * x + c * y - 3.3]);
            let found = ears(&turned);
            let areas = || found.iter().map(|&[a, b, c]| turn(turned[a], turned[b], turned[c]));
            assert!(found.len() == 4 && areas().all(|twice| twice > 0.5), "{k}: {found:?}");
        }
    }
}
