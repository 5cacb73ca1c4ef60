//! Criterion for a quad with a circumscribed circle, without fitting one (Liu, Pottmann, Wallner,
//! Yang, Wang: Geometric modeling with conical meshes and developable surfaces, 2006): the sums of
//! opposite angles are pi, and the corners are coplanar. The residuals are dimensionless.

use crate::math::{Vec3, angle};
use std::f64::consts::PI;

/// Number of residuals of a quad.
pub(super) const RESIDUALS: usize = 3;

/// The residuals of one quad with their derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AngleSums {
    /// The sum of the first and the third angle minus pi, the same for the second and the fourth,
    /// and the signed volume spanned by the corners. The angle sums alone are insensitive to a
    /// small bend: they change with its square.
    pub residuals: [f64; 3],
    /// Derivative of each residual by each corner.
    pub derivatives: [[Vec3<f64>; 4]; 3],
}

impl AngleSums {
    /// Evaluates the residuals at four corners, in order around the quad. The volume is divided by
    /// `length` cubed. The result is not finite if an edge has zero length or two adjacent edges
    /// are collinear: the angles then have no derivative.
    pub fn of(corners: [Vec3<f64>; 4], length: f64) -> AngleSums {
        let mut residuals = [-PI, -PI, 0.0];
        let mut derivatives = [[Vec3::zero(); 4]; RESIDUALS];
        for k in 0..4 {
            let [next, before] = [(k + 1) % 4, (k + 3) % 4];
            let (u, v) = (corners[next] - corners[k], corners[before] - corners[k]);
            let (u_length, v_length) = (u.length(), v.length());
            let (u, v) = (u * (1.0 / u_length), v * (1.0 / v_length));
            let (cosine, sine) = (u.dot(v), u.cross(v).length());
            let sum = k % 2;
            residuals[sum] += angle(cosine, sine);
            let by_next = (u * cosine - v) * (1.0 / (sine * u_length));
            let by_before = (v * cosine - u) * (1.0 / (sine * v_length));
            let by = &mut derivatives[sum];
            by[next] += by_next;
            by[before] += by_before;
            by[k] += by_next * -1.0 - by_before;
        }
        let scale = 1.0 / (length * length * length);
        let [a, b, c] = [1, 2, 3].map(|k| corners[k] - corners[0]);
        residuals[2] = scale * a.dot(b.cross(c));
        let [by_a, by_b, by_c] = [b.cross(c), c.cross(a), a.cross(b)].map(|by| by * scale);
        derivatives[2] = [(by_a + by_b + by_c) * -1.0, by_a, by_b, by_c];
        AngleSums { residuals, derivatives }
    }
}
