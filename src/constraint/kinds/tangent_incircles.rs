//! Tangent incircles: two triangles on the two sides of an edge, as in the circle packing meshes of
//! Schiftner, Hoebinger, Wallner and Pottmann (2009).

use crate::constraint::kinds::shared::pitot;
use crate::constraint::{Arity, Element, Info, Projection};
use crate::math::{Lane, Vec3};
use serde::{Deserialize, Serialize};

/// An edge between two triangles, then the two opposite corners: the incircles of the triangles
/// touch each other. Equivalently, opposite sides of the quad around both have the same sum.
///
/// Not always exact: for vertices off by up to 30 % of the size of such a quad nothing closer was
/// found, but for 2 of 400 clouds of four points something was. Coincident vertices are allowed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct TangentIncircles {}

impl Projection for TangentIncircles {
    const INFO: Info = Info {
        id: "tangent-incircles",
        label: "Tangent incircles",
        summary: "The circles inscribed in two neighbouring triangles touch each other.",
        arity: Arity::Exactly(4),
        elements: &[Element::Hinge],
        exact: false,
        colour: [170, 100, 60],
        ..Info::PLAIN
    };

    const GUARDED: bool = true;

    fn closed_form<S: Lane>(
        &self,
        _rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        let mut found = [Vec3::zero(); 4];
        let accurate = pitot::closest(&[v[0], v[2], v[1], v[3]], &mut found);
        projected.copy_from_slice(&[found[0], found[2], found[1], found[3]]);
        accurate
    }

    fn project_robust(&self, _rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        v.swap(1, 2);
        pitot::project_robust(v);
        v.swap(1, 2);
    }
}
