//! Angle distortion of a flat map of a surface (Sander, Snyder, Gortler, Hoppe 2001).

use crate::math::{Vec3, twice_vector_area};
use crate::mesh::{BoundingSphere, Point, Ragged, at_vertices};
use serde::Serialize;

/// Quasi-conformal error over the triangles of the fans `(f0, fk, fk+1)`: the ratio of the larger
/// to the smaller singular value, 1 if the map preserves angles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct QuasiConformal {
    /// The mean, weighted by the areas on the surface.
    pub mean: f64,
    /// The maximum; infinite if a triangle has collapsed.
    pub max: f64,
}

/// Distortion of the triangles of a surface by a flat map.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MapErrors {
    /// Over all triangles.
    pub quasi_conformal: QuasiConformal,
    /// Number of triangles that the map flips relative to their face.
    pub flipped: usize,
    /// The faces with flipped triangles, ascending.
    pub flipped_faces: Vec<u32>,
    /// `#F`: the largest error of the triangles of each face; NaN if none has an area.
    pub of_faces: Vec<f64>,
}

/// Relative height of a triangle, against the size of the mesh, below which its area is rounding
/// error.
const ROUNDING: f64 = 1e-12;

/// Returns the errors of the map `uv` (`#V by 2`) of the surface (`#V by 3` positions). Triangles
/// without area on the surface are ignored, and so are the faces `left_out` of the map, ascending.
pub fn quasi_conformal(
    positions: &[Point],
    uv: &[[f64; 2]],
    faces: &Ragged,
    left_out: &[u32],
) -> MapErrors {
    let least =
        ROUNDING * BoundingSphere::of(&at_vertices(positions, &[faces.indices()])).diameter();
    let (mut error, mut area, mut flipped) = (QuasiConformal::default(), 0.0, 0);
    let mut flipped_faces = Vec::new();
    let mut of_faces = Vec::with_capacity(faces.len());
    for (index, face) in (0..).zip(faces.iter()) {
        if left_out.binary_search(&index).is_ok() {
            of_faces.push(f64::NAN);
            continue;
        }
        let mut worst = f64::NAN;
        let flipped_before = flipped;
        let upward = twice_vector_area(face.iter().map(|&v| Vec3::from(positions[v as usize])));
        for side in face[1..].windows(2) {
            let corners = [face[0], side[0], side[1]].map(|v| v as usize);
            let [p, q, r] = corners.map(|v| Vec3::from(positions[v]));
            let (along, across) = (q - p, r - p);
            let base = along.length();
            let normal = along.cross(across);
            let twice_area = normal.length();
            let longest = base.max(across.length()).max((r - q).length());
            if twice_area <= least * longest {
                continue;
            }
            // A triangle of the fan of a non-convex face can be flipped on the surface already.
            let is_reversed = normal.dot(upward) < 0.0;
            // Corners of the triangle in its own plane: (0, 0), (base, 0), (foot, height).
            let (foot, height) = (along.dot(across) / base, twice_area / base);
            let [u0, u1, u2] = corners.map(|v| uv[v]);
            let (e, f) = ([u1[0] - u0[0], u1[1] - u0[1]], [u2[0] - u0[0], u2[1] - u0[1]]);
            // Columns of the Jacobian: the images of the two axes.
            let x = e.map(|e| e / base);
            let y = [0, 1].map(|i| (f[i] - x[i] * foot) / height);
            // Twice the norms of the conformal and the anti-conformal part.
            let length = |a: f64, b: f64| (a * a + b * b).sqrt();
            let (keeps, turns_over) =
                (length(x[0] + y[1], x[1] - y[0]), length(x[0] - y[1], x[1] + y[0]));
            let collapsed = keeps == turns_over;
            let ratio = if collapsed {
                f64::INFINITY
            } else {
                (keeps + turns_over) / (keeps - turns_over).abs()
            };
            let is_turned = if is_reversed { keeps > turns_over } else { keeps < turns_over };
            flipped += usize::from(is_turned);
            error.mean += twice_area * ratio;
            // `f64::max` ignores NaN.
            worst = worst.max(ratio);
            area += twice_area;
        }
        error.max = error.max.max(worst);
        of_faces.push(worst);
        if flipped > flipped_before {
            flipped_faces.push(index);
        }
    }
    error.mean /= if area > 0.0 { area } else { 1.0 };
    MapErrors { quasi_conformal: error, flipped, flipped_faces, of_faces }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square of two triangles, and its image under a linear map.
    fn of(image: impl Fn(f64, f64) -> [f64; 2]) -> (QuasiConformal, usize) {
        let errors = errors(image);
        (errors.quasi_conformal, errors.flipped)
    }

    fn errors(image: impl Fn(f64, f64) -> [f64; 2]) -> MapErrors {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let positions = corners.map(|[x, y]| [x, 0.6 * y, 0.8 * y]);
        let uv = corners.map(|[x, y]| image(x, y));
        quasi_conformal(&positions, &uv, &[vec![0, 1, 2, 3]].into_iter().collect(), &[])
    }

    #[test]
    fn a_face_has_the_greatest_error_of_its_triangles_and_none_without_area() {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let positions = corners.map(|[x, y]| [x, y, 0.0]);
        // The second triangle of the square is sheared, the first is not.
        let uv = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [-0.5, 1.0]];
        let faces = [vec![0, 1, 2, 3], vec![0, 1, 2], vec![0, 1, 0]].into_iter().collect();
        let errors = quasi_conformal(&positions, &uv, &faces, &[]);
        let [quad, triangle, none] = errors.of_faces[..] else { panic!("three faces") };
        assert_eq!(quad, errors.quasi_conformal.max);
        assert!(quad > 1.5 && (triangle - 1.0).abs() < 1e-15 && none.is_nan(), "{errors:?}");
    }

    #[test]
    fn faces_that_are_turned_over_are_named_and_those_that_are_not_convex_are_not_taken_for_such() {
        // A quad with a reflex corner, and a triangle beside it.
        let positions = [[0.0, 0.0], [4.0, -3.0], [1.0, 0.0], [4.0, 3.0], [9.0, 0.0]];
        let positions = positions.map(|[x, y]| [x, y, 0.0]);
        let faces: Ragged = [vec![1, 2, 3, 0], vec![1, 4, 3]].into_iter().collect();
        let of = |image: &dyn Fn(f64, f64) -> [f64; 2]| {
            let uv = positions.map(|[x, y, _]| image(x, y));
            let errors = quasi_conformal(&positions, &uv, &faces, &[]);
            (errors.flipped, errors.flipped_faces)
        };
        assert_eq!(of(&|x, y| [x, y]), (0, vec![]));
        assert_eq!(of(&|x, y| [y, x]), (3, vec![0, 1]));
        // Folded along the common side: only the triangle is flipped.
        assert_eq!(of(&|x, y| [if x > 4.0 { 8.0 - x } else { x }, y]), (1, vec![1]));
    }

    #[test]
    fn stretch_counts_and_turning_does_not() {
        let (error, flipped) = of(|x, y| [3.0 * x - y, x + 3.0 * y]);
        assert!((error.mean - 1.0).abs() < 1e-15 && (error.max - 1.0).abs() < 1e-15);
        assert_eq!(flipped, 0);
        let (error, flipped) = of(|x, y| [2.0 * x, 0.5 * y]);
        assert!((error.mean - 4.0).abs() < 1e-14, "{error:?}");
        assert_eq!(flipped, 0);
        let (error, flipped) = of(|x, y| [y, x]);
        assert!((error.mean - 1.0).abs() < 1e-15);
        assert_eq!(flipped, 2);
    }
}
