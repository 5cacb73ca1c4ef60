//! Difficult cases of circle and sphere: shallow arcs and caps, their limits, and their drawing.

use crate::support::random::{Points, Random, centred, distance_squared, farthest, in_frame, size};
use nalgebra::{DMatrix, DVector, Matrix3, SymmetricEigen, Vector3};
use serde_json::json;
use shape_up::constraint::{Fitted, Kind, KindVisitor, Projection};
use shape_up::math::Vec3;

struct Draw<'a>(&'a Points);

impl KindVisitor for Draw<'_> {
    type Output = Option<Fitted>;
    fn visit<P: Projection>(self, operator: &P) -> Option<Fitted> {
        operator.fitted(self.0)
    }
}

fn kind(id: &str) -> Kind {
    Kind::new(id, json!({})).expect("defaults are valid")
}

fn project(id: &str, points: &Points) -> Points {
    crate::support::project::project(&kind(id), points, points)
}

fn placed(frame: [Vec3<f64>; 3], points: &[Vec3<f64>]) -> Points {
    points.iter().map(|v| in_frame(frame, *v)).collect()
}

/// Paper section 3.1 literally, with nalgebra: the plane of the two greatest eigenvectors, and the
/// centre of Thomas and Chan from a 2x2 system in it.
fn plane_then_fit(v: &Points) -> Points {
    let points: Vec<Vector3<f64>> = v.iter().map(|p| Vector3::new(p.x, p.y, p.z)).collect();
    let scatter: Matrix3<f64> = points.iter().map(|p| p * p.transpose()).sum();
    let eigen = SymmetricEigen::new(scatter);
    let normal = eigen.eigenvalues.imin();
    let [e, f] =
        [(normal + 1) % 3, (normal + 2) % 3].map(|k| eigen.eigenvectors.column(k).into_owned());
    let rows: Vec<[f64; 2]> = points.iter().map(|p| [p.dot(&e), p.dot(&f)]).collect();
    let (centre, radius) = round_by_least_squares(&rows);
    points
        .iter()
        .zip(&rows)
        .map(|(_, [x, y])| {
            let (dx, dy) = (x - centre[0], y - centre[1]);
            let scale = radius / (dx * dx + dy * dy).sqrt();
            let p = e * (centre[0] + dx * scale) + f * (centre[1] + dy * scale);
            Vec3::new(p.x, p.y, p.z)
        })
        .collect()
}

/// By Householder QR: nalgebra's SVD keeps only ten digits here.
fn least_squares(matrix: DMatrix<f64>, right: &DVector<f64>) -> DVector<f64> {
    let qr = matrix.qr();
    qr.r().solve_upper_triangular(&qr.q().tr_mul(right)).expect("the columns are independent")
}

/// `min sum (|x|^2 - 2 c.x - k)^2` as a linear least-squares problem: centre and radius.
fn round_by_least_squares<const D: usize>(rows: &[[f64; D]]) -> ([f64; D], f64) {
    let matrix =
        DMatrix::from_fn(rows.len(), D + 1, |i, j| if j < D { 2.0 * rows[i][j] } else { 1.0 });
    let right = DVector::from_fn(rows.len(), |i, _| rows[i].iter().map(|x| x * x).sum());
    let solution = least_squares(matrix, &right);
    let centre: [f64; D] = std::array::from_fn(|k| solution[k]);
    let square: f64 = centre.iter().map(|c| c * c).sum();
    (centre, (solution[D] + square).sqrt())
}

#[test]
fn circle_agrees_with_plane_then_fit() {
    for seed in 0..2000 {
        let mut random = Random::new(seed);
        let n = 4 + seed as usize % 5;
        let corners = [
            (1.0, 0.0),
            (0.6, 0.8),
            (-0.28, 0.96),
            (-1.0, 0.0),
            (-0.6, -0.8),
            (0.0, -1.0),
            (0.8, -0.6),
            (0.96, -0.28),
        ];
        let frame = random.frame();
        let ring: Points = (0..n)
            .map(|i| corners[i * 8 / n])
            .map(|(x, y)| in_frame(frame, Vec3::new(x, y, 0.0)) + random.vector() * 0.1)
            .collect();
        let points = centred(&ring);
        let error = farthest(&project("circle", &points), &plane_then_fit(&points));
        assert!(error <= 1e-12, "n = {n}, seed {seed}: off by {error:e}");
    }
}

#[test]
fn sphere_agrees_with_linear_least_squares() {
    for seed in 0..2000 {
        let mut random = Random::new(seed);
        let n = 6 + seed as usize % 10;
        let cloud: Points = (0..n).map(|_| random.direction() + random.vector() * 0.1).collect();
        let points = centred(&cloud);
        let rows: Vec<[f64; 3]> = points.iter().map(|v| (*v).into()).collect();
        let (centre, radius) = round_by_least_squares(&rows);
        let centre = Vec3::from(centre);
        let expected: Points = points
            .iter()
            .map(|v| centre + (*v - centre) * (radius / (*v - centre).length()))
            .collect();
        let error = farthest(&project("sphere", &points), &expected);
        assert!(error <= 1e-12, "n = {n}, seed {seed}: off by {error:e}");
    }
}

/// Height above the tangent at the middle of an arc; `sagitta` is for a half chord of one.
fn height(sagitta: f64, square: f64) -> f64 {
    let radius = (1.0 + sagitta * sagitta) / (2.0 * sagitta);
    square / (radius + (radius * radius - square).sqrt())
}

#[test]
fn shallow_arcs_and_caps_stay() {
    for exponent in 1..=12 {
        let sagitta = 10f64.powi(-exponent);
        for seed in 0..50 {
            let mut random = Random::new(seed);
            let frame = random.frame();
            let arc: Points = (0..7)
                .map(|_| random.uniform())
                .map(|x| Vec3::new(x, height(sagitta, x * x), 0.0))
                .collect();
            let cap: Points = (0..9)
                .map(|_| (0.7 * random.uniform(), 0.7 * random.uniform()))
                .map(|(x, y)| Vec3::new(x, y, height(sagitta, x * x + y * y)))
                .collect();
            for (id, points) in [("circle", arc), ("sphere", cap)] {
                let points = centred(&placed(frame, &points));
                let error = farthest(&project(id, &points), &points) / size(&points);
                assert!(
                    error <= 1e-13,
                    "{id}, sagitta {sagitta:e}, seed {seed}: moved by {error:e}"
                );
            }
        }
    }
}

/// Heights are solved for in units of the sagitta, for which the least-squares problem is well
/// conditioned; the step to a circle of such a radius is its first-order distance.
#[test]
fn disturbed_shallow_arcs_and_caps_are_right() {
    for sagitta in [1e-6, 1e-8, 1e-10] {
        for seed in 0..50 {
            let mut random = Random::new(seed);
            let frame = random.frame();
            for (id, dimensions) in [("circle", 1), ("sphere", 2)] {
                let flat: Vec<[f64; 3]> = (0..9)
                    .map(|_| {
                        let (x, y) = (random.uniform(), random.uniform() * (dimensions - 1) as f64);
                        [x, y, x * x + y * y + 0.1 * random.uniform()]
                    })
                    .collect();
                let flat: Vec<[f64; 3]> =
                    centred(&flat.iter().map(|v| Vec3::from(*v)).collect::<Points>())
                        .into_iter()
                        .map(Into::into)
                        .collect();
                let columns = |[x, y, height]: [f64; 3]| [height, 1.0, x, y];
                let square =
                    |[x, y, height]: [f64; 3]| x * x + y * y + sagitta * sagitta * height * height;
                let matrix = DMatrix::from_fn(9, dimensions + 2, |i, j| columns(flat[i])[j]);
                let right = DVector::from_fn(9, |i, _| square(flat[i]));
                let fit = least_squares(matrix, &right);
                let mut given = Points::new();
                let mut expected = Points::new();
                for v in &flat {
                    let w = Vec3::new(v[0], v[1], sagitta * v[2]);
                    let value = sagitta
                        * (square(*v)
                            - (0..dimensions + 2).map(|j| fit[j] * columns(*v)[j]).sum::<f64>());
                    let slope = |j: usize| if j < dimensions + 2 { fit[j] } else { 0.0 };
                    let gradient = Vec3::new(
                        sagitta * (2.0 * v[0] - slope(2)),
                        sagitta * (2.0 * v[1] - slope(3)),
                        -slope(0),
                    );
                    let step = gradient * (value / gradient.length_squared());
                    given.push(w);
                    expected.push(w - step);
                }
                let moved = farthest(&given, &expected);
                assert!(moved > 1e-3 * sagitta, "the test is idle");
                let found = project(id, &placed(frame, &given));
                let error = farthest(&found, &placed(frame, &expected));
                assert!(error <= 4e-15, "{id}, sagitta {sagitta:e}, seed {seed}: off by {error:e}");
            }
        }
    }
}

#[test]
fn limit_shapes_do_not_move() {
    let frame = Random::new(3).frame();
    let line = centred(&placed(frame, &[0.0, 1.0, 2.5, 7.0].map(|x| Vec3::new(x, 0.0, 0.0))));
    let flat = [(0.0, 0.0), (1.0, 0.0), (2.0, 3.0), (-1.0, 1.0), (0.3, 0.4)];
    let flat = centred(&placed(frame, &flat.map(|(x, y)| Vec3::new(x, y, 0.0))));
    let equal = vec![Vec3::zero(); 5];
    let cases = [
        ("circle", &line),
        ("sphere", &line),
        ("sphere", &flat),
        ("circle", &equal),
        ("sphere", &equal),
    ];
    for (id, points) in cases {
        let error = farthest(&project(id, points), points);
        assert!(error <= 1e-14, "{id}: {points:?} moved by {error:e}");
    }
}

#[test]
fn a_vertex_at_the_centre_goes_to_the_circle() {
    let cross = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0), (0.0, 0.0)];
    let cross: Points = cross.map(|(x, y)| Vec3::new(x, y, 0.0)).to_vec();
    let found = project("circle", &cross);
    let radius = 0.8f64.sqrt();
    for v in &found {
        assert!((v.length() - radius).abs() <= 1e-14, "{v:?} is not on the circle");
    }
    let least = 4.0 * (1.0 - radius) * (1.0 - radius) + radius * radius;
    assert!((distance_squared(&cross, &found) - least).abs() <= 1e-14);
}

#[test]
fn what_is_drawn_is_where_the_points_are() {
    let mut random = Random::new(5);
    let frame = random.frame();
    let place = Vec3::new(100.0, -20.0, 7.0);
    let ring: Points = [(3.0, 4.0), (-5.0, 0.0), (4.0, -3.0), (0.0, 5.0), (-3.0, -4.0)]
        .map(|(x, y)| place + in_frame(frame, Vec3::new(x, y, 0.0)))
        .to_vec();
    let Some(Fitted::Circle { centre, normal, radius }) = kind("circle").visit(Draw(&ring)) else {
        panic!("no circle");
    };
    assert!((centre - place).length() <= 1e-12 && (radius - 5.0).abs() <= 1e-12);
    assert!((normal.dot(frame[2]).abs() - 1.0).abs() <= 1e-12);

    let ball: Points = (0..9).map(|_| place + random.direction() * 2.5).collect();
    let Some(Fitted::Sphere { centre, radius }) = kind("sphere").visit(Draw(&ball)) else {
        panic!("no sphere");
    };
    assert!((centre - place).length() <= 1e-11 && (radius - 2.5).abs() <= 1e-11);
}

#[test]
fn nothing_is_drawn_where_the_radius_runs_away() {
    let arc = |sagitta: f64| -> Points {
        [-1.0, -0.4, 0.1, 0.7, 1.0].map(|x| Vec3::new(x, height(sagitta, x * x), 0.0)).to_vec()
    };
    for (sagitta, drawn) in [(1e-2, true), (1e-5, true), (1e-8, false)] {
        assert_eq!(kind("circle").visit(Draw(&arc(sagitta))).is_some(), drawn, "{sagitta:e}");
    }
    let Some(Fitted::Circle { radius, .. }) = kind("circle").visit(Draw(&arc(1e-5))) else {
        panic!("no circle");
    };
    assert!((radius / 5e4 - 1.0).abs() < 1e-9, "radius {radius}");
    let line: Points = [0.0, 1.0, 2.0, 3.0].map(|x| Vec3::new(x, x, 0.0)).to_vec();
    let equal = vec![Vec3::new(1.0, 2.0, 3.0); 4];
    for points in [&line, &equal] {
        assert_eq!(kind("circle").visit(Draw(points)), None);
        assert_eq!(kind("sphere").visit(Draw(points)), None);
    }
}
