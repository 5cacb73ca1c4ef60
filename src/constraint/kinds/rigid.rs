//! Rigid (paper section 3.2): the rest points, moved by the closest rotation and translation
//! (Umeyama 1991, without the scale).

use crate::constraint::{Arity, Info, Projection};
use crate::math::{Alignment, Lane, Vec3};
use serde::{Deserialize, Serialize};

/// The vertices keep their rest shape: it may be translated and rotated, but not deformed, scaled
/// or reflected. Two vertices keep their distance.
///
/// If several rotations are equally close, one is chosen. This happens if the vertices are
/// collinear and the rest shape is not (any rotation about the line), if all vertices coincide (the
/// rest shape is then not rotated), and if they are a mirror image of a shape with two equal
/// singular values (several planes of reflection).
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Rigid {}

impl Projection for Rigid {
    const INFO: Info = Info {
        id: "rigid",
        label: "Rigid",
        summary: "The vertices keep their original shape and size, and may move and turn as one.",
        paper: "3.2",
        arity: Arity::AtLeast(2),
        colour: [44, 160, 80],
        ..Info::PLAIN
    };

    const READS_REST: bool = true;
    const USES_POSE: bool = true;

    fn closed_form<S: Lane>(
        &self,
        rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        let alignment = Alignment::of(rest, v);
        for (r, p) in rest.iter().zip(projected) {
            *p = alignment.turn(*r);
        }
        alignment.accurate.all_greater(S::zero())
    }

    fn project_robust(&self, rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let alignment = Alignment::robust(rest, v);
        for (r, p) in rest.iter().zip(v) {
            *p = alignment.turn(*r);
        }
    }
}
