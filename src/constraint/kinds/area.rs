//! Area of a triangle: as at rest, given, or within limits.
//!
//! In its own plane, with complex numbers for points, a centred triangle is the sum of two
//! equilateral ones of opposite orientation, `z_k = a w^k + b w^-k` with `w` a third of a turn. Its
//! singular values are `|a| + |b|` and `|a| - |b|`, times the root of 3/2; its area is
//! `|a|^2 - |b|^2`, times `3 sqrt(3) / 4`. The closest triangle of another area has the same
//! singular vectors and the closest singular values with the required product (von Neumann's trace
//! inequality): see [`pair_with_product`]. So `a` and `b` keep their directions.

use crate::constraint::parameter::{Limits, Target};
use crate::constraint::{Arity, Info, Projection};
use crate::math::{
    Lane, Vec3, largest_coordinate, pair_with_product, pair_with_product_robust, plane_frame,
};
use serde::{Deserialize, Serialize};

/// `3 sqrt(3) / 4`, the area of the equilateral triangle whose corners are at distance one from its
/// centre.
const EQUILATERAL: f64 = 1.299_038_105_676_658;

/// `sqrt(3) / 2`, the sine of a third of a turn.
const SINE: f64 = 0.866_025_403_784_438_6;

/// Three vertices span their rest area, or a given one. With limits instead of one number, only an
/// area outside them is corrected.
///
/// Collinear vertices move apart in the plane of their line and of one of the coordinate axes
/// farthest from it. Coincident vertices become an equilateral triangle in the plane of the first
/// two axes. If an equilateral triangle loses more than three quarters of its area, all directions
/// of flattening are equally close; one is chosen.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Area {
    /// The area.
    area: Target,
    /// Factor of the rest area, if that is the target.
    strain: Limits,
}

impl Default for Area {
    fn default() -> Self {
        Area { area: Target::Rest, strain: Limits::exactly(1.0) }
    }
}

impl Projection for Area {
    const INFO: Info = Info {
        id: "area",
        label: "Area",
        summary: "The three vertices keep the area of their triangle, or take a given value.",
        arity: Arity::Exactly(3),
        colour: [100, 140, 60],
        params: &Target::params("area", "Area", "Times the original area"),
        ..Info::PLAIN
    };

    const READS_REST: bool = true;

    /// Stores the least and the greatest `sqrt(|a|^2 - |b|^2)`.
    fn prepare(&self, rest: &mut [Vec3<f64>]) {
        let size = Scaled::of(rest).map_or(0.0, |Scaled { size, triangle, .. }| {
            let [s, t] = triangle.singular_values();
            // Rounding can make the last one of a flat triangle negative.
            (s * t.max(0.0)).sqrt() * size
        });
        let unit = (1.0 / EQUILATERAL).sqrt();
        let [least, greatest] = self.area.sizes(self.strain, f64::sqrt, [size, unit]);
        rest[0] = Vec3::new(least, greatest, 0.0);
    }

    fn closed_form<S: Lane>(
        &self,
        rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        let triangle = Triangle::of(v[1] - v[0], v[2] - v[0]);
        let [s, t] = triangle.singular_values();
        let (least, greatest) = (rest[0].x, rest[0].y);
        let product = s * t;
        let target = product.max(least * least).min(greatest * greatest);
        let moves = (target - product).abs();
        let (pair, accurate) = pair_with_product(s, t, target.sqrt());
        let moved = triangle.with_singular_values(pair);
        for ((to, moved), own) in projected.iter_mut().zip(moved).zip(v) {
            *to = Vec3::if_greater(moves, S::zero(), moved, *own);
        }
        let accurate = moves.if_greater(S::zero(), accurate, S::one());
        // Fourth powers of lengths stay in range here; the comparisons also fail for NaN.
        let accurate = s.if_greater(S::splat(1e-30), accurate, S::zero());
        let accurate = S::splat(1e30).if_greater(least, accurate, S::zero());
        S::splat(1e30).if_greater(s, accurate, S::zero()).all_greater(S::zero())
    }

    fn project_robust(&self, rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let (least, greatest) = (rest[0].x, rest[0].y);
        let Some(Scaled { size, triangle, .. }) = Scaled::of(v) else {
            let [c, s] = [-0.5 * least, SINE * least];
            let corners = [[least, 0.0], [c, s], [c, -s]];
            v.iter_mut().zip(corners).for_each(|(p, [x, y])| *p = Vec3::new(x, y, 0.0));
            return;
        };
        let unit = size.max(least);
        let [s, t] = triangle.singular_values().map(|value| value.max(0.0) * (size / unit));
        let (least, greatest) = (least / unit, greatest / unit);
        let target = (s * t).max(least * least).min(greatest * greatest);
        if target != s * t {
            let pair = pair_with_product_robust(s, t, target.sqrt());
            let moved = triangle.with_singular_values(pair);
            v.iter_mut().zip(moved).for_each(|(p, moved)| *p = moved * unit);
        }
    }
}

/// A triangle as the sum of two equilateral ones in its plane.
struct Triangle<S> {
    frame: [Vec3<S>; 2],
    /// `a`.
    with: [S; 2],
    /// `b`.
    against: [S; 2],
}

impl<S: Lane> Triangle<S> {
    /// The triangle with these edges from the first corner, at least one of them not zero.
    #[inline(always)]
    fn of(x: Vec3<S>, y: Vec3<S>) -> Self {
        let frame = plane_frame(x, y);
        let [x, y] = [x, y].map(|edge| frame.map(|axis| edge.dot(axis)));
        // a = (z0 + w* z1 + w z2) / 3, b = (z0 + w z1 + w* z2) / 3, and z0 cancels.
        let (sixth, sine) = (S::splat(1.0 / 6.0), S::splat(SINE / 3.0));
        let mean = [0, 1].map(|i| -(x[i] + y[i]) * sixth);
        let turned = [(x[1] - y[1]) * sine, (y[0] - x[0]) * sine];
        Triangle {
            frame,
            with: [mean[0] + turned[0], mean[1] + turned[1]],
            against: [mean[0] - turned[0], mean[1] - turned[1]],
        }
    }

    /// `|a| + |b|` and `|a| - |b|`.
    #[inline(always)]
    fn singular_values(&self) -> [S; 2] {
        let (a, b) = (length(self.with), length(self.against));
        [a + b, a - b]
    }

    /// Returns the corners of the triangle with these singular values in place of its own.
    #[inline(always)]
    fn with_singular_values(&self, [s, t]: [S; 2]) -> [Vec3<S>; 3] {
        let (half, sine) = (S::splat(0.5), S::splat(SINE));
        let a = resized(self.with, (s + t) * half);
        let b = resized(self.against, (s - t) * half);
        let [e, f] = self.frame;
        let point = |x: S, y: S| e * x + f * y;
        let sum = [a[0] + b[0], a[1] + b[1]];
        let across = [(b[1] - a[1]) * sine, (a[0] - b[0]) * sine];
        [
            point(sum[0], sum[1]),
            point(across[0] - sum[0] * half, across[1] - sum[1] * half),
            point(-across[0] - sum[0] * half, -across[1] - sum[1] * half),
        ]
    }
}

#[inline(always)]
fn length<S: Lane>([x, y]: [S; 2]) -> S {
    (x * x + y * y).sqrt()
}

/// Returns the vector with length `to`; along the first axis if it is zero.
#[inline(always)]
fn resized<S: Lane>(v: [S; 2], to: S) -> [S; 2] {
    let own = length(v);
    let [x, y] = v.map(|x| x * (to / own));
    [own.if_greater(S::zero(), x, to), own.if_greater(S::zero(), y, S::zero())]
}

/// A triangle divided by its size.
struct Scaled {
    size: f64,
    triangle: Triangle<f64>,
}

impl Scaled {
    /// Returns none if all points coincide.
    fn of(v: &[Vec3<f64>]) -> Option<Scaled> {
        // Halved first, as the difference of two finite numbers need not be finite.
        let edges = [1, 2].map(|k| v[k] * 0.5 - v[0] * 0.5);
        let size = largest_coordinate(&edges);
        let [x, y] = edges.map(|p| Vec3::new(p.x / size, p.y / size, p.z / size));
        (size > 0.0).then(|| Scaled { size: size * 2.0, triangle: Triangle::of(x, y) })
    }
}

#[cfg(test)]
mod tests {
    use super::Area;
    use crate::constraint::Projection;
    use crate::math::Vec3;
    use serde_json::json;

    fn project(params: serde_json::Value, points: [[f64; 3]; 3]) -> [Vec3<f64>; 3] {
        let area: Area = serde_json::from_value(params).expect("the parameters are valid");
        let mut rest = [[0.0; 3], [2.0, 0.0, 0.0], [0.0, 0.0, 1.0]].map(Vec3::from);
        area.prepare(&mut rest);
        let mut v = points.map(Vec3::from);
        area.project(&rest, &v.clone(), &mut v);
        v
    }

    fn area(v: [Vec3<f64>; 3]) -> f64 {
        0.5 * (v[1] - v[0]).cross(v[2] - v[0]).length()
    }

    #[test]
    fn points_that_coincide_or_are_collinear_part() {
        for points in [[[0.0; 3]; 3], [[0.0, -1.0, 0.0], [0.0; 3], [0.0, 1.0, 0.0]]] {
            for scale in [1.0, 1e-300, 1e-320] {
                let points = points.map(|p| p.map(|x| x * scale));
                let found = area(project(json!({}), points));
                assert!((found - 1.0).abs() <= 1e-14, "{points:?}: {found}");
            }
        }
    }

    #[test]
    fn within_the_limits_nothing_moves() {
        let points = [[1.0, 0.0, 0.0], [-1.0, 1.0, 0.0], [0.0, -1.0, 0.0]];
        for params in [json!({ "strain": [0.5, 2] }), json!({ "area": [1, null] })] {
            assert_eq!(project(params, points), points.map(Vec3::from));
        }
    }

    #[test]
    fn an_equilateral_triangle_is_flattened_in_one_direction() {
        let points = [[1.0, 0.0, 0.0], [-0.5, super::SINE, 0.0], [-0.5, -super::SINE, 0.0]];
        let v = project(json!({ "area": 0 }), points);
        assert!(area(v) <= 1e-15, "{v:?}");
        assert!((v.iter().map(|p| p.length_squared()).sum::<f64>() - 1.5).abs() <= 1e-14, "{v:?}");
    }
}
