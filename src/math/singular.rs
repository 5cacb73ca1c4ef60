//! Singular values of a 3-by-3 matrix, the last one with the sign of the determinant, so that both
//! frames are rotations.
//!
//! One-sided Jacobi (Hestenes 1958), as in [`PrincipalAxes`], with a fixed number of sweeps: small
//! singular values keep their digits, and equal ones are harmless.

use crate::math::{Lane, PrincipalAxes, Vec3};

/// Sweeps in lanes; convergence is quadratic, and six are enough in 99 % of cases.
const SWEEPS: usize = 6;

/// The greatest cosine between axes that counts as a right angle.
const COSINE: f64 = 1e-14;

/// `M = sum_k values[k] axes[k] weights[k]^T`, where the rows of `M` are three points.
#[derive(Clone, Copy, Debug)]
pub struct SingularValues<S> {
    /// Descending; the last one has the sign of the determinant.
    pub values: [S; 3],
    /// Orthonormal and right-handed, in the space of the points.
    axes: [Vec3<S>; 3],
    /// Orthonormal and right-handed; one component for each point.
    weights: [Vec3<S>; 3],
}

impl<S: Lane> SingularValues<S> {
    /// Decomposes the matrix with these rows. The second value is one in the lanes where the result
    /// is accurate, else zero: there the second or third singular value is almost zero.
    #[inline(always)]
    pub fn of(rows: [Vec3<S>; 3]) -> (Self, S) {
        let (zero, one) = (S::zero(), S::one());
        let [p, q, r] = rows;
        let mut columns =
            [Vec3::new(p.x, q.x, r.x), Vec3::new(p.y, q.y, r.y), Vec3::new(p.z, q.z, r.z)];
        let mut axes = [[one, zero, zero], [zero, one, zero], [zero, zero, one]]
            .map(|[x, y, z]| Vec3::new(x, y, z));
        for _ in 0..SWEEPS {
            for (i, j) in [(0, 1), (0, 2), (1, 2)] {
                orthogonalise(&mut columns, &mut axes, i, j);
            }
        }
        for (i, j) in [(0, 1), (1, 2), (0, 1)] {
            order(&mut columns, &mut axes, i, j);
        }
        let first = columns[0] * (one / columns[0].length());
        let second = columns[1] - first * first.dot(columns[1]);
        let second = second * (one / second.length());
        let weights = [first, second, first.cross(second)];
        let found = Self::new(columns, axes, weights);
        let overlaps = [
            (first.dot(columns[1]), columns[1]),
            (first.dot(columns[2]), columns[2]),
            (second.dot(columns[2]), columns[2]),
        ];
        let accurate = overlaps.into_iter().fold(one, |accurate, (overlap, column)| {
            let bound = S::splat(COSINE * COSINE) * column.length_squared();
            bound.if_greater(overlap * overlap, accurate, zero)
        });
        (found, accurate)
    }

    /// From orthogonal columns in descending order, along axes of either handedness.
    #[inline(always)]
    fn new(columns: [Vec3<S>; 3], axes: [Vec3<S>; 3], weights: [Vec3<S>; 3]) -> Self {
        let normal = axes[0].cross(axes[1]);
        let handedness = normal.dot(axes[2]).if_greater(S::zero(), S::one(), -S::one());
        let values = [
            weights[0].dot(columns[0]),
            weights[1].dot(columns[1]),
            weights[2].dot(columns[2]) * handedness,
        ];
        SingularValues { values, axes: [axes[0], axes[1], normal], weights }
    }

    /// Returns the rows of the matrix with its singular values replaced by `values`.
    #[inline(always)]
    pub fn with(&self, values: [S; 3]) -> [Vec3<S>; 3] {
        let [first, second, third] = self.weights;
        let [a, b, c] =
            [self.axes[0] * values[0], self.axes[1] * values[1], self.axes[2] * values[2]];
        let row = |x: S, y: S, z: S| a * x + b * y + c * z;
        [
            row(first.x, second.x, third.x),
            row(first.y, second.y, third.y),
            row(first.z, second.z, third.z),
        ]
    }
}

impl SingularValues<f64> {
    /// The same for every finite matrix, divided by its greatest entry, which is returned second.
    /// If a singular value is zero or several are equal, the axes are one choice of many; those of
    /// the zero matrix are the coordinate axes.
    pub fn robust(mut rows: [Vec3<f64>; 3]) -> (Self, f64) {
        let PrincipalAxes { axes, scale } = PrincipalAxes::rotate(&mut rows);
        let [p, q, r] = rows;
        let columns =
            [Vec3::new(p.x, q.x, r.x), Vec3::new(p.y, q.y, r.y), Vec3::new(p.z, q.z, r.z)];
        let (_, first) = columns[0].length_and_direction();
        let first = first.unwrap_or(Vec3::new(1.0, 0.0, 0.0));
        let aside = columns[1] - first * first.dot(columns[1]);
        let second = match aside.length_and_direction() {
            (length, Some(second)) if length > 4.0 * f64::EPSILON * columns[0].length() => second,
            _ if scale == 0.0 => Vec3::new(0.0, 1.0, 0.0),
            _ => first.across(),
        };
        let second = second - first * first.dot(second);
        let second = second * (1.0 / second.length());
        let mut found = Self::new(columns, axes, [first, second, first.cross(second)]);
        // If the second axis is a choice, the last two values are rounding error.
        let [a, b, c] = &mut found.values;
        // Turns -0 into +0.
        *a += 0.0;
        *b = b.max(0.0) + 0.0;
        *c = c.clamp(-*b, *b);
        (found, scale)
    }
}

/// Rotates columns `i` and `j`, and their axes, until they are orthogonal.
#[inline(always)]
fn orthogonalise<S: Lane>(columns: &mut [Vec3<S>; 3], axes: &mut [Vec3<S>; 3], i: usize, j: usize) {
    let (p, q) = (columns[i], columns[j]);
    let (two, product) = (S::splat(2.0), p.dot(q));
    let difference = p.length_squared() - q.length_squared();
    let root = (difference * difference + S::splat(4.0) * product * product).sqrt();
    let sum = S::zero().if_greater(difference, difference - root, difference + root);
    let tangent = root.if_greater(S::zero(), two * product / sum, S::zero());
    let cosine = S::one() / (S::one() + tangent * tangent).sqrt();
    let sine = cosine * tangent;
    for pair in [columns, axes] {
        let (a, b) = (pair[i], pair[j]);
        pair[i] = a * cosine + b * sine;
        pair[j] = b * cosine - a * sine;
    }
}

/// Swaps columns `i` and `j`, and their axes, if `j` is the longer.
#[inline(always)]
fn order<S: Lane>(columns: &mut [Vec3<S>; 3], axes: &mut [Vec3<S>; 3], i: usize, j: usize) {
    let (own, other) = (columns[i].length_squared(), columns[j].length_squared());
    for pair in [columns, axes] {
        let (a, b) = (pair[i], pair[j]);
        pair[i] = Vec3::if_greater(other, own, b, a);
        pair[j] = Vec3::if_greater(other, own, a, b);
    }
}

#[cfg(test)]
mod tests {
    use super::SingularValues;
    use crate::math::Vec3;
    use nalgebra::DMatrix;

    /// Rows of a matrix whose singular values fall by about `spread` from each to the next.
    fn rows(k: i32, spread: f64) -> [Vec3<f64>; 3] {
        let entry = |i: i32, j: i32| f64::from((k * 31 + i * 17 + j * 29 + i * j * k) % 23 - 11);
        [0, 1, 2].map(|i| {
            let depth = spread.powi(i);
            Vec3::new(entry(i, 0), entry(i, 1), entry(i, 2)) * depth
        })
    }

    #[test]
    fn agrees_with_nalgebra_and_gives_the_matrix_back() {
        let mut slow = 0;
        for spread in [1.0, 0.1, 1e-4, 1e-8] {
            for k in 0..300 {
                let rows = rows(k, spread);
                // Not nalgebra's fixed 3-by-3 matrix, whose small singular values lose half of
                // their digits.
                let matrix = DMatrix::from_fn(3, 3, |i, j| [rows[i].x, rows[i].y, rows[i].z][j]);
                let determinant = matrix.determinant();
                let expected = matrix.svd(false, false).singular_values;
                let size = expected[0];
                let (found, accurate) = SingularValues::of(rows);
                let (careful, scale) = SingularValues::robust(rows);
                slow += usize::from(accurate == 0.0);
                let fast = (found, 1.0, accurate);
                for (found, scale, accurate) in [fast, (careful, scale, 1.0)] {
                    if accurate == 0.0 {
                        continue;
                    }
                    for i in 0..3 {
                        let error = (found.values[i] * scale).abs() - expected[i];
                        assert!(error.abs() <= 1e-14 * size, "{k}, {spread}: {error:e}");
                    }
                    let same_sign = found.values[2] * determinant >= 0.0;
                    assert!(same_sign || expected[2] <= 1e-14 * size, "{k}, {spread}");
                    for (row, back) in rows.iter().zip(found.with(found.values)) {
                        assert!((*row - back * scale).length() <= 1e-13 * size, "{k}, {spread}");
                    }
                }
            }
        }
        assert!(slow <= 40, "{slow} of 1200 need the careful way");
    }

    #[test]
    fn the_careful_way_takes_every_matrix() {
        let e = Vec3::new(0.3, -1.2, 0.4);
        let zero = Vec3::zero();
        for rows in [[zero; 3], [e; 3], [e, zero, -e], [e * 1e-310, zero, zero], [e * 1e290; 3]] {
            let (found, scale) = SingularValues::robust(rows);
            for (row, back) in rows.iter().zip(found.with(found.values)) {
                let error = *row - back * scale;
                assert!(error.length() <= 1e-14 * row.length().max(f64::MIN_POSITIVE), "{rows:?}");
            }
            let volume = |[a, b, c]: [Vec3<f64>; 3]| a.dot(b.cross(c));
            assert!((volume(found.with([1.0; 3])) - 1.0).abs() <= 1e-14, "{rows:?}");
        }
    }
}
