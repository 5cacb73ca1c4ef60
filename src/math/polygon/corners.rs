//! The sides and corners of a polygon in order, for loops over the faces of a mesh.

use crate::math::Vec3;

/// The sides of a polygon: each corner with the next one, the last with the first.
pub fn polygon_sides<T: Copy>(corners: &[T]) -> impl Iterator<Item = [T; 2]> + Clone + '_ {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(&here, &next)| [here, next])
}

/// The corners of a polygon, each between its predecessor and its successor.
pub fn polygon_corners<T: Copy>(corners: &[T]) -> impl Iterator<Item = [T; 3]> + Clone + '_ {
    let n = corners.len();
    (0..n).map(move |k| [corners[(k + n - 1) % n], corners[k], corners[(k + 1) % n]])
}

/// Twice the vector area of a polygon, flat or not: the sum over the triangles `(p0, pk, pk+1)`.
/// For a flat polygon it is normal to the plane, and its length is twice the area.
pub fn twice_vector_area(corners: impl IntoIterator<Item = Vec3<f64>>) -> Vec3<f64> {
    let mut corners = corners.into_iter();
    let Some(first) = corners.next() else { return Vec3::zero() };
    let (mut sum, mut before) = (Vec3::zero(), Vec3::zero());
    for corner in corners {
        let at = corner - first;
        sum += before.cross(at);
        before = at;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sides_and_corners_go_round() {
        let sides: Vec<_> = polygon_sides(&[4, 7, 2]).collect();
        assert_eq!(sides, [[4, 7], [7, 2], [2, 4]]);
        let corners: Vec<_> = polygon_corners(&[4, 7, 2]).collect();
        assert_eq!(corners, [[2, 4, 7], [4, 7, 2], [7, 2, 4]]);
        assert_eq!(polygon_sides::<u32>(&[]).count() + polygon_corners::<u32>(&[]).count(), 0);
    }

    #[test]
    fn the_vector_area_does_not_depend_on_the_first_corner() {
        // A unit square with a reflex corner, on a plane far away.
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.5, 0.5], [0.0, 1.0]];
        for k in 0..corners.len() {
            let turned = (0..5).map(|i| corners[(i + k) % 5]);
            let area = twice_vector_area(turned.map(|[x, y]| Vec3::new(1e3 + x, 7.0, y)));
            assert_eq!(area, Vec3::new(0.0, -1.5, 0.0));
        }
        assert_eq!(twice_vector_area([]), Vec3::zero());
    }
}
