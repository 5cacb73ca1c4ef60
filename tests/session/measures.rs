//! Values of the face measures.

use crate::support::grid::grid;
use serde_json::Value;
use shape_up::mesh::Mesh;
use shape_up::scene::{MeshSource, Scene};
use shape_up::session::{FACE_MEASURES, PanelStart, Session};

/// A unit square with two opposite corners lifted by 0.02; its rest shape is flat.
fn lifted() -> Session {
    let square = |lift| vec![[0.0, 0.0, lift], [1.0, 0.0, 0.0], [1.0, 1.0, lift], [0.0, 1.0, 0.0]];
    let mesh = Mesh {
        positions: square(0.0),
        faces: [[0, 1, 2, 3]].into_iter().collect(),
        ..Mesh::default()
    };
    let mut scene = Scene::new(MeshSource::File(String::new()));
    scene.current = Some(square(0.02));
    Session::open(scene, mesh).expect("it opens")
}

#[test]
fn conventions_of_the_same_panel_differ_as_they_are_known_to() {
    let mut session = lifted();
    let mut value = |id| session.face_values(id).expect("there is one")[0];
    let near = |value: f64, expected: f64| assert!((value - expected).abs() < 2e-3 * expected);
    near(value("planarity"), 0.01);
    near(value("diagonals"), 1.414);
    near(value("diagonals-by-edge"), 2.0);
    near(value("planarity-by-edge"), 1.0);
    near(value("fourth-corner"), 0.04);
    near(value("e-p"), 0.5e-4);
    near(value("displacement"), 0.02);
    near(value("surface"), 0.02);
    near(value("edges"), 0.02);
    assert!(value("angles") < 0.05);
}

#[test]
fn an_edge_without_length_at_rest_has_no_change_of_length() {
    // It changed infinitely, and no goal on edges could be met.
    let (mut mesh, now) = (grid(2, 1, |i, j| [f64::from(i), f64::from(j), 0.0]), 1.1);
    mesh.positions[1] = mesh.positions[0];
    let mut scene = Scene::new(MeshSource::File(String::new()));
    scene.current = Some(mesh.positions.iter().map(|[x, y, z]| [now * x, now * y, *z]).collect());
    let moved = scene.current.as_mut().expect("it was set");
    moved[1] = [0.3, 0.0, 0.0];
    let mut session = Session::open(scene, mesh).expect("it opens");
    let values = session.face_values("edges").expect("there is one");
    assert!(values.iter().all(|value| value.is_finite()), "{values:?}");
}

#[test]
fn a_face_in_a_point_has_no_angle_error() {
    // It was 0, the best, and a goal on angles was met by crushing.
    let mut scene = lifted().scene();
    scene.current = Some(vec![[1.0, 2.0, 3.0]; 4]);
    let mut session = Session::open(scene, lifted().mesh().clone()).expect("it opens");
    assert!(session.face_values("angles").expect("there is one")[0].is_nan());
}

#[test]
fn values_of_corners_are_what_their_faces_have_the_largest_of() {
    let mut session = lifted();
    for measure in FACE_MEASURES {
        let Some(corners) = session.corner_values(measure.id) else { continue };
        let faces = session.face_values(measure.id).expect("it is declared");
        assert_eq!(corners.len(), 4);
        assert_eq!(corners.into_iter().fold(0.0, f64::max), faces[0]);
    }
    assert!(session.corner_values("displacement").is_some());
    assert!(session.corner_values("planarity").is_none());
}

#[test]
fn every_measure_is_nothing_for_a_square_at_rest() {
    let mut session = lifted();
    let rest = session.mesh().positions.clone();
    let mut scene = session.scene();
    scene.current = Some(rest);
    session = Session::open(scene, session.mesh().clone()).expect("it opens");
    for measure in FACE_MEASURES {
        let value = session.face_values(measure.id).expect("it is declared")[0];
        // A single face has no curvature.
        let none = measure.id.contains("curvature") && value.is_nan();
        assert!(none || value.abs() < 1e-12, "{}: {value}", measure.id);
    }
    assert!(session.face_values("beauty").is_none());
}

#[test]
fn curvatures_of_faces_have_both_signs_and_the_units_that_they_say() {
    // A dome, a saddle and a vault; also at ten times the size, and with all faces reversed.
    let surface = |bend: [f64; 2], size: f64, flip: bool| {
        let mut mesh = grid(16, 16, |i, j| {
            let [x, y] = [i, j].map(|k| 0.05 * (f64::from(k) - 8.0));
            [x, y, 0.5 * (bend[0] * x * x + bend[1] * y * y)].map(|x| size * x)
        });
        if flip {
            mesh.faces = mesh
                .faces
                .iter()
                .map(|face| face.iter().rev().copied().collect::<Vec<_>>())
                .collect();
        }
        Session::open(Scene::new(MeshSource::File(String::new())), mesh).expect("it opens")
    };
    for (bend, size, flip) in [
        ([-1.0, -0.5], 1.0, false),
        ([-1.0, 1.5], 1.0, false),
        ([0.0, -2.0], 1.0, false),
        ([-1.0, -0.5], 10.0, false),
        ([-1.0, -0.5], 1.0, true),
    ] {
        let mut session = surface(bend, size, flip);
        let middle = 8 * 16 + 8;
        let mut value = |id| session.face_values(id).expect("it is declared")[middle] * size;
        let gauss = bend[0] * bend[1];
        let mean = if flip { 0.5 } else { -0.5 } * (bend[0] + bend[1]);
        assert!((value("gauss-curvature") * size - gauss).abs() < 0.02, "{bend:?}");
        assert!((value("mean-curvature") - mean).abs() < 0.02, "{bend:?} {mean}");
    }
    for measure in FACE_MEASURES {
        assert!(!(measure.signed && measure.toleranced), "a tolerance is a distance from 0");
    }
}

/// The paths of everything in `value` that is null, as a number that is not finite is.
fn nulls(value: &Value, path: &str, found: &mut Vec<String>) {
    match value {
        Value::Null => found.push(path.to_owned()),
        Value::Object(map) => {
            map.iter().for_each(|(key, value)| nulls(value, &format!("{path}.{key}"), found));
        }
        Value::Array(list) => list.iter().for_each(|value| nulls(value, path, found)),
        _ => {}
    }
    found.sort();
    found.dedup();
}

#[test]
fn a_panel_without_area_makes_no_number_undefined() {
    // The mean angle between neighbours was no number, and "rougher" or "flatter" never said.
    let whole = || {
        grid(8, 8, |i, j| {
            [f64::from(i), f64::from(j), f64::from(i * i) * 0.05 - f64::from(j) * 0.1]
        })
    };
    let nulls_after_a_press = |mesh: Mesh| {
        let mut scene = Scene::new(MeshSource::File(String::new()));
        scene.solver.tolerance = 1e-7;
        let mut session = Session::open(scene, mesh).expect("it opens");
        session.make_panels("circle", session.tolerance(), PanelStart::Now).expect("it has quads");
        (0..20_000).find(|_| session.step().expect("it stays finite").ended);
        session.end_run();
        let verdict = session.verdict(session.tolerance()).expect("panels were asked for");
        let report = serde_json::json!({
            "verdict": verdict,
            "report": session.report(),
        });
        let mut found = Vec::new();
        nulls(&report, "", &mut found);
        found
    };
    let expected = nulls_after_a_press(whole());
    // A side, a corner on a neighbour, a whole panel.
    for (vertex, onto) in [(vec![20], 21), (vec![20], 29), (vec![20, 21, 29, 28], 20)] {
        let mut mesh = whole();
        for v in &vertex {
            mesh.positions[*v] = mesh.positions[onto];
        }
        assert_eq!(nulls_after_a_press(mesh), expected, "{vertex:?} onto {onto}");
    }
}
