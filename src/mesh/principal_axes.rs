//! Principal axes of a few points.

use crate::math::Vec3;

/// The orthonormal eigenvectors of a symmetric positive semidefinite matrix, of which the upper half
/// is given, by descending eigenvalues.
pub(super) fn principal_axes(a: [[f64; 3]; 3]) -> [Vec3<f64>; 3] {
    smallest_first(a).unwrap_or_else(|| jacobi(a))
}

/// The closed form: the smallest eigenvector, then one rotation in the plane orthogonal to it. None
/// where rounding could turn the smallest by more than 1e-13, as where the points are nearly on a line.
///
/// Newton's method on the characteristic cubic runs up to the smallest root from 0; the adjugate of
/// `A - l I` is `p'(l) n n^T`. The angle to the true eigenvector is at most the residual over the
/// gap to the next eigenvalue (Davis and Kahan 1970), which is at least `p'(l)` for a unit trace.
fn smallest_first(a: [[f64; 3]; 3]) -> Option<[Vec3<f64>; 3]> {
    const NEWTON_STEPS: usize = 5;
    const ANGLE: f64 = 1e-13;
    let trace = a[0][0] + a[1][1] + a[2][2];
    let scale = 1.0 / trace;
    let [xx, xy, xz] = a[0].map(|x| x * scale);
    let [yy, yz, zz] = [a[1][1] * scale, a[1][2] * scale, a[2][2] * scale];
    let minors = (yy * zz - yz * yz) + (xx * zz - xz * xz) + (xx * yy - xy * xy);
    let determinant =
        xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
    let mut l = 0.0;
    for _ in 0..NEWTON_STEPS {
        let value = ((l - 1.0) * l + minors) * l - determinant;
        l -= value / ((3.0 * l - 2.0) * l + minors);
    }
    let (x, y, z) = (xx - l, yy - l, zz - l);
    let diagonal = [y * z - yz * yz, x * z - xz * xz, x * y - xy * xy];
    let off = [xz * yz - xy * z, xy * yz - y * xz, xy * xz - x * yz];
    let column = if diagonal[0] >= diagonal[1] && diagonal[0] >= diagonal[2] {
        Vec3::new(diagonal[0], off[0], off[1])
    } else if diagonal[1] >= diagonal[2] {
        Vec3::new(off[0], diagonal[1], off[2])
    } else {
        Vec3::new(off[1], off[2], diagonal[2])
    };
    let n = column * (1.0 / column.length());
    let times = |v: Vec3<f64>| {
        Vec3::new(
            xx * v.x + xy * v.y + xz * v.z,
            xy * v.x + yy * v.y + yz * v.z,
            xz * v.x + yz * v.y + zz * v.z,
        )
    };
    let image = times(n);
    let residual = image - n * n.dot(image);
    let bound = ANGLE * (diagonal[0] + diagonal[1] + diagonal[2]);
    // False also where the trace is 0, so that all is NaN.
    let accurate = residual.length_squared() < bound * bound;
    if !accurate {
        return None;
    }

    // Any vector orthogonal to n, made from its two greater components.
    let across =
        if n.x.abs() > n.z.abs() { Vec3::new(-n.y, n.x, 0.0) } else { Vec3::new(0.0, -n.z, n.y) };
    let u = across * (1.0 / across.length());
    let v = n.cross(u);
    let (image_u, image_v) = (times(u), times(v));
    let (uu, uv, vv) = (u.dot(image_u), u.dot(image_v), v.dot(image_v));
    let (cos, sin, tan) = rotation(uu, uv, vv);
    let (first, second) = (u * cos - v * sin, u * sin + v * cos);
    Some(if uu - tan * uv >= vv + tan * uv { [first, second, n] } else { [second, first, n] })
}

/// Cosine, sine and tangent of the rotation that makes the symmetric matrix
/// `[[pp, pq], [pq, qq]]` diagonal, at most 45 degrees.
fn rotation(pp: f64, pq: f64, qq: f64) -> (f64, f64, f64) {
    if pq == 0.0 {
        return (1.0, 0.0, 0.0);
    }
    let theta = 0.5 * (qq - pp) / pq;
    let tan = 1.0_f64.copysign(theta) / (theta.abs() + (theta * theta + 1.0).sqrt());
    let cos = 1.0 / (tan * tan + 1.0).sqrt();
    (cos, tan * cos, tan)
}

/// Jacobi's method, cyclic by rows (Golub and Van Loan, section 8.5).
fn jacobi(mut a: [[f64; 3]; 3]) -> [Vec3<f64>; 3] {
    /// Three or four are enough: convergence is quadratic.
    const SWEEPS: usize = 12;
    let mut axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vec3::from);
    let trace = a[0][0] + a[1][1] + a[2][2];
    for _ in 0..SWEEPS {
        if a[0][1].abs() + a[0][2].abs() + a[1][2].abs() <= 1e-17 * trace {
            break;
        }
        for (p, q, r) in [(0, 1, 2), (0, 2, 1), (1, 2, 0)] {
            let (cos, sin, tan) = rotation(a[p][p], a[p][q], a[q][q]);
            a[p][p] -= tan * a[p][q];
            a[q][q] += tan * a[p][q];
            a[p][q] = 0.0;
            let (rp, rq) = ((p.min(r), p.max(r)), (q.min(r), q.max(r)));
            let (x, y) = (a[rp.0][rp.1], a[rq.0][rq.1]);
            a[rp.0][rp.1] = cos * x - sin * y;
            a[rq.0][rq.1] = sin * x + cos * y;
            (axes[p], axes[q]) = (axes[p] * cos - axes[q] * sin, axes[p] * sin + axes[q] * cos);
        }
    }
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| a[j][j].total_cmp(&a[i][i]));
    order.map(|i| axes[i])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_closed_form_agrees_with_jacobi() {
        // A lattice of matrices B^T B with small integers.
        let mut agreed = 0;
        for k in 0..3_u32.pow(6) {
            let digit = |i: u32| f64::from(k / 3_u32.pow(i) % 3) - 1.0;
            let b = [
                [digit(0) + 2.0, digit(1), digit(2)],
                [digit(3), 3.0, digit(4)],
                [0.5, digit(5), 0.1],
            ];
            let mut a = [[0.0; 3]; 3];
            for i in 0..3 {
                for j in i..3 {
                    a[i][j] = b.iter().map(|row| row[i] * row[j]).sum();
                }
            }
            let slow = jacobi(a);
            if let Some(fast) = smallest_first(a) {
                agreed += 1;
                for (fast, slow) in fast.iter().zip(slow) {
                    assert!((fast.dot(slow).abs() - 1.0).abs() < 1e-12);
                }
            }
        }
        assert!(agreed > 600, "the closed form is for most matrices: {agreed}");
    }
}
