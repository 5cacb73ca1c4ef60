//! The example scenes: their meshes are clean, their scenes fit, and there is something to do.

use shape_up::mesh::generate::{Canopy, Dome, Hypar};
use shape_up::mesh::{Mesh, Point, Topology, components, read, write_obj};
use shape_up::scene::Scene;
use shape_up::scene::examples::EXAMPLES;
use shape_up::session::Session;

fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Twice the area vector of a polygon.
fn area_vector(points: &[Point]) -> Point {
    let mut sum = [0.0; 3];
    for k in 0..points.len() {
        let (a, b) =
            (minus(points[k], points[0]), minus(points[(k + 1) % points.len()], points[0]));
        for (i, total) in sum.iter_mut().enumerate() {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            *total += a[j] * b[k] - a[k] * b[j];
        }
    }
    sum
}

fn meshes() -> Vec<(&'static str, Mesh, usize)> {
    // The last number: boundary loops.
    vec![
        ("canopy", Canopy::default().mesh(), 1),
        ("dome", Dome::default().mesh(), 2),
        ("hypar", Hypar::default().mesh(), 1),
        ("small canopy", Canopy { panels: [1, 2], ..Canopy::default() }.mesh(), 1),
        ("small dome", Dome { meridians: 4, rows: [0, 0], ..Dome::default() }.mesh(), 2),
    ]
}

#[test]
fn meshes_are_manifold_and_in_one_piece() {
    for (name, mesh, loops) in meshes() {
        let topology = Topology::new(&mesh);
        assert!(topology.edge_faces().iter().all(|faces| (1..=2).contains(&faces.len())), "{name}");
        assert_eq!(topology.boundary_loops().len(), loops, "{name}");
        let labels = components(mesh.positions.len(), mesh.faces.iter());
        assert!(labels.iter().all(|&label| label == 0), "{name}");
        let flat = mesh.positions.as_flattened();
        assert!(flat.iter().all(|x| x.is_finite()), "{name}");
        // Each side is run through once in each direction.
        let mut sides: Vec<(u32, u32)> = Vec::new();
        for face in mesh.faces.iter() {
            sides.extend((0..face.len()).map(|k| (face[k], face[(k + 1) % face.len()])));
        }
        sides.sort_unstable();
        assert!(sides.windows(2).all(|pair| pair[0] != pair[1]), "{name}: neighbours face alike");
    }
}

#[test]
fn panels_face_up_and_are_neither_slivers_nor_out_of_scale() {
    for (name, mesh, _) in meshes().into_iter().take(3) {
        for (f, face) in mesh.faces.iter().enumerate() {
            let points: Vec<Point> = face.iter().map(|&v| mesh.positions[v as usize]).collect();
            let area = area_vector(&points);
            assert!(area[2] > 0.0, "{name}: face {f} faces down");
            let sides: Vec<f64> = (0..points.len())
                .map(|k| minus(points[(k + 1) % points.len()], points[k]))
                .map(|side| dot(side, side).sqrt())
                .collect();
            let (short, long) =
                sides.iter().fold((f64::MAX, 0.0f64), |(s, l), &x| (s.min(x), l.max(x)));
            assert!(short > 0.3 && long < 4.0, "{name}: face {f} has sides {short} to {long} m");
            let area = dot(area, area).sqrt() / 2.0;
            assert!(area > 0.15 * long * long, "{name}: face {f} is a sliver of {area} square m");
        }
    }
}

#[test]
fn the_dome_has_quads_and_a_row_of_pentagons() {
    let dome = Dome::default();
    let mesh = dome.mesh();
    let corners = |n: usize| mesh.faces.iter().filter(|face| face.len() == n).count();
    assert_eq!(corners(5), dome.meridians);
    assert_eq!(corners(4) + corners(5), mesh.faces.len());
}

#[test]
fn meshes_and_scenes_come_back_from_their_files() {
    let mut ids = Vec::new();
    for example in EXAMPLES {
        let (scene, mesh) = example.build();
        let text = scene.to_json(&mesh);
        assert_eq!(Scene::from_json(&text).unwrap(), scene, "{text}");
        scene.validate(&mesh).unwrap();
        assert_eq!(example.file, format!("{}.shapeup.json", example.id));
        assert_eq!(example.mesh_file, format!("{}.obj", example.id));
        let again = read(example.mesh_file, write_obj(&mesh, &mesh.positions).as_bytes()).unwrap();
        assert_eq!(again.mesh, mesh, "{}", example.id);
        assert!(again.problems.is_empty(), "{}: {:?}", example.id, again.problems);
        ids.push(example.id);
    }
    assert_eq!(ids[0], "canopy", "the page opens the first");
    ids.dedup();
    assert_eq!(ids.len(), EXAMPLES.len());
}

#[test]
fn every_constraint_finds_its_vertices_and_the_energy_falls() {
    for example in EXAMPLES {
        let (scene, mesh) = example.build();
        let mut session = Session::open(scene, mesh).unwrap();
        session.solve(false).unwrap();
        let report = session.report();
        assert_eq!(report.skipped, 0, "{}", example.id);
        assert!(report.pinned.is_empty(), "{}", example.id);
        let (before, after) = (report.energy.initial, report.energy.last);
        assert!(after.total < 0.5 * before.total, "{}: {before:?} {after:?}", example.id);
        assert!(after.shape < 0.1 * before.shape, "{}: {before:?} {after:?}", example.id);
    }
}
