//! Parallelogram (paper section 3.3, Eq. 9). The paper fits it in the least-squares plane; in space
//! the problem is linear too, and its solution is planar and closer.

use crate::constraint::{Arity, Info, Projection};
use crate::math::{Lane, Vec3};
use serde::{Deserialize, Serialize};

/// Four vertices, in order, are the corners of a parallelogram: its diagonals bisect each other.
///
/// With the half-diagonals `a = (v1 - v3) / 2` and `b = (v2 - v4) / 2` the closest one is
/// `(a, b, -a, -b)`. It is unique for every input; for collinear vertices it lies on their line.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Parallelogram {}

impl Projection for Parallelogram {
    const INFO: Info = Info {
        id: "parallelogram",
        label: "Parallelogram",
        summary: "The four vertices are the corners of a flat panel whose opposite sides are \
                  parallel and equally long.",
        paper: "3.3",
        arity: Arity::Exactly(4),
        colour: [95, 85, 200],
        ..Info::PLAIN
    };

    fn closed_form<S: Lane>(
        &self,
        _rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        let half = S::splat(0.5);
        let (a, b) = ((v[0] - v[2]) * half, (v[1] - v[3]) * half);
        projected.copy_from_slice(&[a, b, -a, -b]);
        true
    }
}
