//! Principal axes of one set of points, accurate for every input: the scalar fallback for lanes
//! whose closed form fails its check.
//!
//! One-sided Jacobi (Hestenes 1958): pairs of the three columns of the n-by-3 matrix of points are
//! rotated until they are orthogonal. The matrix of products is never formed, because its small
//! eigenvalues would lose half of their digits. The height of an arc is thus accurate to the
//! rounding error of its length.

use crate::math::{Vec3, largest_coordinate};

/// Convergence is quadratic: 99 % of a million random and degenerate inputs needed at most six
/// sweeps. Any rotation that remains after twelve is rounding error.
const SWEEPS: usize = 12;

/// Columns whose cosine is below this are orthogonal, and a column shorter than this fraction of
/// another is rounding error.
const NEGLIGIBLE: f64 = 4.0 * f64::EPSILON;

/// The principal axes of points around the origin, and their scale.
#[derive(Clone, Copy, Debug)]
pub struct PrincipalAxes {
    /// Orthonormal, ordered by extent, longest first; of either sign and handedness.
    pub axes: [Vec3<f64>; 3],
    /// The unit of principal coordinates: the greatest absolute coordinate of the input. Zero if
    /// all points are at the origin.
    pub scale: f64,
}

impl PrincipalAxes {
    /// Finds the principal axes of mean-centred points, and replaces the points by their
    /// coordinates along these axes, divided by the scale.
    pub fn rotate(points: &mut [Vec3<f64>]) -> PrincipalAxes {
        let scale = largest_coordinate(points);
        if scale > 0.0 {
            for v in points.iter_mut() {
                *v = Vec3::new(v.x / scale, v.y / scale, v.z / scale);
            }
        }
        let mut frame = Frame { points, axes: IDENTITY };
        for _ in 0..SWEEPS {
            let rotated = [(0, 1), (0, 2), (1, 2)].map(|(p, q)| frame.orthogonalise(p, q));
            if rotated == [false; 3] {
                break;
            }
        }
        frame.order(0, 1);
        frame.order(1, 2);
        frame.order(0, 1);
        PrincipalAxes { axes: frame.axes, scale }
    }

    /// The point with these principal coordinates.
    pub fn point(&self, v: Vec3<f64>) -> Vec3<f64> {
        self.direction(v) * self.scale
    }

    /// The vector with these components along the axes, not scaled.
    pub fn direction(&self, v: Vec3<f64>) -> Vec3<f64> {
        self.axes[0] * v.x + self.axes[1] * v.y + self.axes[2] * v.z
    }
}

const IDENTITY: [Vec3<f64>; 3] = [
    Vec3 { x: 1.0, y: 0.0, z: 0.0 },
    Vec3 { x: 0.0, y: 1.0, z: 0.0 },
    Vec3 { x: 0.0, y: 0.0, z: 1.0 },
];

/// The points in coordinates along the axes: each rotation changes both.
struct Frame<'a> {
    points: &'a mut [Vec3<f64>],
    axes: [Vec3<f64>; 3],
}

impl Frame<'_> {
    /// Rotates columns `p` and `q` until they are orthogonal; returns false if they already were.
    fn orthogonalise(&mut self, p: usize, q: usize) -> bool {
        let (mut pp, mut qq, mut pq) = (0.0, 0.0, 0.0);
        for v in self.points.iter() {
            let (a, b) = (component(*v, p), component(*v, q));
            pp += a * a;
            qq += b * b;
            pq += a * b;
        }
        let negligible = NEGLIGIBLE * NEGLIGIBLE;
        if pq * pq <= negligible * pp * qq || pp.min(qq) <= negligible * pp.max(qq) {
            return false;
        }
        let difference = pp - qq;
        let root = (difference * difference + 4.0 * pq * pq).sqrt();
        let tangent =
            2.0 * pq / if difference < 0.0 { difference - root } else { difference + root };
        let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
        let sine = cosine * tangent;
        for v in self.points.iter_mut() {
            let (a, b) = (component(*v, p), component(*v, q));
            *component_mut(v, p) = cosine * a + sine * b;
            *component_mut(v, q) = cosine * b - sine * a;
        }
        let (a, b) = (self.axes[p], self.axes[q]);
        self.axes[p] = a * cosine + b * sine;
        self.axes[q] = b * cosine - a * sine;
        true
    }

    /// Swaps columns `p` and `q` if `q` is the longer.
    fn order(&mut self, p: usize, q: usize) {
        let squares = |k| self.points.iter().map(|v| component(*v, k)).map(|x| x * x).sum::<f64>();
        if squares(q) > squares(p) {
            self.axes.swap(p, q);
            for v in self.points.iter_mut() {
                let (a, b) = (component(*v, p), component(*v, q));
                *component_mut(v, p) = b;
                *component_mut(v, q) = a;
            }
        }
    }
}

fn component(v: Vec3<f64>, k: usize) -> f64 {
    [v.x, v.y, v.z][k]
}

fn component_mut(v: &mut Vec3<f64>, k: usize) -> &mut f64 {
    match k {
        0 => &mut v.x,
        1 => &mut v.y,
        _ => &mut v.z,
    }
}

#[cfg(test)]
mod tests {
    use super::{PrincipalAxes, component};
    use crate::math::Vec3;
    use nalgebra::DMatrix;

    #[test]
    fn agrees_with_the_singular_values_of_nalgebra() {
        for height in [1.0, 1e-3, 1e-8, 1e-12, 0.0] {
            for depth in [1.0, 1e-4, 1e-9, 0.0] {
                let points: Vec<Vec3<f64>> = (0..9)
                    .map(|i| {
                        let (x, y, z) =
                            (f64::from(i * 7 % 9), f64::from(i * i % 5), f64::from(i % 4));
                        let (x, y, z) = (x - 4.0, height * (y - 2.0), height * depth * (z - 1.5));
                        Vec3::new(0.6 * x - 0.8 * y, 0.8 * x + 0.6 * y, z)
                    })
                    .collect();
                let mut rotated = points.clone();
                let axes = PrincipalAxes::rotate(&mut rotated);

                let rows: Vec<f64> = points.iter().flat_map(|v| [v.x, v.y, v.z]).collect();
                let svd = DMatrix::from_row_slice(9, 3, &rows).svd(false, false);
                let size = svd.singular_values[0];
                for k in 0..3 {
                    let squares = rotated.iter().map(|v| component(*v, k) * component(*v, k));
                    let extent = squares.sum::<f64>().sqrt() * axes.scale;
                    let expected = svd.singular_values[k];
                    assert!((extent - expected).abs() <= 1e-14 * size, "{height} {depth} {k}");
                    for j in 0..3 {
                        let unit = f64::from(u8::from(j == k));
                        assert!((axes.axes[k].dot(axes.axes[j]) - unit).abs() <= 1e-14);
                    }
                }
                for (v, w) in points.iter().zip(&rotated) {
                    assert!((*v - axes.point(*w)).length() <= 1e-14 * size);
                }
            }
        }
    }
}
