//! Circle (paper section 3.1): the least-squares plane, then the circle of Thomas and Chan in it.

use super::{Arity, Centring, Fitted, Info, Projection};
use crate::math::{CircleFit, Lane, PrincipalCircle, Vec3, centre};
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
        centring: Centring::Together,
        elements: &[],
        exact: false,
        measure: Some("circularity"),
        colour: [40, 115, 215],
        params: &[],
    };

    fn closed_form<S: Lane>(
        &self,
        _rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        CircleFit::project(v, projected)
    }

    fn careful(&self, _rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let circle = PrincipalCircle::rotate(v);
        for p in v {
            *p = circle.closest(*p);
        }
    }

    fn fitted(&self, v: &[Vec3<f64>]) -> Option<Fitted> {
        let mut centred = v.to_vec();
        let mean = centre(&mut centred);
        let (normal, circle) = match CircleFit::of(&centred) {
            Some(circle) => (circle.normal, circle.round.centre_and_radius()),
            None => {
                let circle = PrincipalCircle::rotate(&mut centred);
                (circle.normal(), circle.centre_and_radius())
            }
        };
        circle.map(|(centre, radius)| Fitted::Circle { centre: mean + centre, normal, radius })
    }
}
