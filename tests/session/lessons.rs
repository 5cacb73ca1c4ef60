//! Lessons: goals are measured on the current shape, and handed-in results are measured again.

use crate::support::grid::{bumpy, grid};
use serde_json::json;
use shape_up::constraint::Kind;
use shape_up::mesh::{KEPT_TURN, Mesh, Scheme, Subdivision, Topology};
use shape_up::scene::{
    ChosenAttempt, ClosenessTo, EasedFaces, Goal, GoalOf, HandleSpec, Hold, Lesson, Lock, Pose,
    Results, Scene, Target,
};
use shape_up::session::{Edit, Session, check_results};
use shape_up::solve::Require;

/// Planes on all faces, to be reached without large displacements.
pub(super) fn scene() -> Scene {
    let text = r#"{ "format": "shape-up-scene", "version": 1, "title": "Roof", "units": "m",
        "mesh": { "file": "grid.obj" },
        "constraints": [{ "kind": "plane", "on": "faces", "weight": 100, "name": "Panels" }],
        "weights": { "close": 0.01 },
        "lesson": { "text": "Make every panel flat.", "goals": [
            { "measure": "planarity", "at_most": 0.001 },
            { "measure": "displacement", "at_most": 1 },
            { "constraint": "Panels", "at_most": 0.001 } ] } }"#;
    Scene::from_json(text).expect("the scene is valid")
}

pub(super) fn session() -> Session {
    Session::open(scene(), bumpy(5)).expect("it fits")
}

fn met(session: &mut Session) -> Vec<bool> {
    session.goals().iter().map(|goal| goal.met).collect()
}

/// The scene, solved.
fn solved() -> Session {
    let mut session = session();
    session.solve(false).expect("positions stay finite");
    session
}

#[test]
fn goals_are_measured_on_the_shape_as_it_is() {
    let mut session = session();
    assert_eq!(met(&mut session), [false, true, false]);
    let goals = session.goals();
    assert_eq!(goals[0].value, Some(session.measures().planarity.max_distance));
    assert_eq!(goals[1].value, Some(0.0));
    session.solve(false).expect("positions stay finite");
    assert_eq!(met(&mut session), [true; 3], "{:?}", session.goals());
    session.edit(Edit::Reset).expect("it can be reset");
    assert_eq!(met(&mut session), [false, true, false]);
}

#[test]
fn at_most_zero_asks_a_constraint_to_be_exact() {
    let mut exact = scene();
    exact.lesson.as_mut().expect("it has one").goals[2].at_most = 0.0;
    let mut session = Session::open(exact.clone(), bumpy(5)).expect("it fits");
    session.solve(false).expect("positions stay finite");
    assert!(!session.goals()[2].met, "a soft row is not exact: {:?}", session.goals()[2]);
    exact.constraints[0].require = Require::Exact;
    let mut session = Session::open(exact, bumpy(5)).expect("it fits");
    session.solve(false).expect("positions stay finite");
    assert!(session.goals()[2].met, "{:?}", session.goals()[2]);
}

#[test]
fn a_goal_on_a_constraint_is_not_met_by_taking_it_away() {
    let mut session = solved();
    let off = |enabled| Edit::SetConstraint {
        index: 0,
        weight: None,
        require: None,
        enabled: Some(enabled),
        params: Default::default(),
    };
    session.edit(off(false)).expect("there is a row");
    assert_eq!(session.goals()[2].value, None);
    assert_eq!(met(&mut session), [true, true, false]);
    session.edit(off(true)).expect("there is a row");
    assert_eq!(met(&mut session), [true; 3]);
}

#[test]
fn a_row_stays_what_a_goal_is_on() {
    let mut session = solved();
    let renamed = Edit::RenameConstraint { index: 0, name: "Other".to_owned() };
    let removed = Edit::RemoveConstraint { index: 0 };
    for (edit, expected) in [(&renamed, "expected \"Other\""), (&removed, "the scene has none")] {
        let refused = session.edit(edit.clone()).expect_err(expected).to_string();
        assert!(refused.starts_with("lesson.goals[2].constraint: "), "{refused}");
        assert!(refused.contains("\"Panels\"") && refused.contains(expected), "{refused}");
        assert_eq!(session.document(), solved().document());
    }
    // One of two rows with the same name can be removed; both once the lesson is gone.
    session.edit(Edit::DuplicateConstraint { index: 0 }).expect("there is a row");
    session.edit(removed.clone()).expect("another one is called so");
    session.edit(Edit::SetLesson { lesson: None, unsolved: false }).expect("it can be taken away");
    session.edit(renamed).expect("nothing is on it");
    session.edit(removed).expect("nothing is on it");
    while session.undo().expect("the state was solvable").is_some() {}
    assert_eq!(session.document(), solved().document());
}

#[test]
fn a_lesson_is_written_in_one_step_that_leaves_the_solver_alone() {
    let mut session = solved();
    let before = (session.positions(), session.iteration(), session.solver().energy());
    let text = r#"{ "text": "Other", "goals": [{ "measure": "angles", "at_most": 5 }] }"#;
    let lesson = serde_json::from_str::<Lesson>(text).expect("it is valid");
    session
        .edit(Edit::SetLesson { lesson: Some(lesson.clone()), unsolved: false })
        .expect("it can be measured");
    assert_eq!(session.document().lesson.as_ref(), Some(&lesson));
    assert_eq!((session.positions(), session.iteration(), session.solver().energy()), before);
    assert_eq!(session.goals().len(), 1);
    assert_eq!(session.undo().expect("it can be undone").as_deref(), Some("Change lesson"));
    assert_eq!(session.document().lesson, scene().lesson);
    session.edit(Edit::SetLesson { lesson: None, unsolved: false }).expect("it can be taken away");
    assert!(session.goals().is_empty());
    assert_eq!(session.results("Ada", ""), None);
}

#[test]
fn what_is_wrong_in_a_lesson_is_named_by_its_place() {
    let rows = r#"[{ "kind": "plane", "on": "faces", "enabled": false },
        { "kind": "plane", "on": "faces", "name": "Panels" },
        { "kind": "circle", "on": "faces", "name": "Panels" }]"#;
    let in_scene = |rows: &str, lesson: &str, mesh: Mesh| {
        let text = format!(
            r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "a.obj" }},
                "constraints": {rows}, "lesson": {lesson} }}"#
        );
        let opened = Scene::from_json(&text)
            .map_err(shape_up::session::Error::from)
            .and_then(|scene| Session::open(scene, mesh).map(|_| ()));
        opened.expect_err(lesson).to_string()
    };
    for (lesson, place, what) in [
        (r#"3"#, "lesson: ", "expected an object"),
        (
            r#"{ "goals": [{ "measure": "planarity", "at_most": 1 }] }"#,
            "lesson: ",
            "`text` is missing",
        ),
        (r#"{ "text": "" }"#, "lesson: ", "`goals` is missing"),
        (r#"{ "text": "", "goals": [] }"#, "lesson.goals: ", "at least one goal"),
        (r#"{ "text": "", "goals": [{}] }"#, "lesson.goals[0]: ", "has no quantity"),
        (
            r#"{ "text": "", "goals": [{ "measure": "e-p", "constraint": "a", "at_most": 1 }] }"#,
            "lesson.goals[0]: ",
            "has two quantities",
        ),
        (
            r#"{ "text": "", "goals": [{ "measure": "e-p", "at_most": -1 }] }"#,
            "lesson.goals[0].at_most: ",
            "expected a number from 0",
        ),
        (
            r#"{ "text": "", "goals": [{ "measure": "e-p" }] }"#,
            "lesson.goals[0]: ",
            "`at_most` is missing",
        ),
        (
            r#"{ "text": "", "goals": [{ "measure": "beauty", "at_most": 1 }] }"#,
            "lesson.goals[0].measure: ",
            "expected one of planarity, ",
        ),
        (
            r#"{ "text": "", "goals": [{ "constraint": "Panel", "at_most": 1 }] }"#,
            "lesson.goals[0].constraint: ",
            "on the constraint \"Panel\", expected one of \"Panels\", \"Plane\"",
        ),
        (r#"{ "text": "", "locks": [], "goals": [] }"#, "lesson: ", "unknown key `locks`"),
    ] {
        let message = in_scene(rows, lesson, bumpy(5));
        assert!(message.starts_with(place) && message.contains(what), "{message}");
    }
    let points = Mesh { positions: vec![[0.0; 3], [1.0; 3]], ..Mesh::default() };
    let lesson = r#"{ "text": "", "goals": [{ "measure": "planarity", "at_most": 1 }] }"#;
    assert!(in_scene("[]", lesson, points).contains("the mesh has no faces"));
    let lesson = r#"{ "text": "", "goals": [{ "constraint": "Plane", "at_most": 1 }] }"#;
    assert!(
        in_scene("[]", lesson, bumpy(5))
            .contains("expected the name of a constraint, but the scene has none")
    );
}

#[test]
fn results_are_written_read_and_measured_again() {
    let mut session = solved();
    let results = session.results("Ada Lovelace", "2026-11-20T20:00:00Z").expect("it is a lesson");
    assert!(results.passed);
    assert_eq!(results.title, "Roof");
    assert_eq!(results.iterations, session.iteration());
    let again = Results::from_json(&results.to_json()).expect("it was written here");
    assert_eq!(again.to_json(), results.to_json());
    let goals = check_results(&again, scene(), bumpy(5)).expect("they are of this scene").goals;
    assert!(goals.iter().all(|goal| goal.met), "{goals:?}");
    for (measured, said) in goals.iter().zip(&results.goals) {
        let (measured, said) =
            (measured.value.expect("it has one"), said.value.expect("it has one"));
        assert!((measured - said).abs() <= 1e-9 * said.abs() + 1e-12, "{measured} is not {said}");
    }
}

#[test]
fn results_on_the_pose_of_a_scene_are_measured_against_that_pose() {
    // Every face keeps its shape in the pose, twice as large.
    let mut own = scene();
    let pose: Vec<_> = bumpy(5).positions.iter().map(|point| point.map(|x| 2.0 * x)).collect();
    own.pose = Some(Pose::Positions(pose.clone().into()));
    own.constraints[0].kind = Kind::new("rigid", json!({})).expect("it is a kind");
    own.lesson.as_mut().expect("it has one").goals.drain(..2);
    own.current = Some(pose);
    let results = Session::open(own.clone(), bumpy(5)).expect("it fits").results("Ada", "");
    let results = results.expect("it is a lesson");
    assert!(results.passed);
    let checked = check_results(&results, own, bumpy(5)).expect("they are of this scene");
    assert!(checked.goals[0].met, "{checked:?}");
}

#[test]
fn the_distance_to_a_surface_is_checked_against_the_surface_that_the_student_saw() {
    // It was measured against the mesh instead of the surface on which it was laid out.
    let mut own = scene();
    let fine = Subdivision { scheme: Scheme::Linear, levels: 1, keep: KEPT_TURN };
    let fine = fine.apply(&bumpy(5), &Topology::new(&bumpy(5))).expect("it has faces").mesh;
    own.closeness.to = ClosenessTo::Target;
    own.closeness.target = Some(Target::Mesh(fine.into()));
    let goal = Goal { of: GoalOf::Measure("surface".to_owned()), at_most: 0.1 };
    own.lesson.as_mut().expect("it has one").goals = vec![goal];
    own.current = Some(bumpy(5).positions.iter().map(|p| [p[0], p[1], p[2] + 0.03]).collect());
    let results = Session::open(own.clone(), bumpy(5)).expect("it fits").results("Ada", "");
    let results = results.expect("it is a lesson");
    let checked = check_results(&results, own, bumpy(5)).expect("they are of this scene");
    assert_eq!(checked.goals[0].value, results.goals[0].value);
}

#[test]
fn which_panels_the_search_relaxed_is_no_change_by_the_student() {
    let mut own = scene();
    own.lesson.as_mut().expect("it has one").lock = vec![Lock::Constraints];
    own.constraints[0].require = Require::Within(0.1);
    own.constraints[0].eased = Some(EasedFaces { within: 0.2, faces: [3].into() });
    let results = Session::open(own.clone(), bumpy(5)).expect("it fits").results("Ada", "");
    let mut results = results.expect("it is a lesson");
    results.constraints[0].eased = Some(EasedFaces { within: 0.1, faces: [3, 4].into() });
    let checked = check_results(&results, own, bumpy(5)).expect("they are of this scene");
    assert_eq!((checked.altered, checked.changed), (Vec::new(), Vec::<String>::new()));
}

#[test]
fn what_a_search_chose_and_made_exact_is_no_change_by_the_student() {
    let mut own = scene();
    own.lesson.as_mut().expect("it has one").lock = vec![Lock::Weights];
    own.constraints[0].require = Require::Within(0.01);
    own.closeness.to = ClosenessTo::Rest;
    // Ten times it is no number that a tenth of it is.
    own.weights.smooth = 0.11;
    let mut session = Session::open(own.clone(), bumpy(5)).expect("it fits");
    let smoother = ChosenAttempt { smoother: 10.0, on_surface: true, ..ChosenAttempt::default() };
    let mut chosen = session.scene();
    (chosen.attempt, chosen.weights.smooth) = (smoother, 10.0 * chosen.weights.smooth);
    chosen.closeness.to = ClosenessTo::Surface;
    chosen.constraints[0].require = Require::Exact;
    session = Session::open(chosen, bumpy(5)).expect("it fits");
    let results = session.results("Ada", "").expect("it is a lesson");
    let checked = check_results(&results, own, bumpy(5)).expect("they are of this scene");
    assert_eq!((checked.altered, checked.changed), (Vec::new(), Vec::<String>::new()));
}

#[test]
fn a_constraint_that_is_to_be_switched_on_is_measured_for_the_teacher_too() {
    let mut own = scene();
    own.constraints[0].enabled = false;
    let mut session = Session::open(own.clone(), bumpy(5)).expect("it fits");
    assert_eq!(session.goals()[2].value, None);
    let on = r#"{ "setConstraint": { "index": 0, "enabled": true } }"#;
    session.edit(Edit::from_json(on).expect("it is an edit")).expect("it may be switched on");
    session.solve(false).expect("positions stay finite");
    let results = session.results("Ada", "").expect("it is a lesson");
    assert!(results.passed, "{:?}", results.goals);
    let checked = check_results(&results, own, bumpy(5)).expect("they are of this scene");
    assert!(checked.goals.iter().all(|goal| goal.met), "{checked:?}");
}

#[test]
fn results_are_not_believed() {
    let mut session = session();
    let mut results = session.results("Mallory", "").expect("it is a lesson");
    assert!(!results.passed);
    results.passed = true;
    for goal in &mut results.goals {
        goal.met = true;
        goal.value = Some(0.0);
    }
    let goals = check_results(&results, scene(), bumpy(5)).expect("they are of this scene").goals;
    assert_eq!(goals.iter().map(|goal| goal.met).collect::<Vec<_>>(), [false, true, false]);
    results.positions.pop();
    assert!(check_results(&results, scene(), bumpy(5)).is_err());
}

#[test]
fn results_of_another_mesh_or_lesson_are_refused() {
    let results = solved().results("Ada", "").expect("it is a lesson");
    let mut other = bumpy(5);
    other.positions[3][2] += 0.5;
    let refused = check_results(&results, scene(), other).expect_err("it is another mesh");
    assert!(refused.to_string().starts_with("scene: "), "{refused}");
    let mut easier = scene();
    easier.lesson.as_mut().expect("it has one").goals[0].at_most = 1.0;
    assert!(check_results(&results, easier, bumpy(5)).is_err());
    // A student's changes do not make it another exercise.
    let mut changed = scene();
    changed.constraints.clear();
    changed.weights.close = 3.0;
    assert_eq!(changed.fingerprint(&bumpy(5)), scene().fingerprint(&bumpy(5)));
}

#[test]
fn a_file_that_is_not_of_results_is_refused_at_its_place() {
    let results = solved().results("Ada", "").expect("it is a lesson").to_json();
    for (from, to, place) in [
        ("shape-up-results", "shape-up-scene", "format: "),
        (r#""version": 1"#, r#""version": 2"#, "version: "),
        (r#""student""#, r#""pupil""#, ""),
        (r#""met": true"#, r#""met": 1"#, "goals[0].met: "),
        (r#""met": true"#, r#""seen": true, "met": true"#, "goals[0]: unknown key `seen`"),
        (r#""at_most": 0.001"#, r#""at_most": -1"#, "goals[0].at_most: "),
        (r#""kind": "plane""#, r#""kind": "plain""#, "constraints[0].kind: "),
    ] {
        let text = results.replacen(from, to, 1);
        assert_ne!(text, results);
        let error = Results::from_json(&text).expect_err(from);
        assert!(error.to_string().starts_with(place), "{error}");
    }
}

#[test]
fn goals_on_what_is_built_are_told_and_measured_again_when_they_are_handed_in() {
    let mut own = scene();
    let lesson = r#"{ "text": "Flat, and on one sheet.", "goals": [
        { "build": "panel_flatness", "at_most": 0.001 }, { "build": "sheets", "at_most": 1 } ] }"#;
    let read = serde_json::from_str::<Lesson>(lesson).expect("it is a lesson");
    own.lesson = Some(read.clone());
    let again = Scene::from_json(&own.to_json(&bumpy(5))).expect("it reads what it writes");
    assert_eq!(again.lesson, Some(read));

    let mut session = Session::open(own.clone(), bumpy(5)).expect("it fits");
    session.solve(false).expect("positions stay finite");
    assert_eq!(met(&mut session), [false, false], "nobody has built it");
    session
        .set_build_numbers(vec![("panel_flatness".to_owned(), 2e-4), ("sheets".to_owned(), 3.0)]);
    assert_eq!(met(&mut session), [true, false]);
    let results = session.results("Ada", "").expect("there is a lesson");
    assert_eq!(results.goals[1].value, Some(3.0));
    session.edit(Edit::Reset).expect("it can be reset");
    assert_eq!(session.goals()[0].value, None, "of another shape nothing was told");

    // Reported numbers are not trusted: the shape is built again, at 1:50 on one sheet of A3.
    let text = results.to_json();
    let results = Results::from_json(&text).expect("it reads what it writes");
    let checked = check_results(&results, own, bumpy(5)).expect("it is of the scene");
    assert!(checked.goals.iter().all(|goal| goal.met), "{:?}", checked.goals);
    assert_eq!(checked.goals[1].value, Some(1.0));
    let flatness = checked.goals[0].value.expect("it is measured");
    assert!((flatness - session_flatness(&results)).abs() < 1e-9);

    // One damaged file used to end the check of a whole class.
    let mut cut = results.clone();
    cut.positions.truncate(3);
    assert!(check_results(&cut, scene_with(lesson), bumpy(5)).is_err());
    // Numbers are of the settings that they were built with.
    session.set_build_numbers(vec![("sheets".to_owned(), 1.0)]);
    assert!(session.goals()[1].met);
    let edit = Edit::from_json(r#"{ "setBuild": { "values": { "scale": 1 } } }"#);
    session.edit(edit.expect("an edit")).expect("it is valid");
    assert_eq!(session.goals()[1].value, None);
}

#[test]
fn sheets_are_counted_as_the_shape_stands_that_was_handed_in() {
    // Four panels in a row. From one end two by two fit on a sheet; from what is held the short ones do.
    let at = [0.0, 6.0, 10.0, 14.0, 20.0];
    let strip = grid(4, 1, |i, j| [at[i as usize], 3.0 * f64::from(j), 0.0]);
    let own: Scene = Scene::from_json(
        r#"{ "format": "shape-up-scene", "version": 1, "units": "m", "mesh": { "file": "strip.obj" },
        "build": { "names": "assembly", "order": "names", "sheet": [210, 70], "margin": 2, "gap": 1 },
        "lesson": { "text": "", "goals": [{ "build": "sheets", "at_most": 3 }] } }"#,
    )
    .expect("the scene is valid");
    let of = |held: Vec<u32>| {
        let handles = vec![HandleSpec { vertices: held, targets: None, hold: Hold::Fixed }];
        let made = Session::open(own.clone(), strip.clone()).expect("it fits").results("Ada", "");
        let results = Results { handles, ..made.expect("there is a lesson") };
        let checked = check_results(&results, own.clone(), strip.clone()).expect("it is its scene");
        checked.goals[0].value
    };
    let middle = (0..10).filter(|&v| strip.positions[v as usize][0] == 10.0).collect();
    // A file may name what is not there.
    assert_eq!([of(middle), of(vec![10])], [Some(3.0), Some(2.0)]);
}

fn scene_with(lesson: &str) -> Scene {
    Scene {
        lesson: Some(serde_json::from_str::<Lesson>(lesson).expect("it is a lesson")),
        ..scene()
    }
}

/// Largest distance of a panel to its plane, as the session measures it.
fn session_flatness(results: &Results) -> f64 {
    let mut own = scene();
    own.current = Some(results.positions.clone());
    let session = Session::open(own, bumpy(5)).expect("it fits");
    session.measures().planarity.max_distance
}

#[test]
fn a_goal_on_something_that_is_not_built_is_refused() {
    let mut own = scene();
    let goal = r#"{ "text": "", "goals": [{ "build": "warp", "at_most": 1 }] }"#;
    own.lesson = Some(serde_json::from_str::<Lesson>(goal).expect("it is a lesson"));
    let refused = Session::open(own, bumpy(5)).err().expect("there is none").to_string();
    assert!(
        refused.contains("lesson.goals[0].build") && refused.contains("beam_warp"),
        "{refused}"
    );
}

#[test]
fn a_signed_measure_is_bounded_on_both_sides() {
    // A saddle passed "at most 0.01 of Gauss curvature", because it is below 0.
    let saddle = grid(6, 6, |i, j| {
        let [x, y] = [i, j].map(|k| f64::from(k) - 3.0);
        [x, y, 0.3 * x * y]
    });
    let text = r#"{ "format": "shape-up-scene", "version": 1, "mesh": { "file": "grid.obj" },
        "lesson": { "text": "Lay it flat.", "goals": [
            { "measure": "gauss-curvature", "at_most": 0.01 },
            { "measure": "gauss-curvature", "beyond": 0.01, "at_most": 0 } ] } }"#;
    let scene = Scene::from_json(text).expect("the scene is valid");
    let mut session = Session::open(scene, saddle).expect("it fits");
    assert_eq!(met(&mut session), [false, false], "{:?}", session.goals());
    let worst = session.worst_faces("gauss-curvature", 1, None).expect("it is a measure");
    assert_eq!(session.goals()[0].value, Some(worst[0].value.abs()));
    let request = r#"{ "operation": "error", "mode": "faces",
        "params": { "measure": "gauss-curvature", "tolerance": 0.01 } }"#;
    let request = serde_json::from_str(request).expect("it is a request");
    let beyond = session.select(&request).expect("it is a measure").faces.len();
    assert_eq!(session.goals()[1].value, Some(beyond as f64));
}
