//! The rectangle of the paper (Eq. 10) against its method, implemented with nalgebra: least-squares
//! plane, QR decomposition, eigenvector of a 2x2 matrix, intersections of lines.

use crate::support::random::{Points, Random, centred, farthest, in_frame, size};
use nalgebra::{Matrix2, Matrix3, SMatrix, SymmetricEigen, Vector2, Vector3};
use serde_json::json;
use shape_up::constraint::Kind;
use shape_up::math::Vec3;

fn project(fit: &str, points: &Points) -> Points {
    let kind = Kind::new("rectangle", json!({ "fit": fit })).expect("the fit is known");
    crate::support::project::project(&kind, points, points)
}

/// The two greatest principal axes of centred points.
fn plane(points: &[Vector3<f64>]) -> [Vector3<f64>; 2] {
    let scatter: Matrix3<f64> = points.iter().map(|p| p * p.transpose()).sum();
    let eigen = SymmetricEigen::new(scatter);
    let normal = eigen.eigenvalues.imin();
    [(normal + 1) % 3, (normal + 2) % 3].map(|k| eigen.eigenvectors.column(k).into_owned())
}

/// Eq. 10 for corners in the plane, Gander and von Matt: the corners are the intersections of the
/// lines that minimise `|A x|` with `x = (c1, c2, n)` and `|n| = 1`.
fn intersected_lines(v: &[Vector2<f64>]) -> [Vector2<f64>; 4] {
    #[rustfmt::skip]
    let a = SMatrix::<f64, 8, 4>::from_row_slice(&[
         1.0,  0.0, v[0].x,  v[0].y,
         1.0,  0.0, v[1].x,  v[1].y,
         0.0,  1.0, v[1].y, -v[1].x,
         0.0,  1.0, v[2].y, -v[2].x,
        -1.0,  0.0, v[2].x,  v[2].y,
        -1.0,  0.0, v[3].x,  v[3].y,
         0.0, -1.0, v[3].y, -v[3].x,
         0.0, -1.0, v[0].y, -v[0].x,
    ]);
    let r = a.qr().r();
    let block: Matrix2<f64> = r.fixed_view::<2, 2>(2, 2).into_owned();
    let eigen = SymmetricEigen::new(block.transpose() * block);
    let n: Vector2<f64> = eigen.eigenvectors.column(eigen.eigenvalues.imin()).into_owned();
    let offsets: Matrix2<f64> = r.fixed_view::<2, 2>(0, 0).into_owned();
    let right: Vector2<f64> = -(r.fixed_view::<2, 2>(0, 2) * n);
    let c = offsets.solve_upper_triangular(&right).expect("the columns are independent");
    // c1 + n.v = 0 and c2 + n'.v = 0, and the opposite lines with the other sign.
    let across = Vector2::new(-n.y, n.x);
    let corner = |first: f64, second: f64| n * (-first * c[0]) + across * (-second * c[1]);
    [corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0), corner(-1.0, -1.0)]
}

fn quad(seed: u64, noise: f64) -> Points {
    let mut random = Random::new(seed);
    let frame = random.frame();
    let (width, height) = (1.5 + random.uniform(), 1.5 + random.uniform());
    let corners = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)];
    let corners = corners.map(|(x, y)| in_frame(frame, Vec3::new(x, y, 0.0)));
    centred(&corners.map(|corner| corner + random.vector() * noise))
}

#[test]
fn fitting_lines_agrees_with_equation_10() {
    let mut apart = 0.0f64;
    for seed in 0..2000 {
        let points = quad(seed, [0.01, 0.1, 0.3][seed as usize % 3]);
        let vectors: Vec<_> = points.iter().map(|p| Vector3::new(p.x, p.y, p.z)).collect();
        let [e, f] = plane(&vectors);
        let seen: Vec<_> = vectors.iter().map(|p| Vector2::new(p.dot(&e), p.dot(&f))).collect();
        let expected: Points = intersected_lines(&seen)
            .map(|corner| e * corner.x + f * corner.y)
            .map(|p| Vec3::new(p.x, p.y, p.z))
            .to_vec();
        let error = farthest(&project("lines", &points), &expected) / size(&points);
        assert!(error <= 1e-12, "seed {seed}: off by {error:e}");
        apart = apart.max(farthest(&project("closest", &points), &expected));
    }
    assert!(apart > 1e-2, "the two fits are the same");
}

/// The two fits differ only in their choice of plane.
#[test]
fn of_a_planar_quad_both_fits_are_the_same() {
    for seed in 0..200 {
        let mut random = Random::new(seed);
        let frame = random.frame();
        let mut corner = || in_frame(frame, Vec3::new(random.uniform(), random.uniform(), 0.0));
        let points = centred(&[corner(), corner(), corner(), corner()]);
        let error = farthest(&project("lines", &points), &project("closest", &points));
        assert!(error <= 1e-11, "seed {seed}: apart by {error:e}");
    }
}
