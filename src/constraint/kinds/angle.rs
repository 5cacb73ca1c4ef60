//! Angle: the angle at the corner of a face, or between two neighbouring segments, lies within limits.
//!
//! With `x` and `y` the edges from the corner to the vertices before and after it, and mean-centred
//! points, the squared distance of a displacement is `2/3 (|dx|^2 + |dy|^2 - dx.dy)`. For one angle
//! `a` the shape is `x = p u`, `y = q R u`, with a unit vector `u`, the rotation `R` by `a`, and
//! `p, q >= 0`. It lies in the plane of the points: for given `p` and `q` it is a triangle moved
//! rigidly, and the best motion of one planar set onto another keeps the plane (Kabsch 1976) and
//! the orientation, as the flipped triangle would have `sigma_1 - sigma_2` in place of
//! `sigma_1 + sigma_2` there.
//!
//! For given `u` the best `p` and `q` solve two linear equations, and the remaining distance is a
//! quadratic form in `u`: its greatest eigenvector is the closest, if its `p` and `q` agree in
//! sign. If not, one of them is zero: that of the shorter edge.

use crate::constraint::parameter::{AngleRange, Limits};
use crate::constraint::{Arity, Element, Info, Param, Projection};
use crate::math::{Lane, Vec3, in_range, largest_coordinate, plane_frame};
use serde::{Deserialize, Serialize};

/// Eigenvalues that differ by less than this fraction count as equal: all directions are equally
/// close. An example is a straight corner of equal edges that must become a right angle.
const EQUAL: f64 = 1e-12;

/// The angle at the middle one of three vertices lies within limits. If it does, nothing moves;
/// else it becomes the nearer limit, and all three vertices move.
///
/// If an edge has no length, the angle is undefined and nothing moves. If straightening or closing
/// the corner would turn an edge farther than it takes to collapse it, as for an obtuse angle that
/// must become zero, the shorter edge collapses. A straight or closed corner opens in the plane of
/// its line and of one of the coordinate axes farthest from it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Angle {
    /// In degrees.
    angle: AngleRange,
}

impl Default for Angle {
    fn default() -> Self {
        Angle { angle: AngleRange::of(Limits::exactly(90.0)) }
    }
}

impl Projection for Angle {
    const INFO: Info = Info {
        id: "angle",
        label: "Angle",
        summary: "The angle at the middle vertex is the given one, or lies within a range.",
        arity: Arity::Exactly(3),
        elements: &[Element::Corner],
        colour: [70, 130, 130],
        params: &[Param::limits("angle", "Angle", "degrees", 90.0, [0.0, 180.0])],
        ..Info::PLAIN
    };

    fn closed_form<S: Lane>(
        &self,
        _rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        let (x, y) = (v[0] - v[1], v[2] - v[1]);
        let (xx, yy) = (x.length_squared(), y.length_squared());
        self.closest(v, x, y, projected);
        in_range(xx.min(yy), xx.max(yy), S::one()).all_greater(S::zero())
    }

    fn project_robust(&self, _rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let size = largest_coordinate(v);
        if size == 0.0 {
            return;
        }
        let scaled: Vec<_> =
            v.iter().map(|p| Vec3::new(p.x / size, p.y / size, p.z / size)).collect();
        let (x, y) = (scaled[0] - scaled[1], scaled[2] - scaled[1]);
        // An edge this short cannot move anything by more than rounding.
        if x.length().min(y.length()) > 1e-25 {
            self.closest(&scaled, x, y, v);
            v.iter_mut().for_each(|p| *p = *p * size);
        }
    }
}

impl Angle {
    /// Writes the closest points, for edges `x` and `y` that are not zero.
    #[inline(always)]
    fn closest<S: Lane>(&self, v: &[Vec3<S>], x: Vec3<S>, y: Vec3<S>, projected: &mut [Vec3<S>]) {
        let (zero, half) = (S::zero(), S::splat(0.5));
        let [e, f] = plane_frame(x, y);
        let flat = |v: Vec3<S>| [v.dot(e), v.dot(f)];
        let (a, b) = (flat(x), flat(y));
        // Positive sines of the difference: the angle is below the least, or above the greatest.
        let (dot, cross) = (a[0] * b[0] + a[1] * b[1], a[0] * b[1] - a[1] * b[0]);
        let splat = |pair: [f64; 2]| pair.map(S::splat);
        let (least, greatest) = (splat(self.angle.least), splat(self.angle.greatest));
        let below = least[1] * dot - least[0] * cross;
        let beyond = greatest[0] * cross - greatest[1] * dot;
        let inside = if self.angle.is_one_angle { -S::one() } else { -below.max(beyond) };
        let [c, s] = [0, 1].map(|i| below.if_greater(zero, least[i], greatest[i]));

        // The vectors whose products with `u` and `R u` enter the form; `h` is turned back by `R`.
        let (before, after) = (x - y * half, y - x * half);
        let g = flat(before);
        let h = flat(after);
        let h = [c * h[0] + s * h[1], c * h[1] - s * h[0]];
        let form =
            |i: usize, j: usize| g[i] * g[j] + h[i] * h[j] + c * half * (g[i] * h[j] + g[j] * h[i]);
        let u = greatest_eigenvector([form(0, 0), form(0, 1), form(1, 1)], between(g, h));
        let (along_x, along_y) = (g[0] * u[0] + g[1] * u[1], h[0] * u[0] + h[1] * u[1]);
        // `p` and `q` times the determinant 1 - c^2 / 4 of the two equations.
        let p = along_x + c * half * along_y;
        let q = along_y + c * half * along_x;
        let scale = S::one() / (S::one() - c * c * S::splat(0.25));
        let (p, q, agree) = (p * scale, q * scale, p * q);
        let ru = [c * u[0] - s * u[1], s * u[0] + c * u[1]];
        let new_x = (e * u[0] + f * u[1]) * p;
        let new_y = (e * ru[0] + f * ru[1]) * q;

        // If the signs differ, the shorter edge collapses.
        let longer = x.length_squared() - y.length_squared();
        let collapsed_x = Vec3::if_greater(longer, zero, before, Vec3::zero());
        let collapsed_y = Vec3::if_greater(longer, zero, Vec3::zero(), after);
        let new_x = Vec3::if_greater(zero, agree, collapsed_x, new_x);
        let new_y = Vec3::if_greater(zero, agree, collapsed_y, new_y);
        let corner = (new_x + new_y) * S::splat(-1.0 / 3.0);
        let moved = [new_x + corner, corner, new_y + corner];
        for ((to, moved), own) in projected.iter_mut().zip(moved).zip(v) {
            // Zero sines mean that the angle equals a limit.
            *to = Vec3::if_greater(inside, S::splat(-f64::MIN_POSITIVE), *own, moved);
        }
    }
}

/// Returns the unit eigenvector of the greatest eigenvalue of a symmetric 2-by-2 matrix;
/// `otherwise` if both eigenvalues are equal.
#[inline(always)]
fn greatest_eigenvector<S: Lane>([xx, xy, yy]: [S; 3], otherwise: [S; 2]) -> [S; 2] {
    let (difference, twice) = (xx - yy, xy + xy);
    let root = (difference * difference + twice * twice).sqrt();
    let equal = S::splat(EQUAL) * (xx + yy);
    let x = difference.if_greater(S::zero(), difference + root, twice);
    let y = difference.if_greater(S::zero(), twice, root - difference);
    let inverse = S::one() / (x * x + y * y).sqrt();
    [
        root.if_greater(equal, x * inverse, otherwise[0]),
        root.if_greater(equal, y * inverse, otherwise[1]),
    ]
}

/// Returns the unit bisector of the angle of `g` and `h`; the first axis if they are opposite.
#[inline(always)]
fn between<S: Lane>(g: [S; 2], h: [S; 2]) -> [S; 2] {
    let inverse = |v: [S; 2]| S::one() / (v[0] * v[0] + v[1] * v[1]).sqrt();
    let (of_g, of_h) = (inverse(g), inverse(h));
    let sum = [g[0] * of_g + h[0] * of_h, g[1] * of_g + h[1] * of_h];
    let squared = sum[0] * sum[0] + sum[1] * sum[1];
    let inverse = S::one() / squared.sqrt();
    [
        squared.if_greater(S::splat(EQUAL), sum[0] * inverse, S::one()),
        squared.if_greater(S::splat(EQUAL), sum[1] * inverse, S::zero()),
    ]
}

#[cfg(test)]
mod tests {
    use super::Angle;
    use crate::constraint::Projection;
    use crate::math::Vec3;
    use serde_json::json;

    fn project(angle: serde_json::Value, points: [[f64; 3]; 3]) -> [Vec3<f64>; 3] {
        let angle: Angle = serde_json::from_value(json!({ "angle": angle })).expect("it is valid");
        let mut v = points.map(Vec3::from);
        crate::math::centre(&mut v);
        angle.project(&[], &v.clone(), &mut v);
        v
    }

    #[test]
    fn within_the_range_nothing_moves() {
        let points = [[1.0, 0.0, 0.0], [-1.0, -1.0, 0.0], [0.0, 1.0, 0.0]];
        for range in [json!([30, 100]), json!([null, 60]), json!([null, null]), json!([0, 180])] {
            assert_eq!(project(range, points), points.map(Vec3::from));
        }
    }

    #[test]
    fn a_straight_corner_opens_and_an_obtuse_one_that_is_closed_loses_its_shorter_edge() {
        let v = project(json!(90), [[-1.0, 0.0, 0.0], [0.0; 3], [1.0, 0.0, 0.0]]);
        let (x, y) = (v[0] - v[1], v[2] - v[1]);
        assert!(x.dot(y).abs() <= 1e-15 && x.length() > 0.5 && y.length() > 0.5, "{v:?}");

        let v = project(json!(0), [[-1.0, 0.5, 0.0], [0.0; 3], [2.0, 0.0, 0.0]]);
        assert!((v[0] - v[1]).length() <= 1e-15, "the shorter edge is lost: {v:?}");
        assert!((v[2] - v[1]).length() > 2.0, "the longer one is not: {v:?}");
    }

    #[test]
    fn an_edge_without_length_moves_nothing() {
        let points = [[1.0, 2.0, -2.0], [1.0, 2.0, -2.0], [-2.0, -4.0, 4.0]];
        for scale in [1.0, 1e-300, 1e300] {
            let points = points.map(|p| p.map(|x| x * scale));
            assert_eq!(project(json!(45), points), points.map(Vec3::from));
        }
    }
}
