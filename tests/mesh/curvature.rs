//! Principal curvatures of meshes on surfaces with known curvatures, and the angles of edges to the
//! principal directions.

use crate::support::shared;
use shape_up::math;
use shape_up::mesh::{CurvatureField, CurvatureLines, Family, Mesh, Topology, curvatures};
use std::f64::consts::{PI, TAU};

type Surface = fn(f64, f64) -> [f64; 3];

fn cosine(radians: f64) -> f64 {
    math::cosine(radians / TAU)
}
fn sine(radians: f64) -> f64 {
    math::sine(radians / TAU)
}

/// A patch of a parametric surface, rotated by `turn` in the parameter domain; rows and columns are
/// unevenly spaced.
fn patch(n: u32, turn: f64, surface: Surface) -> Mesh {
    let point = |i: u32, j: u32| {
        let even = [i, j].map(|k| f64::from(k) / f64::from(n) - 0.5);
        let [u, v] = even.map(|t| 0.6 * (t + 0.1 * t * t));
        surface(cosine(turn) * u - sine(turn) * v, sine(turn) * u + cosine(turn) * v)
    };
    crate::support::grid::grid(n, n, point)
}

fn sphere(u: f64, v: f64) -> [f64; 3] {
    let (x, y) = (u, v);
    [2.0 * x, 2.0 * y, -2.0 * (1.0 - x * x - y * y).sqrt()]
}
fn cylinder(u: f64, v: f64) -> [f64; 3] {
    [cosine(u) / 2.0, sine(u) / 2.0, v]
}
fn torus(u: f64, v: f64) -> [f64; 3] {
    let radius = 2.0 + cosine(v);
    [radius * cosine(u), radius * sine(u), sine(v)]
}
fn saddle(u: f64, v: f64) -> [f64; 3] {
    [u, v, u * u - v * v]
}
/// Ellipsoid around an end of its third axis.
fn ellipsoid(u: f64, v: f64) -> [f64; 3] {
    [3.0 * u, 2.0 * v, (1.0 - u * u - v * v).sqrt()]
}

/// At the middle: magnitudes of the principal curvatures; Gauss curvature and magnitude of the mean
/// curvature.
fn middle(surface: Surface, n: u32, turn: f64) -> ([f64; 2], [f64; 2]) {
    let mesh = patch(n, turn, surface);
    let topology = Topology::new(&mesh);
    let found = curvatures(&mesh.positions, &mesh.faces, &topology);
    let vertex = (n / 2) * (n + 1) + n / 2;
    let one = found[vertex as usize].unwrap();
    for direction in one.directions {
        assert!((direction.length() - 1.0).abs() < 1e-14);
        assert!(direction.dot(one.normal).abs() < 1e-14);
    }
    assert!(one.directions[0].dot(one.directions[1]).abs() < 1e-14);
    (one.principal.map(f64::abs), [one.gauss(), one.mean().abs()])
}

#[test]
fn curvatures_tend_to_those_of_the_surface() {
    // The middle of a patch is at parameters (0, 0).
    let known: [(Surface, [f64; 2], f64); 5] = [
        (sphere, [0.5, 0.5], 0.25),
        (cylinder, [0.0, 2.0], 0.0),
        (torus, [1.0 / 3.0, 1.0], 1.0 / 3.0),
        (saddle, [2.0, 2.0], -4.0),
        (ellipsoid, [1.0 / 9.0, 0.25], 1.0 / 36.0),
    ];
    for (place, (surface, [low, high], gauss)) in known.into_iter().enumerate() {
        for turn in [0.0, 0.5] {
            let error = |n| {
                let ([a, b], [product, mean]) = middle(surface, n, turn);
                let sum = if gauss < 0.0 { high - low } else { high + low };
                let errors = [
                    (a.min(b) - low).abs(),
                    (a.max(b) - high).abs(),
                    (product - gauss).abs(),
                    (mean - 0.5 * sum).abs(),
                ];
                errors.into_iter().fold(0.0, f64::max)
            };
            let [coarse, fine] = [8, 32].map(error);
            println!("surface {place}, turn {turn}: {coarse:e} {fine:e}");
            assert!(fine <= 0.01, "surface {place}, turn {turn}: {fine}");
            // At least first order in the edge length, which is divided by four.
            assert!(fine <= 0.35 * coarse || fine < 1e-9, "surface {place}, turn {turn}");
        }
    }
}

#[test]
fn curvatures_do_not_depend_on_the_unit_and_on_where_a_mesh_lies() {
    let mesh = patch(8, 0.3, torus);
    let topology = Topology::new(&mesh);
    let found = curvatures(&mesh.positions, &mesh.faces, &topology);
    for scale in [1e-3, 1e3] {
        let moved: Vec<_> =
            mesh.positions.iter().map(|&[x, y, z]| [scale * y, scale * z, scale * x]).collect();
        for (a, b) in found.iter().zip(curvatures(&moved, &mesh.faces, &topology)) {
            let (a, b) = (a.unwrap(), b.unwrap());
            for k in 0..2 {
                assert!((a.principal[k] - scale * b.principal[k]).abs() < 1e-9);
            }
        }
    }
}

#[test]
fn edges_along_lines_of_curvature_have_no_angle_to_them_and_turned_ones_theirs() {
    let lines = |surface: Surface, turn: f64| {
        let mesh = patch(24, turn, surface);
        CurvatureLines::new(&mesh.positions, &mesh.faces, &Topology::new(&mesh))
    };
    let straight = lines(cylinder, 0.0);
    assert!(straight.mean.unwrap() < 1e-3 && straight.directed > 0.999, "{:?}", straight.mean);
    assert!(lines(torus, 0.0).mean.unwrap() < 1.0);
    // For a parametrisation of equal lengths, angles in the parameter domain are those on the
    // surface.
    let equal: Surface = |u, v| [cosine(u), sine(u), v];
    for degrees in [10.0, 30.0, 45.0] {
        let turned = lines(equal, degrees * PI / 180.0).mean.unwrap();
        assert!((turned - degrees).abs() < 0.5, "{degrees}: {turned}");
    }
}

#[test]
fn a_face_has_the_mean_angle_of_its_edges_and_none_where_the_surface_is_flat() {
    // A vault next to flat ground.
    let mesh = crate::support::grid::grid(24, 6, |i, j| {
        let u = (f64::from(i) - 12.0).max(0.0) / 12.0;
        [12.0 + if i < 12 { f64::from(i) - 12.0 } else { sine(u) }, f64::from(j), cosine(u)]
    });
    let topology = Topology::new(&mesh);
    let lines = CurvatureLines::new(&mesh.positions, &mesh.faces, &topology);
    let values = lines.of_faces(&mesh.faces, &topology);
    assert_eq!(values.len(), mesh.faces.len());
    for (face, value) in mesh.faces.iter().zip(&values) {
        let x = face.iter().map(|&v| mesh.positions[v as usize][0]).fold(f64::MIN, f64::max);
        // Near the line where the vault begins, fits include points of both parts.
        let right = if x < 9.5 { value.is_nan() } else { x < 12.3 || *value < 0.1 };
        assert!(right, "{x}: {value}");
    }
    // Rotated edges: the values of the faces average to the mean of all edges.
    let mesh = patch(24, PI / 9.0, |u, v| [cosine(u), sine(u), v]);
    let topology = Topology::new(&mesh);
    let lines = CurvatureLines::new(&mesh.positions, &mesh.faces, &topology);
    for value in lines.of_faces(&mesh.faces, &topology) {
        assert!((value - 20.0).abs() < 2.0, "{value}");
    }
}

#[test]
fn a_sphere_and_a_plane_have_no_directions() {
    for surface in [sphere, |u, v| [u, v, 0.0]] {
        let mesh = patch(12, 0.2, surface);
        let lines = CurvatureLines::new(&mesh.positions, &mesh.faces, &Topology::new(&mesh));
        assert_eq!((lines.mean, lines.directed), (None, 0.0));
        assert!(lines.angles.iter().all(|angle| angle.is_nan()));
    }
}

#[test]
fn faces_that_turn_the_other_way_change_no_angle() {
    let mesh = patch(12, 0.4, torus);
    let mut other = mesh.clone();
    other.faces =
        mesh.faces.iter().map(|face| face.iter().rev().copied().collect::<Vec<_>>()).collect();
    let [a, b] = [&mesh, &other]
        .map(|mesh| CurvatureLines::new(&mesh.positions, &mesh.faces, &Topology::new(mesh)));
    for (a, b) in a.angles.iter().zip(&b.angles) {
        assert!((a - b).abs() < 1e-6, "{a} and {b}");
    }
}

/// Where as many faces turn one way as the other there was none, or that over a tangent plane.
#[test]
fn curvatures_are_those_of_the_surface_where_every_second_face_turns_the_other_way() {
    let mesh = patch(12, 0.4, torus);
    let topology = Topology::new(&mesh);
    let found = curvatures(&mesh.positions, &mesh.faces, &topology);
    let faces = mesh.faces.iter().enumerate().map(|(f, face)| {
        let is_turned = (f / 12 + f % 12) % 2 == 1;
        if is_turned { face.iter().rev().copied().collect() } else { face.to_vec() }
    });
    let mixed = Mesh { faces: faces.collect::<Vec<Vec<u32>>>().iter().collect(), ..mesh.clone() };
    let others = curvatures(&mixed.positions, &mixed.faces, &Topology::new(&mixed));
    for (a, b) in found.iter().zip(others) {
        let (a, b) = (a.expect("it is known"), b.expect("it is known"));
        assert!((a.gauss() - b.gauss()).abs() < 1e-9 && (a.mean() - b.mean()).abs() < 1e-9);
    }
}

#[test]
fn a_lone_face_and_points_have_no_curvature() {
    let mesh = crate::support::grid::grid(1, 1, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let found = curvatures(&mesh.positions, &mesh.faces, &Topology::new(&mesh));
    assert!(found.iter().all(Option::is_none));
}

/// Mean angle, in degrees, of known meshes, and the fraction of their edges that have one.
#[test]
fn edges_of_known_meshes_lie_as_measured() {
    for (file, mean) in [
        ("trimesh_quadknot.obj", 1.7),
        ("halftunnel.off", 4.5),
        ("compas_tubemesh.obj", 6.7),
        ("horse_quad.obj", 13.8),
        ("botanic-garden-bubble-0.obj", 14.0),
        ("M2_eq_quad2.obj", 25.1),
        ("pillow_1.obj", 27.0),
        ("compas_hypar.obj", 42.5),
        ("cmc1.obj", 44.7),
    ] {
        let Some(mesh) = shared::mesh(file) else { return };
        let lines = CurvatureLines::new(&mesh.positions, &mesh.faces, &Topology::new(&mesh));
        let found = lines.mean.unwrap();
        assert!((found - mean).abs() < 0.1 && lines.directed > 0.85, "{file}: {found}");
    }
    let Some(sphere) = shared::mesh("chebyshev_sphere.obj") else { return };
    let lines = CurvatureLines::new(&sphere.positions, &sphere.faces, &Topology::new(&sphere));
    assert_eq!(lines.mean, None);
}

/// Every line ends, on known meshes.
#[test]
fn lines_of_known_meshes_are_finite_and_on_the_mesh() {
    for file in ["compas_tubemesh.obj", "horse_quad.obj", "cmc1.obj", "M2_eq_quad2.obj"] {
        let Some(mesh) = shared::mesh(file) else { return };
        let size = mesh
            .positions
            .iter()
            .fold(0.0, |size: f64, p| p.iter().fold(size, |s, x| s.max(x.abs())));
        let field = CurvatureField::new(&mesh.positions, &mesh, &Topology::new(&mesh));
        let begun = std::time::Instant::now();
        let lines = [Family::Larger, Family::Smaller]
            .map(|family| field.spaced_lines(family, 3.0 * field.mean_edge()));
        println!("{file}: {} and {} lines, {:?}", lines[0].len(), lines[1].len(), begun.elapsed());
        for line in lines.iter().flatten() {
            assert!(line.positions().all(|point| point.iter().all(|x| x.abs() <= size + 1e-9)));
        }
        assert!(lines.iter().all(|lines| lines.len() > 2), "{file}");
    }
}
