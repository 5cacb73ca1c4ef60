//! Conformal maps against an independent implementation (`../shared/expected`; reports its
//! absence), and on surfaces whose flat map is known.

use crate::support::grid::grid;
use shape_up::mesh::{Mesh, Topology};
use shape_up::solve::{ConformalNorm, ConformalWeights, FewerFlips, Parametrization};

const WEIGHTS: [(&str, ConformalWeights); 3] = [
    ("one", ConformalWeights::One),
    ("inv_area", ConformalWeights::InverseArea),
    ("lscm", ConformalWeights::Lscm),
];
const NORMS: [(&str, ConformalNorm); 2] =
    [("all_vertices", ConformalNorm::Vertices), ("boundary", ConformalNorm::Boundary)];

fn map(mesh: &Mesh, weights: ConformalWeights, norm: ConformalNorm) -> Parametrization {
    Parametrization::new(mesh, &Topology::new(mesh), weights, norm).expect("the mesh has a map")
}

#[test]
fn maps_agree_with_an_independent_implementation() {
    for (name, file) in [
        ("conformal_hemisphere", "hemisphere.obj"),
        ("conformal_inspired_mesh", "inspired_mesh.obj"),
        ("conformal_camelhead", "camelhead.off"),
    ] {
        let (Some(expected), Some(mesh)) =
            (crate::support::shared::expected(name), crate::support::shared::mesh(file))
        else {
            continue;
        };
        for (weight, weights) in WEIGHTS {
            for (normalisation, norm) in NORMS {
                let variant = format!("{weight}/{normalisation}");
                let expected = &expected["variants"][&variant];
                let number = |value: &serde_json::Value| value.as_f64().expect("a number");
                let found = map(&mesh, weights, norm);
                let close = |what, found: f64, expected: f64, tolerance: f64| {
                    assert!(
                        (found - expected).abs() <= tolerance * expected,
                        "{name} {variant}: {what} is {found}, expected {expected}"
                    );
                };
                // The inverse area has a unit, and the reference does not state which one it uses.
                if weights != ConformalWeights::InverseArea {
                    let expected = number(&expected["eigenvalues"][0]);
                    close("eigenvalue", found.eigenvalue, expected, 1e-6);
                }
                let mean = number(&expected["qc_area_weighted_mean"]);
                close("error", found.errors.quasi_conformal.mean, mean, 1e-9);
                assert_eq!(found.errors.flipped as u64, expected["flipped"], "{name} {variant}");
            }
        }
    }
}

/// Half a cylinder of planar quads: it unrolls without distortion for any weights.
fn roll(scale: f64) -> Mesh {
    // Chords of equal length: the angle of each has the cosine 0.96.
    let mut corners = vec![[1.0, 0.0]];
    for _ in 0..10 {
        let [x, y] = corners[corners.len() - 1];
        corners.push([0.96 * x - 0.28 * y, 0.28 * x + 0.96 * y]);
    }
    grid(10, 6, |i, j| {
        let [x, y] = corners[i as usize];
        [scale * x, scale * y, scale * 0.2 * f64::from(j)]
    })
}

#[test]
fn what_can_be_unrolled_is_unrolled_in_any_unit() {
    let chord = (0.04f64.powi(2) + 0.28f64.powi(2)).sqrt();
    for scale in [1e-3, 1.0, 1e3] {
        for (_, weights) in WEIGHTS {
            for (_, norm) in NORMS {
                let found = map(&roll(scale), weights, norm);
                assert!((found.errors.quasi_conformal.max - 1.0).abs() < 1e-6, "{found:?}");
                assert_eq!((found.errors.flipped, found.parts, found.closed_parts), (0, 1, 0));
                // The longest axis of the map is the length of the ten chords, and its area is the
                // area of the surface.
                let extent = |i: usize| found.uv.iter().map(|uv| uv[i]).fold(0.0, f64::max);
                assert!((extent(0) / scale - 10.0 * chord).abs() < 1e-5, "{}", extent(0));
                assert!((extent(1) / scale - 1.2).abs() < 1e-5, "{}", extent(1));
            }
        }
    }
}

#[test]
fn parts_lie_side_by_side_and_vertices_without_faces_do_no_harm() {
    let mut mesh = roll(1.0);
    let n = mesh.positions.len() as u32;
    let second = roll(0.5);
    mesh.positions.extend(second.positions.iter().map(|[x, y, z]| [x + 3.0, *y, *z]));
    for face in second.faces.iter() {
        mesh.faces.push(&face.iter().map(|v| v + n).collect::<Vec<_>>());
    }
    mesh.positions.push([9.0; 3]);
    let found = map(&mesh, ConformalWeights::InverseArea, ConformalNorm::Boundary);
    assert_eq!((found.parts, found.errors.flipped), (2, 0));
    let (first, rest) = found.uv.split_at(n as usize);
    let (second, last) = rest.split_at(n as usize);
    let right = first.iter().map(|uv| uv[0]).fold(0.0, f64::max);
    let left = second.iter().map(|uv| uv[0]).fold(f64::INFINITY, f64::min);
    assert!(left > right, "the parts overlap: {left}, {right}");
    assert_eq!(last, [[0.0; 2]]);
}

#[test]
fn a_closed_surface_is_mapped_over_all_its_vertices() {
    let mut cube = Mesh::default();
    let corner = |k: u32| [k & 1, (k >> 1) & 1, (k >> 2) & 1].map(f64::from);
    cube.positions.extend((0..8).map(corner));
    for face in [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    {
        cube.faces.push(&face);
    }
    let found = map(&cube, ConformalWeights::default(), ConformalNorm::Boundary);
    assert_eq!((found.parts, found.closed_parts), (1, 1));
    assert!(found.uv.iter().flatten().all(|value| value.is_finite()));
}

/// Maps the mesh and checks that all numbers of the map are finite.
fn finite_map(mesh: &Mesh) -> Parametrization {
    let found = map(mesh, ConformalWeights::InverseArea, ConformalNorm::Boundary);
    assert!(found.uv.as_flattened().iter().all(|value| value.is_finite()));
    assert!(found.errors.quasi_conformal.max.is_finite(), "{:?}", found.errors);
    found
}

#[test]
fn faces_without_area_are_left_out_and_a_surface_without_any_is_refused() {
    let mut mesh = roll(1.0);
    mesh.faces.push(&[0, 1, 0]);
    let found = finite_map(&mesh);
    assert!((found.errors.quasi_conformal.max - 1.0).abs() < 1e-6, "{found:?}");
    assert_eq!(found.left_out, [60]);

    let mut line = Mesh::default();
    line.positions.extend([[0.0; 3], [1.0; 3], [2.0; 3]]);
    line.faces.push(&[0, 1, 2]);
    let topology = Topology::new(&line);
    let (weights, norm) = (ConformalWeights::default(), ConformalNorm::default());
    Parametrization::new(&line, &topology, weights, norm).expect_err("it has no area");
}

#[test]
fn a_face_that_has_shrunk_to_a_point_or_a_line_does_not_take_the_map_with_it() {
    let sound = finite_map(&crate::support::grid::bumpy(4));
    // Two vertices at the position of a third: only the norm constrained them, and they took up the
    // whole norm. The mean error was infinite, and the exit code 0.
    let mut point = crate::support::grid::bumpy(4);
    point.positions.extend([point.positions[6]; 2]);
    point.faces.push(&[6, 25, 26]);
    // A sliver with a height near rounding: its weight was 1e14 times the other weights.
    let mut sliver = crate::support::grid::bumpy(4);
    let [a, b] = [0, 1].map(|k| sliver.positions[k]);
    sliver.positions.push(std::array::from_fn(|i| 0.5 * a[i] + 0.5 * b[i] + [0.0, 1e-14, 0.0][i]));
    sliver.faces.push(&[0, 25, 1]);
    for mesh in [point, sliver] {
        let found = finite_map(&mesh);
        assert_eq!(found.left_out, [16]);
        assert_eq!(found.errors.quasi_conformal, sound.errors.quasi_conformal);
        assert!(found.errors.of_faces[16].is_nan());
    }
}

#[test]
fn faces_of_an_edge_that_is_not_manifold_do_not_make_the_map_collapse() {
    // A fin on an inner edge, so that three faces share the edge. It is mapped with the rest.
    let mut fin = crate::support::grid::bumpy(4);
    fin.positions.extend([[1.0, 1.0, 2.0], [2.0, 1.0, 2.0]]);
    fin.faces.push(&[6, 7, 26, 25]);
    let found = finite_map(&fin);
    assert!(found.left_out.is_empty() && found.errors.quasi_conformal.max < 1.2, "{found:?}");
    // With a back of the fin, a face on the same vertices in the other direction, no map is
    // conformal on both faces, and their part collapsed, with a mean error of 1e14.
    fin.faces.push(&[25, 26, 7, 6]);
    let with_back = finite_map(&fin);
    assert_eq!(with_back.left_out, [17]);
    assert_eq!(with_back.uv, found.uv);
}

#[test]
fn a_polygon_of_many_corners_is_mapped_in_time_that_grows_with_them() {
    // Its corners were coupled with each other, a dense block of the matrix: 4,000 corners took
    // 34 s and 1.4 GB, and 20,000 aborted.
    let mut polygon = Mesh::default();
    // Rational points of a circle, without trigonometric functions.
    let n = 20_000;
    polygon.positions.extend((0..n).map(|k| {
        let slope = 2.0 * f64::from(k % (n / 2)) / f64::from(n / 2) - 1.0;
        let (square, turn) = (slope * slope, if k < n / 2 { 1.0 } else { -1.0 });
        let (x, y) = ((1.0 - square) / (1.0 + square), 2.0 * slope / (1.0 + square));
        [turn * x, turn * y, 0.05 * x * x]
    }));
    polygon.faces.push(&(0..n).collect::<Vec<_>>());
    let started = std::time::Instant::now();
    let found = finite_map(&polygon);
    assert!(started.elapsed().as_secs() < 30, "it took {:?}", started.elapsed());
    assert_eq!((found.parts, found.errors.flipped), (1, 0));
    assert!(found.errors.quasi_conformal.mean < 1.01, "{:?}", found.errors.quasi_conformal);
}

#[test]
fn where_faces_are_turned_over_settings_are_offered_that_turn_fewer() {
    let Some(mesh) = crate::support::shared::mesh("halftunnel.off") else { return };
    let topology = Topology::new(&mesh);
    let flipped = |weights, norm| {
        let map = Parametrization::new(&mesh, &topology, weights, norm);
        map.expect("the mesh has a map").errors.flipped
    };
    let now = flipped(ConformalWeights::default(), ConformalNorm::default());
    let offered = FewerFlips::of(&mesh, &topology, now).expect("there are better settings");
    assert!(now > 0 && offered.flipped < now, "{now} {offered:?}");
    assert_eq!(flipped(offered.weights, offered.norm), offered.flipped);
    assert_eq!(FewerFlips::of(&mesh, &topology, offered.flipped), None, "there are no fewer");
}

#[test]
fn the_map_of_a_closed_surface_has_its_area() {
    let mut mesh = Mesh::default();
    mesh.positions.extend([[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    mesh.positions.extend([[0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]]);
    for [a, b] in [[0, 2], [2, 1], [1, 3], [3, 0]] {
        mesh.faces.push(&[a, b, 4]);
        mesh.faces.push(&[b, a, 5]);
    }
    let map = map(&mesh, ConformalWeights::default(), ConformalNorm::default());
    let area = |face: &[u32]| {
        let [a, b, c] = [0, 1, 2].map(|k| map.uv[face[k] as usize]);
        0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs()
    };
    let flat: f64 = mesh.faces.iter().map(area).sum();
    // Eight equilateral triangles with sides of the square root of two.
    let expected = 4.0 * f64::sqrt(3.0);
    assert!((flat - expected).abs() < 1e-9 * expected, "{flat}");
}
