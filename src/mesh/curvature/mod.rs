//! Principal curvatures, lines of curvature, and the alignment of mesh edges with them.
//!
//! The curvature at a vertex is that of a quadric height function through it, fitted to its
//! neighbours in least squares (Cazals and Pouget 2005, osculating jets of degree two).

mod edges;
mod field;
mod spaced;
#[cfg(test)]
mod tests;
mod trace;

pub use edges::CurvatureLines;
pub(crate) use field::form_on;
pub use field::{CurvatureField, Family, SurfacePoint};
pub use trace::CurvatureLine;

use crate::math::Vec3;
use crate::mesh::topology::oriented_areas;
use crate::mesh::{Point, Ragged, Topology};
use nalgebra::{Matrix5, Vector5};

/// Number of rings of neighbours in a fit.
const RINGS: u32 = 2;
/// The surface counts as flat over a length if it turns by less than this, in radians.
const FLAT: f64 = 1e-3;

/// A symmetric tensor in space: xx, yy, zz, xy, xz, yz.
pub(crate) type Tensor = [f64; 6];

/// Curvature of the surface at a vertex, in one over the unit of the mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curvature {
    /// The larger and the smaller principal curvature. Positive curvature bends towards the normal:
    /// a sphere with outward normals has negative curvatures.
    pub principal: [f64; 2],
    /// The orthogonal unit principal directions; arbitrary if the curvatures are equal.
    pub directions: [Vec3<f64>; 2],
    /// The unit normal, on the side from which the faces at the vertex turn counterclockwise, or would if
    /// they agreed with most of their component.
    pub normal: Vec3<f64>,
}

impl Curvature {
    /// Product of the principal curvatures; [`crate::mesh::gauss_curvature`] uses angles instead.
    pub fn gauss(&self) -> f64 {
        self.principal[0] * self.principal[1]
    }

    /// Mean of the principal curvatures; positive if the surface bends towards the normal.
    pub fn mean(&self) -> f64 {
        0.5 * (self.principal[0] + self.principal[1])
    }

    /// The second fundamental form as a symmetric tensor.
    pub(crate) fn tensor(&self) -> Tensor {
        let mut tensor = [0.0; 6];
        for (value, Vec3 { x, y, z }) in self.principal.into_iter().zip(self.directions) {
            let square = [x * x, y * y, z * z, x * y, x * z, y * z];
            tensor.iter_mut().zip(square).for_each(|(sum, part)| *sum += value * part);
        }
        tensor
    }

    /// Whether the principal directions are defined: the principal curvatures differ by more than
    /// the fraction `umbilic` of the sum of their absolute values, and the surface turns by at
    /// least [`FLAT`] over `length`.
    fn has_directions(&self, umbilic: f64, length: f64) -> bool {
        let [larger, smaller] = self.principal;
        let size = larger.abs() + smaller.abs();
        larger - smaller > umbilic * size && size * length >= FLAT
    }

    /// Diagonalises a second fundamental form.
    fn of(SecondForm { axes: [x, y], values: [l, m, n] }: SecondForm) -> Curvature {
        let (mean, half) = (0.5 * (l + n), 0.5 * (l - n));
        let radius = (half * half + m * m).sqrt();
        // Of the two equations of an eigenvector, take the one without cancellation.
        let (u, v) = if half >= 0.0 { (radius + half, m) } else { (m, radius - half) };
        let length = (u * u + v * v).sqrt();
        let first = if length > 0.0 { x * (u / length) + y * (v / length) } else { x };
        let normal = x.cross(y);
        Curvature {
            principal: [mean + radius, mean - radius],
            directions: [first, normal.cross(first)],
            normal,
        }
    }
}

/// Returns the curvature at each vertex, `#V`, of the quadric fitted to its two rings of
/// neighbours. On a smooth surface the error is of first order in the edge length, and of second
/// order if the neighbours lie symmetrically. `None` without faces, with fewer than five
/// neighbours, or if the neighbours do not determine a quadric.
pub fn curvatures(
    positions: &[Point],
    faces: &Ragged,
    topology: &Topology,
) -> Vec<Option<Curvature>> {
    let at = |v: u32| Vec3::from(positions[v as usize]);
    let areas = oriented_areas(positions, faces, topology);
    let of_vertex = |v: u32| {
        let around = topology.vertex_faces().row(v as usize);
        let sum = around.iter().fold(Vec3::zero(), |sum, &f| sum + areas[f as usize]);
        let (_, normal) = sum.length_and_direction();
        let normal = normal?;
        let x = normal.across();
        let neighbours: Vec<Vec3<f64>> =
            topology.ring(v, RINGS)[1..].iter().map(|&u| at(u) - at(v)).collect();
        fit(&neighbours, [x, normal.cross(x)]).map(Curvature::of)
    };
    (0..positions.len() as u32).map(of_vertex).collect()
}

/// Returns the mean of a quantity over the corners of each face, `#F`; NaN if all are unknown.
pub fn face_curvatures(
    positions: &[Point],
    faces: &Ragged,
    topology: &Topology,
    quantity: impl Fn(&Curvature) -> f64,
) -> Vec<f64> {
    let known = curvatures(positions, faces, topology);
    let mean = |face: &[u32]| {
        let corners = face.iter().filter_map(|&v| known[v as usize].as_ref()).map(&quantity);
        let (sum, count) = corners.fold((0.0, 0.0), |(sum, n), value| (sum + value, n + 1.0));
        if count > 0.0 { sum / count } else { f64::NAN }
    };
    faces.iter().map(mean).collect()
}

/// Number of unknowns of `h(x, y) = a x^2 + b x y + c y^2 + d x + e y`.
const N: usize = 5;
/// Relative pivot threshold. Below it, the points lie on a conic through the origin, and the
/// quadric is not unique.
const SINGULAR: f64 = 1e-10;

/// A symmetric second fundamental form in an orthonormal frame of the tangent plane.
#[derive(Clone, Copy, Debug)]
struct SecondForm {
    /// Orthonormal axes of the tangent plane; their cross product is the normal.
    axes: [Vec3<f64>; 2],
    /// Values on the pairs of axes (first, first), (first, second) and (second, second).
    values: [f64; 3],
}

/// Fits a quadric over the plane of the orthonormal axes to `around`, relative to the point that it
/// interpolates, and returns its second fundamental form. Positive curvature bends towards the
/// normal, the cross product of the axes. `None` if the points do not determine a quadric.
fn fit(around: &[Vec3<f64>], [x_axis, y_axis]: [Vec3<f64>; 2]) -> Option<SecondForm> {
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
