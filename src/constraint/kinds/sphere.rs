//! Sphere (paper section 3.1): the fit of the circle (Thomas and Chan) for points in space.

use crate::constraint::parameter::Limits;
use crate::constraint::{Arity, Fitted, Info, Param, Projection, TargetShape};
use crate::math::{Lane, PrincipalRound, Round, RoundWithin, Scatter, Vec3, centre};
use serde::{Deserialize, Serialize};

/// All vertices lie on one sphere; its radius is free, given, or limited.
///
/// Not exact: with vertices off a sphere by 1 %, 10 % or 30 % of its radius, the squared distance
/// is on average 6e-5, 7e-3 or 6 % greater than the least possible (8 vertices all around).
///
/// With a given radius the projection is the closest for every configuration, the best of many
/// starts; so with limits if the fitted radius is beyond them. Limits change nothing if it is within.
///
/// Coplanar vertices stay in their plane, the limit of large spheres; with a given radius they
/// bulge to one side. The sphere is replaced by a plane if the radius exceeds a million times their
/// size. Collinear and coincident vertices stay where they are, or move to an arc over their line.
/// A vertex at the centre is projected along the longest principal axis.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Sphere {
    /// The radius; none for the best fit.
    radius: Option<Limits>,
}

impl Projection for Sphere {
    const INFO: Info = Info {
        id: "sphere",
        label: "Sphere",
        summary: "The vertices lie on one sphere.",
        paper: "3.1",
        arity: Arity::AtLeast(4),
        exact: false,
        colour: [220, 50, 47],
        params: &[Param::RADIUS],
        default_for: &[TargetShape::Patch],
        ..Info::PLAIN
    };

    fn closed_form<S: Lane>(
        &self,
        _rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        if let Some(limits) = self.radius {
            let (_, good) = project_within(v, projected, |r| limits.clamp(r));
            return good.all_greater(S::zero());
        }
        let (sphere, mut good) = fit(v);
        for (v, p) in v.iter().zip(projected) {
            let step = sphere.step_off_centre(*v, &mut good);
            *p = *v + step;
        }
        good.all_greater(S::zero())
    }

    fn project_robust(&self, _rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let sphere = PrincipalRound::rotate(v, 3, |r| self.clamp(r));
        for p in v {
            *p = sphere.closest(*p);
        }
    }

    fn fitted(&self, v: &[Vec3<f64>]) -> Option<Fitted> {
        let mut centred = v.to_vec();
        let mean = centre(&mut centred);
        let mut projected = centred.clone();
        let (sphere, good) = project_within(&centred, &mut projected, |r| self.clamp(r));
        let sphere = if good > 0.0 {
            sphere.centre_and_radius()
        } else {
            PrincipalRound::rotate(&mut centred, 3, |r| self.clamp(r)).centre_and_radius()
        };
        sphere.map(|(centre, radius)| Fitted::Sphere { centre: mean + centre, radius })
    }
}

impl Sphere {
    /// Returns the nearest allowed radius.
    fn clamp(&self, radius: f64) -> f64 {
        self.radius.map_or(radius, |limits| limits.clamp(radius))
    }
}

/// Projects to the sphere with the fitted radius limited by `clamp`. Returns the sphere, and one in
/// the lanes in which all is accurate, else zero.
// Not inlined, to keep register pressure low for spheres of any radius.
#[inline(never)]
fn project_within<S: Lane>(
    v: &[Vec3<S>],
    projected: &mut [Vec3<S>],
    clamp: impl Fn(S) -> S,
) -> (RoundWithin<S>, S) {
    let (round, mut good) = fit(v);
    let sphere = RoundWithin::of(v, round, Vec3::zero(), clamp, Vec3::zero(), &mut good);
    for (v, p) in v.iter().zip(projected) {
        *p = *v + sphere.step_off_centre(*v, &mut good);
    }
    (sphere, good)
}

/// Fits the sphere in closed form; returns one in the lanes in which it is accurate, else zero.
#[inline(always)]
fn fit<S: Lane>(v: &[Vec3<S>]) -> (Round<S>, S) {
    let scatter = Scatter::of(v);
    let mut h = Vec3::zero();
    for p in v {
        h += *p * p.length_squared();
    }
    let h = h * S::splat(0.5 / v.len() as f64);

    let adjugate = scatter.unit.adjugate();
    let determinant = scatter.unit.determinant(adjugate);
    let s = scatter.mean_square;
    let round = Round::new(adjugate.times(h), determinant * s, s);
    (round, round.accurate(scatter.in_range))
}
