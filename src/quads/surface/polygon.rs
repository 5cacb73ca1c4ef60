//! Triangles of a polygon.

use crate::math::{Vec3, twice_vector_area};

/// Cuts a polygon into triangles along short diagonals inside it: of the corners that are convex and
/// whose triangle contains no other corner, the one with the shortest diagonal is cut off first.
pub(super) fn triangles(face: &[u32], at: impl Fn(u32) -> Vec3<f64>) -> Vec<[u32; 3]> {
    let normal = twice_vector_area(face.iter().map(|&v| at(v)));
    let mut rest = face.to_vec();
    let mut cut = Vec::with_capacity(face.len() - 2);
    while rest.len() > 3 {
        let n = rest.len();
        let of_corner = |k: usize| [rest[(k + n - 1) % n], rest[k], rest[(k + 1) % n]];
        let turn = |[a, b, c]: [Vec3<f64>; 3]| (b - a).cross(c - a).dot(normal);
        let is_ear = |k: usize| {
            let corner = of_corner(k);
            let [a, b, c] = corner.map(&at);
            let outside = |v: u32| {
                let p = at(v);
                [[a, b, p], [b, c, p], [c, a, p]].into_iter().any(|side| turn(side) < 0.0)
            };
            turn([a, b, c]) > 0.0
                && rest.iter().all(|v| corner.contains(v) || outside(*v))
                // The rest of a quad must not be turned over.
                && (n > 4 || turn([c, at(rest[(k + 2) % n]), a]) > 0.0)
        };
        let length = |k: usize| {
            let [a, _, c] = of_corner(k);
            (at(a) - at(c)).length_squared()
        };
        let shortest = |candidates: &mut dyn Iterator<Item = usize>| {
            candidates.min_by(|&a, &b| length(a).total_cmp(&length(b)))
        };
        let ear = shortest(&mut (0..n).filter(|&k| is_ear(k)));
        let ear = ear.or_else(|| shortest(&mut (0..n))).expect("a polygon has corners");
        cut.push(of_corner(ear));
        rest.remove(ear);
    }
    cut.push([rest[0], rest[1], rest[2]]);
    cut
}

#[cfg(test)]
mod tests {
    use super::*;

    fn areas(points: &[[f64; 3]]) -> Vec<f64> {
        let face: Vec<u32> = (0..points.len() as u32).collect();
        let at = |v: u32| Vec3::from(points[v as usize]);
        let area = |[a, b, c]: [u32; 3]| (at(b) - at(a)).cross(at(c) - at(a)).z;
        triangles(&face, at).into_iter().map(area).collect()
    }

    #[test]
    fn an_arrowhead_and_an_l_are_cut_inside() {
        let arrow = [[0.0, 0.0, 0.0], [2.0, -1.0, 0.0], [0.5, 0.0, 0.0], [2.0, 1.0, 0.0]];
        assert!(areas(&arrow).iter().all(|&area| area > 0.0));
        let l = [[0, 0], [3, 0], [3, 1], [1, 1], [1, 3], [0, 3]];
        let l = l.map(|[x, y]: [i32; 2]| [f64::from(x), f64::from(y), 0.0]);
        let found = areas(&l);
        assert_eq!((found.len(), found.iter().sum::<f64>()), (4, 10.0));
        assert!(found.iter().all(|&area| area > 0.0), "{found:?}");
    }
}
