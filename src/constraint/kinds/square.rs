//! Square (paper section 3.3): the regular polygon with four corners. Their cosines and sines are
//! 0, 1 and -1, so that the two sums of the regular polygon are the diagonals.

use crate::constraint::{Arity, Info, Projection};
use crate::math::{Lane, OrthogonalPair, Vec3};
use serde::{Deserialize, Serialize};

/// Four vertices, in order, are the corners of a square: its diagonals bisect each other, are
/// equally long and orthogonal.
///
/// If the diagonals are parallel or one of them is zero, as for collinear vertices, all planes
/// through their line are equally close, and one is chosen. If both are zero, all vertices meet.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Square {}

impl Projection for Square {
    const INFO: Info = Info {
        id: "square",
        label: "Square",
        summary: "The four vertices are the corners of a flat panel with four equal sides and \
                  four right angles.",
        paper: "3.3",
        arity: Arity::Exactly(4),
        colour: [140, 100, 70],
        ..Info::PLAIN
    };

    fn closed_form<S: Lane>(
        &self,
        _rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        let half = S::splat(0.5);
        let (pair, accurate) = OrthogonalPair::closest((v[0] - v[2]) * half, (v[1] - v[3]) * half);
        projected.copy_from_slice(&[pair.u, pair.w, -pair.u, -pair.w]);
        accurate.all_greater(S::zero())
    }

    fn project_robust(&self, _rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let pair = OrthogonalPair::closest_robust((v[0] - v[2]) * 0.5, (v[1] - v[3]) * 0.5);
        v.copy_from_slice(&[pair.u, pair.w, -pair.u, -pair.w]);
    }
}
