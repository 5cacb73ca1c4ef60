//! The sides and corners of a polygon in order, for loops over the faces of a mesh, its vector
//! area, and axes of the plane that two vectors span.

use crate::math::{Lane, Vec3};

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

/// Corners of polygons with at most this many are compared with each other.
const FEW_CORNERS: usize = 32;

/// Whether a polygon visits a corner twice.
pub fn visits_twice<T: Copy + Ord>(corners: &[T]) -> bool {
    if corners.len() <= FEW_CORNERS {
        return (1..corners.len()).any(|k| corners[..k].contains(&corners[k]));
    }
    let mut sorted = corners.to_vec();
    sorted.sort_unstable();
    sorted.windows(2).any(|pair| pair[0] == pair[1])
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

/// A vector shorter than this fraction of another is rounding error.
const NEGLIGIBLE: f64 = 4.0 * f64::EPSILON;

/// Returns orthonormal axes `e`, `f` of the plane of `x` and `y`, such that the turn from `x` to
/// `y` by less than 180 degrees goes from `e` to `f`.
///
/// For parallel vectors `f` is orthogonal to them, in their plane with one of the coordinate axes
/// farthest from them. The vectors must be finite with squares in the range of `f64`, and at least
/// one of them nonzero.
#[inline(always)]
pub fn plane_frame<S: Lane>(x: Vec3<S>, y: Vec3<S>) -> [Vec3<S>; 2] {
    let (xx, yy) = (x.length_squared(), y.length_squared());
    let long = Vec3::if_greater(yy, xx, y, x);
    let short = Vec3::if_greater(yy, xx, x, y);
    let e = long * (S::one() / xx.max(yy).sqrt());
    let across = short - e * e.dot(short);
    // Repeated: if the remainder is small, the rounding error of the first time is large beside it.
    let across = across - e * e.dot(across);
    let bound = S::splat(NEGLIGIBLE * NEGLIGIBLE) * xx.min(yy);
    let f = Vec3::if_greater(across.length_squared(), bound, across, e.across());
    let f = f * (S::one() / f.length());
    [e, Vec3::if_greater(yy, xx, -f, f)]
}

#[cfg(test)]
mod tests {
    use super::{plane_frame, *};
    use crate::math::Vec3;

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

    #[test]
    fn axes_are_orthonormal_and_turn_from_the_first_to_the_second() {
        let x = Vec3::new(0.3, -0.8, 0.5);
        let aside = Vec3::new(0.7, 0.1, -0.2);
        for sine in [1.0, 1e-3, 1e-9, 1e-14, 1e-18, 0.0] {
            for along in [0.2, -3.0, 1.0, 1e-9, 0.0] {
                let y = x * along + aside * sine;
                for (x, y) in [(x, y), (y, x)] {
                    let [e, f] = plane_frame(x, y);
                    for (product, expected) in [(e.dot(e), 1.0), (f.dot(f), 1.0), (e.dot(f), 0.0)] {
                        let error: f64 = product - expected;
                        assert!(error.abs() <= 1e-15, "{x:?}, {y:?}: {product}");
                    }
                    for p in [x, y] {
                        let off = p - e * e.dot(p) - f * f.dot(p);
                        assert!(off.length() <= 1e-15 * p.length().max(1e-3), "{x:?}, {y:?}");
                    }
                    let turn = e.dot(x) * f.dot(y) - f.dot(x) * e.dot(y);
                    assert!(turn >= -1e-15 * x.length() * y.length(), "{x:?}, {y:?}: {turn:e}");
                }
            }
        }
    }
}
