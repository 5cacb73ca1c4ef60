//! Symmetric 3x3 matrices in lanes, and the scatter matrix of centred points (`C^T C` of paper
//! section 3.1).

use crate::math::{Lane, Vec3, in_range};

/// A symmetric 3x3 matrix; with [`crate::math::Lanes`], one for each of several constraints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Symmetric3<S> {
    /// Row 1, column 1.
    pub xx: S,
    /// Row 1, column 2.
    pub xy: S,
    /// Row 1, column 3.
    pub xz: S,
    /// Row 2, column 2.
    pub yy: S,
    /// Row 2, column 3.
    pub yz: S,
    /// Row 3, column 3.
    pub zz: S,
}

impl<S: Lane> Symmetric3<S> {
    /// The sum of `v v^T` over the points.
    #[inline(always)]
    pub fn scatter(points: &[Vec3<S>]) -> Self {
        let zero = S::zero();
        let mut sum = Symmetric3 { xx: zero, xy: zero, xz: zero, yy: zero, yz: zero, zz: zero };
        for v in points {
            sum.xx += v.x * v.x;
            sum.xy += v.x * v.y;
            sum.xz += v.x * v.z;
            sum.yy += v.y * v.y;
            sum.yz += v.y * v.z;
            sum.zz += v.z * v.z;
        }
        sum
    }
    /// Sum of the eigenvalues.
    #[inline(always)]
    pub fn trace(self) -> S {
        self.xx + self.yy + self.zz
    }
    /// All entries times `s`.
    #[inline(always)]
    pub fn scaled(self, s: S) -> Self {
        Symmetric3 {
            xx: self.xx * s,
            xy: self.xy * s,
            xz: self.xz * s,
            yy: self.yy * s,
            yz: self.yz * s,
            zz: self.zz * s,
        }
    }
    /// The matrix minus `s` times the identity.
    #[inline(always)]
    pub fn shifted(self, s: S) -> Self {
        Symmetric3 { xx: self.xx - s, yy: self.yy - s, zz: self.zz - s, ..self }
    }
    /// The adjugate: determinant times inverse, also defined for singular matrices. Its trace is
    /// the sum of the pairwise products of the eigenvalues.
    #[inline(always)]
    pub fn adjugate(self) -> Self {
        let Symmetric3 { xx, xy, xz, yy, yz, zz } = self;
        Symmetric3 {
            xx: yy * zz - yz * yz,
            xy: xz * yz - xy * zz,
            xz: xy * yz - xz * yy,
            yy: xx * zz - xz * xz,
            yz: xy * xz - xx * yz,
            zz: xx * yy - xy * xy,
        }
    }
    /// The determinant, from the matrix and its adjugate.
    #[inline(always)]
    pub fn determinant(self, adjugate: Self) -> S {
        self.xx * adjugate.xx + self.xy * adjugate.xy + self.xz * adjugate.xz
    }
    /// The matrix times a vector.
    #[inline(always)]
    pub fn times(self, v: Vec3<S>) -> Vec3<S> {
        Vec3::new(
            self.xx * v.x + self.xy * v.y + self.xz * v.z,
            self.xy * v.x + self.yy * v.y + self.yz * v.z,
            self.xz * v.x + self.yz * v.y + self.zz * v.z,
        )
    }
}

/// The scatter matrix of centred points, scaled to unit trace so that the intermediate results of
/// closed forms are of order one in any unit of length.
#[derive(Clone, Copy, Debug)]
pub struct Scatter<S> {
    /// The sum of `v v^T`, scaled to unit trace.
    pub unit: Symmetric3<S>,
    /// The mean of `|v|^2`: the trace before scaling, divided by the number of points.
    pub mean_square: S,
    /// One in the lanes where no product of up to eight lengths comes near the limits of the range
    /// of `f64`; zero in the others, among them coincident and non-finite points. In lanes with
    /// zero the fields above must not be used.
    pub in_range: S,
}

impl<S: Lane> Scatter<S> {
    /// The scatter of mean-centred points.
    #[inline(always)]
    pub fn of(points: &[Vec3<S>]) -> Self {
        let sum = Symmetric3::scatter(points);
        let trace = sum.trace();
        Scatter {
            unit: sum.scaled(S::one() / trace),
            mean_square: trace * S::splat(1.0 / points.len() as f64),
            in_range: in_range(trace, trace, S::one()),
        }
    }
}
