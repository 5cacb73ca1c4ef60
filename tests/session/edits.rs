//! Edits of whole constraint rows, settings and handles: each has an effect and can be undone.

use crate::support::grid::grid;
use serde_json::{Map, Value, json};
use shape_up::constraint::{Selector, Set};
use shape_up::mesh::{Group, GroupKeyword};
use shape_up::scene::{
    Accelerator, AttemptStart, ClosenessTo, ConstraintSpec, EasedFaces, Hold, MeshSource, Require,
    Scene, Slide, Weights,
};
use shape_up::session::{Edit, Error, PanelStart, Session};

/// A bumpy grid of five by five quads with planes on all faces and closeness to the rest shape.
fn session() -> Session {
    let mesh =
        grid(5, 5, |i, j| [f64::from(i), f64::from(j), f64::from((i * 5 + j * 7) % 4) / 8.0]);
    let text = r#"{ "format": "shape-up-scene", "version": 1, "mesh": { "file": "grid.obj" },
        "constraints": [{ "kind": "plane", "on": "faces", "weight": 3 }],
        "closeness": { "to": "rest" } }"#;
    let mut scene = Scene::from_json(text).expect("the scene is valid");
    scene.weights = Weights { shape: 5.0, close: 1.0, smooth: 0.0 };
    scene.mesh = MeshSource::Inline(Box::new(mesh.clone()));
    Session::open(scene, mesh).expect("it fits")
}

fn run(session: &mut Session) {
    for _ in 0..60 {
        session.step().expect("positions stay finite");
    }
}

fn distance(session: &Session, vertex: usize) -> f64 {
    let (now, rest) = (session.positions()[vertex], session.mesh().positions[vertex]);
    (0..3).map(|axis| (now[axis] - rest[axis]).powi(2)).sum::<f64>().sqrt()
}

fn set_build<const N: usize>(values: [(&str, Value); N]) -> Edit {
    let values = values.map(|(path, value)| (path.to_owned(), value));
    Edit::SetBuild { values: Map::from_iter(values) }
}

#[test]
fn settings_of_build_are_changed_one_by_one() {
    // All of them were sent, so that one came back whose change was just undone.
    let mut session = session();
    for edit in [
        set_build([("scale", json!(20))]),
        set_build([("sheet[0]", json!(600))]),
        set_build([("sheet[1]", json!(400)), ("limits.warp", json!(3))]),
    ] {
        session.edit(edit).expect("it is valid");
    }
    let own = |session: &Session| *session.document().build.clone().expect("there are settings");
    let now = own(&session);
    assert_eq!((now.scale, now.sheet, now.limits.warp), (20.0, [600.0, 400.0], 3.0));
    for (path, value, place) in [
        ("sheet", json!([8, 297]), "build.margin"),
        ("scale", json!(0), "build.scale"),
        ("scale", json!("large"), "build.scale"),
        ("colour", json!("red"), "build.colour"),
    ] {
        match session.edit(set_build([(path, value)])) {
            Err(Error::Scene(error)) => assert_eq!(error.path, place),
            other => panic!("{path}: {other:?}"),
        }
        assert_eq!(own(&session), now);
    }
}

#[test]
fn only_what_changes_the_problem_or_the_shape_is_another_generation() {
    let mut session = session();
    let mut goes_on = |edit: Edit| {
        let before = session.generation();
        session.edit(edit).expect("it is valid");
        let after = session.generation();
        session.undo().expect("it can be undone");
        assert_eq!(session.generation() != after, after != before, "undo is like the edit");
        session.redo().expect("it can be done again");
        after != before
    };
    let faces = vec![1, 2];
    for edit in [
        Edit::RenameConstraint { index: 0, name: "Roof".to_owned() },
        set_build([("scale", json!(20))]),
        Edit::SetSteps { steps: vec![Slide { title: "Now".to_owned(), ..Slide::default() }] },
        Edit::NameSet { name: "two".to_owned(), vertices: Vec::new(), faces },
        Edit::SetUnits { units: "m".to_owned() },
    ] {
        assert!(!goes_on(edit.clone()), "{edit:?}");
    }
    let weights = Weights { shape: 7.0, close: 1.0, smooth: 0.0 };
    for edit in [
        Edit::SetWeights(weights.into()),
        Edit::AddHandles { vertices: vec![3], fixed: false },
        Edit::RemoveConstraint { index: 0 },
    ] {
        assert!(goes_on(edit.clone()), "{edit:?}");
    }
}

#[test]
fn a_row_is_duplicated_with_all_that_it_is() {
    let mut session = session();
    session.edit(Edit::DuplicateConstraint { index: 0 }).expect("there is a row");
    let rows = &session.document().constraints;
    assert_eq!(rows.len(), 2);
    assert_eq!(rows[0], rows[1]);
    let numbers = |session: &Session| -> Vec<u32> {
        session.document().constraints.iter().map(|row| row.number.get()).collect()
    };
    let both = numbers(&session);
    assert_ne!(both[0], both[1], "each row has a number of its own");
    assert!(session.edit(Edit::DuplicateConstraint { index: 2 }).is_err());
    assert_eq!(session.undo().expect("it can be undone").as_deref(), Some("Duplicate plane"));
    assert_eq!(session.document().constraints.len(), 1);
    // An edit of a row reached another one that was alike.
    session.redo().expect("it can be redone");
    session.edit(Edit::RenameConstraint { index: 1, name: "Roof".to_owned() }).expect("valid");
    session.edit(Edit::RemoveConstraint { index: 0 }).expect("there is a row");
    assert_eq!(numbers(&session), both[1..]);
    session.undo().expect("it can be undone");
    assert_eq!(numbers(&session), both);
}

#[test]
fn a_row_is_named_in_one_step_that_leaves_the_solver_alone() {
    let mut session = session();
    run(&mut session);
    let before = (session.solver().energy(), session.iteration());
    let rename = |index, name: &str| Edit::RenameConstraint { index, name: name.to_owned() };
    session.edit(rename(0, "Skylight is flat")).expect("there is a row");
    assert_eq!(session.document().constraints[0].label(), "Skylight is flat");
    assert_eq!((session.solver().energy(), session.iteration()), before);
    assert!(session.edit(rename(1, "No such row")).is_err());
    let text = session.scene().to_json(session.mesh());
    assert!(text.contains(r#""name": "Skylight is flat""#), "{text}");
    let again = Scene::from_json(&text).expect("it was written here");
    assert_eq!(again.constraints, session.document().constraints);
    assert_eq!(session.undo().expect("it can be undone").as_deref(), Some("Rename plane"));
    assert_eq!(session.document().constraints[0].label(), "Plane");
    session.redo().expect("it can be done again");
    session.edit(rename(0, "")).expect("there is a row");
    assert_eq!(session.document().constraints[0].label(), "Plane");
}

#[test]
fn vertices_that_are_held_more_move_less_and_those_let_go_more() {
    let vertices = vec![14, 15, 20, 21];
    let mut moved = Vec::new();
    for weight in [0.0, 1.0, 100.0] {
        let mut session = session();
        let hold = Edit::HoldClose { vertices: Some(vertices.clone()), weight };
        session.edit(hold).expect("the vertices are there");
        run(&mut session);
        moved.push(vertices.iter().map(|&v| distance(&session, v as usize)).sum::<f64>());
        let others = if weight == 1.0 { 0 } else { 4 };
        assert_eq!(session.reweighted_vertices(), others);
        session.edit(Edit::HoldClose { vertices: None, weight: 1.0 }).expect("it is plain");
        assert_eq!(session.reweighted_vertices(), 0);
    }
    assert!(moved[0] > 1.2 * moved[1] && moved[1] > 3.0 * moved[2], "{moved:?}");
    let mut session = session();
    for (vertex, weight) in [(99, 2.0), (3, -1.0), (3, f64::NAN)] {
        assert!(session.edit(Edit::HoldClose { vertices: Some(vec![vertex]), weight }).is_err());
        assert_eq!(session.reweighted_vertices(), 0);
    }
}

#[test]
fn settings_act_on_the_solver_and_are_undone() {
    let mut session = session();
    let set = |id: &str, value| Edit::Set { id: id.to_owned(), value };
    session.edit(set("closeness", json!("none"))).expect("it is declared");
    assert_eq!(session.document().closeness.to, ClosenessTo::None);
    session.step().expect("positions stay finite");
    assert_eq!(session.solver().energy().close, 0.0);
    session.edit(set("accelerator", json!("none"))).expect("it is declared");
    assert_eq!(session.document().solver.accelerator, Accelerator::None);
    // Cotangent weights need triangles: the edit changes nothing and the error gives the reason.
    let refused = session.edit(set("weighting", json!("cotangent"))).expect_err("these are quads");
    assert!(refused.to_string().contains("triangle"), "{refused}");
    assert_eq!(session.undo().expect("undo works").as_deref(), Some("Change setting: Accelerator"));
    assert_eq!(session.undo().expect("undo works").as_deref(), Some("Change setting: Stay near"));
    assert_eq!(session.document().closeness.to, ClosenessTo::Rest);
}

#[test]
fn the_boundary_stays_on_its_curve_when_it_is_told_to() {
    let mut session = session();
    for (id, value) in [("corners", json!(60)), ("boundary", json!("exact"))] {
        session.edit(Edit::Set { id: id.to_owned(), value }).expect("it is declared");
    }
    run(&mut session);
    for corner in [0, 5, 30, 35] {
        assert_eq!(distance(&session, corner), 0.0, "a corner stays");
    }
}

#[test]
fn handles_get_a_weight_and_pull_as_hard() {
    let mut session = session();
    session.edit(Edit::AddHandles { vertices: vec![14], fixed: true }).expect("it is there");
    let weigh = |weight| Edit::WeighHandles { vertices: vec![14], weight };
    session.edit(weigh(7.5)).expect("it is a handle");
    assert_eq!(session.solver().handles()[0].hold, Hold::Soft { weight: 7.5 });
    for weight in [0.0, -1.0, f64::NAN] {
        assert!(session.edit(weigh(weight)).is_err());
    }
    session.undo().expect("undo works");
    assert_eq!(session.solver().handles()[0].hold, Hold::Fixed);
}

#[test]
fn numbers_of_a_boundary_that_is_free_leave_the_problem_as_it_is() {
    // The solver was set up anew, and what was found for the shape was out of date.
    let mut session = session();
    let set = |id: &str, value: Value| Edit::Set { id: id.to_owned(), value };
    for (value, hold, counts) in [(30, "off", false), (60, "soft", true)] {
        session.edit(set("boundary", json!(hold))).expect("it is one of its words");
        for id in ["corners", "boundary-weight"] {
            let generation = session.generation();
            assert!(session.edit(set(id, json!(value))).expect("it is in range"));
            assert_eq!(session.generation() != generation, counts, "{id}, {hold}");
        }
    }
}

/// The tolerance was kept by the page alone: another reader of the scene judged by another one.
#[test]
fn the_tolerance_is_that_of_the_scene_or_of_its_panels_or_of_the_mesh() {
    let mut session = session();
    let own = session.tolerance();
    assert_eq!(own, 1e-3, "a thousandth of the mean edge, rounded");
    let set = |tolerance| Edit::SetTolerance { tolerance };
    let generation = session.generation();
    assert!(!session.edit(set(Some(0.05))).expect("it is valid"), "it is no step of undo");
    assert_eq!((session.tolerance(), session.generation()), (0.05, generation));
    let mesh = session.mesh().clone();
    let read = Session::open(session.scene(), mesh).expect("it is the same scene");
    assert_eq!(read.tolerance(), 0.05, "it is in the file");

    session.make_panels("plane", 0.02, PanelStart::Now).expect("there are quads");
    assert_eq!(session.tolerance(), 0.02, "the panels were asked for within another one");
    session.edit(set(Some(0.07))).expect("it is valid");
    assert!(session.is_running(), "it is judged otherwise, and goes on");
    session.end_run();
    assert_eq!(session.tolerance(), 0.07);
    session.edit(set(None)).expect("it is valid");
    assert_eq!(session.tolerance(), 0.02);

    session.undo().expect("it can be undone");
    session.edit(set(Some(0.3))).expect("it is valid");
    assert!(session.undo_and_redo()[1].is_some(), "it keeps Redo");
    // A step that has not changed it does not take it back.
    session.edit(Edit::SetUnits { units: "m".to_owned() }).expect("any unit will do");
    session.edit(set(Some(0.4))).expect("it is valid");
    session.undo().expect("it can be undone");
    assert_eq!((session.tolerance(), &*session.document().units), (0.4, ""));
    for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = session.edit(set(Some(wrong))).expect_err("it is no length").to_string();
        assert_eq!(error, format!("tolerance: found {wrong}, expected a length above 0"));
    }
}

#[test]
fn what_is_refused_or_changes_nothing_leaves_a_run_under_way() {
    // A search that was interrupted by a wrong number began again, and became a step of its own.
    let mut session = session();
    session.begin_run();
    for _ in 0..3 {
        session.step().expect("positions stay finite");
    }
    let refused = Edit::Set { id: "window".to_owned(), value: json!(0.5) };
    assert!(session.edit(refused).is_err());
    // What is found only where the mesh is asked.
    for (id, value) in [("weighting", "cotangent"), ("closeness", "target")] {
        let refused = Edit::Set { id: id.to_owned(), value: json!(value) };
        assert!(session.edit(refused).is_err(), "{id}");
        assert!(session.is_running(), "{id}");
    }
    let same = Edit::SetWeights(session.document().weights.into());
    assert!(!session.edit(same).expect("it is valid"));
    assert!(session.is_running());
    let other = Edit::SetUnits { units: "km".to_owned() };
    assert!(session.edit(other).expect("it is valid"));
    assert!(!session.is_running());
    assert_eq!(session.undo_and_redo()[0], Some("Change unit"));
}

#[test]
fn a_set_cannot_take_the_name_of_a_group() {
    // What was on the group was on the set then, also where a lesson locks the constraints.
    let mut mesh = grid(2, 2, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let (name, keyword) = ("Roof".to_owned(), GroupKeyword::Group);
    mesh.groups.push(Group { name, keyword, faces: vec![0, 1], curves: Vec::new() });
    let text = r#"{ "format": "shape-up-scene", "version": 1, "mesh": { "file": "grid.obj" },
        "constraints": [{ "kind": "plane", "on": { "set": "Roof" } }] }"#;
    let scene = Scene::from_json(text).expect("the scene is valid");
    let mut session = Session::open(scene, mesh.clone()).expect("it fits");
    let roof = Edit::NameSet { name: "Roof".to_owned(), vertices: Vec::new(), faces: vec![3] };
    let error = session.edit(roof.clone()).expect_err("it is that of a group").to_string();
    let expected =
        "sets: found \"Roof\", the name of a group of the mesh, expected one that no group has";
    assert_eq!(error, expected);
    // Where the file has both, the set cannot leave its constraints to the group.
    let mut both = session.scene();
    both.sets.insert("Roof".to_owned(), Set { faces: [3].into(), ..Set::default() });
    let mut session = Session::open(both, mesh).expect("it fits");
    session.edit(roof).expect("it is a set already");
    session.edit(Edit::RemoveSet { name: "Roof".to_owned() }).expect_err("it is used");
    // Nor does a set that gets its name of itself.
    let mut mesh = session.mesh().clone();
    mesh.groups[0].name = "selection 1".to_owned();
    let mut session =
        Session::open(Scene::new(MeshSource::Inline(Box::default())), mesh).expect("it fits");
    let (on, set) = (json!({ "each": "face", "in": "" }), json!({ "faces": [3] }));
    let add = json!({ "addConstraint": { "kind": "plane", "on": on, "set": set, "weight": 1 } });
    let add = add.to_string();
    session.edit(Edit::from_json(&add).expect("it is an edit")).expect("it fits");
    assert_eq!(session.document().sets.keys().collect::<Vec<_>>(), ["selection 2"]);
}

#[test]
fn panels_are_judged_as_before_where_another_constraint_is_relaxed() {
    // 50 mm of a sphere became the tolerance of the panels.
    let mut session = session();
    let sphere = r#"{ "addConstraint": { "kind": "sphere", "weight": 1, "on": { "vertices": [0, 1, 2, 3, 4, 5] } } }"#;
    let require = |index: usize, require: &str| {
        let text =
            format!(r#"{{ "setConstraint": {{ "index": {index}, "require": {require} }} }}"#);
        Edit::from_json(&text).expect("it is an edit")
    };
    let sphere = Edit::from_json(sphere).expect("it is an edit");
    for edit in [sphere, require(0, r#"{ "within": 0.001 }"#), require(1, "\"exact\"")] {
        session.edit(edit).expect("it is valid");
    }
    session.edit(require(1, r#"{ "within": 0.05 }"#)).expect("it is valid");
    assert_eq!(session.tolerance(), 0.001);
}

#[test]
fn an_attempt_is_that_of_the_hard_constraints_for_which_it_was_chosen() {
    // Others were tried from the rest shape alone, with the smoothness of the search, and were said to
    // be impossible; and panels stayed within the larger tolerance that they had needed beside a
    // constraint that was off by then.
    let mut scene = session().scene();
    (scene.attempt.from, scene.attempt.smoother) = (AttemptStart::Rest, 10.0);
    scene.weights.smooth = 20.0;
    scene.constraints[0].require = Require::Within(0.01);
    scene.constraints[0].eased = Some(EasedFaces { within: 0.1, faces: [3, 4].into() });
    let sphere = scene.constraints[0].clone();
    scene.constraints.push(ConstraintSpec { on: Selector::Vertices((0..9).collect()), ..sphere });
    let eased = |session: &Session| session.document().constraints[0].eased.clone();
    let found = scene.constraints[0].eased.clone();
    scene.constraints[1].eased = None;
    let mut session = Session::open(scene, session().mesh().clone()).expect("it fits");
    let from = |session: &Session| {
        let Scene { attempt, weights, .. } = session.document();
        (attempt.from, attempt.smoother, weights.smooth)
    };
    let [chosen, own] = [(AttemptStart::Rest, 10.0, 20.0), (AttemptStart::Soft, 1.0, 2.0)];
    let edit = |text: &str| Edit::from_json(text).expect("it is an edit");
    session.edit(edit(r#"{ "setConstraint": { "index": 0, "weight": 7 } }"#)).expect("valid");
    assert_eq!((from(&session), eased(&session)), (chosen, found.clone()));
    for other in [
        r#"{ "setConstraint": { "index": 0, "require": "exact" } }"#,
        r#"{ "setConstraint": { "index": 0, "enabled": false } }"#,
        r#"{ "setConstraint": { "index": 1, "enabled": false } }"#,
        r#"{ "removeConstraint": { "index": 1 } }"#,
        r#"{ "fitTo": { "name": "a.obj", "text": "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3" } }"#,
    ] {
        session.edit(edit(other)).expect("it is valid");
        assert_eq!((from(&session), eased(&session)), (own, None), "{other}");
        session.undo().expect("it was solvable");
        let back = (from(&session), eased(&session));
        assert_eq!(back, (chosen, found.clone()), "{other}");
    }
}
