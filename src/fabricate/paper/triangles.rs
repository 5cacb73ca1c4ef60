//! A polygon as triangles.

use crate::math::plane::Point2;

/// Cuts off ears, the one with the shortest diagonal first: triangles as corners, counterclockwise.
pub(super) fn triangles(polygon: &[Point2]) -> Vec<[usize; 3]> {
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
            let holds =
                |p: Point2| [[a, b], [b, c], [c, a]].iter().all(|&[p0, p1]| turn(p0, p1, p) >= 0.0);
            let is_other = |corner: &&usize| !own.contains(corner);
            turn(a, b, c) > 0.0
                && !left.iter().filter(is_other).any(|&corner| holds(polygon[corner]))
        };
        let shortest = |a: &usize, b: &usize| diagonal(*a).total_cmp(&diagonal(*b)).then(a.cmp(b));
        // A polygon that crosses itself may have no ear: cut off any triangle.
        let k = (0..n).filter(is_whole).min_by(shortest).unwrap_or(0);
        found.push(ear(k));
        left.remove(k);
    }
    found.extend(<[usize; 3]>::try_from(left));
    found
}

/// Twice the signed area of a triangle, positive if counterclockwise.
pub(super) fn turn(a: Point2, b: Point2, c: Point2) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quad_is_cut_along_its_shorter_diagonal_and_a_notch_is_left_out() {
        let kite = [[0.0, 0.0], [3.0, -1.0], [6.0, 0.0], [3.0, 1.0]];
        let found = triangles(&kite);
        assert_eq!(found.len(), 2);
        assert!(found.iter().all(|own| own.contains(&1) && own.contains(&3)));
        let notched = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [2.0, 1.0], [0.0, 3.0]];
        let areas = triangles(&notched)
            .into_iter()
            .map(|[a, b, c]| turn(notched[a], notched[b], notched[c]));
        let areas: Vec<f64> = areas.collect();
        assert!(areas.iter().all(|twice| *twice > 0.0));
        assert_eq!(areas.iter().sum::<f64>(), 16.0);
    }
}
