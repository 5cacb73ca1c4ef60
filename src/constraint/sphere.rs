//! Sphere (paper section 3.1): the circle's equation minimised directly over the points in space
//! (Thomas and Chan).

use super::{Arity, Centring, Fitted, Info, Projection};
use crate::math::{Lane, PrincipalAxes, Round, Scatter, Vec3, centre};
use serde::{Deserialize, Serialize};

/// All vertices on one sphere.
///
/// Not exact: with vertices off a sphere by 1 %, 10 % or 30 % of its radius, the squared distance is
/// on average 6e-5, 7e-3 or 6 % greater than the least possible (8 vertices all around).
///
/// Coplanar vertices stay in their plane, the limit of great spheres, and do not move; neither do
/// collinear and coincident ones. A vertex at the centre goes to the sphere along the longest
/// principal axis.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Sphere {}

impl Projection for Sphere {
    const INFO: Info = Info {
        id: "sphere",
        label: "Sphere",
        summary: "The vertices lie on one sphere.",
        paper: "3.1",
        arity: Arity::AtLeast(4),
        centring: Centring::Together,
        elements: &[],
        exact: false,
        measure: None,
        colour: [220, 50, 47],
        params: &[],
    };

    fn closed_form<S: Lane>(
        &self,
        _rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        let (sphere, mut good) = fit(v);
        for (v, p) in v.iter().zip(projected) {
            let step = sphere.step_off_centre(*v, &mut good);
            *p = *v + step;
        }
        good.all_greater(S::zero())
    }

    fn careful(&self, _rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let axes = PrincipalAxes::rotate(v);
        let sphere = Round::fit_principal(v, 3);
        for p in v {
            *p = axes.point(sphere.closest_or_chosen(*p));
        }
    }

    fn fitted(&self, v: &[Vec3<f64>]) -> Option<Fitted> {
        let mut centred = v.to_vec();
        let mean = centre(&mut centred);
        let (round, good) = fit(&centred);
        let sphere = if good > 0.0 {
            round.centre_and_radius()
        } else {
            let axes = PrincipalAxes::rotate(&mut centred);
            let sphere = Round::fit_principal(&centred, 3).centre_and_radius();
            sphere.map(|(c, r)| (axes.point(c), r * axes.scale))
        };
        sphere.map(|(centre, radius)| Fitted::Sphere { centre: mean + centre, radius })
    }
}

/// The sphere in closed form; one in the lanes where it is accurate, else zero.
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
