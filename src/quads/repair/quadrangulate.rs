//! The best division of a polygon into quads without new vertices.

use crate::math::{Vec3, angle, twice_vector_area};
use std::f64::consts::FRAC_PI_2;

/// Polygons of more corners are left alone: the search takes the fourth power of their number.
const MOST: usize = 96;
/// Cost of a corner that turns the other way than the polygon, in squared radians.
const TURNED: f64 = 10.0;

/// Divides an even polygon into quads, so that the sum of the squared deviations of their corners
/// from a right angle is least. `allowed` says whether there may be a diagonal between two corners.
/// `None` if there is no such division, or the polygon has too many corners.
pub(super) fn quadrangulate(
    polygon: &[usize],
    at: impl Fn(usize) -> Vec3<f64>,
    allowed: impl Fn(usize, usize) -> bool,
) -> Option<Vec<[usize; 4]>> {
    let count = polygon.len();
    if count < 4 || count % 2 == 1 || count > MOST {
        return None;
    }
    let corners: Vec<Vec3<f64>> = polygon.iter().map(|&node| at(node)).collect();
    let normal = twice_vector_area(corners.iter().copied());
    let is_side = |i: usize, j: usize| j == i + 1 || (i == 0 && j == count - 1);
    let may_join = |i: usize, j: usize| {
        is_side(i, j) || (polygon[i] != polygon[j] && allowed(polygon[i], polygon[j]))
    };
    let joins: Vec<bool> = (0..count * count)
        .map(|k| k / count < k % count && may_join(k / count, k % count))
        .collect();
    let joined = |i: usize, j: usize| joins[i * count + j];
    // The best division of the corners i to j, with the side from j to i, and its first quad.
    let mut best: Vec<(f64, [usize; 2])> = vec![(f64::INFINITY, [0, 0]); count * count];
    for i in 0..count - 1 {
        best[i * count + i + 1].0 = 0.0;
    }
    for length in (3..count).step_by(2) {
        for i in 0..count - length {
            let j = i + length;
            if !joined(i, j) {
                continue;
            }
            let mut found = (f64::INFINITY, [0, 0]);
            for a in (i + 1..j).step_by(2) {
                for b in (a + 1..j).step_by(2) {
                    let parts = [(i, a), (a, b), (b, j)];
                    if !parts.iter().all(|&(from, to)| joined(from, to)) {
                        continue;
                    }
                    let rest: f64 = parts.iter().map(|&(from, to)| best[from * count + to].0).sum();
                    let nodes = [i, a, b, j].map(|k| polygon[k]);
                    let repeats = nodes[0] == nodes[2] || nodes[1] == nodes[3];
                    if rest < found.0 && !repeats {
                        let cost = rest + deviation([i, a, b, j].map(|k| corners[k]), normal);
                        if cost < found.0 {
                            found = (cost, [a, b]);
                        }
                    }
                }
            }
            best[i * count + j] = found;
        }
    }
    let mut quads = Vec::new();
    let mut rest = vec![(0, count - 1)];
    while let Some((i, j)) = rest.pop() {
        let (cost, [a, b]) = best[i * count + j];
        if cost.is_infinite() {
            return None;
        }
        if j > i + 1 {
            quads.push([i, a, b, j].map(|k| polygon[k]));
            rest.extend([(i, a), (a, b), (b, j)]);
        }
    }
    Some(quads)
}

/// Sum over the corners of a quad of the squared difference of their angle from a right one.
pub(super) fn deviation(corners: [Vec3<f64>; 4], normal: Vec3<f64>) -> f64 {
    let of_corner = |k: usize| {
        let to_next = corners[(k + 1) % 4] - corners[k];
        let to_last = corners[(k + 3) % 4] - corners[k];
        let turn = to_next.cross(to_last);
        let found = angle(to_next.dot(to_last), turn.length());
        let deviation = found.map_or(FRAC_PI_2, |found| found - FRAC_PI_2);
        deviation * deviation + if turn.dot(normal) > 0.0 { 0.0 } else { TURNED }
    };
    (0..4).map(of_corner).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn strip(count: usize) -> Vec<Vec3<f64>> {
        let half = count / 2;
        let place = |k: usize| {
            let (x, y) = if k < half { (k, 0) } else { (count - 1 - k, 1) };
            Vec3::new(x as f64, y as f64, 0.0)
        };
        (0..count).map(place).collect()
    }

    #[test]
    fn a_strip_becomes_its_squares() {
        for count in [4, 6, 8, 14] {
            let polygon: Vec<usize> = (0..count).collect();
            let corners = strip(count);
            let quads = quadrangulate(&polygon, |node| corners[node], |_, _| true).unwrap();
            assert_eq!(quads.len(), count / 2 - 1);
            for quad in quads {
                let area = twice_vector_area(quad.iter().map(|&k| corners[k]));
                assert_eq!(area.z, 2.0);
            }
        }
    }

    #[test]
    fn a_forbidden_diagonal_is_not_used() {
        let corners = strip(8);
        let polygon: Vec<usize> = (0..8).collect();
        let allowed = |a: usize, b: usize| [a.min(b), a.max(b)] != [1, 6];
        let quads = quadrangulate(&polygon, |node| corners[node], allowed).unwrap();
        assert_eq!(quads.len(), 3);
        for quad in quads {
            let sides = (0..4).map(|k| [quad[k], quad[(k + 1) % 4]]);
            assert!(sides.into_iter().all(|[a, b]| [a.min(b), a.max(b)] != [1, 6]));
        }
    }

    #[test]
    fn odd_polygons_and_those_that_touch_themselves_in_all_ways_are_refused() {
        let corners = strip(6);
        assert!(quadrangulate(&[0, 1, 2], |k| corners[k], |_, _| true).is_none());
        assert!(quadrangulate(&[0, 1, 2, 3, 4], |k| corners[k], |_, _| true).is_none());
        assert!(quadrangulate(&[0, 1, 0, 2], |k| corners[k], |_, _| true).is_none());
    }
}
