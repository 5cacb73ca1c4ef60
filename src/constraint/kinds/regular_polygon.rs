//! Regular polygon of any size and position (paper section 3.3).
//!
//! The paper fits the regular polygon as a template, by the similarity of Umeyama 1991. As its
//! corners lie in a plane, only two columns of the 3x3 matrix of Umeyama matter,
//! `p = sum cos(2 pi k / n) v_k` and `q = sum sin(2 pi k / n) v_k`. The best frame in space is the
//! closest pair of equal, orthogonal vectors to them, of either orientation without a reflection.

use crate::constraint::{Arity, Info, Projection, TargetShape};
use crate::math::{Lane, OrthogonalPair, UnitPolygon, Vec3};
use serde::{Deserialize, Serialize};

/// The vertices, in order, are the corners of a regular polygon: equal sides and equal angles.
///
/// If `p` and `q` are parallel, as for collinear vertices, all planes through their line are
/// equally close, and one is chosen. If both are zero (as for a square with opposite corners in one
/// point each), the closest polygon is a point, the mean of the vertices.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct RegularPolygon {}

impl Projection for RegularPolygon {
    const INFO: Info = Info {
        id: "regular-polygon",
        label: "Regular polygon",
        summary: "The vertices are the corners of a flat panel whose sides are all equally long \
                  and whose angles are all equal.",
        paper: "3.3",
        arity: Arity::AtLeast(3),
        colour: [200, 60, 150],
        default_for: &[TargetShape::Triangles],
        ..Info::PLAIN
    };

    fn closed_form<S: Lane>(
        &self,
        _rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        let corners = UnitPolygon::new(v.len());
        let (p, q) = sums(&corners, v);
        let (pair, accurate) = OrthogonalPair::closest(p, q);
        place(&corners, pair, projected);
        accurate.all_greater(S::zero())
    }

    fn project_robust(&self, _rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        let corners = UnitPolygon::new(v.len());
        let (p, q) = sums(&corners, v);
        place(&corners, OrthogonalPair::closest_robust(p, q), v);
    }
}

/// Returns `p` and `q` divided by `n / 2`: the half-axes of the closest affine polygon.
#[inline(always)]
fn sums<S: Lane>(corners: &[[f64; 2]], v: &[Vec3<S>]) -> (Vec3<S>, Vec3<S>) {
    let (mut p, mut q) = (Vec3::zero(), Vec3::zero());
    let scale = 2.0 / v.len() as f64;
    for ([c, s], v) in corners.iter().zip(v) {
        p += *v * S::splat(c * scale);
        q += *v * S::splat(s * scale);
    }
    (p, q)
}

/// Writes the polygon with the first corner at `u` and the direction `w` a quarter turn from it.
#[inline(always)]
fn place<S: Lane>(corners: &[[f64; 2]], pair: OrthogonalPair<S>, projected: &mut [Vec3<S>]) {
    for ([c, s], to) in corners.iter().zip(projected) {
        *to = pair.u * S::splat(*c) + pair.w * S::splat(*s);
    }
}
