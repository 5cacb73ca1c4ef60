//! Circle (paper section 3.1): least-squares plane, then the circle of Thomas and Chan in it.

use crate::constraint::parameter::Limits;
use crate::constraint::{Arity, Fitted, Info, Param, Projection, TargetShape};
use crate::math::{CircleFit, Lane, PrincipalRound, Vec3, centre};
use serde::{Deserialize, Serialize};

/// All vertices lie on one circle, in any order and spacing; its radius is free, given, or limited.
///
/// Not exact: with vertices off a circle by 1 %, 10 % or 30 % of its radius, the squared distance is
/// on average 3e-5, 3e-3 or 2.5 % greater than the least possible (8 vertices all around).
///
/// With a given radius, or limits that the fitted one is beyond, the circle is the closest in the
/// plane of the vertices, the best of many starts; only the plane is then not optimal, at excesses
/// of 8e-6, 7e-4 and 1.3 % in these cases. Limits change nothing if the fitted radius is within them.
///
/// Collinear vertices stay on their line, the limit of large circles; with a given radius they
/// bulge to one side. The circle is replaced by a line if the radius exceeds a million times their
/// size. Coincident vertices stay where they are. A vertex at the centre is projected along the
/// longest principal axis.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Circle {
    /// The radius; none for the best fit.
    radius: Option<Limits>,
}

impl Projection for Circle {
    const INFO: Info = Info {
        id: "circle",
        label: "Circle",
        summary: "The vertices lie on one circle, and so also in one plane.",
        paper: "3.1",
        arity: Arity::AtLeast(3),
        exact: false,
        measure: Some("circularity"),
        panels: Some("circular"),
        colour: [40, 115, 215],
        params: &[Param::RADIUS],
        default_for: &[TargetShape::Panels, TargetShape::Loop],
        ..Info::PLAIN
    };

    // Inlined, so that the number of corners is a constant in the instance for four.
    #[inline(always)]
    fn closed_form<S: Lane>(
        &self,
        _rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        match self.radius {
            None => CircleFit::project(v, projected),
            Some(limits) => {
                let (_, _, good) = CircleFit::project_within(v, projected, |r| limits.clamp(r));
                good.all_greater(S::zero())
            }
        }
    }

    fn project_robust(&self, _rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let circle = PrincipalRound::rotate(v, 2, |r| self.clamp(r));
        for p in v {
            *p = circle.closest(*p);
        }
    }

    fn fitted(&self, v: &[Vec3<f64>]) -> Option<Fitted> {
        let mut centred = v.to_vec();
        let mean = centre(&mut centred);
        let mut projected = centred.clone();
        let (normal, circle, good) =
            CircleFit::project_within(&centred, &mut projected, |r| self.clamp(r));
        let (normal, circle) = if good > 0.0 {
            (normal, circle.centre_and_radius())
        } else {
            let circle = PrincipalRound::rotate(&mut centred, 2, |r| self.clamp(r));
            (circle.axes.axes[2], circle.centre_and_radius())
        };
        circle.map(|(centre, radius)| Fitted::Circle { centre: mean + centre, normal, radius })
    }
}

impl Circle {
    /// Returns the nearest allowed radius.
    fn clamp(&self, radius: f64) -> f64 {
        self.radius.map_or(radius, |limits| limits.clamp(radius))
    }
}
