//! Least-squares fit of a quadric height function through a point to its neighbours, and the second
//! fundamental form at that point (Cazals and Pouget 2005, osculating jets of degree two).

use crate::math::Vec3;
use nalgebra::{Matrix5, Vector5};

/// Number of unknowns of `h(x, y) = a x^2 + b x y + c y^2 + d x + e y`.
const N: usize = 5;
/// Relative pivot threshold. Below it, the points lie on a conic through the origin, and the
/// quadric is not unique.
const SINGULAR: f64 = 1e-10;

/// A symmetric second fundamental form in an orthonormal frame of the tangent plane.
#[derive(Clone, Copy, Debug)]
pub(super) struct SecondForm {
    /// Orthonormal axes of the tangent plane; their cross product is the normal.
    pub(super) axes: [Vec3<f64>; 2],
    /// Values on the pairs of axes (first, first), (first, second) and (second, second).
    pub(super) values: [f64; 3],
}

/// Fits a quadric over the plane of the orthonormal axes to `around`, relative to the point that it
/// interpolates, and returns its second fundamental form. Positive curvature bends towards the
/// normal, the cross product of the axes. `None` if the points do not determine a quadric.
pub(super) fn fit(around: &[Vec3<f64>], [x_axis, y_axis]: [Vec3<f64>; 2]) -> Option<SecondForm> {
    let normal = x_axis.cross(y_axis);
    let mean_square =
        around.iter().map(|p| p.length_squared()).sum::<f64>() / around.len().max(1) as f64;
    if around.len() < N || mean_square.is_nan() || mean_square <= 0.0 {
        return None;
    }
    // Scaled by the root mean square distance, all coefficients are of the same magnitude.
    let unit = 1.0 / mean_square.sqrt();
    let (mut normal_matrix, mut right) = (Matrix5::zeros(), Vector5::zeros());
    for &point in around {
        let [x, y, h] = [x_axis, y_axis, normal].map(|axis| axis.dot(point) * unit);
        let row = Vector5::new(x * x, x * y, y * y, x, y);
        normal_matrix.ger(1.0, &row, &row, 1.0);
        right.axpy(h, &row, 1.0);
    }
    let factor = normal_matrix.cholesky()?;
    // Their squares are the pivots.
    let diagonal = factor.l_dirty().diagonal();
    if diagonal.min() * diagonal.min() <= SINGULAR * diagonal.max() * diagonal.max() {
        return None;
    }
    let [[a, b, c, d, e]] = factor.solve(&right).into();
    // First form (E, F, G) and second form (L, M, N) of the graph at the origin.
    let area = (1.0 + d * d + e * e).sqrt();
    let [l, m, n] = [2.0 * a, b, 2.0 * c].map(|value| value * unit / area);
    let (big_e, f) = (1.0 + d * d, d * e);
    let length = big_e.sqrt();
    // The first axis is along x on the surface, the second perpendicular to it:
    // (-F, E) / (sqrt(E) area).
    let (u, v) = (-f / (length * area), length / area);
    let tangent_x = x_axis + normal * d;
    let tangent_y = y_axis + normal * e;
    Some(SecondForm {
        axes: [tangent_x * (1.0 / length), tangent_x * u + tangent_y * v],
        values: [l / big_e, (l * u + m * v) / length, l * u * u + 2.0 * m * u * v + n * v * v],
    })
}
