//! Line (paper section 3.1): the direction of the line is the eigenvector of the greatest
//! eigenvalue of the scatter matrix.

use super::{Arity, Info, Projection};
use crate::math::{Lane, PrincipalAxes, Scatter, Vec3, each_lane};
use serde::{Deserialize, Serialize};

/// All vertices on one straight line.
///
/// Where two directions fit equally well (the corners of a square, coincident points) one of them
/// is taken; both are closest.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Line {}

impl Projection for Line {
    const INFO: Info = Info {
        id: "line",
        label: "Line",
        summary: "The vertices lie on one straight line.",
        paper: "3.1",
        arity: Arity::AtLeast(2),
        exact: true,
        measure: None,
        colour: [150, 90, 200],
        params: &[],
    };

    fn project<S: Lane>(&self, _rest: &[Vec3<S>], v: &mut [Vec3<S>]) {
        let scatter = Scatter::of(v);
        let e = scatter.unit.greatest_eigenvector();
        if (e.accurate * scatter.in_range).all_greater(S::zero()) {
            for p in v {
                *p = e.vector * e.vector.dot(*p);
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
        *p = axes.point(Vec3::new(p.x, 0.0, 0.0));
    }
}
