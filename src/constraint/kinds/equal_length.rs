//! Equal lengths: the edges among the selected vertices have a common length.

use crate::constraint::{Arity, Centring, Info, Projection};
use crate::math::{Lane, Vec3, in_range};
use serde::{Deserialize, Serialize};

/// All edges among the vertices are equally long.
///
/// The closest edges keep their directions and have the mean length. Proof: changing the length of
/// an edge from `l` to `m` moves its vector by at least `|l - m|`, and by exactly that along its
/// own direction; the sum of squares of `l - m` is least if `m` is the mean of `l`.
///
/// An edge whose ends coincide gets its rest direction, or that of the first axis if they coincide
/// at rest too. If the ends of all edges coincide, they stay.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct EqualLength {}

impl Projection for EqualLength {
    const INFO: Info = Info {
        id: "equal-length",
        label: "Equal lengths",
        summary: "All edges among the vertices are equally long.",
        arity: Arity::AtLeast(4),
        centring: Centring::ByEdge,
        colour: [185, 95, 60],
        ..Info::PLAIN
    };

    const READS_REST: bool = true;

    /// Stores the direction of each edge at both of its ends.
    fn prepare(&self, rest: &mut [Vec3<f64>]) {
        for ends in rest.chunks_exact_mut(2) {
            let (_, direction) = half(ends).length_and_direction();
            ends.fill(direction.unwrap_or(Vec3::new(1.0, 0.0, 0.0)));
        }
    }

    fn closed_form<S: Lane>(
        &self,
        _rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        let (mut sum, mut accurate) = (S::zero(), S::one());
        for (ends, half_and_length) in v.chunks_exact(2).zip(projected.chunks_exact_mut(2)) {
            let half = half(ends);
            let squared = half.length_squared();
            let length = squared.sqrt();
            sum += length;
            half_and_length.copy_from_slice(&[half, Vec3::new(length, length, length)]);
            accurate = in_range(squared, squared, accurate);
        }
        let mean = sum * S::splat(2.0 / v.len() as f64);
        for ends in projected.chunks_exact_mut(2) {
            let half = ends[0] * (mean / ends[1].x);
            ends.copy_from_slice(&[-half, half]);
        }
        accurate.all_greater(S::zero())
    }

    fn project_robust(&self, rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let share = 2.0 / v.len() as f64;
        let lengths = v.chunks_exact(2).map(|ends| half(ends).length_and_direction().0);
        let mean: f64 = lengths.map(|length| length * share).sum();
        for (ends, rest) in v.chunks_exact_mut(2).zip(rest.chunks_exact(2)) {
            let (_, direction) = half(ends).length_and_direction();
            let half = direction.unwrap_or(rest[1]) * mean;
            ends.copy_from_slice(&[-half, half]);
        }
    }
}

/// Returns half the vector from the first end to the second. Halved first, as the difference of two
/// finite numbers need not be finite.
#[inline(always)]
fn half<S: Lane>(ends: &[Vec3<S>]) -> Vec3<S> {
    ends[1] * S::splat(0.5) - ends[0] * S::splat(0.5)
}

#[cfg(test)]
mod tests {
    use super::EqualLength;
    use crate::constraint::Projection;
    use crate::math::Vec3;

    #[test]
    fn an_edge_without_length_takes_its_rest_direction() {
        let across = Vec3::new(0.0, 1.0, 0.0);
        let mut rest = [-across, across, Vec3::zero(), Vec3::zero()];
        EqualLength {}.prepare(&mut rest);
        for scale in [1.0, 1e-200, 1e200] {
            let along = Vec3::new(0.0, 0.6, 0.8) * scale;
            let mut v = [Vec3::zero(), Vec3::zero(), -along, along];
            EqualLength {}.project(&rest, &v.clone(), &mut v);
            let v = v.map(|p| p * (1.0 / scale));
            assert!((v[1] - across * 0.5).length() <= 1e-15, "{v:?}");
            assert!((v[3] - Vec3::new(0.0, 0.3, 0.4)).length() <= 1e-15, "{v:?}");

            let mut v = [-along, along, Vec3::zero(), Vec3::zero()];
            EqualLength {}.project(&rest, &v.clone(), &mut v);
            assert!((v[3] * (1.0 / scale) - Vec3::new(0.5, 0.0, 0.0)).length() <= 1e-15, "{v:?}");
        }
    }
}
