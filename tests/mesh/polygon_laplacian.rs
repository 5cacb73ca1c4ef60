//! The polygon Laplacian (Alexa, Wardetzky 2011) against the matrices of its definition and against
//! cotangents; linear precision, and convergence on curved surfaces.

use crate::support::random::Random;
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};
use proptest::prelude::*;
use shape_up::math::{Vec3, cosine};
use shape_up::mesh::{Laplacian, Mesh, Point, Ragged, Topology};
use shape_up::scene::{Scene, SmoothnessOf, Weighting};
use shape_up::session::Session;

fn dense(laplacian: &Laplacian) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(laplacian.len(), laplacian.len());
    for (i, (neighbours, weights)) in laplacian.rows().enumerate() {
        for (&j, &w) in neighbours.iter().zip(weights) {
            matrix[(i, j as usize)] -= w;
            matrix[(i, i)] += w;
        }
    }
    matrix
}

fn polygon(mesh: &Mesh) -> Laplacian {
    Laplacian::polygon(mesh, &Topology::new(mesh))
}

/// A grid of quads, some of which are split into two triangles; some pairs are merged to hexagons,
/// whose common side has its midpoint displaced. Vertex `(i, j)` is at `point(i / n, j / n)`.
fn mixed_grid(n: u32, point: impl Fn(f64, f64) -> Point) -> Mesh {
    let step = 1.0 / f64::from(n);
    let quads =
        crate::support::meshes::grid(n, n, |i, j| point(f64::from(i) * step, f64::from(j) * step));
    let mut faces = Ragged::new();
    for (k, q) in quads.faces.iter().enumerate() {
        let (i, j) = (k as u32 % n, k as u32 / n);
        match (i % 4, j % 3) {
            (0, 0) if i + 1 < n => {
                let right = quads.faces.row(k + 1);
                faces.push(&[q[0], q[1], right[1], right[2], q[2], q[3]]);
            }
            (1, 0) => {}
            (2, 1) => {
                faces.push(&[q[0], q[1], q[2]]);
                faces.push(&[q[0], q[2], q[3]]);
            }
            _ => faces.push(q),
        }
    }
    Mesh { positions: quads.positions, faces, ..Mesh::default() }
}

/// The matrix of one face, following section 3 of the paper step by step.
fn by_definition(corners: &[Vector3<f64>]) -> DMatrix<f64> {
    let n = corners.len();
    let at = |k: usize| corners[k % n];
    let rows = |of: &dyn Fn(usize) -> Vector3<f64>| DMatrix::from_fn(n, 3, |i, k| of(i)[k]);
    let sides = rows(&|i| at(i + 1) - at(i));
    let middles = rows(&|i| (at(i) + at(i + 1)) / 2.0);
    // The vector area as a skew-symmetric matrix.
    let skew: Matrix3<f64> = (sides.transpose() * &middles).fixed_view::<3, 3>(0, 0).into();
    let area = Vector3::new(skew[(2, 1)], skew[(0, 2)], skew[(1, 0)]);
    let normal = area.normalize();
    let seen = &sides - &sides * normal * normal.transpose();
    // The kernel of its transpose: all but two directions.
    let mut singular = (seen.clone() * seen.transpose()).symmetric_eigen();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&a, &b| singular.eigenvalues[a].total_cmp(&singular.eigenvalues[b]));
    singular.eigenvectors = singular.eigenvectors.select_columns(&order[..n - 2]);
    let kernel = singular.eigenvectors;
    let product = &middles * middles.transpose() / area.norm() + 0.5 * &kernel * kernel.transpose();
    let difference =
        DMatrix::from_fn(n, n, |i, j| f64::from(i8::from(j == (i + 1) % n) - i8::from(j == i)));
    difference.transpose() * product * difference
}

#[test]
fn it_is_the_matrix_of_its_definition_on_polygons_that_are_not_planar() {
    let mut random = Random::new(11);
    for n in 3..9 {
        for _ in 0..20 {
            // On a circle, displaced by up to half of its radius.
            let corner = |k: usize| {
                let turn = k as f64 / n as f64;
                Vec3::new(cosine(turn), cosine(turn - 0.25), 0.0) + random.vector() * 0.5
            };
            let positions: Vec<Point> = (0..n).map(corner).map(Point::from).collect();
            let corners: Vec<Vector3<f64>> = positions.iter().map(|&p| p.into()).collect();
            let faces = Ragged::from_iter([(0..n as u32).collect::<Vec<_>>()]);
            let found = dense(&polygon(&Mesh { positions, faces, ..Mesh::default() }));
            let expected = by_definition(&corners);
            let off = (found - &expected).amax();
            assert!(off <= 1e-12 * expected.amax(), "{n} corners: {off:e}");
        }
    }
}

proptest! {
    #![proptest_config(crate::support::fuzz::cases(64))]

    #[test]
    fn on_triangles_it_is_the_laplacian_of_cotangents(mesh in crate::support::meshes::triangles()) {
        let topology = Topology::new(&mesh);
        if Laplacian::has_cotangents(&mesh) {
            let expected = dense(&Laplacian::cotangent(&mesh, &topology));
            let off = (dense(&polygon(&mesh)) - &expected).amax();
            prop_assert!(off <= 1e-12 * expected.amax(), "{off:e}");
        }
    }

    #[test]
    fn it_is_symmetric_and_positive_semi_definite_with_the_constants_alone_in_its_kernel(
        n in 3_u32..7,
        moves in prop::collection::vec(prop::array::uniform3(-0.1..0.1), 64),
    ) {
        let mut mesh = mixed_grid(n, |x, y| [x, y, x * y]);
        for (p, by) in mesh.positions.iter_mut().zip(&moves) {
            *p = [0, 1, 2].map(|i| p[i] + by[i] / f64::from(n));
        }
        let laplacian = polygon(&mesh);
        for (i, (neighbours, weights)) in laplacian.rows().enumerate() {
            prop_assert!(neighbours.is_sorted());
            for (&j, w) in neighbours.iter().zip(weights) {
                let (back, others) = laplacian.row(j as usize);
                let place = back.binary_search(&(i as u32)).expect("neighbours are mutual");
                prop_assert_eq!(w.to_bits(), others[place].to_bits());
            }
        }
        let mut eigenvalues = dense(&laplacian).symmetric_eigenvalues().as_slice().to_vec();
        eigenvalues.sort_by(f64::total_cmp);
        let largest = eigenvalues[eigenvalues.len() - 1];
        prop_assert!(eigenvalues[0].abs() <= 1e-13 * largest, "{:e}", eigenvalues[0]);
        prop_assert!(eigenvalues[1] > 1e-3, "{:e}", eigenvalues[1]);
    }
}

#[test]
fn linear_functions_have_none_inside_planar_meshes() {
    // The corners of hexagons and quads are displaced at random; some are reflex.
    let mut random = Random::new(5);
    let mut plane = mixed_grid(9, |x, y| [x, y, 0.0]);
    for p in &mut plane.positions {
        let [x, y] = [p[0] + 0.035 * random.uniform(), p[1] + 0.035 * random.uniform()];
        *p = [0.6 * x + 0.8 * y, 0.8 * x - 0.6 * y, 2.0 - 0.3 * x];
    }
    let laplacian = dense(&polygon(&plane));
    let topology = Topology::new(&plane);
    let boundary: Vec<u32> = topology.boundary_loops().indices().to_vec();
    let inside = (0..plane.positions.len()).filter(|&v| !boundary.contains(&(v as u32)));
    for i in inside {
        for k in 0..3 {
            let sum: f64 =
                (0..plane.positions.len()).map(|j| laplacian[(i, j)] * plane.positions[j][k]).sum();
            assert!(sum.abs() < 1e-12, "vertex {i}: {sum:e}");
        }
    }
}

#[test]
fn smoothness_with_it_is_the_sum_of_eq_12() {
    let mesh = mixed_grid(5, |x, y| [x, y, 0.4 * x * y - 0.2 * x * x]);
    let mut random = Random::new(2);
    let moved: Vec<Point> =
        mesh.positions.iter().map(|&p| (Vec3::from(p) + random.vector() * 0.1).into()).collect();
    let laplacian = dense(&polygon(&mesh));
    for of in [SmoothnessOf::Surface, SmoothnessOf::Displacement] {
        let scene = r#"{ "format": "shape-up-scene", "version": 1, "mesh": { "file": "grid.obj" },
            "weights": { "smooth": 1 }, "smoothness": { "weighting": "polygon" } }"#;
        let mut scene = Scene::from_json(scene).expect("it is valid");
        assert_eq!(scene.smoothness.weighting, Weighting::Polygon);
        scene.smoothness.of = of;
        scene.current = Some(moved.clone());
        let mut session = Session::open(scene, mesh.clone()).expect("it fits");
        let expected: f64 = (0..3)
            .map(|k| {
                let l = (0..moved.len()).map(|v| match of {
                    SmoothnessOf::Surface => moved[v][k],
                    SmoothnessOf::Displacement => moved[v][k] - mesh.positions[v][k],
                });
                (&laplacian * DVector::from_iterator(moved.len(), l)).norm_squared()
            })
            .sum();
        let found = session.solver().energy().smooth;
        assert!((found - expected).abs() <= 1e-12 * expected, "{of:?} {found} {expected}");
        // The normal matrix uses the same weights: one plain step minimises the energy.
        session.solve(false).expect("positions stay finite");
        let left = session.solver().energy().smooth;
        assert!(left <= 1e-20 * expected, "{of:?}: {left:e} of {expected:e}");
    }
}

#[test]
fn a_face_with_too_many_corners_is_refused_by_its_number() {
    let n = Laplacian::MOST_CORNERS as u32 + 1;
    let circle = |k: u32| [f64::from(k % 7), f64::from(k), 0.0];
    let mesh = Mesh {
        positions: (0..n).map(circle).collect(),
        faces: Ragged::from_iter([vec![0, 1, 2], (0..n).collect()]),
        ..Mesh::default()
    };
    let scene = |weighting: &str| {
        let text = format!(
            r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "a.obj" }},
                "weights": {{ "smooth": 1 }}, "smoothness": {{ "weighting": "{weighting}" }} }}"#
        );
        Session::open(Scene::from_json(&text).expect("it is valid"), mesh.clone())
    };
    let refused = scene("polygon").err().expect("it has too many").to_string();
    assert!(refused.contains("smoothness.weighting") && refused.contains("face 1"), "{refused}");
    let refused = scene("cotangent").err().expect("it is no triangle").to_string();
    assert!(refused.contains("expected \"polygon\", \"auto\" or \"uniform\""), "{refused}");
    scene("uniform").expect("it does not mind");
}

/// Lumped masses: each corner gets an equal part of the area of its face.
fn masses(mesh: &Mesh) -> DVector<f64> {
    let mut masses = DVector::zeros(mesh.positions.len());
    for face in mesh.faces.iter() {
        let at = |k: usize| Vector3::from(mesh.positions[face[k % face.len()] as usize]);
        let area: Vector3<f64> = (0..face.len()).map(|k| at(k).cross(&at(k + 1)) / 2.0).sum();
        face.iter().for_each(|&v| masses[v as usize] += area.norm() / face.len() as f64);
    }
    masses
}

/// Root mean square over the surface.
fn size(values: &DVector<f64>, masses: &DVector<f64>) -> f64 {
    (values.component_mul(values).dot(masses) / masses.sum()).sqrt()
}

/// Solves `L u = M f` at the vertices that are not `known`, by conjugate gradients.
fn poisson(laplacian: &Laplacian, right: &DVector<f64>, known: &[Option<f64>]) -> DVector<f64> {
    let n = laplacian.len();
    let apply = |u: &DVector<f64>| {
        let row = |i: usize| {
            let (neighbours, weights) = laplacian.row(i);
            let pairs = neighbours.iter().zip(weights);
            pairs.map(|(&j, w)| w * (u[i] - u[j as usize])).sum::<f64>()
        };
        DVector::from_fn(n, |i, _| if known[i].is_some() { 0.0 } else { row(i) })
    };
    let mut u = DVector::from_fn(n, |i, _| known[i].unwrap_or(0.0));
    let mut residual = right - apply(&u);
    (0..n).filter(|&i| known[i].is_some()).for_each(|i| residual[i] = 0.0);
    let mut direction = residual.clone();
    let start = residual.norm_squared();
    for _ in 0..20 * n {
        let before = residual.norm_squared();
        if before <= 1e-24 * start {
            break;
        }
        let image = apply(&direction);
        let step = before / direction.dot(&image);
        u += &direction * step;
        residual -= image * step;
        direction = &residual + &direction * (residual.norm_squared() / before);
    }
    u
}

/// Relative error of a solution; for uniform weights, whose solution has an arbitrary scale, the
/// error of the best multiple.
fn errors(
    mesh: &Mesh,
    exact: &DVector<f64>,
    minus_laplacian: &DVector<f64>,
    known: &[Option<f64>],
    is_free_of: impl Fn(DVector<f64>) -> DVector<f64>,
) -> [f64; 2] {
    let masses = masses(mesh);
    let right = minus_laplacian.component_mul(&masses);
    let solve = |laplacian: &Laplacian| is_free_of(poisson(laplacian, &right, known));
    let polygon = solve(&polygon(mesh));
    let uniform = solve(&Laplacian::uniform(&Topology::new(mesh)));
    let inner = |a: &DVector<f64>, b: &DVector<f64>| a.component_mul(b).dot(&masses);
    let scale = inner(&uniform, exact) / inner(&uniform, &uniform);
    [polygon - exact, uniform * scale - exact].map(|off| size(&off, &masses) / size(exact, &masses))
}

/// A cube on the unit sphere, whose faces are grids of `n` by `n` quads that are finer at one side.
/// The quads are not planar.
fn sphere(n: u32) -> Mesh {
    let mut mesh = Mesh::default();
    let at = |k: u32| {
        let t = f64::from(k) / f64::from(n);
        2.0 * (0.7 * t + 0.3 * t * t) - 1.0
    };
    let mut index = std::collections::BTreeMap::new();
    let mut vertex = |mesh: &mut Mesh, place: [u32; 3]| {
        *index.entry(place).or_insert_with(|| {
            let p = Vector3::from(place.map(at)).normalize();
            mesh.positions.push(p.into());
            mesh.positions.len() as u32 - 1
        })
    };
    for axis in 0..3 {
        for side in [0, n] {
            for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
                let mut corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].map(|[a, b]| {
                    let mut place = [side; 3];
                    place[(axis + 1) % 3] = a;
                    place[(axis + 2) % 3] = b;
                    vertex(&mut mesh, place)
                });
                if side == 0 {
                    corners.reverse();
                }
                mesh.faces.push(&corners);
            }
        }
    }
    mesh
}

#[test]
fn it_converges_on_the_sphere_where_uniform_weights_do_not() {
    let mut before = None;
    for n in [6, 12, 24] {
        let mesh = sphere(n);
        // Harmonics of the first and second order: their Laplacian is -2 and -6 times themselves.
        let of = |a: f64, b: f64| {
            let value = |&[x, y, z]: &Point| a * z + b * x * y;
            DVector::from_iterator(mesh.positions.len(), mesh.positions.iter().map(value))
        };
        let (exact, minus_laplacian) = (of(1.0, 1.0), of(2.0, 6.0));
        // The solution is defined up to a constant, which is subtracted.
        let masses = masses(&mesh);
        let mean = |u: &DVector<f64>| u.dot(&masses) / masses.sum();
        let exact_mean = mean(&exact);
        let shift = |u: DVector<f64>| {
            let by = exact_mean - mean(&u);
            u.add_scalar(by)
        };
        // The sum of the right side is zero up to discretisation error.
        let minus_laplacian = minus_laplacian.add_scalar(-mean(&minus_laplacian));
        let none = vec![None; mesh.positions.len()];
        let now = errors(&mesh, &exact, &minus_laplacian, &none, shift);
        println!("sphere, {} quads: {:.5} {:.5}", mesh.faces.len(), now[0], now[1]);
        if let Some([polygon, uniform]) = before.replace(now) {
            assert!(polygon > 3.5 * now[0], "of second order: {polygon} {}", now[0]);
            assert!(uniform < 1.5 * now[1] && now[1] > 0.02, "not at all: {uniform} {}", now[1]);
        }
    }
}

#[test]
fn it_converges_on_the_graph_of_a_function_where_uniform_weights_do_not() {
    // The grid is finer on one side; z = h(x, y).
    let warp = |t: f64| 0.5 * t + 0.5 * t * t;
    let height = |x: f64, y: f64| 0.3 * x * x - 0.4 * x * y + 0.2 * y * y * y;
    // Zero on the boundary, so that the solution is linear in the right side.
    let function = |x: f64, y: f64| x * (1.0 - x) * y * (1.0 - y) * (1.0 + 2.0 * x - y);
    let step = 1e-3;
    let slope = |f: &dyn Fn(f64, f64) -> f64, x: f64, y: f64| {
        [f(x + step, y) - f(x - step, y), f(x, y + step) - f(x, y - step)].map(|d| d / (2.0 * step))
    };
    // The gradient in the metric of the graph, times its area density.
    let flow = |x: f64, y: f64| {
        let ([a, b], [u, v]) = (slope(&height, x, y), slope(&function, x, y));
        let density = (1.0 + a * a + b * b).sqrt();
        [((1.0 + b * b) * u - a * b * v) / density, ((1.0 + a * a) * v - a * b * u) / density]
    };
    let minus_laplacian = |x: f64, y: f64| {
        let [a, b] = slope(&height, x, y);
        let divergence =
            slope(&|x, y| flow(x, y)[0], x, y)[0] + slope(&|x, y| flow(x, y)[1], x, y)[1];
        -divergence / (1.0 + a * a + b * b).sqrt()
    };
    let mut before = None;
    for n in [12, 24, 48] {
        let mesh = mixed_grid(n, |x, y| {
            let (x, y) = (warp(x), warp(y));
            [x, y, height(x, y)]
        });
        let on_mesh = |f: &dyn Fn(f64, f64) -> f64| {
            DVector::from_iterator(
                mesh.positions.len(),
                mesh.positions.iter().map(|p| f(p[0], p[1])),
            )
        };
        let exact = on_mesh(&function);
        let mut known = vec![None; mesh.positions.len()];
        for &v in Topology::new(&mesh).boundary_loops().indices() {
            known[v as usize] = Some(exact[v as usize]);
        }
        let now = errors(&mesh, &exact, &on_mesh(&minus_laplacian), &known, |u| u);
        println!("graph, {} faces: {:.6} {:.6}", mesh.faces.len(), now[0], now[1]);
        if let Some([polygon, uniform]) = before.replace(now) {
            assert!(polygon > 2.5 * now[0], "{polygon} {}", now[0]);
            assert!(uniform < 1.5 * now[1] && now[1] > 10.0 * now[0], "{uniform} {}", now[1]);
        }
    }
}

#[test]
fn an_edge_of_no_face_has_weight_one() {
    let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [3.0, 0.0, 1.0]];
    let curves = Mesh { positions, curves: [[0, 1, 2]].iter().collect(), ..Mesh::default() };
    assert_eq!(polygon(&curves), Laplacian::uniform(&Topology::new(&curves)));
}
