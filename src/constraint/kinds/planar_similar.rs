//! Planar similar (paper section 3.2, Eq. 7 and 8): the closest two-dimensional similarity between
//! the points and the rest points, each in their least-squares plane.
//!
//! With complex numbers for the points of a plane, `A` of Eq. 8 is one column: the rest points
//! `r_j` divided by the first. `P = A (A^T A)^-1 A^T` is then `r r^H / |r|^2`, and with `r` of
//! length one, `P z = r (r^H z)`: no matrix is needed.
//!
//! Axes in the plane of the points are not needed either. With its unit normal `n`, multiplication
//! by `i` is the cross product with `n`. For `h_x = sum x_j v_j` and `h_y = sum y_j v_j`, where
//! `r_j = x_j + i y_j`, the images of the two axes of the rest plane are `e = h_x - n x h_y`
//! (without its component along `n`) and `n x e`. Both signs of `n` are valid; the one nearer to
//! `h_x x h_y` gives the longer `e`, and so the closer points.

use crate::constraint::{Arity, Info, Projection};
use crate::math::{Lane, PrincipalAxes, Scatter, Vec3};
use serde::{Deserialize, Serialize};

/// The vertices lie in one plane and have the rest shape, flattened to its own plane, in any size.
///
/// Not exact, unless the vertices are planar, as three always are: the closest similar shape need
/// not lie in the least-squares plane. With vertices off such a shape by 1 %, 10 % or 30 % of its
/// size, the squared distance is on average 1e-5, 3e-3 or 1 % greater than the least (8 vertices).
///
/// If several planes fit the vertices equally well, one is chosen. Coincident vertices, and a rest
/// shape without size, give one point.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct PlanarSimilar {}

impl Projection for PlanarSimilar {
    const INFO: Info = Info {
        id: "planar-similar",
        label: "Planar similar",
        summary: "The vertices lie in one plane and keep their original shape, flattened, at any size.",
        paper: "3.2, Eq. 7-8",
        arity: Arity::AtLeast(3),
        exact: false,
        colour: [125, 140, 20],
        ..Info::PLAIN
    };

    const READS_REST: bool = true;
    const USES_POSE: bool = true;

    /// Replaces the points by their coordinates in the least-squares plane, scaled so that their
    /// squares sum to one; the third is zero.
    fn prepare(&self, rest: &mut [Vec3<f64>]) {
        PrincipalAxes::rotate(rest);
        let square: f64 = rest.iter().map(|r| r.x * r.x + r.y * r.y).sum();
        if square > 0.0 {
            let length = square.sqrt();
            for r in rest {
                *r = Vec3::new(r.x / length, r.y / length, 0.0);
            }
        }
    }

    fn closed_form<S: Lane>(
        &self,
        rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        let scatter = Scatter::of(v);
        let n = scatter.unit.smallest_eigenvector();
        place(rest, v, n.vector, projected);
        (n.accurate * scatter.in_range).all_greater(S::zero())
    }

    fn project_robust(&self, rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let axes = PrincipalAxes::rotate(v);
        let coordinates = v.to_vec();
        place(rest, &coordinates, Vec3::new(0.0, 0.0, 1.0), v);
        for p in v {
            *p = axes.point(*p);
        }
    }
}

/// Writes the rest shape as close to `v` as possible, in the plane with unit normal `n` or `-n`.
#[inline(always)]
fn place<S: Lane>(rest: &[Vec3<S>], v: &[Vec3<S>], n: Vec3<S>, projected: &mut [Vec3<S>]) {
    let (mut x, mut y) = (Vec3::zero(), Vec3::zero());
    for (r, v) in rest.iter().zip(v) {
        x += *v * r.x;
        y += *v * r.y;
    }
    let n = Vec3::if_greater(n.dot(y.cross(x)), S::zero(), -n, n);
    let e = x - n * n.dot(x) - n.cross(y);
    let f = n.cross(e);
    for (r, p) in rest.iter().zip(projected) {
        *p = e * r.x + f * r.y;
    }
}
