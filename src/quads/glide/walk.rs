//! A walk over triangles to the point of the surface that is nearest to one beside it.

use crate::math::Vec3;
use crate::quads::grid_map::{Side, Triangulation};

/// The most triangles of a walk; those of a panel are fewer.
const MOST: usize = 64;

/// Walks from a triangle, over the sides beyond which the point lies, to the triangle above or below
/// which it is, without crossing features. Returns that triangle, and the point on it: a point of
/// the side at which the walk ends, where it cannot go on or would come back.
pub(super) fn walk(surface: &Triangulation, start: usize, point: Vec3<f64>) -> (usize, Vec3<f64>) {
    let (mut triangle, mut last) = (start, None);
    for _ in 0..MOST {
        let weights = surface.barycentric(triangle, point);
        let beyond = (0..3).filter(|&k| weights[k] < 0.0);
        let Some(corner) = beyond.min_by(|&i, &j| weights[i].total_cmp(&weights[j])) else {
            let at = |k: usize| surface.at(triangle, k) * weights[k];
            return (triangle, at(0) + at(1) + at(2));
        };
        let side = Side { triangle, side: (corner + 1) % 3 };
        let next = surface.across(side).filter(|_| !surface.is_feature(side));
        match next {
            Some(next) if last != Some(next.triangle) => {
                (triangle, last) = (next.triangle, Some(triangle));
            }
            _ => return (triangle, on_side(surface, side, point)),
        }
    }
    (triangle, on_side(surface, Side { triangle, side: 0 }, point))
}

/// The point of a side that is nearest to a point.
fn on_side(surface: &Triangulation, side: Side, point: Vec3<f64>) -> Vec3<f64> {
    let along = surface.along(side);
    let start = surface.at(side.triangle, side.side);
    let share = (point - start).dot(along) / along.length_squared();
    start + along * share.clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two triangles that meet in the y axis, the second one bent down by `slope`.
    fn roof(slope: f64, crease: bool) -> Triangulation {
        let at = Vec3::new;
        let positions =
            vec![at(-1.0, 0.5, -slope), at(0.0, 0.0, 0.0), at(0.0, 1.0, 0.0), at(1.0, 0.5, -slope)];
        let beside = |triangle, side| Some(Side { triangle, side });
        Triangulation {
            positions,
            triangles: vec![[0, 1, 2], [3, 2, 1]],
            neighbours: vec![[None, beside(1, 1), None], [None, beside(0, 1), None]],
            feature: vec![[true, crease, true]; 2],
            vertices: vec![None; 4],
        }
    }

    #[test]
    fn the_walk_ends_at_the_foot_of_the_point() {
        let flat = roof(0.0, false);
        assert_eq!(walk(&flat, 0, Vec3::new(0.25, 0.5, 3.0)), (1, Vec3::new(0.25, 0.5, 0.0)));
        // Beyond the boundary it ends on it.
        let (triangle, found) = walk(&flat, 0, Vec3::new(5.0, 0.5, 0.0));
        assert_eq!((triangle, found), (1, Vec3::new(1.0, 0.5, 0.0)));
    }

    #[test]
    fn over_a_ridge_and_at_a_crease_it_ends_on_the_edge() {
        // Above a ridge each triangle sends the point to the other.
        let (_, found) = walk(&roof(2.0, false), 0, Vec3::new(0.1, 0.5, 1.0));
        assert_eq!(found, Vec3::new(0.0, 0.5, 0.0));
        let (triangle, found) = walk(&roof(0.0, true), 0, Vec3::new(0.25, 0.5, 0.0));
        assert_eq!((triangle, found), (0, Vec3::new(0.0, 0.5, 0.0)));
    }
}
