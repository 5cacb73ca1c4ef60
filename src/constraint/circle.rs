//! Circle (paper section 3.1): the least-squares plane, then the circle of Thomas and Chan in it.

use super::{Arity, Fitted, Info, Projection};
use crate::math::{Lane, PrincipalAxes, Round, Scatter, Vec3, each_lane};
use serde::{Deserialize, Serialize};

/// All vertices on one circle, in any order and at any spacing.
///
/// Not exact: with vertices off a circle by 1 %, 10 % or 30 % of its radius, the squared distance is
/// on average 3e-5, 3e-3 or 2.5 % greater than the least possible (8 vertices all around).
///
/// Collinear vertices stay on their line, the limit of great circles; coincident ones stay where
/// they are. A vertex at the centre goes to the circle along the longest principal axis.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Circle {}

impl Projection for Circle {
    const INFO: Info = Info {
        id: "circle",
        label: "Circle",
        summary: "The vertices lie on one circle, and so also in one plane.",
        paper: "3.1",
        arity: Arity::AtLeast(3),
        exact: false,
        colour: [40, 115, 215],
        params: &[],
    };

    fn project<S: Lane>(&self, _rest: &[Vec3<S>], v: &mut [Vec3<S>]) {
        if let Some((n, round)) = fit(v) {
            for p in v {
                *p = round.closest(*p - n * n.dot(*p));
            }
        } else if S::WIDTH > 1 {
            each_lane(v, |one| self.project(&[], one));
        } else {
            each_lane(v, project_in_principal_axes);
        }
    }

    fn fitted(&self, v: &[Vec3<f64>]) -> Option<Fitted> {
        let (mean, mut centred) = super::centred(v);
        let (normal, circle) = match fit(&centred) {
            Some((normal, round)) => (normal, round.centre_and_radius()),
            None => {
                let axes = PrincipalAxes::rotate(&mut centred);
                let circle = Round::fit_principal(&centred, 2).centre_and_radius();
                (axes.axes[2], circle.map(|(c, r)| (axes.point(c), r * axes.scale)))
            }
        };
        circle.map(|(centre, radius)| Fitted::Circle { centre: mean + centre, normal, radius })
    }
}

/// Unit normal of the plane and the circle in it, in closed form; None when that is not accurate in
/// every lane.
#[inline(always)]
fn fit<S: Lane>(v: &[Vec3<S>]) -> Option<(Vec3<S>, Round<S>)> {
    let scatter = Scatter::of(v);
    let n = scatter.unit.smallest_eigenvector();
    let in_plane = |p: Vec3<S>| p - n.vector * n.vector.dot(p);
    let mut h = Vec3::zero();
    for p in v {
        let w = in_plane(*p);
        h += w * w.length_squared();
    }
    let h = h * S::splat(0.5 / v.len() as f64);

    // In the plane the scatter has trace t = 1 - l and adjugate t I - M; M h is the 3x3 product, as
    // h is orthogonal to n.
    let t = S::one() - n.value;
    let a = h * t - scatter.unit.times(h);
    let determinant = scatter.unit.adjugate().trace() - n.value * t;
    let round = Round::new(a, determinant * scatter.mean_square, t * scatter.mean_square);
    let mut good = round.accurate(n.accurate * scatter.in_range);
    for p in v {
        good = round.off_centre(in_plane(*p), good);
    }
    good.all_greater(S::zero()).then_some((n.vector, round))
}

/// The same for one constraint, accurate for every input.
fn project_in_principal_axes(v: &mut [Vec3<f64>]) {
    let axes = PrincipalAxes::rotate(v);
    let round = Round::fit_principal(v, 2);
    for p in v {
        *p = axes.point(round.closest_or_chosen(Vec3::new(p.x, p.y, 0.0)));
    }
}
