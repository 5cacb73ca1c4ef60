//! Rectangle (paper section 3.3), the closest one in space: the parallelogram whose half-diagonals
//! are both rescaled to their mean length.

use super::{Arity, Centring, Info, Projection};
use crate::math::{Lane, Vec3};
use serde::{Deserialize, Serialize};

/// Four vertices, in turn, are the corners of a rectangle: its diagonals halve each other and are
/// equally long.
///
/// With the half-diagonals `a = (v1 - v3) / 2` and `b = (v2 - v4) / 2` of the closest parallelogram,
/// and `m` the mean of `|a|` and `|b|`, the closest rectangle is `(a', b', -a', -b')` with
/// `a' = m a / |a|` and `b' = m b / |b|`.
///
/// Collinear vertices give a rectangle without width on their line. Where one diagonal is zero,
/// every direction is equally close for it; a square is taken, in the plane of the other diagonal
/// and the coordinate axis farthest from it. Where both are zero, all vertices meet.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Rectangle {}

impl Projection for Rectangle {
    const INFO: Info = Info {
        id: "rectangle",
        label: "Rectangle",
        summary: "The four vertices are the corners of a flat panel whose angles are all right.",
        paper: "3.3",
        arity: Arity::Exactly(4),
        centring: Centring::Together,
        elements: &[],
        exact: true,
        measure: None,
        colour: [110, 120, 140],
        params: &[],
    };

    fn closed_form<S: Lane>(
        &self,
        _rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        let half = S::splat(0.5);
        let (a, b) = ((v[0] - v[2]) * half, (v[1] - v[3]) * half);
        let (aa, bb) = (a.length_squared(), b.length_squared());
        let (length_a, length_b) = (aa.sqrt(), bb.sqrt());
        let mean = (length_a + length_b) * half;
        let (a, b) = (a * (mean / length_a), b * (mean / length_b));
        projected.copy_from_slice(&[a, b, -a, -b]);
        // Squares of lengths keep all digits in this range.
        let accurate = aa.min(bb).if_greater(S::splat(1e-60), S::one(), S::zero());
        S::splat(1e60).if_greater(aa.max(bb), accurate, S::zero()).all_greater(S::zero())
    }

    fn careful(&self, _rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let (length_a, a) = (v[0] - v[2]).length_and_direction();
        let (length_b, b) = (v[1] - v[3]).length_and_direction();
        let [a, b] = match (a, b) {
            (Some(a), Some(b)) => [a, b],
            (Some(a), None) => [a, across(a)],
            (None, Some(b)) => [across(b), b],
            (None, None) => [Vec3::zero(); 2],
        };
        // The diagonals were not halved before.
        let mean = 0.25 * length_a + 0.25 * length_b;
        let (a, b) = (a * mean, b * mean);
        v.copy_from_slice(&[a, b, -a, -b]);
    }
}

/// A unit vector at right angles to the unit vector `e`.
fn across(e: Vec3<f64>) -> Vec3<f64> {
    let [x, y, z] = [e.x.abs(), e.y.abs(), e.z.abs()];
    let axis = if x <= y && x <= z {
        Vec3::new(1.0, 0.0, 0.0)
    } else if y <= z {
        Vec3::new(0.0, 1.0, 0.0)
    } else {
        Vec3::new(0.0, 0.0, 1.0)
    };
    let across = axis - e * e.dot(axis);
    across * (1.0 / across.length())
}

#[cfg(test)]
mod tests {
    use super::Rectangle;
    use crate::constraint::Projection;
    use crate::math::Vec3;

    #[test]
    fn a_missing_diagonal_makes_a_square() {
        let b = Vec3::new(0.0, 0.6, 0.8);
        for scale in [1.0, 1e-200, 1e200] {
            let v = [Vec3::zero(), b * scale, Vec3::zero(), -b * scale];
            let mut found = v;
            Rectangle {}.project(&[], &v, &mut found);
            let found = found.map(|p| p * (1.0 / scale));
            assert_eq!(found[0], -found[2]);
            assert_eq!(found[1], -found[3]);
            assert!((found[1] - b * 0.5).length() <= 1e-15, "{found:?}");
            assert!((found[0].length() - 0.5).abs() <= 1e-15, "{found:?}");
            assert!(found[0].dot(b).abs() <= 1e-15, "{found:?}");
        }
    }
}
