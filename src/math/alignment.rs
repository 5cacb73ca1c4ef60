//! The rotation and uniform scale that align rest points best with points (paper section 3.2;
//! Kabsch 1976, Umeyama 1991, without reflections).
//!
//! With `H = sum v v'^T` over the points and their rest points, the rotation maximises `tr(R^T H)`,
//! and the scale is `tr(R^T H) / sum |v'|^2`.
//!
//! The maximum of `tr(R^T H)`, here `l`, is the greatest eigenvalue of Horn's 4-by-4 quaternion
//! matrix (1987). Its characteristic polynomial depends on only three invariants of `H`: with `s =
//! |H|^2`, `t = |cof H|^2` and `d = det H` it is
//!
//! ```text
//! f(l) = (l^2 - s)^2 - 8 d l - 4 t
//! ```
//!
//! All its roots are real, so that an iteration from above converges monotonically to the greatest
//! one. By Cauchy and Schwarz `l <= |V| |V'|`, nearly with equality if the points almost have their
//! rest shape (Theobald 2005). The rotation is the derivative of `l` with respect to `H`, since the
//! best `R` is stationary; by implicit differentiation
//!
//! ```text
//! R = ((l^2 - s) H + 2 l cof H + T) / (l^3 - s l - 2 d),    T = dt/dH
//! ```
//!
//! With the singular values `a >= b >= |c|` of `H`, `c` with the sign of `d`, the denominator is
//! `2 (a + b) (a + c) (b + c)`: it vanishes exactly if several rotations are best. An error of `l`
//! multiplies the true rotation by a symmetric matrix, so it always shows as columns that are not
//! orthonormal. This is checked, and corrected by a step towards the polar factor.

use crate::math::{Lane, PrincipalAxes, Vec3, largest_coordinate};

/// Upper bound of `|R^T R - I|` for the columns of an accurate rotation.
const ORTHONORMAL: f64 = 1e-12;

/// The least denominator, as a fraction of `l^3`; below it, rounding errors are magnified too much.
const DISTINCT: f64 = 1e-4;

/// Steps towards the greatest root for points that nearly have their rest shape, and further steps
/// for others. Each step cubes the error.
const STEPS: usize = 2;
const FURTHER_STEPS: usize = 6;

/// A singular value below this fraction of the greatest is rounding error.
const NEGLIGIBLE: f64 = 8.0 * f64::EPSILON;

/// The best rotation and scale from rest points to points.
#[derive(Clone, Copy, Debug)]
pub struct Alignment<S> {
    /// The columns of the rotation `R`, orthonormal and right-handed.
    pub columns: [Vec3<S>; 3],
    /// The factor that brings the rotated rest points closest to the points. Not negative.
    pub scale: S,
    /// One in the lanes where the rotation is off by at most 1e-12 radians, else zero. In lanes
    /// with zero the fields above must not be used: see [`Alignment::robust`].
    pub accurate: S,
}

impl<S: Lane> Alignment<S> {
    /// Aligns mean-centred rest points with as many mean-centred points.
    #[inline(always)]
    pub fn of(rest: &[Vec3<S>], v: &[Vec3<S>]) -> Self {
        let mut h = [Vec3::zero(); 3];
        let (mut square, mut rest_square) = (S::zero(), S::zero());
        for (r, v) in rest.iter().zip(v) {
            h[0] += *v * r.x;
            h[1] += *v * r.y;
            h[2] += *v * r.z;
            square += v.length_squared();
            rest_square += r.length_squared();
        }
        Self::of_product(h, square, rest_square)
    }

    /// Rotates the rest point `r`.
    #[inline(always)]
    pub fn turn(&self, r: Vec3<S>) -> Vec3<S> {
        self.columns[0] * r.x + self.columns[1] * r.y + self.columns[2] * r.z
    }

    /// From the columns of `H`, `sum |v|^2` and `sum |v'|^2`.
    // Not inlined, like the eigenvector, so that the lanes stay packed.
    #[inline(never)]
    fn of_product(h: [Vec3<S>; 3], square: S, rest_square: S) -> Self {
        let invariants = Invariants::of(h);
        let bound = square * rest_square;
        let in_range = within_range(bound);
        let mut l = bound.sqrt();
        for _ in 0..STEPS {
            l = invariants.nearer(l);
        }
        let (columns, distinct) = invariants.rotation(h, l);
        let accurate = Deviation::of(columns).small(distinct.min(in_range));
        let mut found = Alignment { columns, scale: l / rest_square, accurate };
        if !accurate.all_greater(S::zero()) {
            found.refine(h, &invariants, l, rest_square, in_range);
        }
        found
    }

    /// Takes further steps in the lanes that are not accurate. The other lanes stay unchanged,
    /// whatever their neighbours need.
    #[cold]
    #[inline(never)]
    fn refine(
        &mut self,
        h: [Vec3<S>; 3],
        invariants: &Invariants<S>,
        mut l: S,
        rest_square: S,
        in_range: S,
    ) {
        let (zero, one) = (S::zero(), S::one());
        for _ in 0..FURTHER_STEPS {
            l = invariants.nearer(l);
        }
        let (columns, distinct) = invariants.rotation(h, l);
        let columns = Deviation::of(columns).mended(columns);
        let passed = self.accurate;
        for (column, mended) in self.columns.iter_mut().zip(columns) {
            *column = Vec3::if_greater(passed, zero, *column, mended);
        }
        self.scale = passed.if_greater(zero, self.scale, l / rest_square);
        let mended = Deviation::of(columns).small(distinct.min(in_range));
        self.accurate = passed.if_greater(zero, one, mended);
    }
}

/// One if a product of two squared lengths, its square and its cube are well within the range of
/// `f64`, else zero.
#[inline(always)]
fn within_range<S: Lane>(product: S) -> S {
    let not_tiny = product.if_greater(S::splat(1e-80), S::one(), S::zero());
    S::splat(1e80).if_greater(product, not_tiny, S::zero())
}

/// The invariants of `H` that determine the maximum of `tr(R^T H)`.
#[derive(Clone, Copy)]
struct Invariants<S> {
    /// The columns of the cofactor matrix.
    cofactors: [Vec3<S>; 3],
    /// `s = |H|^2`.
    s: S,
    /// `4 t = 4 |cof H|^2`.
    t4: S,
    /// `2 d = 2 det H`.
    d2: S,
}

impl<S: Lane> Invariants<S> {
    #[inline(always)]
    fn of(h: [Vec3<S>; 3]) -> Self {
        let cofactors = [h[1].cross(h[2]), h[2].cross(h[0]), h[0].cross(h[1])];
        let square =
            |m: [Vec3<S>; 3]| m[0].length_squared() + m[1].length_squared() + m[2].length_squared();
        let d = h[0].dot(cofactors[0]);
        let t = square(cofactors);
        Invariants { cofactors, s: square(h), t4: t * S::splat(4.0), d2: d + d }
    }

    /// Takes one Halley step towards the greatest root from above.
    #[inline(always)]
    fn nearer(&self, l: S) -> S {
        let square = l * l;
        let beyond = square - self.s;
        // The value, and a quarter of the first and of the second derivative.
        let value = beyond * beyond - l * self.d2 * S::splat(4.0) - self.t4;
        let slope = l * beyond - self.d2;
        let bend = square + square + beyond;
        l - value * (slope + slope) / (S::splat(8.0) * slope * slope - value * bend)
    }

    /// Returns the columns of the rotation for the greatest root `l`, and one if the denominator
    /// shows that the rotation is unique, else zero.
    #[inline(always)]
    fn rotation(&self, h: [Vec3<S>; 3], l: S) -> ([Vec3<S>; 3], S) {
        let [c0, c1, c2] = self.cofactors;
        let square = l * l;
        let beyond = square - self.s;
        let denominator = l * beyond - self.d2;
        let bound = S::splat(DISTINCT) * square * l;
        let distinct = denominator.if_greater(bound, S::one(), S::zero());
        let inverse = S::one() / denominator;
        let (of_h, of_t) = (beyond * inverse, inverse + inverse);
        let of_cofactors = l * of_t;
        // Half of dt/dH, column by column.
        let t = [
            h[1].cross(c2) - h[2].cross(c1),
            h[2].cross(c0) - h[0].cross(c2),
            h[0].cross(c1) - h[1].cross(c0),
        ];
        let columns = [
            h[0] * of_h + c0 * of_cofactors + t[0] * of_t,
            h[1] * of_h + c1 * of_cofactors + t[1] * of_t,
            h[2] * of_h + c2 * of_cofactors + t[2] * of_t,
        ];
        (columns, distinct)
    }
}

/// The deviation of three columns `M` from orthonormality: the entries of `M^T M - I`.
struct Deviation<S> {
    squares: [S; 3],
    products: [S; 3],
}

impl<S: Lane> Deviation<S> {
    #[inline(always)]
    fn of(m: [Vec3<S>; 3]) -> Self {
        let square = |column: Vec3<S>| column.length_squared() - S::one();
        Deviation {
            squares: [square(m[0]), square(m[1]), square(m[2])],
            products: [m[1].dot(m[2]), m[2].dot(m[0]), m[0].dot(m[1])],
        }
    }

    /// Returns `flag` where the deviation is at most [`ORTHONORMAL`], else zero.
    #[inline(always)]
    fn small(&self, flag: S) -> S {
        let sum = |x: [S; 3]| x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
        let (off_diagonal, diagonal) = (sum(self.products), sum(self.squares));
        let bound = S::splat(ORTHONORMAL * ORTHONORMAL);
        bound.if_greater(off_diagonal + off_diagonal + diagonal, flag, S::zero())
    }

    /// Returns the columns after one step towards the polar factor, `M - M (M^T M - I) / 2`. The
    /// remaining deviation is of second order.
    #[inline(always)]
    fn mended(&self, m: [Vec3<S>; 3]) -> [Vec3<S>; 3] {
        let half = S::splat(0.5);
        let scale = |square: S| S::one() - square * half;
        let [x, y, z] = [scale(self.squares[0]), scale(self.squares[1]), scale(self.squares[2])];
        let [yz, zx, xy] =
            [self.products[0] * half, self.products[1] * half, self.products[2] * half];
        [
            m[0] * x - m[1] * xy - m[2] * zx,
            m[1] * y - m[0] * xy - m[2] * yz,
            m[2] * z - m[0] * zx - m[1] * yz,
        ]
    }
}

impl Alignment<f64> {
    /// The alignment for every finite input, from the singular value decomposition of `H`.
    ///
    /// If several rotations are equally close, one is chosen: any one about the common line of
    /// collinear points, the identity if all points or all rest points coincide.
    pub fn robust(rest: &[Vec3<f64>], v: &[Vec3<f64>]) -> Self {
        let (rest_size, size) = (largest_coordinate(rest), largest_coordinate(v));
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
        // Rows of H in coordinates along its right singular vectors: its columns are now the left
        // singular vectors times the singular values.
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
        // A scale beyond the range of f64 becomes the greatest f64.
        found.scale = (trace.max(0.0) / square * (size / rest_size)).min(f64::MAX);
        found
    }
}
