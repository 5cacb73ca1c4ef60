//! Unrolling: strips of planar quads, and surfaces without Gauss curvature.

use crate::support::grid::grid;
use shape_up::generate::model::{Court, Strip};
use shape_up::math::{Vec3, cosine, sine};
use shape_up::mesh::{Mesh, Point, Topology, UnrolledStrip, gauss_curvature, strips};
use std::f64::consts::TAU;

/// A piece of a cone with planar quads.
fn cone() -> Mesh {
    grid(9, 3, |i, j| {
        let (turn, radius) = (f64::from(i) / 16.0, 2.0 + f64::from(j));
        [radius * cosine(turn), radius * sine(turn), 0.75 * radius]
    })
}

fn apart(a: [f64; 2], b: [f64; 2]) -> f64 {
    ((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1])).sqrt()
}

fn check_unrolled(mesh: &Mesh, closed: usize) {
    let topology = Topology::new(mesh);
    let mut rounds = 0;
    for strip in strips(mesh, &topology).iter() {
        let flat = UnrolledStrip::new(&mesh.positions, strip, &topology).expect("it has lengths");
        rounds += usize::from(flat.closed);
        let mut edges: Vec<[u32; 2]> = strip.as_chunks().0.to_vec();
        edges.extend(flat.closed.then_some(edges[0]));
        assert_eq!((flat.quads, flat.outline.len()), (edges.len() - 1, 2 * edges.len()));
        let last = flat.outline.len() - 1;
        let at = |v: u32| Vec3::from(mesh.positions[v as usize]);
        for k in 0..flat.quads {
            // The sides and diagonals of the quad keep their length, so the quad is congruent.
            let ends = [edges[k][0], edges[k][1], edges[k + 1][0], edges[k + 1][1]];
            let places = [k, last - k, k + 1, last - k - 1];
            for (i, j) in [(0, 1), (2, 3), (0, 2), (1, 3), (0, 3), (1, 2)] {
                let length = (at(ends[i]) - at(ends[j])).length();
                let laid = apart(flat.outline[places[i]], flat.outline[places[j]]);
                assert!((laid - length).abs() < 1e-12 * length, "{length} is laid {laid}");
            }
        }
    }
    assert_eq!(rounds, closed);
}

#[test]
fn strips_of_flat_quads_are_laid_without_stretch() {
    check_unrolled(&cone(), 0);
    let mut level = Court::mesh();
    level.positions.iter_mut().for_each(|p| p[2] = 0.0);
    check_unrolled(&level, Court::ROWS as usize);
}

#[test]
fn a_ring_is_closed_only_by_a_quad() {
    let mut ring = grid(8, 1, |i, j| {
        let turn = f64::from(i) / 8.0;
        [cosine(turn), sine(turn), f64::from(j)]
    });
    let joined: Vec<Vec<u32>> = ring
        .faces
        .iter()
        .map(|face| face.iter().map(|&v| if v % 9 == 8 { v - 8 } else { v }).collect())
        .collect();
    ring.faces = joined.iter().collect();
    check_unrolled(&ring, 1);
    // Two triangles in place of the first quad: the ends are still joined by edges.
    let triangles = [vec![0, 1, 10], vec![0, 10, 9]];
    ring.faces = triangles.iter().chain(&joined[1..]).collect();
    check_unrolled(&ring, 0);
}

#[test]
fn an_edge_without_length_leads_nowhere() {
    let points: [Point; 6] = [[0.0; 3], [0.0; 3], [1.0; 3], [2.0; 3], [3.0; 3], [4.0; 3]];
    let mesh = grid(1, 2, |i, j| points[(2 * j + i) as usize]);
    let topology = Topology::new(&mesh);
    assert_eq!(UnrolledStrip::new(&mesh.positions, &[0, 1, 2, 3, 4, 5], &topology), None);
}

#[test]
fn gauss_curvature_is_zero_on_a_cone_and_that_of_the_sphere_on_a_sphere() {
    let of = |mesh: &Mesh| gauss_curvature(&mesh.positions, mesh, &Topology::new(mesh));
    let inside = |all: Vec<f64>| all.into_iter().filter(|k| k.is_finite());
    assert!(inside(of(&cone())).all(|k| k.abs() < 1e-12));
    assert_eq!(inside(of(&cone())).count(), 8 * 2);
    // A band of a sphere of radius 2 around its equator.
    let sphere = grid(40, 40, |i, j| {
        let [turn, up] = [f64::from(i) / 160.0, (f64::from(j) - 20.0) / 320.0];
        [2.0 * cosine(up) * cosine(turn), 2.0 * cosine(up) * sine(turn), 2.0 * sine(up)]
    });
    assert!(inside(of(&sphere)).all(|k| (k - 0.25).abs() < 1e-3));
}

#[test]
fn quads_that_are_not_flat_have_their_curvature_too() {
    // z = x y / 2 at its middle: the product of the principal curvatures 1/2 and -1/2.
    let hypar = grid(64, 64, |i, j| {
        let [x, y] = [i, j].map(|k| (f64::from(k) - 32.0) / 64.0);
        [x, y, 0.5 * x * y]
    });
    let all = gauss_curvature(&hypar.positions, &hypar, &Topology::new(&hypar));
    assert!((all[32 * 65 + 32] + 0.25).abs() < 1e-3, "{}", all[32 * 65 + 32]);
}

#[test]
fn curvature_over_a_closed_surface_is_that_of_its_shape() {
    // Gauss-Bonnet: the angle defects of a box add up to 4 pi, wherever its corners are.
    let corner = |k: u32| {
        let [x, y, z] = [k & 1, k >> 1 & 1, k >> 2].map(f64::from);
        [x + 0.1 * y, y * (1.0 + 0.2 * z), z + 0.1 * x * y]
    };
    let faces =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let mesh = Mesh {
        positions: (0..8).map(corner).collect(),
        faces: faces.into_iter().collect(),
        ..Mesh::default()
    };
    let all = gauss_curvature(&mesh.positions, &mesh, &Topology::new(&mesh));
    let at = |v: u32| Vec3::from(mesh.positions[v as usize]);
    let mut areas = [0.0; 8];
    for face in mesh.faces.iter() {
        let centre = face.iter().fold(Vec3::zero(), |sum, &v| sum + at(v)) * 0.25;
        let area = |k: usize| {
            let [a, b] = [at(face[k]) - centre, at(face[(k + 1) % 4]) - centre];
            0.5 * a.cross(b).length()
        };
        let share = (0..4).map(area).sum::<f64>() / 4.0;
        face.iter().for_each(|&v| areas[v as usize] += share);
    }
    let total: f64 = all.iter().zip(areas).map(|(k, area)| k * area).sum();
    assert!((total - 2.0 * TAU).abs() < 1e-12 * TAU, "{total}");
}

#[test]
fn the_rows_of_a_warped_strip_are_no_surface_that_unrolls() {
    let strip = Strip::default().mesh();
    let all = gauss_curvature(&strip.positions, &strip, &Topology::new(&strip));
    assert!(all.into_iter().any(|k| k < -1e-3));
}
