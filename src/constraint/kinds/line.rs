//! Line (paper section 3.1): the direction of the line is the eigenvector of the greatest
//! eigenvalue of the scatter matrix, or is given.

use crate::constraint::parameter::Direction;
use crate::constraint::{Arity, Info, Param, Projection, TargetShape};
use crate::math::{Lane, PrincipalAxes, Scatter, Vec3};
use serde::{Deserialize, Serialize};

/// All vertices lie on one straight line, of any direction or of a given one.
///
/// If several directions fit equally well (corners of a square, coincident points), one is chosen.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Line {
    /// The direction of the line; none for the best fit.
    direction: Option<Direction>,
}

impl Projection for Line {
    const INFO: Info = Info {
        id: "line",
        label: "Line",
        summary: "The vertices lie on one straight line.",
        paper: "3.1",
        arity: Arity::AtLeast(2),
        colour: [150, 90, 200],
        params: &[Param::direction("direction", "Direction")],
        default_for: &[TargetShape::Chain],
        ..Info::PLAIN
    };

    fn closed_form<S: Lane>(
        &self,
        _rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        if let Some(direction) = &self.direction {
            let e = direction.unit();
            for (v, p) in v.iter().zip(projected) {
                *p = e * e.dot(*v);
            }
            return true;
        }
        let scatter = Scatter::of(v);
        let e = scatter.unit.greatest_eigenvector();
        for (v, p) in v.iter().zip(projected) {
            *p = e.vector * e.vector.dot(*v);
        }
        (e.accurate * scatter.in_range).all_greater(S::zero())
    }

    fn project_robust(&self, _rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let axes = PrincipalAxes::rotate(v);
        for p in v {
            *p = axes.point(Vec3::new(p.x, 0.0, 0.0));
        }
    }
}
