//! Polygons as triangles, for drawing and picking.

use crate::math;
use glam::Vec3;

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

/// The triangles of a polygon around its first corner.
pub fn fan(polygon: &[u32]) -> impl Iterator<Item = [u32; 3]> + Clone + '_ {
    (2..polygon.len()).map(|k| [polygon[0], polygon[k - 1], polygon[k]])
}

/// Whether no triangle of a polygon is turned over, as seen along its normal.
pub fn is_whole(
    positions: &[Vec3],
    mut triangles: impl Iterator<Item = [u32; 3]>,
    outside: Vec3,
) -> bool {
    triangles.all(|own| newell_normal(positions, &own).dot(outside) >= 0.0)
}

/// Appends the triangles of `polygon` (vertex indices into `positions`) to `triangles`: `n - 2` with
/// the orientation of the polygon. Those of a polygon that crosses itself, or has no area, may
/// overlap; it does not disappear.
pub fn triangulate(positions: &[Vec3], polygon: &[u32], triangles: &mut Vec<[u32; 3]>) {
    // Nearly all panels are such a fan, which needs no copy.
    let outside = newell_normal(positions, polygon);
    if is_whole(positions, fan(polygon), outside) {
        triangles.extend(fan(polygon));
        return;
    }
    let corner = |&v: &u32| math::Vec3::from(positions[v as usize].to_array().map(f64::from));
    let corners: Vec<math::Vec3<f64>> = polygon.iter().map(corner).collect();
    let own = math::triangles_in_space(&corners).into_iter();
    triangles.extend(own.map(|triangle| triangle.map(|k| polygon[k])));
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
    fn a_hole_that_a_slit_joins_to_the_outline_stays_open() {
        // Its ends are corners at one point; the triangles went across the hole.
        let outline = [
            [0.0, 0.0],
            [4.0, 0.0],
            [4.0, 4.0],
            [0.0, 4.0],
            [0.0, 0.0],
            [1.0, 1.0],
            [1.0, 3.0],
            [3.0, 3.0],
            [3.0, 1.0],
            [1.0, 1.0],
        ];
        let positions = outline.map(|[x, y]| Vec3::new(x, y, 0.5));
        let triangles = cut(&positions);
        assert_eq!(triangles.len(), 8);
        assert!((area(&positions, &triangles) - 12.0).abs() < 1e-5);
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
