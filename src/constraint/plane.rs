//! Plane (paper section 3.1): the normal of the plane is the eigenvector of the smallest eigenvalue
//! of the scatter matrix.

use super::{Arity, Info, Projection};
use crate::math::{Lane, PrincipalAxes, Scatter, Vec3, each_lane};
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
        exact: true,
        measure: Some("planarity"),
        colour: [190, 120, 0],
        params: &[],
    };

    fn project<S: Lane>(&self, _rest: &[Vec3<S>], v: &mut [Vec3<S>]) {
        let scatter = Scatter::of(v);
        let n = scatter.unit.smallest_eigenvector();
        if (n.accurate * scatter.in_range).all_greater(S::zero()) {
            for p in v {
                *p -= n.vector * n.vector.dot(*p);
            }
        } else if S::WIDTH > 1 {
            each_lane(v, |one| self.project(&[], one));
        } else {
            each_lane(v, project_in_principal_axes);
        }
    }
}

/// The same for one constraint, accurate for every input.
fn project_in_principal_axes(v: &mut [Vec3<f64>]) {
    let axes = PrincipalAxes::rotate(v);
    for p in v {
        *p = axes.point(Vec3::new(p.x, p.y, 0.0));
    }
}
