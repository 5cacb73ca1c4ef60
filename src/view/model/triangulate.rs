//! Triangulation of polygons for drawing and picking, by ear clipping in the polygon's mean plane
//! (Meisters 1975). Convex polygons, that is nearly all panels, become fans directly.
//!
//! The triangles keep the orientation of the polygon. Self-intersecting polygons and polygons
//! without area still give `n - 2` triangles, so that they do not disappear.

use glam::{Vec2, Vec3};

/// Returns Newell's normal of a polygon: its length is twice the area, possibly zero.
pub fn newell_normal(positions: &[Vec3], polygon: &[u32]) -> Vec3 {
    let Some(&last) = polygon.last() else { return Vec3::ZERO };
    // Relative to one corner, to avoid cancellation far from the origin.
    let origin = positions[last as usize];
    let mut before = Vec3::ZERO;
    let mut sum = Vec3::ZERO;
    for &corner in polygon {
        let at = positions[corner as usize] - origin;
        sum += before.cross(at);
        before = at;
    }
    sum
}

/// Appends the triangles of `polygon` (vertex indices into `positions`) to `triangles`.
pub fn triangulate(positions: &[Vec3], polygon: &[u32], triangles: &mut Vec<[u32; 3]>) {
    if polygon.len() < 3 {
        return;
    }
    if polygon.len() == 3 {
        triangles.push([polygon[0], polygon[1], polygon[2]]);
        return;
    }
    let flat = flatten(positions, polygon);
    let mut left: Vec<usize> = (0..polygon.len()).collect();
    if (0..flat.len()).all(|i| turn(&flat, &left, i) >= 0.0) {
        triangles.extend(polygon[1..].windows(2).map(|w| [polygon[0], w[0], w[1]]));
        return;
    }
    while left.len() > 3 {
        let ear = best_ear(&flat, &left);
        let (before, after) = neighbours(left.len(), ear);
        triangles.push([left[before], left[ear], left[after]].map(|i| polygon[i]));
        left.remove(ear);
    }
    triangles.push([left[0], left[1], left[2]].map(|i| polygon[i]));
}

/// Projects the corners to the plane of the polygon's normal, counter-clockwise.
fn flatten(positions: &[Vec3], polygon: &[u32]) -> Vec<Vec2> {
    let normal = newell_normal(positions, polygon).try_normalize().unwrap_or(Vec3::Z);
    let (u, v) = normal.any_orthonormal_pair();
    let origin = positions[polygon[0] as usize];
    polygon
        .iter()
        .map(|&corner| {
            let at = positions[corner as usize] - origin;
            Vec2::new(at.dot(u), at.dot(v))
        })
        .collect()
}

fn neighbours(count: usize, i: usize) -> (usize, usize) {
    ((i + count - 1) % count, (i + 1) % count)
}

/// Returns twice the signed area of the triangle at remaining corner `i`; negative if reflex.
fn turn(flat: &[Vec2], left: &[usize], i: usize) -> f32 {
    let (before, after) = neighbours(left.len(), i);
    let at = flat[left[i]];
    (at - flat[left[before]]).perp_dot(flat[left[after]] - at)
}

/// Returns the ear with the shortest new side, or the least reflex corner if there is no ear.
fn best_ear(flat: &[Vec2], left: &[usize]) -> usize {
    let new_side = |i: usize| {
        let (before, after) = neighbours(left.len(), i);
        flat[left[before]].distance_squared(flat[left[after]])
    };
    let ears = (0..left.len()).filter(|&i| is_ear(flat, left, i));
    ears.min_by(|&i, &j| new_side(i).total_cmp(&new_side(j))).unwrap_or_else(|| {
        (0..left.len())
            .max_by(|&i, &j| turn(flat, left, i).total_cmp(&turn(flat, left, j)))
            .unwrap_or(0)
    })
}

/// Returns whether the triangle at corner `i` is convex and contains no other corner.
fn is_ear(flat: &[Vec2], left: &[usize], i: usize) -> bool {
    if turn(flat, left, i) <= 0.0 {
        return false;
    }
    let (before, after) = neighbours(left.len(), i);
    let (a, b, c) = (flat[left[before]], flat[left[i]], flat[left[after]]);
    (0..left.len()).filter(|&j| j != before && j != i && j != after).all(|j| {
        let p = flat[left[j]];
        let outside = |from: Vec2, to: Vec2| (to - from).perp_dot(p - from) < 0.0;
        outside(a, b) || outside(b, c) || outside(c, a)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(positions: &[Vec3], triangles: &[[u32; 3]]) -> f32 {
        triangles.iter().map(|t| newell_normal(positions, t).length() / 2.0).sum()
    }

    fn cut(positions: &[Vec3]) -> Vec<[u32; 3]> {
        let polygon: Vec<u32> = (0..positions.len() as u32).collect();
        let mut triangles = Vec::new();
        triangulate(positions, &polygon, &mut triangles);
        triangles
    }

    #[test]
    fn a_convex_polygon_is_a_fan_from_its_first_corner() {
        let hexagon: Vec<Vec3> = (0..6)
            .map(|i| {
                let angle = i as f32 * std::f32::consts::FRAC_PI_3;
                Vec3::new(angle.cos(), 2.0, angle.sin())
            })
            .collect();
        let triangles = cut(&hexagon);
        assert_eq!(triangles.len(), 4);
        assert!(triangles.iter().all(|t| t[0] == 0));
    }

    /// Triangles of a concave polygon overlap, and so have too much area, unless they lie inside.
    #[test]
    fn a_concave_polygon_is_covered_once_from_every_first_corner() {
        let outline = [
            [0.0, 0.0],
            [4.0, 0.0],
            [4.0, 3.0],
            [3.0, 3.0],
            [3.0, 1.0],
            [1.0, 1.0],
            [1.0, 3.0],
            [0.0, 3.0],
        ];
        for start in 0..outline.len() {
            let positions: Vec<Vec3> = (0..outline.len())
                .map(|i| outline[(start + i) % outline.len()])
                .map(|[x, y]| Vec3::new(x, 0.3 * x + 0.1 * y, y))
                .collect();
            let polygon: Vec<u32> = (0..outline.len() as u32).collect();
            let expected = newell_normal(&positions, &polygon).length() / 2.0;
            let triangles = cut(&positions);
            assert_eq!(triangles.len(), outline.len() - 2);
            assert!((area(&positions, &triangles) - expected).abs() < 1e-5 * expected);
        }
    }

    #[test]
    fn an_arrowhead_quad_is_cut_at_its_reflex_corner() {
        let dart = [
            Vec3::ZERO,
            Vec3::new(2.0, 1.0, 0.0),
            Vec3::new(0.5, 0.5, 0.0),
            Vec3::new(1.0, 2.0, 0.0),
        ];
        for t in cut(&dart) {
            assert!(t.contains(&0) && t.contains(&2), "{t:?} does not use the diagonal 0-2");
        }
    }

    #[test]
    fn triangles_turn_as_their_polygon_does() {
        let ell = [[0.0, 0.0], [0.0, 2.0], [1.0, 2.0], [1.0, 1.0], [2.0, 1.0], [2.0, 0.0]]
            .map(|[x, y]| Vec3::new(x, y, 0.0));
        let normal = newell_normal(&ell, &[0, 1, 2, 3, 4, 5]);
        for t in cut(&ell) {
            assert!(newell_normal(&ell, &t).dot(normal) > 0.0);
        }
    }

    #[test]
    fn polygons_without_area_still_give_triangles() {
        assert_eq!(cut(&[Vec3::ONE; 5]).len(), 3);
        let bow =
            [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]].map(|[x, y]| Vec3::new(x, y, 0.0));
        assert_eq!(cut(&bow).len(), 2);
        assert!(cut(&[Vec3::ZERO, Vec3::ONE]).is_empty());
    }
}
