//! A polygon as triangles.

use super::plane::{Point2, bounds, distance};
use super::polygon::{polygon_sides, twice_vector_area};
use super::vec3::Vec3;

/// Distance from a line within which a corner lies on it, as a fraction of the size of the polygon.
const STRAIGHT: f64 = 1e-9;

/// Cuts off ears, the one with the shortest diagonal first: triangles as corners, counterclockwise.
/// A straight corner is never the tip of an ear, whatever its rounding.
pub fn ears(polygon: &[Point2]) -> Vec<[usize; 3]> {
    let [low, high] = bounds(polygon.iter().copied());
    let least = STRAIGHT * distance(low, high);
    let mut left: Vec<usize> = (0..polygon.len()).collect();
    let mut found = Vec::new();
    while left.len() > 3 {
        let n = left.len();
        let ear = |k: usize| [left[(k + n - 1) % n], left[k], left[(k + 1) % n]];
        let diagonal = |k: usize| {
            let [a, _, c] = ear(k).map(|corner| polygon[corner]);
            (c[0] - a[0]) * (c[0] - a[0]) + (c[1] - a[1]) * (c[1] - a[1])
        };
        let is_whole = |&k: &usize| {
            let own = ear(k);
            let [a, b, c] = own.map(|corner| polygon[corner]);
            let holds = |p: Point2| {
                let is_left =
                    |&[p0, p1]: &[Point2; 2]| turn(p0, p1, p) >= -least * distance(p0, p1);
                [[a, b], [b, c], [c, a]].iter().all(is_left)
            };
            // Another corner at the same point, as at the ends of a slit, is not in the ear.
            let is_other = |&p: &Point2| p != a && p != b && p != c;
            !left.iter().map(|&corner| polygon[corner]).filter(is_other).any(holds)
        };
        let turns_left = |&k: &usize| {
            let [a, b, c] = ear(k).map(|corner| polygon[corner]);
            turn(a, b, c) > least * distance(a, c)
        };
        // Most of the first ones are whole; to test all would take the cube of their number.
        let mut all: Vec<(f64, usize)> =
            (0..n).filter(turns_left).map(|k| (diagonal(k), k)).collect();
        all.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        // A polygon that crosses itself may have no ear: cut off any triangle.
        let k = all.into_iter().map(|(_, k)| k).find(is_whole).unwrap_or(0);
        found.push(ear(k));
        left.remove(k);
    }
    found.extend(<[usize; 3]>::try_from(left));
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
    let normal = unit(outside);
    let steps = polygon_sides(corners).map(|[p, q]| q - p);
    let along = steps.map(|step| unit(step - normal * step.dot(normal)));
    let x = along.reduce(|a, b| if a == Vec3::zero() { b } else { a }).unwrap_or(Vec3::zero());
    let y = normal.cross(x);
    let flat: Vec<Point2> = corners.iter().map(|p| [p.dot(x), p.dot(y)]).collect();
    ears(&flat)
}

/// Normalises a vector; zero if it has no direction.
fn unit(v: Vec3<f64>) -> Vec3<f64> {
    v.length_and_direction().1.unwrap_or(Vec3::zero())
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
