//! Volume of a tetrahedron: as at rest, given, or within limits.
//!
//! Four centred points have three coordinates for each axis of space in the orthonormal basis
//! `(1, 1, -1, -1) / 2`, `(1, -1, 1, -1) / 2`, `(1, -1, -1, 1) / 2` of all centred quadruples.
//! These form a 3-by-3 matrix with the same distances, whose determinant is three times the volume.
//! The closest matrix with another determinant has the same singular vectors and the closest
//! singular values with the required product, the last one with the sign of the determinant (von
//! Neumann's trace inequality for rotations): see [`triple_with_product`].

use crate::constraint::parameter::{Limits, Target};
use crate::constraint::{Arity, Element, Info, Projection};
use crate::math::{Lane, SingularValues, Vec3, triple_with_product, triple_with_product_robust};
use libm::cbrt;
use serde::{Deserialize, Serialize};

/// Four vertices span their rest volume, or a given one, with the orientation that they have at
/// rest: an inverted tetrahedron is turned back. With limits instead of one number, only a volume
/// outside them is corrected.
///
/// If the rest volume is zero, the required orientation is positive: the fourth vertex is on the
/// side from which the others are seen counter-clockwise. Points without volume move apart across
/// their plane or line, or become a regular tetrahedron whose edges are diagonals of a cube along
/// the axes. If several directions are equally close, one is chosen.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Volume {
    /// The volume.
    volume: Target,
    /// Factor of the rest volume, if that is the target.
    strain: Limits,
}

/// A rest tetrahedron is flat if its least singular value is at most this fraction of the greatest.
const FLAT: f64 = 1e-12;

impl Default for Volume {
    fn default() -> Self {
        Volume { volume: Target::Rest, strain: Limits::exactly(1.0) }
    }
}

impl Projection for Volume {
    const INFO: Info = Info {
        id: "volume",
        label: "Volume",
        summary: "The tetrahedron keeps its volume, or takes a given value, and is never inside out.",
        arity: Arity::Exactly(4),
        elements: &[Element::Tet],
        colour: [165, 80, 110],
        params: &Target::params("volume", "Volume", "Times the original volume"),
        ..Info::PLAIN
    };

    const READS_REST: bool = true;

    /// Stores the least and the greatest cube root of the determinant, and its sign at rest.
    fn prepare(&self, rest: &mut [Vec3<f64>]) {
        let (found, scale) = SingularValues::robust(rows(rest));
        let [a, b, c] = found.values;
        let sizes = [cbrt(a * b * c.abs()) * scale, cbrt(3.0)];
        let [least, greatest] = self.volume.sizes(self.strain, cbrt, sizes);
        // The sign of a flat tetrahedron would be that of a rounding error.
        rest[0] = Vec3::new(least, greatest, if c < -FLAT * a { -1.0 } else { 1.0 });
    }

    fn closed_form<S: Lane>(
        &self,
        rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        let Vec3 { x: least, y: greatest, z: sign } = rest[0];
        let (found, accurate) = SingularValues::of(rows(v).map(|row| row * sign));
        let [a, b, c] = found.values;
        let product = a * b * c;
        let too_small = (least * least * least).if_greater(product, S::one(), S::zero());
        let too_great = product.if_greater(greatest * greatest * greatest, S::one(), S::zero());
        let root = too_small.if_greater(S::zero(), least, greatest);
        let (values, close) = triple_with_product(found.values, root);
        let moved = points(found.with(values).map(|row| row * sign));
        let moves = too_small + too_great;
        for ((to, moved), own) in projected.iter_mut().zip(moved).zip(v) {
            *to = Vec3::if_greater(moves, S::zero(), moved, *own);
        }
        let close = moves.if_greater(S::zero(), close, S::one());
        let accurate = close.if_greater(S::zero(), accurate, S::zero());
        // Cubes of lengths stay in range here.
        let accurate = a.if_greater(S::splat(1e-30), accurate, S::zero());
        let accurate = S::splat(1e30).if_greater(least, accurate, S::zero());
        S::splat(1e30).if_greater(a, accurate, S::zero()).all_greater(S::zero())
    }

    fn project_robust(&self, rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let Vec3 { x: least, y: greatest, z: sign } = rest[0];
        let (found, size) = SingularValues::robust(rows(v).map(|row| row * sign));
        let unit = size.max(least);
        if unit == 0.0 {
            return;
        }
        let (least, greatest) = (least / unit, greatest / unit);
        let values = found.values.map(|value| value * (size / unit));
        let product = values[0] * values[1] * values[2];
        let root = if product < least * least * least {
            least
        } else if product > greatest * greatest * greatest {
            greatest
        } else {
            return;
        };
        let values = triple_with_product_robust(values, root);
        let moved = points(found.with(values).map(|row| row * sign));
        v.iter_mut().zip(moved).for_each(|(p, moved)| *p = moved * unit);
    }
}

/// Returns four centred points in the basis; the determinant has the sign of the volume.
#[inline(always)]
fn rows<S: Lane>(v: &[Vec3<S>]) -> [Vec3<S>; 3] {
    // Halved first, as the sum of four finite numbers need not be finite.
    let [a, b, c, d] = [0, 1, 2, 3].map(|k| v[k] * S::splat(0.5));
    [(a - b) + (c - d), (a + b) - (c + d), (a - b) - (c - d)]
}

/// Returns the points with these coordinates: multiplies by the transpose.
#[inline(always)]
fn points<S: Lane>(rows: [Vec3<S>; 3]) -> [Vec3<S>; 4] {
    let [q, p, r] = rows.map(|row| row * S::splat(0.5));
    [p + q + r, p - q - r, q - p - r, r - p - q]
}

#[cfg(test)]
mod tests {
    use super::Volume;
    use crate::constraint::Projection;
    use crate::math::{Vec3, centre};
    use serde_json::json;

    const REST: [[f64; 3]; 4] = [[0.0; 3], [3.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0]];

    fn project(params: serde_json::Value, rest: [[f64; 3]; 4], points: [[f64; 3]; 4]) -> f64 {
        let kind: Volume = serde_json::from_value(params).expect("the parameters are valid");
        let (mut rest, mut v) = (rest.map(Vec3::from), points.map(Vec3::from));
        centre(&mut rest);
        centre(&mut v);
        kind.prepare(&mut rest);
        kind.project(&rest, &v.clone(), &mut v);
        volume(v)
    }

    fn volume(v: [Vec3<f64>; 4]) -> f64 {
        (v[3] - v[0]).dot((v[1] - v[0]).cross(v[2] - v[0])) / 6.0
    }

    #[test]
    fn what_is_inside_out_or_flat_gets_its_volume_back() {
        let mirrored = REST.map(|[x, y, z]| [x, y, -z]);
        let flat = REST.map(|[x, y, _]| [x, y, 0.0]);
        let line = REST.map(|[x, y, z]| [x - y + 0.5 * z, 0.0, 0.0]);
        for points in [mirrored, flat, line, [[0.0; 3]; 4]] {
            for scale in [1.0, 1e-300, 1e-320] {
                let points = points.map(|p| p.map(|x| x * scale));
                let found = project(json!({}), REST, points);
                assert!((found - 1.0).abs() <= 1e-13, "{points:?} as at rest: {found}");
                let found = project(json!({}), mirrored, points);
                assert!((found + 1.0).abs() <= 1e-13, "{points:?} as mirrored: {found}");
                let found = project(json!({ "volume": 2 }), flat, points);
                assert!((found - 2.0).abs() <= 1e-13, "{points:?} as given: {found}");
            }
        }
    }

    #[test]
    fn limits_hold_from_both_sides() {
        for (params, expected) in [
            (json!({ "volume": [2, 3] }), 2.0),
            (json!({ "volume": [null, 0.01] }), 0.01),
            (json!({ "strain": [0.5, 0.75] }), 0.75),
            (json!({ "strain": 0 }), 0.0),
            (json!({ "strain": [0.5, null] }), 1.0),
        ] {
            let found = project(params.clone(), REST, REST);
            assert!((found - expected).abs() <= 1e-14, "{params}: {found}");
        }
    }
}
