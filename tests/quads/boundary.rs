//! The boundary is followed with its corners, or it cuts the panels.

use super::surfaces::{hypar, parametric, plate, tube, vault};
use super::{check, check_manifold, panels, shape, with};
use shape_up::math::{Vec3, cosine, sine};
use shape_up::mesh::{Mesh, Point, Ragged, Surface, Topology};
use shape_up::quads::{Boundary, MapOptions, PanelSize};

/// The largest distance of the boundary vertices of a mesh from the boundary of another.
fn off_boundary(mesh: &Mesh, of: &Mesh) -> f64 {
    let curves: Ragged = Topology::new(of)
        .boundary_loops()
        .iter()
        .map(|one| one.iter().chain([&one[0]]).copied().collect::<Vec<u32>>())
        .collect();
    let curves = Mesh { curves, ..Mesh::default() };
    let boundary = Surface::new(&of.positions, &curves);
    let topology = Topology::new(mesh);
    let distance = |&v: &u32| {
        let point = mesh.positions[v as usize];
        let closest = boundary.closest(point, &mut Surface::NO_HINT.clone());
        (Vec3::from(closest) - Vec3::from(point)).length()
    };
    topology.boundary_loops().indices().iter().map(distance).fold(0.0, f64::max)
}

/// Whether a mesh has a vertex there.
fn has_vertex(mesh: &Mesh, at: Point) -> bool {
    mesh.positions.iter().any(|&point| (Vec3::from(point) - Vec3::from(at)).length() < 1e-9)
}

#[test]
fn a_followed_boundary_keeps_its_corners_and_its_curve() {
    let corners = |mesh: &Mesh, wanted: &[[f64; 2]]| -> Vec<Point> {
        let is_wanted = |point: &&Point| wanted.contains(&[point[0], point[1]]);
        mesh.positions.iter().filter(is_wanted).copied().collect()
    };
    let square = [[0.0, 0.0], [6.0, 0.0], [0.0, 6.0], [6.0, 6.0]];
    let hole = [[2.0, 2.0], [4.0, 2.0], [2.0, 4.0], [4.0, 4.0]];
    let rectangle = [[0.0, 0.0], [8.0, 0.0], [0.0, 6.0], [8.0, 6.0]];
    let cases =
        [(plate(), [square, hole].concat()), (vault(), rectangle.to_vec()), (tube(), Vec::new())];
    for (mesh, wanted) in cases {
        let found = panels(&mesh, 250).unwrap();
        check(&mesh, &found);
        assert!(off_boundary(&found.mesh, &mesh) < 1e-9);
        let corners = corners(&mesh, &wanted);
        assert_eq!(corners.len(), wanted.len());
        assert!(corners.into_iter().all(|corner| has_vertex(&found.mesh, corner)));
    }
}

#[test]
fn a_cut_boundary_has_panels_of_three_to_five_corners_nearer_to_the_lines_of_curvature() {
    for mesh in [hypar(), vault()] {
        let size = PanelSize::Count(250);
        let options = MapOptions { boundary: Boundary::Cut, ..MapOptions::of_size(size) };
        let cut = with(&mesh, options).unwrap();
        let followed = with(&mesh, MapOptions::of_size(size)).unwrap();
        check_manifold(&cut.mesh);
        assert_eq!(shape(&cut.mesh), shape(&mesh));
        let topology = Topology::new(&cut.mesh);
        let outer = topology.boundary_loops().row(0);
        for face in cut.mesh.faces.iter() {
            let at_boundary = face.iter().any(|v| outer.contains(v));
            assert!(face.len() == 4 || at_boundary && (3..=5).contains(&face.len()), "{face:?}");
        }
        assert!(off_boundary(&cut.mesh, &mesh) < 1e-9);
        for corner in [0, mesh.positions.len() - 1] {
            assert!(has_vertex(&cut.mesh, mesh.positions[corner]));
        }
        let angle = |found: &shape_up::quads::Remeshed| found.measures.angle.unwrap().mean;
        assert!(angle(&cut) < angle(&followed), "{} {}", angle(&cut), angle(&followed));
        assert!(cut.measures.irregular.inside <= followed.measures.irregular.inside);
    }
}

#[test]
fn a_cut_boundary_keeps_its_holes() {
    // A canopy over a square with a square opening, and one with a round one.
    let canopy = |point: &mut Point| point[2] = 0.05 * point[0] * point[1];
    let mut square = plate();
    square.positions.iter_mut().for_each(canopy);
    let mut round = parametric([48, 10], [true, false], |u, v| {
        let radius = 1.2 + 2.8 * v;
        [radius * cosine(u), radius * sine(u), 0.0]
    });
    round.positions.iter_mut().for_each(canopy);
    for mesh in [square, round] {
        let options =
            MapOptions { boundary: Boundary::Cut, ..MapOptions::of_size(PanelSize::Count(250)) };
        let cut = with(&mesh, options).unwrap();
        check_manifold(&cut.mesh);
        assert_eq!(shape(&cut.mesh), shape(&mesh));
        assert_eq!((cut.measures.loops, cut.notes.len()), (2, 0), "{:?}", cut.notes);
        assert!(off_boundary(&cut.mesh, &mesh) < 1e-9);
        // Each opening keeps its outline: no part of it is bridged.
        assert!(cut.measures.distance.from_input < 0.3 * cut.measures.edge.mean);
    }
}

#[test]
fn a_zigzag_boundary_is_followed_as_if_it_were_smooth() {
    // A disk whose rim goes in and out at every vertex, by a tenth of the edge there.
    let disk = parametric([48, 8], [true, false], |u, v| {
        let odd = (48.0 * u).round() as u32 % 2 == 1;
        let radius = 3.0 * (0.12 + 0.88 * v) + if v == 1.0 && odd { 0.1 } else { 0.0 };
        [radius * cosine(u), radius * sine(u), 0.3 * radius]
    });
    let found = panels(&disk, 200).unwrap();
    check(&disk, &found);
    assert!(found.measures.irregular.boundary <= 4, "{:?}", found.measures.irregular);
}
