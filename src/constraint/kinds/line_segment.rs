//! Line segment (paper section 3.3): two vertices at a given distance, or at one within limits.

use crate::constraint::parameter::{Limits, Target};
use crate::constraint::{Arity, Info, Projection, TargetShape};
use crate::math::{Lane, Vec3, in_range};
use serde::{Deserialize, Serialize};

/// Two vertices have their rest distance, or a given one. With limits instead of one number, only a
/// distance outside them is corrected: strain limiting.
///
/// The closest segment has the same midpoint and direction. Coincident ends move apart along their
/// rest direction, or along the first axis if they coincide at rest too.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct LineSegment {
    /// The length.
    length: Target,
    /// Factor of the rest length, if that is the target.
    strain: Limits,
}

impl Default for LineSegment {
    fn default() -> Self {
        LineSegment { length: Target::Rest, strain: Limits::exactly(1.0) }
    }
}

impl Projection for LineSegment {
    const INFO: Info = Info {
        id: "line-segment",
        label: "Line segment",
        summary: "The two vertices keep their distance, or take a given value.",
        paper: "3.3",
        arity: Arity::Exactly(2),
        colour: [150, 105, 20],
        params: &Target::params("length", "Length", "Times the original length"),
        default_for: &[TargetShape::Edges],
        ..Info::PLAIN
    };

    const READS_REST: bool = true;

    /// Stores the length at rest, then the direction.
    fn prepare(&self, rest: &mut [Vec3<f64>]) {
        let (length, direction) = (rest[1] - rest[0]).length_and_direction();
        rest[0] = Vec3::new(length, 0.0, 0.0);
        rest[1] = direction.unwrap_or(Vec3::new(1.0, 0.0, 0.0));
    }

    fn closed_form<S: Lane>(
        &self,
        rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        let half = (v[1] - v[0]) * S::splat(0.5);
        let squared = half.length_squared();
        let length = squared.sqrt();
        let half = half * (self.clamped(length, rest[0].x) / length);
        projected.copy_from_slice(&[-half, half]);
        in_range(squared, squared, S::one()).all_greater(S::zero())
    }

    fn project_robust(&self, rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        // Halved first, as the difference of two finite numbers need not be finite.
        let (length, direction) = (v[1] * 0.5 - v[0] * 0.5).length_and_direction();
        let half = direction.unwrap_or(rest[1]) * self.clamped(length, rest[0].x);
        v.copy_from_slice(&[-half, half]);
    }
}

impl LineSegment {
    /// The least and the greatest length that are allowed, for the rest length `rest`.
    pub(crate) fn lengths(&self, rest: f64) -> [f64; 2] {
        match self.length {
            Target::Rest => self.strain.ends().map(|strain| strain * rest),
            Target::Within(limits) => limits.ends(),
        }
    }

    /// Returns half the allowed length nearest to twice `half`, for the rest length `rest`.
    #[inline(always)]
    fn clamped<S: Lane>(&self, half: S, rest: S) -> S {
        match self.length {
            Target::Rest => self.strain.clamp_times(half, rest * S::splat(0.5)),
            Target::Within(limits) => limits.clamp_times(half, S::splat(0.5)),
        }
    }
}
