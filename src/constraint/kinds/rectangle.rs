//! Rectangle (paper section 3.3): the closest one in space, or the one fitted by the paper.
//!
//! The closest is the parallelogram whose half-diagonals are both rescaled to their mean length.
//!
//! The paper projects the vertices to their least-squares plane and fits four lines there (Eq. 10,
//! by QR decomposition and a 2x2 eigenproblem, Gander and von Matt). With centred points the
//! offsets are `c1 = -n.p` and `c2 = -n'.q`, where `p = (v1 + v2) / 2`, `q = (v2 + v3) / 2` and
//! `n'` is `n` rotated by a right angle, which leaves `max (n.p)^2 + (n'.q)^2` over unit vectors
//! `n`. In complex numbers, `n^2` has the direction of `p^2 - q^2 = a b`, the product of the
//! half-diagonals: `n` bisects the angle between them. The sides of the closest rectangle in the
//! plane have the same directions and offsets, so the two fits differ only in the plane, which for
//! the closest rectangle is that of the half-diagonals.

use crate::constraint::{Arity, Form, Info, Param, Projection};
use crate::json::word;
use crate::math::{Lane, PrincipalAxes, Scatter, Vec3, in_range};
use serde::{Deserialize, Serialize};

/// Four vertices, in order, are the corners of a rectangle: its diagonals bisect each other and are
/// equally long.
///
/// With the half-diagonals `a = (v1 - v3) / 2` and `b = (v2 - v4) / 2` of the closest parallelogram,
/// and `m` the mean of `|a|` and `|b|`, the closest rectangle is `(a', b', -a', -b')` with
/// `a' = m a / |a|` and `b' = m b / |b|`.
///
/// Collinear vertices give a rectangle without width on their line. If one diagonal is zero, all
/// directions are equally close for it; a square is chosen, in the plane of the other diagonal and
/// the coordinate axis farthest from it (or, if requested, in the least-squares plane). If both are
/// zero, all vertices coincide.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Rectangle {
    /// Which rectangle.
    #[serde(deserialize_with = "word")]
    fit: Fit,
}

/// Which rectangle the vertices are projected to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Fit {
    /// The closest.
    #[default]
    Closest,
    /// The rectangle of the paper: least-squares lines in the least-squares plane.
    ///
    /// Not exact: with vertices off a rectangle by 1 %, 10 % or 30 % of its size, the squared distance
    /// is on average 1e-5, 1e-3 or 1.5 % greater than the least possible.
    Lines,
}

impl Projection for Rectangle {
    const INFO: Info = Info {
        id: "rectangle",
        label: "Rectangle",
        summary: "The four vertices are the corners of a flat panel with four right angles.",
        paper: "3.3",
        arity: Arity::Exactly(4),
        colour: [110, 120, 140],
        params: &[Param::word(
            "fit",
            "Fit",
            "closest",
            &[Form::Word("closest"), Form::Word("lines")],
        )],
        ..Info::PLAIN
    };

    fn closed_form<S: Lane>(
        &self,
        _rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        let half = S::splat(0.5);
        let (a, b, good) = match self.fit {
            Fit::Closest => ((v[0] - v[2]) * half, (v[1] - v[3]) * half, S::one()),
            Fit::Lines => flat_half_diagonals(v),
        };
        let (aa, bb) = (a.length_squared(), b.length_squared());
        let (length_a, length_b) = (aa.sqrt(), bb.sqrt());
        let mean = (length_a + length_b) * half;
        let (a, b) = (a * (mean / length_a), b * (mean / length_b));
        projected.copy_from_slice(&[a, b, -a, -b]);
        in_range(aa.min(bb), aa.max(bb), good).all_greater(S::zero())
    }

    fn project_robust(&self, _rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        if self.fit == Fit::Lines {
            let axes = PrincipalAxes::rotate(v);
            for p in v.iter_mut() {
                p.z = 0.0;
            }
            closest(v, |e| Vec3::new(-e.y, e.x, 0.0));
            for p in v {
                *p = axes.point(*p);
            }
        } else {
            closest(v, Vec3::across);
        }
    }
}

/// Returns the half-diagonals in the least-squares plane, and one per accurate lane, else zero.
// Not inlined, to keep register pressure low for the closest rectangle.
#[inline(never)]
fn flat_half_diagonals<S: Lane>(v: &[Vec3<S>]) -> (Vec3<S>, Vec3<S>, S) {
    let half = S::splat(0.5);
    let scatter = Scatter::of(v);
    let n = scatter.unit.smallest_eigenvector();
    let flat = |v: Vec3<S>| v - n.vector * n.vector.dot(v);
    let (a, b) = (flat((v[0] - v[2]) * half), flat((v[1] - v[3]) * half));
    // The projection of a steep diagonal has lost digits.
    let least = a.length_squared().min(b.length_squared());
    let bound = S::splat(1e-6) * scatter.mean_square;
    (a, b, least.if_greater(bound, n.accurate * scatter.in_range, S::zero()))
}

/// Replaces four points by the closest rectangle. A zero diagonal gets direction `across` the
/// other.
fn closest(v: &mut [Vec3<f64>], across: impl Fn(Vec3<f64>) -> Vec3<f64>) {
    let (length_a, a) = (v[0] - v[2]).length_and_direction();
    let (length_b, b) = (v[1] - v[3]).length_and_direction();
    let [a, b] = match (a, b) {
        (Some(a), Some(b)) => [a, b],
        (Some(a), None) => [a, across(a)],
        (None, Some(b)) => [across(b), b],
        (None, None) => [Vec3::zero(); 2],
    };
    // The diagonals were not halved above.
    let mean = 0.25 * length_a + 0.25 * length_b;
    let (a, b) = (a * mean, b * mean);
    v.copy_from_slice(&[a, b, -a, -b]);
}

#[cfg(test)]
mod tests {
    use super::{Fit, Rectangle};
    use crate::constraint::Projection;
    use crate::math::Vec3;

    #[test]
    fn a_missing_diagonal_makes_a_square() {
        let b = Vec3::new(0.0, 0.6, 0.8);
        for (fit, scale) in [Fit::Closest, Fit::Lines]
            .into_iter()
            .flat_map(|fit| [1.0, 1e-200, 1e200].map(|scale| (fit, scale)))
        {
            let v = [Vec3::zero(), b * scale, Vec3::zero(), -b * scale];
            let mut found = v;
            Rectangle { fit }.project(&[], &v, &mut found);
            let found = found.map(|p| p * (1.0 / scale));
            assert_eq!(found[0], -found[2]);
            assert_eq!(found[1], -found[3]);
            assert!((found[1] - b * 0.5).length() <= 1e-15, "{found:?}");
            assert!((found[0].length() - 0.5).abs() <= 1e-15, "{found:?}");
            assert!(found[0].dot(b).abs() <= 1e-15, "{found:?}");
        }
    }
}
