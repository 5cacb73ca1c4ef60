//! Incircle: a quad whose sides touch one circle.

use crate::constraint::kinds::shared::pitot;
use crate::constraint::{Arity, Element, Info, Projection};
use crate::math::{Lane, Vec3};
use serde::{Deserialize, Serialize};

/// Four vertices, in order: opposite sides have the same sum. The sides of a flat convex panel then
/// touch a circle inside; those of a non-planar quad touch a sphere.
///
/// Not always exact: for vertices off by up to 30 % of the size of such a quad nothing closer was
/// found, but for 2 of 400 clouds of four points something was. Coincident vertices are allowed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Incircle {}

impl Projection for Incircle {
    const INFO: Info = Info {
        id: "incircle",
        label: "Incircle",
        summary: "The four sides of a flat panel touch a circle inside it: both pairs of opposite sides have the same total length.",
        arity: Arity::Exactly(4),
        elements: &[Element::Face],
        exact: false,
        colour: [120, 110, 170],
        ..Info::PLAIN
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
