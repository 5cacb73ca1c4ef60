//! The list of the worst elements agrees with the values that colour the faces and with the worst
//! error of each row of constraints.

use crate::support::grid::grid;
use shape_up::mesh::{Group, GroupKeyword};
use shape_up::scene::Scene;
use shape_up::session::{Edit, FACE_MEASURES, Session};
use shape_up::words;

/// Six by six bumpy quads; the first row is a group.
fn session(constraints: &str) -> Session {
    let mut mesh = grid(6, 6, |i, j| {
        let bump = f64::from((i * i * 5 + j * 7 + i * j * 3) % 11) / 16.0;
        [f64::from(i), f64::from(j), bump]
    });
    mesh.groups = vec![Group {
        name: "eaves".to_owned(),
        keyword: GroupKeyword::Group,
        faces: (0..6).collect(),
        curves: Vec::new(),
    }];
    let text = format!(
        r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "grid.obj" }},
            "constraints": [{constraints}] }}"#
    );
    Session::open(Scene::from_json(&text).expect("the scene is valid"), mesh).expect("it fits")
}

/// Worst error of every enabled row, as the solver found it.
fn worst_of_rows(session: &Session) -> Vec<f64> {
    session.solver().found().map(|found| found.worst_squared.sqrt()).collect()
}

#[test]
fn the_worst_faces_are_those_with_the_largest_values() {
    let mut session = session(r#"{ "kind": "plane", "on": "faces", "name": "Flat" }"#);
    for measure in FACE_MEASURES {
        let values = session.face_values(measure.id).expect("it is declared");
        let worst = session.worst_faces(measure.id, 5, None).expect("it is declared");
        assert_eq!(worst.len(), 5, "{}", measure.id);
        let mut sorted: Vec<f64> = values.iter().copied().filter(|value| !value.is_nan()).collect();
        let size = |value: f64| if measure.signed { value.abs() } else { value };
        sorted.sort_by(|&a, &b| size(b).total_cmp(&size(a)));
        for (element, value) in worst.iter().zip(&sorted) {
            assert_eq!(element.value, *value, "{}", measure.id);
            assert_eq!(values[element.faces[0] as usize], element.value);
            assert_eq!(element.element, format!("face {}", element.faces[0]));
            assert_eq!(element.about.ends_with("eaves"), element.faces[0] < 6);
        }
    }
    let worst = session.worst_faces("planarity", 100, None).expect("it is declared");
    assert_eq!(worst.len(), 36);
    assert!(worst.iter().all(|one| one.row == Some(0) && one.about.starts_with("Flat")));
    assert!(session.worst_faces("beauty", 5, None).is_none());
}

#[test]
fn faces_without_a_value_are_not_in_the_list() {
    let mut mesh = grid(1, 1, |i, j| [f64::from(i), f64::from(j), 0.0]);
    mesh.faces.push(&[0, 1, 3]);
    let scene = Scene::from_json(
        r#"{ "format": "shape-up-scene", "version": 1, "mesh": { "file": "a.obj" } }"#,
    );
    let mut session = Session::open(scene.expect("it is valid"), mesh).expect("it fits");
    let worst = session.worst_faces("diagonals", 9, None).expect("it is declared");
    assert_eq!(worst.iter().map(|one| one.faces[0]).collect::<Vec<_>>(), [0]);
    assert_eq!((worst[0].row, worst[0].about.as_str()), (None, "–"));
}

#[test]
fn the_worst_constraint_of_a_row_has_the_worst_error_of_that_row() {
    let mut session = session(
        r#"{ "kind": "plane", "on": "faces" },
           { "kind": "line", "on": "curves", "enabled": false },
           { "kind": "circle", "on": "faces", "weight": 2 },
           { "kind": "line-segment", "on": "edges", "length": 1 },
           { "kind": "sphere", "on": "rings" },
           { "kind": "line", "on": { "vertices": [0, 1, 8] }, "name": "Rim" },
           { "kind": "on-surface", "on": { "vertices": [9] } }"#,
    );
    for _ in 0..3 {
        session.step().expect("positions stay finite");
        let errors = worst_of_rows(&session);
        for (found, row) in [0, 2, 3, 4, 5, 6].into_iter().enumerate() {
            let worst = session.worst_constraints(row, 8, None);
            let near = (worst[0].value - errors[found]).abs() <= 1e-9 * errors[found];
            assert!(near, "row {row}: {} is not {}", worst[0].value, errors[found]);
            assert!(worst.windows(2).all(|pair| pair[0].value >= pair[1].value));
            assert!(worst.iter().all(|one| one.row == Some(row)));
        }
    }
    assert!(session.worst_constraints(1, 8, None).is_empty(), "the row is off");
    assert!(session.worst_constraints(9, 8, None).is_empty(), "there is no such row");
    assert!(session.worst_constraints(0, 0, None).is_empty());
    let face = &session.worst_constraints(2, 1, None)[0];
    assert_eq!(face.element, format!("face {}", face.faces[0]));
    assert!(face.about.starts_with("Circle"));
    let edge = &session.worst_constraints(3, 1, None)[0];
    assert_eq!(edge.element, format!("edge {}–{}", edge.vertices[0], edge.vertices[1]));
    assert!(edge.faces.is_empty());
    let ring = &session.worst_constraints(4, 1, None)[0];
    assert_eq!(ring.element, format!("vertex {}", ring.vertices[0]));
    let rim = &session.worst_constraints(5, 3, None);
    assert_eq!((rim.len(), rim[0].element.as_str()), (1, "3 vertices"));
    assert_eq!(rim[0].about, "Rim");
    assert_eq!(session.worst_constraints(6, 1, None)[0].element, "1 vertex");
}

#[test]
fn a_face_is_listed_once_though_its_constraint_names_a_corner_for_each_edge() {
    let mut session = session(r#"{ "kind": "equal-length", "on": "faces" }"#);
    for one in session.worst_constraints(0, 36, None) {
        assert_eq!(one.faces.len(), 1, "{one:?}");
        assert_eq!(one.element, format!("face {}", one.faces[0]));
    }
}

#[test]
fn asking_for_the_list_changes_nothing() {
    let rows = r#"{ "kind": "circle", "on": "faces" }"#;
    let (mut asked, mut left) = (session(rows), session(rows));
    for _ in 0..5 {
        asked.worst_faces("planarity", 3, None);
        asked.worst_constraints(0, 3, None);
        asked.step().expect("positions stay finite");
        left.step().expect("positions stay finite");
    }
    assert_eq!(asked.positions(), left.positions());
    asked.edit(Edit::Reset).expect("it can be reset");
}

#[test]
fn the_list_names_the_constraint_and_the_groups_and_rounding_errors_are_zero() {
    let mut session = session(r#"{ "kind": "plane", "on": "faces", "name": "Flat" }"#);
    let rows = session.worst_faces("planarity", 36, None).expect("it is declared");
    for row in &rows {
        assert_eq!(row.words, words::length(row.value, ""));
        let in_group = row.faces[0] < 6;
        assert_eq!(row.about, if in_group { "Flat · eaves" } else { "Flat" });
    }
    assert!(session.worst_faces("beauty", 5, None).is_none());
    let of_row = session.worst_constraints(0, 1, None);
    assert_eq!(of_row[0].words, words::length(of_row[0].value, ""));

    // A flat grid, whose heights are not exact.
    let mesh = grid(2, 2, |i, j| {
        let [x, y] = [0.1 * f64::from(i), 0.7 * f64::from(j)];
        [x, y, x / 3.0 + y / 7.0]
    });
    let text = r#"{ "format": "shape-up-scene", "version": 1, "units": "m", "mesh": { "file": "a.obj" } }"#;
    let mut flat =
        Session::open(Scene::from_json(text).expect("it is valid"), mesh).expect("it fits");
    let rows = flat.worst_faces("planarity", 4, Some(0.001)).expect("it is declared");
    assert_eq!(rows.len(), 4);
    assert!(rows.iter().all(|row| row.words == "0 mm" && row.about == "–"));
    let (values, greatest) = flat.face_values_and_greatest("planarity").expect("it is declared");
    assert_eq!((values.len(), greatest), (4, 0.0));
}

#[test]
fn the_measure_of_a_scene_is_that_of_its_first_row_with_one() {
    let measure = |constraints: &str| session(constraints).scene_measure();
    let [plane, circle, sphere] = ["plane", "circle", "sphere"]
        .map(|kind| format!(r#"{{ "kind": "{kind}", "on": "faces" }}"#));
    let off = r#"{ "kind": "plane", "on": "faces", "enabled": false }"#;
    assert_eq!(measure(""), None);
    assert_eq!(measure(&plane), Some("planarity"));
    assert_eq!(measure(&format!("{sphere}, {circle}, {plane}")), Some("circularity"));
    assert_eq!(measure(&format!("{off}, {circle}")), Some("circularity"));
    // Any other scene is measured by the distances to its constraints.
    assert_eq!(measure(&sphere), Some("residual"));
    assert_eq!(measure(off), Some("residual"));
    assert_eq!(measure(r#"{ "kind": "plane", "on": "rings" }"#), Some("residual"));
    for constraints in [&plane, &circle, &sphere] {
        let mut session = session(constraints);
        let measure = session.scene_measure().expect("there is a constraint");
        let (_, greatest) = session.face_values_and_greatest(measure).expect("it is declared");
        let worst = session.worst_by_scene_measure(0.0);
        assert!((worst - greatest).abs() <= 1e-6 * worst, "{measure}: {worst}, {greatest}");
    }
}
