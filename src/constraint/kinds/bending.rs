//! Bending at the edge between two triangles: flat, or bent as much as at rest.
//!
//! The vector `s = sum_i w_i v_i` over the ends of the edge and the two corners opposite to it,
//! with weights from the cotangents of the rest triangles, is zero exactly if the points are an
//! affine image of the unfolded rest triangles; its length is that of the discrete mean curvature
//! vector of the hinge (Bergou, Wardetzky, Harmon, Zorin, Grinspun 2006). As it is linear in the
//! points, the closest points with another vector `s*` are `v_i - w_i (s - s*) / sum_k w_k^2`.

use crate::constraint::parameter::Limits;
use crate::constraint::{Arity, Element, Info, Param, Projection};
use crate::math::{Lane, Vec3, in_range, largest_coordinate};
use serde::{Deserialize, Serialize};

/// A bending vector shorter than this fraction of the size of the hinge is rounding error.
const FLAT: f64 = 1e-13;

/// Two triangles with a common edge are flat, bent as much as at rest, or bent within limits
/// relative to that; the side to which they bend does not matter.
///
/// Flat triangles that must bend do so towards the side on which they bend at rest. A rest triangle
/// without area counts as its collinear points, and the other one has no weight beside it. If both
/// have no area, nothing moves.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Bending {
    /// Limits relative to the bending at rest.
    bend: Limits,
}

impl Default for Bending {
    fn default() -> Self {
        Bending { bend: Limits::exactly(0.0) }
    }
}

impl Projection for Bending {
    const INFO: Info = Info {
        id: "bending",
        label: "Bending",
        summary: "Two triangles with a common edge are flat, or bent as much as in the original.",
        arity: Arity::Exactly(4),
        elements: &[Element::Hinge],
        colour: [120, 100, 150],
        params: &[Param::limits(
            "bend",
            "Times the original bending",
            "",
            0.0,
            [0.0, f64::INFINITY],
        )],
        ..Info::PLAIN
    };

    const READS_REST: bool = true;

    /// Stores the weights of the ends and of the corners, scaled so that their squares sum to one;
    /// the length of the bending vector at rest, and the side of the hinge to which it points.
    fn prepare(&self, rest: &mut [Vec3<f64>]) {
        let size = largest_coordinate(rest);
        let unit = if size > 0.0 { size } else { 1.0 };
        let scaled = [0, 1, 2, 3].map(|k| rest[k]);
        let scaled = scaled.map(|p| Vec3::new(p.x / unit, p.y / unit, p.z / unit));
        let [a, b, c, d] = weights(scaled);
        rest[0] = Vec3::new(a, b, 0.0);
        rest[1] = Vec3::new(c, d, 0.0);
        let bending = bending(rest, &scaled);
        let side = if bending.dot(normal(&scaled)) < 0.0 { -1.0 } else { 1.0 };
        rest[2] = Vec3::new(bending.length() * unit, side, 0.0);
    }

    fn closed_form<S: Lane>(
        &self,
        rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        self.bend_to_limits(rest, v, measure(rest, v), projected);
        let squared = v.iter().fold(S::zero(), |sum, p| sum + p.length_squared());
        in_range(squared, squared, S::one()).all_greater(S::zero())
    }

    fn project_robust(&self, rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let size = largest_coordinate(v);
        // Coincident points are flat.
        let unit = if size > 0.0 { size } else { 1.0 };
        let own = v.to_vec();
        let scaled: Vec<_> =
            v.iter().map(|p| Vec3::new(p.x / unit, p.y / unit, p.z / unit)).collect();
        let (length, direction) = measure(rest, &scaled);
        self.bend_to_limits(rest, &own, (length * unit, direction), v);
    }
}

impl Bending {
    /// Brings the bending vector, with this length and direction, within the limits.
    #[inline(always)]
    fn bend_to_limits<S: Lane>(
        &self,
        rest: &[Vec3<S>],
        v: &[Vec3<S>],
        (length, direction): (S, Vec3<S>),
        projected: &mut [Vec3<S>],
    ) {
        let target = self.bend.clamp_times(length, rest[2].x);
        let excess = bending(rest, v) - direction * target;
        let excess = Vec3::if_greater((length - target).abs(), S::zero(), excess, Vec3::zero());
        for ((to, own), weight) in projected.iter_mut().zip(v).zip(prepared_weights(rest)) {
            *to = *own - excess * weight;
        }
    }
}

/// Returns length and direction of the bending vector. If the hinge is flat up to rounding, the
/// direction is that of its normal, on the side of the rest shape.
#[inline(always)]
fn measure<S: Lane>(rest: &[Vec3<S>], v: &[Vec3<S>]) -> (S, Vec3<S>) {
    let (zero, one) = (S::zero(), S::one());
    let size = v.iter().fold(zero, |sum, p| sum + p.length_squared());
    let s = bending(rest, v);
    let (squared, normal) = (s.length_squared(), normal(v));
    let (length, area) = (squared.sqrt(), normal.length());
    let normal = normal * (rest[2].y / area);
    let normal = Vec3::if_greater(area, zero, normal, Vec3::new(one, zero, zero));
    let is_bent = S::splat(FLAT * FLAT) * size;
    (length, Vec3::if_greater(squared, is_bent, s * (one / length), normal))
}

/// Returns the weights, normalised, of a hinge of size about one; all zero if both triangles have
/// no area. Cotangents are dot over cross product; here they are multiplied by both areas.
fn weights([a, b, c, d]: [Vec3<f64>; 4]) -> [f64; 4] {
    let edge = b - a;
    let area = |corner: Vec3<f64>| edge.cross(corner - a).length();
    let at_a = |corner: Vec3<f64>| edge.dot(corner - a);
    let at_b = |corner: Vec3<f64>| -edge.dot(corner - b);
    let (of_c, of_d) = (area(c), area(d));
    let squared = edge.length_squared();
    let w = [
        at_b(c) * of_d + at_b(d) * of_c,
        at_a(c) * of_d + at_a(d) * of_c,
        -squared * of_d,
        -squared * of_c,
    ];
    let greatest = w.iter().fold(0.0f64, |m, w| m.max(w.abs()));
    if greatest == 0.0 {
        return w;
    }
    let w = w.map(|w| w / greatest);
    let length = w.iter().map(|w| w * w).sum::<f64>().sqrt();
    w.map(|w| w / length)
}

#[inline(always)]
fn prepared_weights<S: Lane>(rest: &[Vec3<S>]) -> [S; 4] {
    [rest[0].x, rest[0].y, rest[1].x, rest[1].y]
}

/// `sum_i w_i v_i`, with prepared weights.
#[inline(always)]
fn bending<S: Lane>(rest: &[Vec3<S>], v: &[Vec3<S>]) -> Vec3<S> {
    let [a, b, c, d] = prepared_weights(rest);
    (v[0] * a + v[1] * b) + (v[2] * c + v[3] * d)
}

/// The sum of the triangle normals, each times twice its area.
#[inline(always)]
fn normal<S: Lane>(v: &[Vec3<S>]) -> Vec3<S> {
    (v[1] - v[0]).cross(v[2] - v[3])
}

#[cfg(test)]
mod tests {
    use super::Bending;
    use crate::constraint::Projection;
    use crate::math::{Vec3, centre};
    use serde_json::json;

    fn project(bend: f64, rest: [[f64; 3]; 4], points: [[f64; 3]; 4]) -> [Vec3<f64>; 4] {
        let kind: Bending = serde_json::from_value(json!({ "bend": bend })).expect("it is valid");
        let (mut rest, mut v) = (rest.map(Vec3::from), points.map(Vec3::from));
        centre(&mut rest);
        centre(&mut v);
        kind.prepare(&mut rest);
        kind.project(&rest, &v.clone(), &mut v);
        v
    }

    /// A ridge along y.
    const BENT: [[f64; 3]; 4] =
        [[0.0, 0.0, 0.5], [0.0, 2.0, 0.5], [-1.0, 0.5, 0.0], [1.0, 1.0, 0.0]];

    #[test]
    fn a_hinge_that_is_flattened_is_bent_back_to_the_side_of_its_rest_shape() {
        let flat = BENT.map(|[x, y, _]| [x, y, 0.0]);
        let back = project(1.0, BENT, flat);
        let height = (back[0].z + back[1].z) - (back[2].z + back[3].z);
        assert!(height > 0.5, "{back:?}");
        let unmoved = project(1.0, BENT, BENT);
        let mut expected = BENT.map(Vec3::from);
        centre(&mut expected);
        for (p, q) in unmoved.iter().zip(expected) {
            assert!((*p - q).length() <= 1e-15, "{unmoved:?}");
        }
        let flattened = project(0.0, BENT, BENT);
        let normal = (flattened[1] - flattened[0]).cross(flattened[2] - flattened[0]);
        assert!(normal.dot(flattened[3] - flattened[0]).abs() <= 1e-15, "{flattened:?}");
    }

    #[test]
    fn a_rest_triangle_without_area_counts_as_its_collinear_points() {
        let mut rest = BENT;
        rest[2] = [0.0, 1.0, 0.5];
        let v = project(0.0, rest, BENT);
        let middle = (v[0] + v[1]) * 0.5;
        assert!((v[2] - middle).length() <= 1e-15, "{v:?}");

        rest[3] = [0.0, 5.0, 0.5];
        let v = project(0.0, rest, BENT);
        let mut expected = BENT.map(Vec3::from);
        centre(&mut expected);
        assert_eq!(v, expected, "there is nothing to bend");
    }
}
