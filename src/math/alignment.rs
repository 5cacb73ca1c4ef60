//! The rotation and uniform scale that take rest points closest to points (paper section 3.2;
//! Kabsch 1976, Umeyama 1991, reflections excluded).
//!
//! With `H = sum v v'^T` over the points and their rest points, the rotation is the one that makes
//! `tr(R^T H)` greatest, and the scale is `tr(R^T H) / sum |v'|^2`.
//!
//! In closed form: the right singular vector `n` of the smallest singular value of `H` is the smallest
//! eigenvector of `H^T H`; on its complement, the polar factor of a 2-by-2 matrix is a formula; the
//! third axis is a cross product, so that the determinant is one.
//!
//! Near equal singular values `n` is poor, while `R` need not be. So `R` is checked, not `n`: with
//! `K = R^T H = S + skew`, turning `R` by a small vector `o` changes `tr(R^T H)` by
//! `g.o - o.A o / 2`, where `g` is the axial vector of `K` and `A = tr(S) I - S`. `R` is greatest
//! where `g = 0` and `A` is positive definite, and no other rotation is then greater: in quaternions,
//! `tr(R^T H)` is a quadratic form, whose only maximum is its greatest eigenvalue. Where `g` is not
//! yet zero, `o = A^-1 g` is Newton's step, and `|o|` the angle by which `R` is off.

use super::{Lane, PrincipalAxes, Symmetric3, Vec3};

/// The greatest angle, in radians, by which a rotation that passes the check can be off.
const ANGLE: f64 = 1e-12;

/// Convergence is quadratic at least: more are needed only where the check cannot be passed.
const CORRECTIONS: usize = 3;

/// A singular value below this fraction of the greatest is rounding error.
const NEGLIGIBLE: f64 = 8.0 * f64::EPSILON;

/// The best rotation and scale from rest points to points.
#[derive(Clone, Copy, Debug)]
pub struct Alignment<S> {
    /// The columns of the rotation `R`, orthonormal and right-handed.
    pub columns: [Vec3<S>; 3],
    /// The factor that takes the turned rest points closest to the points. Not negative.
    pub scale: S,
    /// One in the lanes where the rotation is off by at most 1e-12 radians, else zero. There
    /// nothing above is to be used: see [`Alignment::careful`].
    pub accurate: S,
}

impl<S: Lane> Alignment<S> {
    /// The alignment of mean-centred rest points with as many mean-centred points.
    #[inline(always)]
    pub fn of(rest: &[Vec3<S>], v: &[Vec3<S>]) -> Self {
        let mut h = [Vec3::zero(); 3];
        let mut square = S::zero();
        for (r, v) in rest.iter().zip(v) {
            h[0] += *v * r.x;
            h[1] += *v * r.y;
            h[2] += *v * r.z;
            square += r.length_squared();
        }
        Self::of_product(h, square)
    }

    /// The rest point `r` turned.
    #[inline(always)]
    pub fn turn(&self, r: Vec3<S>) -> Vec3<S> {
        combine(self.columns, r)
    }

    /// From the columns of `H` and `sum |v'|^2`.
    // Not inlined, as the eigenvector: the lanes stay packed.
    #[inline(never)]
    fn of_product(h: [Vec3<S>; 3], square: S) -> Self {
        let one = S::one();
        let size = h[0].length_squared() + h[1].length_squared() + h[2].length_squared();
        let in_range = within_range(size, within_range(square, one));
        let size = size.sqrt();
        let h = h.map(|column| column * (one / size));

        let mut columns = first_rotation(h);
        let mut check = Check::of(columns, h, in_range);
        for _ in 0..CORRECTIONS {
            if check.passed.all_greater(S::zero()) {
                break;
            }
            let corrected = turned(columns, check.step);
            // A lane that has passed stays as it is, whatever its neighbours need.
            for (column, corrected) in columns.iter_mut().zip(corrected) {
                *column = Vec3::if_greater(check.passed, S::zero(), *column, corrected);
            }
            check = Check::of(columns, h, in_range);
        }
        Alignment { columns, scale: check.trace * size / square, accurate: check.passed }
    }
}

/// Keeps `flag` where a sum of products of two or four lengths is not near the ends of the range of
/// `f64`.
#[inline(always)]
fn within_range<S: Lane>(sum: S, flag: S) -> S {
    let not_tiny = sum.if_greater(S::splat(1e-200), flag, S::zero());
    S::splat(1e200).if_greater(sum, not_tiny, S::zero())
}

/// The vector with components `x` along `columns`.
#[inline(always)]
fn combine<S: Lane>(columns: [Vec3<S>; 3], x: Vec3<S>) -> Vec3<S> {
    columns[0] * x.x + columns[1] * x.y + columns[2] * x.z
}

/// The columns of the closest rotation to the matrix with the columns `h`, whose squares sum to one.
#[inline(always)]
fn first_rotation<S: Lane>(h: [Vec3<S>; 3]) -> [Vec3<S>; 3] {
    let (zero, one, half) = (S::zero(), S::one(), S::splat(0.5));
    let gram = Symmetric3 {
        xx: h[0].length_squared(),
        xy: h[0].dot(h[1]),
        xz: h[0].dot(h[2]),
        yy: h[1].length_squared(),
        yz: h[1].dot(h[2]),
        zz: h[2].length_squared(),
    };
    let n = gram.smallest_eigenvector().vector;
    let aside = Vec3::if_greater(
        n.x.abs(),
        S::splat(0.6),
        Vec3::new(zero, one, zero),
        Vec3::new(one, zero, zero),
    );
    let a = n.cross(aside);
    let a = a * (one / a.length());
    let b = n.cross(a);

    // The polar factor of M = (p r) is M (M^T M)^-1/2, with
    // (M^T M)^1/2 = (M^T M + det I) / tau.
    let (p, r) = (combine(h, a), combine(h, b));
    let (pp, pr, rr) = (p.length_squared(), p.dot(r), r.length_squared());
    let determinant = p.cross(r).length();
    let tau = (pp + rr + determinant + determinant).sqrt();
    let inverse = one / (determinant * tau);
    let u = (p * (rr + determinant) - r * pr) * inverse;
    let v = (r * (pp + determinant) - p * pr) * inverse;
    // Orthonormal to rounding, where the division above has magnified it.
    let overlap = u.dot(v) * half;
    let shortened = |u: Vec3<S>| u * (S::splat(1.5) - u.length_squared() * half);
    let (u, v) = (shortened(u) - v * overlap, shortened(v) - u * overlap);
    let w = u.cross(v);
    let column = |a: S, b: S, n: S| u * a + v * b + w * n;
    [column(a.x, b.x, n.x), column(a.y, b.y, n.y), column(a.z, b.z, n.z)]
}

/// How far a rotation is from the closest one.
struct Check<S> {
    /// `tr(R^T H)`.
    trace: S,
    /// Newton's step, as a rotation vector in rest coordinates.
    step: Vec3<S>,
    /// One where the rotation is off by at most [`ANGLE`], else zero.
    passed: S,
}

impl<S: Lane> Check<S> {
    #[inline(always)]
    fn of(r: [Vec3<S>; 3], h: [Vec3<S>; 3], in_range: S) -> Self {
        let half = S::splat(0.5);
        let k = |i: usize, j: usize| r[i].dot(h[j]);
        let (xx, yy, zz) = (k(0, 0), k(1, 1), k(2, 2));
        let (xy, yx) = (k(0, 1), k(1, 0));
        let (xz, zx) = (k(0, 2), k(2, 0));
        let (yz, zy) = (k(1, 2), k(2, 1));
        let gradient = Vec3::new(zy - yz, xz - zx, yx - xy);
        let a = Symmetric3 {
            xx: yy + zz,
            xy: -(xy + yx) * half,
            xz: -(xz + zx) * half,
            yy: xx + zz,
            yz: -(yz + zy) * half,
            zz: xx + yy,
        };
        let adjugate = a.adjugate();
        let (minors, determinant) = (adjugate.trace(), a.determinant(adjugate));
        let step = adjugate.times(gradient) * (S::one() / determinant);
        // All eigenvalues are positive where all three invariants are; the least of them is then at
        // least determinant over minors. The gradient counts as one ulp at least.
        let bound = S::splat(ANGLE) * determinant / minors;
        let rounding = S::splat(f64::EPSILON * f64::EPSILON);
        let mut passed =
            (bound * bound).if_greater(gradient.length_squared() + rounding, in_range, S::zero());
        for invariant in [a.trace(), minors, determinant] {
            passed = invariant.if_greater(S::zero(), passed, S::zero());
        }
        Check { trace: xx + yy + zz, step, passed }
    }
}

/// The rotation after one more about `step`: the Cayley transform, a rotation whatever the length.
#[inline(always)]
fn turned<S: Lane>(columns: [Vec3<S>; 3], step: Vec3<S>) -> [Vec3<S>; 3] {
    let (zero, one) = (S::zero(), S::one());
    let t = step * S::splat(0.5);
    let factor = S::splat(2.0) / (one + t.length_squared());
    [[one, zero, zero], [zero, one, zero], [zero, zero, one]].map(|[x, y, z]| {
        let axis = Vec3::new(x, y, z);
        let across = t.cross(axis);
        combine(columns, axis + (across + t.cross(across)) * factor)
    })
}

impl Alignment<f64> {
    /// The alignment for every finite input, from the singular value decomposition of `H`.
    ///
    /// Where several rotations are equally close, one is chosen: of those about the common line of
    /// collinear points any, and the identity where all points or all rest points coincide.
    pub fn careful(rest: &[Vec3<f64>], v: &[Vec3<f64>]) -> Self {
        let (rest_size, size) = (greatest(rest), greatest(v));
        let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vec3::from);
        let mut found = Alignment { columns: identity, scale: 0.0, accurate: 1.0 };
        if rest_size == 0.0 || size == 0.0 {
            return found;
        }
        let over = |v: &Vec3<f64>, size: f64| Vec3::new(v.x / size, v.y / size, v.z / size);
        let mut rows = [Vec3::zero(); 3];
        let mut square = 0.0;
        for (r, v) in rest.iter().zip(v) {
            let (r, v) = (over(r, rest_size), over(v, size));
            rows[0] += r * v.x;
            rows[1] += r * v.y;
            rows[2] += r * v.z;
            square += r.length_squared();
        }
        let product = rows;
        // Rows of H in coordinates along its right singular vectors: the columns are now its left
        // ones, times the singular values.
        let right = PrincipalAxes::rotate(&mut rows).axes;
        let first = Vec3::new(rows[0].x, rows[1].x, rows[2].x);
        let second = Vec3::new(rows[0].y, rows[1].y, rows[2].y);
        let longest = first.length();
        if longest > 0.0 {
            let u = first * (1.0 / longest);
            let mut v = second - u * u.dot(second);
            if v.length() <= NEGLIGIBLE * longest {
                let turned = |axis: Vec3<f64>| axis - u * u.dot(axis);
                v = turned(right[1]);
                if v.length() < 0.5 {
                    v = turned(right[2]);
                }
            }
            let v = v * (1.0 / v.length());
            let v = v - u * u.dot(v);
            let v = v * (1.0 / v.length());
            let w = u.cross(v);
            let (a, b) = (right[0], right[1]);
            let n = a.cross(b);
            let column = |a: f64, b: f64, n: f64| u * a + v * b + w * n;
            found.columns = [column(a.x, b.x, n.x), column(a.y, b.y, n.y), column(a.z, b.z, n.z)];
        }
        let [x, y, z] = found.columns;
        let trace = product[0].dot(Vec3::new(x.x, y.x, z.x))
            + product[1].dot(Vec3::new(x.y, y.y, z.y))
            + product[2].dot(Vec3::new(x.z, y.z, z.z));
        // A scale beyond the range of f64 counts as its greatest.
        found.scale = (trace.max(0.0) / square * (size / rest_size)).min(f64::MAX);
        found
    }
}

/// The greatest coordinate.
fn greatest(points: &[Vec3<f64>]) -> f64 {
    points.iter().fold(0.0f64, |m, v| m.max(v.x.abs()).max(v.y.abs()).max(v.z.abs()))
}
