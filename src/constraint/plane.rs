//! Plane (paper section 3.1): the normal of the plane is the eigenvector of the smallest eigenvalue
//! of the scatter matrix.

use super::{Arity, Centring, Info, Projection};
use crate::math::{Lane, PrincipalAxes, Scatter, Vec3};
use serde::{Deserialize, Serialize};

/// All vertices in one plane.
///
/// Where several planes fit equally well (collinear points, a regular tetrahedron) one of them is
/// taken; all are closest.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Plane {}

impl Projection for Plane {
    const INFO: Info = Info {
        id: "plane",
        label: "Plane",
        summary: "The vertices lie in one plane, so that the panel can be cut from a flat sheet.",
        paper: "3.1",
        arity: Arity::AtLeast(3),
        centring: Centring::Together,
        elements: &[],
        exact: true,
        measure: Some("planarity"),
        colour: [190, 120, 0],
        params: &[],
    };

    fn closed_form<S: Lane>(
        &self,
        _rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        let scatter = Scatter::of(v);
        let n = scatter.unit.smallest_eigenvector();
        for (v, p) in v.iter().zip(projected) {
            *p = *v - n.vector * n.vector.dot(*v);
        }
        (n.accurate * scatter.in_range).all_greater(S::zero())
    }

    fn careful(&self, _rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let axes = PrincipalAxes::rotate(v);
        for p in v {
            *p = axes.point(Vec3::new(p.x, p.y, 0.0));
        }
    }
}
