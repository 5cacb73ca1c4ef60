//! Closest point on a triangle (Ericson, *Real-Time Collision Detection*, section 5.1.5).

use super::Point;
use crate::math::Vec3;

/// A triangle, with what the closest point on it needs. A segment `ab` is the triangle `abb`, a
/// point the triangle `aaa`.
#[derive(Clone, Debug)]
pub(super) struct Triangle {
    a: Vec3<f64>,
    ab: Vec3<f64>,
    ac: Vec3<f64>,
    /// Unit normal; zero for segments and points.
    normal: Vec3<f64>,
    ab_ab: f64,
    ab_ac: f64,
    ac_ac: f64,
}

/// A point of a surface and its squared distance to the point that was asked for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hit {
    pub(super) point: Vec3<f64>,
    pub(super) distance_squared: f64,
}

impl Triangle {
    /// The triangle of these corners. It must not be a sliver: see [`Triangle::is_sliver`].
    pub(super) fn new(corners: [Point; 3]) -> Triangle {
        let [a, b, c] = corners.map(Vec3::from);
        let (ab, ac) = (b - a, c - a);
        let normal = ab.cross(ac);
        let area = normal.length();
        let normal = if area > 0.0 { normal * (1.0 / area) } else { Vec3::zero() };
        let (ab_ab, ab_ac, ac_ac) = (ab.dot(ab), ab.dot(ac), ac.dot(ac));
        Triangle { a, ab, ac, normal, ab_ab, ab_ac, ac_ac }
    }

    /// Whether the triangle is so thin that rounding decides what is inside: its height is less
    /// than 1e-8 of its longest side. Its three sides then stand for it.
    pub(super) fn is_sliver(corners: [Point; 3]) -> bool {
        const THINNEST: f64 = 1e-8;
        let [a, b, c] = corners.map(Vec3::from);
        let longest_squared =
            (b - a).length_squared().max((c - b).length_squared()).max((a - c).length_squared());
        (b - a).cross(c - a).length() <= THINNEST * longest_squared
    }

    /// The closest point to `p`, if it is nearer than the square root of `bound`.
    #[inline]
    pub(super) fn closest(&self, p: Vec3<f64>, bound: f64) -> Option<Hit> {
        let ap = p - self.a;
        let height = self.normal.dot(ap);
        if height * height >= bound {
            return None;
        }
        let from_a = self.foot(ap, height);
        let distance_squared = (ap - from_a).length_squared();
        (distance_squared < bound).then(|| Hit { point: self.a + from_a, distance_squared })
    }

    /// The closest point to `p = a + ap`, relative to `a`. The inner products of the sides with
    /// `p - a`, `p - b` and `p - c` tell in which of the seven regions around the triangle it is.
    #[inline(always)]
    fn foot(&self, ap: Vec3<f64>, height: f64) -> Vec3<f64> {
        let (ab, ac) = (self.ab, self.ac);
        let (ab_ap, ac_ap) = (ab.dot(ap), ac.dot(ap));
        if ab_ap <= 0.0 && ac_ap <= 0.0 {
            return Vec3::zero();
        }
        let (ab_bp, ac_bp) = (ab_ap - self.ab_ab, ac_ap - self.ab_ac);
        if ab_bp >= 0.0 && ac_bp <= ab_bp {
            return ab;
        }
        let c_side = ab_ap * ac_bp - ab_bp * ac_ap;
        if c_side <= 0.0 && ab_ap >= 0.0 && ab_bp <= 0.0 {
            return ab * (ab_ap / self.ab_ab);
        }
        let (ab_cp, ac_cp) = (ab_ap - self.ab_ac, ac_ap - self.ac_ac);
        if ac_cp >= 0.0 && ab_cp <= ac_cp {
            return ac;
        }
        let b_side = ab_cp * ac_ap - ab_ap * ac_cp;
        if b_side <= 0.0 && ac_ap >= 0.0 && ac_cp <= 0.0 {
            return ac * (ac_ap / self.ac_ac);
        }
        let a_side = ab_bp * ac_cp - ab_cp * ac_bp;
        let (bc_bp, cb_cp) = (ac_bp - ab_bp, ab_cp - ac_cp);
        if a_side <= 0.0 && bc_bp >= 0.0 && cb_cp >= 0.0 {
            return ab + (ac - ab) * (bc_bp / (bc_bp + cb_cp));
        }
        ap - self.normal * height
    }
}
