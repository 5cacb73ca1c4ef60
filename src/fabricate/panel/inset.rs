//! Subtraction of the joint: every edge is moved inwards by half the joint `g`, and consecutive
//! lines are intersected. The area of a convex panel becomes
//! `A - (g/2) L + (g/2)^2 sum cot(angle/2)`, as long as no edge vanishes.

use super::polygon::{direction_of, distance_to_outline, is_simple};
use crate::math::plane::{Point2, area, cross, dot, is_inside, minus};

/// Lines are parallel if the sine of their angle is smaller than this.
const PARALLEL: f64 = 1e-9;
/// Sides of a polygon are in line below this sine of the angle between them: they are moved equally far.
const IN_LINE: f64 = 0.1;

/// Moves every edge of a polygon inwards by `by`, or outwards if it is negative. An edge that would
/// flip vanishes first: its ends become one corner. Returns none if less than a triangle is left, or
/// the outline falls apart: the panel is too small for the joint. Coincident corners stay coincident.
pub fn inset(polygon: &[Point2], by: f64) -> Option<Vec<Point2>> {
    inset_sides(polygon, &vec![by; polygon.len()])
}

/// As [`inset`], with a distance for each side; none if two sides in line have different ones.
pub fn inset_sides(polygon: &[Point2], by: &[f64]) -> Option<Vec<Point2>> {
    let n = polygon.len();
    let is_moved = by.iter().any(|by| *by != 0.0);
    let distinct: Vec<usize> = (0..n).filter(|&k| polygon[k] != polygon[(k + 1) % n]).collect();
    let m = distinct.len();
    // Distinct corners, each the start of an edge.
    let corners: Vec<Point2> = distinct.iter().map(|&k| polygon[k]).collect();
    let edges: Vec<Edge> = (0..m)
        .map(|k| Edge {
            start: corners[k],
            along: direction_of(corners[k], corners[(k + 1) % m]),
            by: by[distinct[k]],
        })
        .collect();
    let mut left: Vec<usize> = (0..m).collect();
    let moved = loop {
        let count = left.len();
        if count < 3 {
            return None;
        }
        let starts = |is_moved: bool| -> Option<Vec<Point2>> {
            let start = |k: usize| {
                let [before, own] = [left[(k + count - 1) % count], left[k]];
                let are_neighbours = (before + 1) % m == own;
                meet([&edges[before], &edges[own]], are_neighbours, is_moved)
            };
            (0..count).map(start).collect()
        };
        let moved = starts(is_moved)?;
        if !is_moved {
            break moved;
        }
        let along = |points: &[Point2], k: usize| {
            dot(minus(points[(k + 1) % count], points[k]), edges[left[k]].along)
        };
        if (0..count).all(|k| along(&moved, k) > 0.0) {
            break moved;
        }
        // The edge that vanishes first, at the smallest share of the way.
        let unmoved = starts(false)?;
        let share = |k: usize| {
            let (from, to) = (along(&unmoved, k), along(&moved, k));
            (to <= 0.0).then(|| from / (from - to))
        };
        let shares = (0..count).filter_map(|k| Some((share(k)?, k)));
        let (_, first) = shares.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)))?;
        left.remove(first);
    };
    if is_moved && (area(&moved) <= 0.0 || !is_simple(&moved)) {
        return None;
    }
    // Beside a notch an edge may vanish that would still be in the way of others.
    if left.len() < m && !is_apart(&corners, &moved, &edges, &left) {
        return None;
    }
    // Coincident corners get the position of their distinct corner, and that of an edge that has
    // vanished is the start of the next one.
    let of_distinct = |k: usize| moved[left.partition_point(|&own| own < k) % left.len()];
    let at = |k: usize| of_distinct(distinct.partition_point(|&own| own < k) % m);
    Some((0..n).map(at).collect())
}

/// Whether all sides of two outlines that do not cross, of which those of the moved one are `left`, keep
/// their distance, up to rounding, and the moved outline is on the right side of the other.
fn is_apart(polygon: &[Point2], moved: &[Point2], edges: &[Edge], left: &[usize]) -> bool {
    const ROUNDING: f64 = 1e-6;
    let keeps = |of: &[Point2], k: usize, by: f64, point: Point2| {
        let side = [of[k], of[(k + 1) % of.len()]];
        distance_to_outline(&side, point) >= (1.0 - ROUNDING) * by.abs()
    };
    // Where some sides move inwards and others outwards, corners may be on either side.
    let moves =
        |inwards: bool| edges.iter().any(|edge| edge.by != 0.0 && (edge.by > 0.0) == inwards);
    let (is_inwards, is_mixed) = (!moves(false), moves(true) && moves(false));
    let is_beside = |p: Point2| {
        is_mixed
            || is_inside(polygon, p) == is_inwards
            || edges.iter().any(|edge| edge.by == 0.0) && distance_to_outline(polygon, p) < ROUNDING
    };
    moved.iter().all(|&p| {
        is_beside(p) && edges.iter().enumerate().all(|(k, edge)| keeps(polygon, k, edge.by, p))
    }) && polygon.iter().enumerate().all(|(j, &p)| {
        // A corner is no farther from what is left than its own sides move.
        let before = &edges[(j + edges.len() - 1) % edges.len()];
        let own = edges[j].by.abs().min(before.by.abs());
        let keeps = |(k, &edge): (usize, &usize)| keeps(moved, k, edges[edge].by.abs().min(own), p);
        left.iter().enumerate().all(keeps)
    })
}

/// The distances of the sides of a polygon, the larger one for sides that are in line: with different ones
/// they would meet far away, or not at all.
pub(in crate::fabricate) fn alike_in_line(corners: &[Point2], by: &[f64]) -> Vec<f64> {
    let n = corners.len();
    let along = |k: usize| direction_of(corners[k % n], corners[(k + 1) % n]);
    let is_in_line = |k: usize| {
        let (u, v) = (along(k), along(k + 1));
        cross(u, v).abs() < IN_LINE && dot(u, v) > 0.0
    };
    let mut by = by.to_vec();
    // Twice around, for several in line.
    for k in (0..n).chain((0..n).rev()).filter(|&k| is_in_line(k)) {
        let both = by[k].max(by[(k + 1) % n]);
        (by[k], by[(k + 1) % n]) = (both, both);
    }
    by
}

/// An edge as a line with a direction.
struct Edge {
    start: Point2,
    along: Point2,
    /// How far it moves to its left.
    by: f64,
}

/// The point where two edges meet, moved or not, the first before the second; none if they are parallel,
/// except at a straight corner between neighbours that move alike.
fn meet([before, after]: [&Edge; 2], are_neighbours: bool, is_moved: bool) -> Option<Point2> {
    let (u, v) = (before.along, after.along);
    let [before_by, by] = [before, after].map(|edge| if is_moved { edge.by } else { 0.0 });
    let (sine, cosine) = (cross(u, v), dot(u, v));
    let [x, y] = after.start;
    if sine.abs() <= PARALLEL {
        // A straight corner moves at right angles; a spike has no inside.
        let goes_on = cosine > 0.0 && are_neighbours && before_by == by;
        return goes_on.then(|| [x - by * v[1], y + by * v[0]]);
    }
    // Unmoved, they meet so far before the start of the second.
    let back = match are_neighbours {
        true => 0.0,
        false => cross(u, minus(after.start, before.start)) / sine,
    };
    // Moved, they meet at `(before_by v - by u) / sine` from there.
    let (share, more) = (by / sine, (before_by - by) / sine);
    let at = |k: usize| after.start[k] - back * v[k] + share * (v[k] - u[k]) + more * v[k];
    Some([at(0), at(1)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fabricate::panel::perimeter;

    #[test]
    fn the_area_of_a_convex_panel_follows_its_formula() {
        let panel = [[0.0, 0.0], [3.0, -0.4], [4.1, 1.3], [2.2, 2.9], [0.3, 2.0]];
        let n = panel.len();
        let cotangents: f64 = (0..n)
            .map(|k| {
                let (before, after) = (panel[(k + n - 1) % n], panel[(k + 1) % n]);
                let (u, v) = (direction_of(panel[k], after), direction_of(panel[k], before));
                // cot(angle/2) = (1 + cos)/sin.
                (1.0 + dot(u, v)) / cross(u, v)
            })
            .sum();
        for half in [0.01, 0.2, -0.3] {
            let found = area(&inset(&panel, half).unwrap());
            let expected = area(&panel) - half * perimeter(&panel) + half * half * cotangents;
            assert!((found - expected).abs() < 1e-12, "{half}: {found} {expected}");
        }
    }

    #[test]
    fn a_side_vanishes_also_where_sides_move_by_their_own_distances_or_both_ways() {
        // A corner whose own sides stay was asked to be as far from the boundary as that moves.
        let panel = [[0.0, 0.0], [100.0, 0.0], [100.0, 1.0], [90.0, 60.0], [0.0, 60.0]];
        let found = inset_sides(&panel, &[5.0, 0.0, 0.0, 0.0, 0.0]).unwrap();
        assert!(found.iter().all(|corner| corner[1] > 5.0 - 1e-9), "{found:?}");
        // A joint inwards, and the kerf outwards at the boundary: corners lie on both sides.
        let chamfered = [[0.0, 0.0], [100.0, 0.0], [100.0, 59.0], [99.0, 60.0], [0.0, 60.0]];
        let found = inset_sides(&chamfered, &[-0.075, 4.925, 4.925, 4.925, 4.925]).unwrap();
        let expected = (100.0 - 2.0 * 4.925) * (60.0 - 4.925 + 0.075);
        assert!((area(&found) - expected).abs() < 1e-9, "{found:?}");
    }

    #[test]
    fn a_short_edge_vanishes_and_the_rest_is_inset() {
        // A square with a chamfer, of which the inset has no trace, wherever the outline starts.
        let chamfered = [[0.0, 0.0], [10.0, 0.0], [10.0, 9.9], [9.9, 10.0], [0.0, 10.0]];
        for first in 0..5 {
            let mut own = chamfered;
            own.rotate_left(first);
            let found = inset(&own, 1.0).unwrap();
            assert_eq!(found.len(), 5);
            assert!((area(&found) - 64.0).abs() < 1e-12, "{found:?}");
            let ends = [(7 - first) % 5, (8 - first) % 5].map(|k| found[k]);
            assert_eq!(ends[0], ends[1]);
            assert!(ends[0].iter().all(|x| (x - 9.0).abs() < 1e-12), "{ends:?}");
        }
        // With a short chamfer at each corner, and with two edges of a corner that vanish in turn.
        let all = [
            [0.1, 0.0],
            [9.9, 0.0],
            [10.0, 0.1],
            [10.0, 9.0],
            [9.9, 9.8],
            [9.7, 9.95],
            [9.0, 10.0],
            [0.1, 10.0],
            [0.0, 9.9],
            [0.0, 0.1],
        ];
        let found = inset(&all, 2.5).unwrap();
        assert!((area(&found) - 25.0).abs() < 1e-9, "{}", area(&found));
        // The bottom of a notch vanishes outwards, but not a slit.
        let notch = [[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [5.0, 5.0], [4.9, 5.0], [0.0, 9.0]];
        let found = inset(&notch, -0.2).unwrap();
        assert_eq!(found[3], found[4]);
        let slit = [
            [0.0, 0.0],
            [9.0, 0.0],
            [9.0, 9.0],
            [5.0, 9.0],
            [5.0, 2.0],
            [4.9, 2.0],
            [4.9, 9.0],
            [0.0, 9.0],
        ];
        assert!(inset(&slit, -0.2).is_none());
    }

    #[test]
    fn a_joint_that_turns_an_edge_round_is_refused() {
        let sliver = [[0.0, 0.0], [10.0, 0.0], [10.0, 0.1], [0.0, 0.1]];
        assert!(inset(&sliver, 0.04).is_some());
        assert!(inset(&sliver, 0.06).is_none());
        assert!(inset(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]], 0.1).is_none());
    }

    #[test]
    fn straight_and_double_corners_stay() {
        let panel = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
        let found = inset(&panel, 0.25).unwrap();
        let expected =
            [[0.25, 0.25], [1.0, 0.25], [1.75, 0.25], [1.75, 0.25], [1.75, 1.75], [0.25, 1.75]];
        assert_eq!(found, expected);
    }
}
