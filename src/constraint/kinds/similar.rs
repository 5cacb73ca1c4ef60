//! Similar (paper section 3.2): the rest points, moved by the closest rotation, uniform scaling and
//! translation (Umeyama 1991), with the scale between two limits.

use crate::constraint::parameter::Limits;
use crate::constraint::{Arity, Form, Info, Param, ParamValue, Projection};
use crate::math::{Alignment, Lane, Vec3};
use serde::{Deserialize, Serialize};

/// The vertices keep their rest shape up to its size: it may be translated, rotated and scaled, but
/// not deformed or reflected.
///
/// The rotation does not depend on the scale, and the distance is a parabola in the scale, so that
/// clamping the best scale is exact.
///
/// Degenerate shapes are treated as by `rigid`. Coincident vertices, and a rest shape without size,
/// give one point, unless the least scale requires more.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Similar {
    /// Least and greatest scale.
    scale: Limits,
}

impl Projection for Similar {
    const INFO: Info = Info {
        id: "similar",
        label: "Similar",
        summary: "The vertices keep their original shape, and so all its angles; the size may change.",
        paper: "3.2",
        arity: Arity::AtLeast(2),
        colour: [0, 145, 160],
        params: &[Param {
            id: "scale",
            label: "Scale",
            unit: "",
            default: ParamValue::Range([None, None]),
            forms: &[Form::Range, Form::Number],
            labels: &[],
            range: [0.0, f64::INFINITY],
        }],
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
        let scale = self.scale.clamp(alignment.scale);
        for (r, p) in rest.iter().zip(projected) {
            *p = alignment.turn(*r) * scale;
        }
        alignment.accurate.all_greater(S::zero())
    }

    fn project_robust(&self, rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let alignment = Alignment::robust(rest, v);
        let scale = self.scale.clamp(alignment.scale);
        for (r, p) in rest.iter().zip(v) {
            *p = alignment.turn(*r) * scale;
        }
    }
}
