//! Incircle: a quad whose sides touch one circle.

use crate::constraint::kinds::shared::pitot;
use crate::constraint::{Arity, Centring, Element, Info, Projection};
use crate::math::{Lane, Vec3};
use serde::{Deserialize, Serialize};

/// Four vertices, in turn: opposite sides have the same sum. A flat convex panel then has a circle
/// inside that touches its four sides; the sides of one that is not flat touch a sphere.
///
/// Not always exact: for vertices off by up to 30 % of the size of such a quad nothing closer was
/// found, but in 2 of 400 clouds of four points something was. Vertices that meet are a side of no
/// length.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Incircle {}

impl Projection for Incircle {
    const INFO: Info = Info {
        id: "incircle",
        label: "Incircle",
        summary: "The four sides of a flat panel touch one circle inside: opposite sides have the same sum.",
        paper: "",
        arity: Arity::Exactly(4),
        centring: Centring::Together,
        elements: &[Element::Face],
        exact: false,
        measure: None,
        panels: None,
        colour: [120, 110, 170],
        params: &[],
    };

    const GUARDED: bool = true;

    fn closed_form<S: Lane>(
        &self,
        _rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        let (v, projected) = (v.try_into(), projected.try_into());
        pitot::closest(v.expect("it takes four points"), projected.expect("it gives four points"))
    }

    fn project_robust(&self, _rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        pitot::project_robust(v);
    }
}
