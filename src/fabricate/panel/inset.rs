//! Subtraction of the joint: every edge is moved inwards by half the joint `g`, and consecutive
//! lines are intersected. The area of a convex panel becomes
//! `A - (g/2) L + (g/2)^2 sum cot(angle/2)`.

use super::polygon::{direction_of, is_simple};
use crate::math::plane::{Point2, area, cross, dot, minus};

/// Lines are parallel if the sine of their angle is smaller than this.
const PARALLEL: f64 = 1e-9;

/// Moves every edge of a polygon inwards by `by`, or outwards if it is negative. Returns none if an
/// edge would flip: the panel is too small for the joint. Coincident corners stay coincident.
pub fn inset(polygon: &[Point2], by: f64) -> Option<Vec<Point2>> {
    let n = polygon.len();
    let distinct: Vec<usize> = (0..n).filter(|&k| polygon[k] != polygon[(k + 1) % n]).collect();
    let m = distinct.len();
    if m < 3 {
        return None;
    }
    // Distinct corners, each the start of an edge.
    let corners: Vec<Point2> = distinct.iter().map(|&k| polygon[k]).collect();
    let directions: Vec<Point2> =
        (0..m).map(|k| direction_of(corners[k], corners[(k + 1) % m])).collect();
    let mut moved = Vec::with_capacity(m);
    for k in 0..m {
        let (before, after) = (directions[(k + m - 1) % m], directions[k]);
        let sine = cross(before, after);
        let cosine = dot(before, after);
        let [x, y] = corners[k];
        if sine.abs() <= PARALLEL {
            // A straight corner moves at right angles; a spike has no inside.
            if cosine < 0.0 {
                return None;
            }
            moved.push([x - by * after[1], y + by * after[0]]);
            continue;
        }
        // The lines intersect at `by / sine (after - before)` from the corner.
        let share = by / sine;
        moved.push([x + share * (after[0] - before[0]), y + share * (after[1] - before[1])]);
    }
    let turned = |k: usize| dot(minus(moved[(k + 1) % m], moved[k]), directions[k]) <= 0.0;
    if by != 0.0 && ((0..m).any(turned) || area(&moved) <= 0.0 || !is_simple(&moved)) {
        return None;
    }
    // Coincident corners get the position of their distinct corner.
    let at = |k: usize| moved[distinct.partition_point(|&own| own < k) % m];
    Some((0..n).map(at).collect())
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
