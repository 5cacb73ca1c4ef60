//! The tables that a session exports agree with its report.

use crate::support::grid::grid;
use shape_up::mesh::{Group, GroupKeyword};
use shape_up::scene::Scene;
use shape_up::session::{Edit, FACE_MEASURES, Session};

fn open() -> Session {
    let text = r#"{ "format": "shape-up-scene", "version": 1, "units": "m",
        "mesh": { "file": "grid.obj" }, "constraints": [{ "kind": "circle", "on": "faces" }],
        "weights": { "shape": 5, "close": 1, "smooth": 0.5 } }"#;
    let mut mesh =
        grid(3, 2, |i, j| [f64::from(i), f64::from(j), f64::from((i * 5 + j * 7) % 4) / 8.0]);
    let group = |name: &str, faces: &[u32]| Group {
        name: name.to_owned(),
        keyword: GroupKeyword::Group,
        faces: faces.to_vec(),
        curves: Vec::new(),
    };
    mesh.groups = vec![group("roof, \"east\"", &[0, 1]), group("eaves", &[1])];
    let mut session =
        Session::open(Scene::from_json(text).expect("it is valid"), mesh).expect("it is solvable");
    session.start_trace();
    session
}

/// Numbers of the column whose head begins with `name`.
fn column(csv: &str, name: &str) -> Vec<f64> {
    let mut lines = csv.lines();
    let heads: Vec<&str> = lines.next().expect("there is a head").split(',').collect();
    // Counted from the right: a quoted field may contain commas.
    let from_right =
        heads.len() - heads.iter().position(|head| head.starts_with(name)).expect(name);
    lines
        .map(|line| line.rsplit(',').nth(from_right - 1).expect("rows are whole"))
        .map(|field| field.parse().expect("it is a number"))
        .collect()
}

#[test]
fn the_errors_of_the_faces_are_those_of_the_report() {
    let mut session = open();
    session.solve(false).expect("it stays finite");
    let csv = session.errors_csv();
    let report = session.report();
    let head = csv.lines().next().expect("there is a head");
    assert!(
        head.starts_with("face,corners,groups,Planarity (m),Planarity: diagonals (%)"),
        "{head}"
    );
    assert_eq!(head.split(',').count(), 3 + FACE_MEASURES.len());
    let lines: Vec<&str> = csv.lines().skip(1).collect();
    assert_eq!(lines.len(), report.faces);
    assert!(lines[0].starts_with(r#"0,4,"roof, ""east""","#), "{}", lines[0]);
    assert!(lines[1].starts_with(r#"1,4,"roof, ""east"" eaves","#), "{}", lines[1]);
    assert!(lines[2].starts_with("2,4,,"), "{}", lines[2]);
    let most = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
    for (name, expected) in [
        ("Planarity (m)", report.planarity.max_distance),
        ("Planarity: as in the paper", report.planarity.e_p_max),
        ("Circularity (m)", report.circularity.max_distance),
        ("Circularity: as in the paper", report.circularity.e_c_max),
    ] {
        assert_eq!(most(&column(&csv, name)), expected, "{name}: to the last bit");
    }
    let residuals = column(&csv, "Constraints (m)");
    assert_eq!(Some(residuals), session.face_values("residual"));
}

#[test]
fn the_convergence_is_the_trace_of_the_report() {
    let mut session = open();
    session.begin_run();
    for _ in 0..7 {
        session.step().expect("it stays finite");
    }
    assert_eq!(session.trace().len(), 8);
    let csv = session.convergence_csv();
    let trace = session.report().trace.expect("it was asked for");
    assert_eq!(column(&csv, "iteration"), (0..8).map(f64::from).collect::<Vec<_>>());
    let totals: Vec<f64> = trace.iter().map(|entry| entry.energy.total).collect();
    assert_eq!(column(&csv, "total (m²)"), totals);
    session.end_run();
    session.undo().expect("it was solvable");
    assert_eq!(session.convergence_csv().lines().count(), 2, "what is undone is not told");
}

#[test]
fn an_edit_changes_the_energies_of_the_iteration_that_it_is_made_at() {
    let mut session = open();
    let before = column(&session.convergence_csv(), "shape (m²)");
    session
        .edit(Edit::SetConstraint {
            index: 0,
            weight: Some(2.0),
            require: None,
            enabled: None,
            params: Default::default(),
        })
        .expect("a weight can be two");
    let after = column(&session.convergence_csv(), "shape (m²)");
    assert_eq!(after.len(), 1);
    assert!((after[0] / before[0] - 2.0).abs() < 1e-12, "{before:?} {after:?}");
    session.undo().expect("it was solvable");
    assert_eq!(column(&session.convergence_csv(), "shape (m²)"), before);
}
