//! Plane (paper section 3.1): the normal of the plane is the eigenvector of the smallest eigenvalue
//! of the scatter matrix. The normal, or a direction in the plane, may be given.

use crate::constraint::parameter::Direction;
use crate::constraint::{Arity, Info, Param, Projection, TargetShape};
use crate::math::{Lane, PrincipalAxes, Scatter, Vec3, in_range};
use serde::{Deserialize, Serialize};

/// The least difference of two eigenvalues, relative to their sum, for which the closed form is
/// used. The error of the normal is about an ulp divided by this.
const LEAST_GAP: f64 = 1e-4;

/// All vertices lie in one plane: any, one with a given normal (a horizontal panel), or one that
/// contains a given direction (a vertical wall).
///
/// If several planes fit equally well (collinear points, a regular tetrahedron), one is chosen.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Given")]
pub struct Plane {
    /// The normal; its sign does not matter.
    normal: Option<Direction>,
    /// A direction in the plane; excludes `normal`.
    along: Option<Direction>,
}

/// The parameters as in the scene file.
#[derive(Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct Given {
    normal: Option<Direction>,
    along: Option<Direction>,
}

impl TryFrom<Given> for Plane {
    type Error = &'static str;

    fn try_from(Given { normal, along }: Given) -> Result<Plane, &'static str> {
        if normal.is_some() && along.is_some() {
            return Err("found both `normal` and `along`, expected one of them");
        }
        Ok(Plane { normal, along })
    }
}

impl Projection for Plane {
    const INFO: Info = Info {
        id: "plane",
        label: "Plane",
        summary: "The vertices lie in one plane, so that the panel can be cut from a flat sheet.",
        paper: "3.1",
        arity: Arity::AtLeast(3),
        measure: Some("planarity"),
        panels: Some("flat"),
        colour: [190, 120, 0],
        params: &[Param::direction("normal", "Normal"), Param::direction("along", "Along")],
        default_for: &[TargetShape::Panels, TargetShape::Points],
        ..Info::PLAIN
    };

    fn closed_form<S: Lane>(
        &self,
        _rest: &[Vec3<S>],
        v: &[Vec3<S>],
        projected: &mut [Vec3<S>],
    ) -> bool {
        if let Some(normal) = &self.normal {
            flatten(normal.unit(), v, projected);
            return true;
        }
        if let Some(along) = &self.along {
            let (normal, accurate) = normal_across(frame_across(along), v);
            flatten(normal, v, projected);
            return accurate.all_greater(S::zero());
        }
        let scatter = Scatter::of(v);
        let n = scatter.unit.smallest_eigenvector();
        flatten(n.vector, v, projected);
        (n.accurate * scatter.in_range).all_greater(S::zero())
    }

    fn project_robust(&self, _rest: &[Vec3<f64>], v: &mut [Vec3<f64>]) {
        if let Some(along) = &self.along {
            let [e, f] = frame_across(along);
            let mut flat: Vec<_> = v.iter().map(|v| Vec3::new(e.dot(*v), f.dot(*v), 0.0)).collect();
            // The third axis is the third coordinate axis, as all third coordinates are zero.
            let [_, least, _] = PrincipalAxes::rotate(&mut flat).axes;
            let normal = e * least.x + f * least.y;
            for p in v {
                *p -= normal * normal.dot(*p);
            }
            return;
        }
        let axes = PrincipalAxes::rotate(v);
        for p in v {
            *p = axes.point(Vec3::new(p.x, p.y, 0.0));
        }
    }
}

/// Projects the points along the unit vector `normal`.
#[inline(always)]
fn flatten<S: Lane>(normal: Vec3<S>, v: &[Vec3<S>], projected: &mut [Vec3<S>]) {
    for (v, p) in v.iter().zip(projected) {
        *p = *v - normal * normal.dot(*v);
    }
}

/// Returns two unit vectors orthogonal to each other and to the direction.
fn frame_across(along: &Direction) -> [Vec3<f64>; 2] {
    let along = along.unit::<f64>();
    let e = along.across();
    [e, along.cross(e)]
}

/// Returns the normal, a combination of `e` and `f`, of the closest plane, and one per accurate
/// lane, else zero.
///
/// The coordinates along `e` and `f` have a 2x2 scatter matrix; the angle of its greatest
/// eigenvector is half of that of `(xx - yy, 2 xy)`.
// Not inlined, to keep register pressure low for planes of any direction.
#[inline(never)]
fn normal_across<S: Lane>([e, f]: [Vec3<f64>; 2], v: &[Vec3<S>]) -> (Vec3<S>, S) {
    let splat = |v: Vec3<f64>| Vec3::new(S::splat(v.x), S::splat(v.y), S::splat(v.z));
    let (e, f) = (splat(e), splat(f));
    let (mut xx, mut xy, mut yy) = (S::zero(), S::zero(), S::zero());
    for v in v {
        let (x, y) = (e.dot(*v), f.dot(*v));
        xx += x * x;
        xy += x * y;
        yy += y * y;
    }
    let (cosine, sine) = (xx - yy, xy + xy);
    let square = cosine * cosine + sine * sine;
    let gap = square.sqrt();
    let x = cosine.if_greater(S::zero(), gap + cosine, sine);
    let y = cosine.if_greater(S::zero(), sine, gap - cosine);
    let normal = (f * x - e * y) * (S::one() / (x * x + y * y).sqrt());

    let trace = xx + yy;
    let good = in_range(trace, trace, S::one());
    let bound = S::splat(LEAST_GAP) * trace;
    (normal, square.if_greater(bound * bound, good, S::zero()))
}
