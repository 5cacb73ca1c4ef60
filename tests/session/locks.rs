//! Locks of a lesson refuse every edit of the locked part, and alterations in a file are detected.

use crate::support::grid::{bumpy, grid};
use shape_up::mesh::Mesh;
use shape_up::scene::{
    BoundaryRequire, ChosenAttempt, ClosenessTo, Lock, NamedEnum, Results, Scene,
};
use shape_up::session::Error;
use shape_up::session::{DragPhase, Edit, PanelStart, Session, check_results};

const VARIANT: &str = r#"{ "goToVariant": { "index": 0 } }"#;

/// Edits of each locked part.
const EDITS: &[(Lock, &str)] = &[
    (Lock::Weights, r#"{ "setWeights": { "close": 3 } }"#),
    (Lock::Weights, r#"{ "set": { "id": "closeness", "value": "rest" } }"#),
    (Lock::Weights, r#"{ "setConstraint": { "index": 0, "weight": 3 } }"#),
    (Lock::Weights, r#"{ "holdClose": { "weight": 3, "vertices": [1] } }"#),
    (Lock::Weights, VARIANT),
    (Lock::Constraints, r#"{ "setConstraint": { "index": 0, "require": "exact" } }"#),
    (Lock::Constraints, r#"{ "setConstraint": { "index": 0, "enabled": false } }"#),
    (Lock::Constraints, r#"{ "duplicateConstraint": { "index": 0 } }"#),
    (Lock::Handles, r#"{ "addHandles": { "vertices": [3], "fixed": true } }"#),
    (Lock::Handles, r#"{ "removeHandles": { "vertices": [0] } }"#),
    (Lock::Handles, VARIANT),
    (Lock::Mesh, r#"{ "refine": { "scheme": "linear", "levels": 1 } }"#),
    (Lock::Mesh, r#"{ "setUnits": { "units": "km" } }"#),
];

fn scene(lock: &str) -> Scene {
    let text = r#"{ "format": "shape-up-scene", "version": 1, "title": "Roof", "units": "m",
        "mesh": { "file": "grid.obj" },
        "constraints": [{ "kind": "plane", "on": "faces" }],
        "handles": [{ "vertices": [0] }],
        "lesson": { "text": "Flat.", "lock": LOCK, "goals": [
            { "measure": "planarity", "beyond": 0.001, "at_most": 3 } ] } }"#;
    Scene::from_json(&text.replace("LOCK", lock)).expect("the scene is valid")
}

fn session(lock: &str) -> Session {
    let mut session = Session::open(scene("[]"), bumpy(5)).expect("it fits");
    let start = session.positions().into();
    session.edit(Edit::KeepVariant { start }).expect("there is room");
    let mut opened = session.scene();
    opened.lesson = scene(lock).lesson;
    Session::open(opened, bumpy(5)).expect("it fits")
}

fn refused(outcome: Result<bool, Error>) -> bool {
    match outcome {
        Err(Error::Scene(error)) => {
            error.path == "lesson.lock" && error.message.contains("locked by the lesson")
        }
        Err(other) => panic!("{other}"),
        Ok(_) => false,
    }
}

#[test]
fn each_lock_refuses_the_edits_of_its_part_and_no_other() {
    for lock in Lock::WORDS {
        for (part, edit) in EDITS.iter().filter(|(_, edit)| *edit != VARIANT) {
            let mut session = session(&format!("[\"{}\"]", lock.0));
            let before = session.scene();
            let edit = Edit::from_json(edit).expect("it is an edit");
            let outcome = session.edit(edit.clone());
            // The weight of a constraint belongs to both locks, weights and constraints.
            let of_both = matches!(edit, Edit::SetConstraint { weight: Some(_), .. });
            let expected = *part == lock.1 || of_both && lock.1 == Lock::Constraints;
            assert_eq!(refused(outcome), expected, "{edit:?} under {lock:?}");
            assert_eq!(session.scene() == before, expected, "{edit:?} under {lock:?}");
        }
    }
}

#[test]
fn a_lesson_with_locks_is_given_on_again_as_it_is() {
    let mut session = session(r#"["mesh", "constraints"]"#);
    let lesson = session.document().lesson.clone();
    session.solve(false).expect("it can be solved");
    let same = Edit::SetLesson { lesson, unsolved: true };
    assert!(session.edit(same).expect("the lesson stays as it is"));
    assert_eq!(session.moved().max, 0.0, "students start unsolved");
    assert!(session.document().variants.kept.is_empty());
}

#[test]
fn nothing_gets_round_a_lock() {
    for (part, edit) in EDITS {
        let mut session = session(r#"["weights", "constraints", "handles", "mesh"]"#);
        let edit = Edit::from_json(edit).expect("it is an edit");
        let before = session.scene();
        assert!(refused(session.edit(edit.clone())), "{part:?} {edit:?}");
        assert!(refused(session.edit_and_run(edit).map(|()| true)), "{part:?}");
        for lesson in [None, scene("[]").lesson] {
            assert!(refused(session.edit(Edit::SetLesson { lesson, unsolved: false })));
        }
        assert!(refused(session.make_panels("plane", 0.1, PanelStart::Now).map(|()| true)));
        for phase in [DragPhase::Make, DragPhase::Start] {
            let dragged = session.drag_through(phase, &[0], &[[9.0; 3]]);
            assert!(refused(dragged.map(|()| true)));
        }
        assert_eq!(session.scene(), before);
        // Solving, undo and solver settings remain available to the student.
        let solver = r#"{ "set": { "id": "window", "value": 3 } }"#;
        let solver = Edit::from_json(solver).expect("it is an edit");
        session.edit(solver).expect("it is not locked");
        session.solve(false).expect("positions stay finite");
        session.edit(Edit::Reset).expect("it is not locked");
    }
}

#[test]
fn a_lesson_that_is_saved_unsolved_starts_at_rest() {
    let mut session = session("[]");
    session.solve(false).expect("positions stay finite");
    let solved = session.scene();
    assert!(solved.current.is_some());
    let lesson = scene(r#"["mesh"]"#).lesson;
    session.edit(Edit::SetLesson { lesson, unsolved: true }).expect("nothing is locked yet");
    assert_eq!(session.positions(), bumpy(5).positions);
    assert_eq!(session.iteration(), 0);
    assert!(session.document().variants.kept.is_empty(), "a variant may be the solution");
    session.undo().expect("it can be undone");
    assert_eq!(session.scene(), solved);
}

#[test]
fn a_lesson_that_is_saved_unsolved_is_as_it_was_asked_for() {
    // It named the attempt that solved it, and had its smoothness and its relaxed tolerance.
    let mut solved = scene("[]");
    let text = r#"{ "from": "eased", "smoother": 10, "on_surface": true, "holds_boundary": true }"#;
    solved.attempt = serde_json::from_str(text).expect("it is an attempt");
    (solved.weights.smooth, solved.closeness.to) = (5.0, ClosenessTo::Surface);
    let lesson = solved.lesson.clone();
    let mut session = Session::open(solved, bumpy(5)).expect("it fits");
    session.edit(Edit::SetLesson { lesson, unsolved: true }).expect("nothing is locked");
    let asked = session.document();
    assert_eq!(asked.attempt, ChosenAttempt::default());
    assert_eq!((asked.weights.smooth, asked.closeness.to), (0.5, ClosenessTo::Rest));
}

#[test]
fn what_a_search_has_chosen_does_not_become_the_students_where_it_is_locked() {
    // The teacher's check said that the student had altered it.
    let mut solved = scene(r#"["weights"]"#);
    let text = r#"{ "from": "rest", "smoother": 10, "on_surface": true }"#;
    solved.attempt = serde_json::from_str(text).expect("it is an attempt");
    (solved.weights.smooth, solved.closeness.to) = (5.0, ClosenessTo::Surface);
    let mut session = Session::open(solved, bumpy(5)).expect("it fits");
    for same in [
        r#"{ "set": { "id": "closeness", "value": "surface" } }"#,
        r#"{ "setWeights": { "smooth": 5 } }"#,
    ] {
        assert!(refused(session.edit(Edit::from_json(same).expect("it is an edit"))), "{same}");
    }
    // Another requirement leaves the search.
    let other = r#"{ "setConstraint": { "index": 0, "require": "exact" } }"#;
    session.edit(Edit::from_json(other).expect("it is an edit")).expect("it is not locked");
    assert_eq!(session.document().weights.smooth, 0.5);
}

#[test]
fn neither_refining_nor_editing_the_mesh_leaves_out_what_is_locked() {
    let mesh = grid(3, 3, |i, j| [f64::from(i), f64::from(j), 0.1 * f64::from(i * j)]);
    let mut triangles = Mesh { positions: mesh.positions.clone(), ..Mesh::default() };
    for face in mesh.faces.iter() {
        triangles.faces.push(&[face[0], face[1], face[2]]);
        triangles.faces.push(&[face[0], face[2], face[3]]);
    }
    // Areas are of triangles, of which this refinement leaves none.
    let text = r#"{ "format": "shape-up-scene", "version": 1, "mesh": { "file": "t.obj" },
        "constraints": [{ "kind": "area", "on": "faces" }], "closeness": { "to": "rest" },
        "lesson": { "text": "Keep it.", "lock": ["constraints"],
            "goals": [{ "measure": "displacement", "at_most": 1 }] } }"#;
    let scene = Scene::from_json(text).expect("the scene is valid");
    let mut session = Session::open(scene, triangles).expect("it fits");
    let refine = r#"{ "refine": { "scheme": "catmull-clark", "levels": 1 } }"#;
    let refine = Edit::from_json(refine).expect("it is an edit");
    let before = session.scene();
    assert!(refused(session.edit(refine)));
    assert_eq!(session.scene(), before);
}

#[test]
fn panels_beyond_a_value_are_counted() {
    let mut session = session("[]");
    let values = session.face_values("planarity").expect("it is declared");
    let beyond = values.iter().filter(|value| **value > 0.001).count();
    assert!(beyond > 3);
    assert_eq!(session.goals()[0].value, Some(beyond as f64));
    assert!(!session.goals()[0].met);
    let again = Scene::from_json(&session.scene().to_json(session.mesh())).expect("written here");
    assert_eq!(again.lesson, session.document().lesson);
}

#[test]
fn results_tell_what_was_done() {
    let mut session = session("[]");
    let edit = r#"{ "setWeights": { "shape": 100 } }"#;
    let edit = Edit::from_json(edit).expect("it is an edit");
    session.edit(edit).expect("nothing is locked");
    session.begin_run();
    session.step().expect("positions stay finite");
    session.end_run();
    let results = session.results("Ada", "").expect("it is a lesson");
    let results = Results::from_json(&results.to_json()).expect("it was written here");
    assert_eq!(results.steps, ["Change weights", "Run, 1 iteration"]);
    assert_eq!(results.weights.map(|weights| weights.shape), Some(100.0));
    assert_eq!(results.moved, Some(session.moved().max));
    assert_eq!(results.distance, Some(session.worst_distance()));
    assert_eq!(results.settings["window"], 5);
}

#[test]
fn what_was_altered_is_found_by_the_part_that_is_locked() {
    let handed_in = |lock: &str| {
        let mut session = session("[]");
        for (part, edit) in EDITS.iter().filter(|(_, edit)| *edit != VARIANT) {
            let edit = Edit::from_json(edit).expect("it is an edit");
            if *part != Lock::Mesh {
                session.edit(edit).expect("nothing is locked");
            }
        }
        let mut results = session.results("Mallory", "").expect("it is a lesson");
        let given = session_scene(lock);
        results.scene = given.fingerprint(&bumpy(5));
        check_results(&results, given, bumpy(5)).expect("they say that they are of it")
    };
    let open = handed_in("[]");
    assert!(open.altered.is_empty());
    assert!(open.changed.iter().any(|words| words == "close weight 0 to 3"), "{:?}", open.changed);
    for lock in [Lock::Weights, Lock::Constraints, Lock::Handles] {
        assert_eq!(handed_in(&format!("[\"{}\"]", lock.word())).altered, [lock]);
    }
    let all = handed_in(r#"["weights", "constraints", "handles", "mesh"]"#);
    assert_eq!(all.altered, [Lock::Weights, Lock::Constraints, Lock::Handles]);
    assert!(all.changed.is_empty());
    // Results without any change are not reported as altered.
    let mut untouched = session("[\"weights\"]");
    let results = untouched.results("Ada", "").expect("it is a lesson");
    let results = Results::from_json(&results.to_json()).expect("it was written here");
    let checked = check_results(&results, session_scene("[\"weights\"]"), bumpy(5));
    let checked = checked.expect("they are of it");
    assert!(checked.altered.is_empty() && checked.changed.is_empty(), "{checked:?}");
}

#[test]
fn results_with_the_earlier_words_for_how_a_boundary_is_held_are_not_altered() {
    // The words were `exactly` and `nearly`, and have become those of scene files.
    let words = [(BoundaryRequire::Exact, "exactly"), (BoundaryRequire::Soft, "nearly")];
    for (require, own) in words {
        let mut given = session_scene("[\"weights\"]");
        given.closeness.boundary.require = require;
        let mut session = Session::open(given.clone(), bumpy(5)).expect("it fits");
        let mut results = session.results("Ada", "").expect("it is a lesson");
        for (_, word) in words {
            results.settings.insert("boundary".to_owned(), word.into());
            let checked = check_results(&results, given.clone(), bumpy(5));
            let altered = checked.expect("they are of it").altered;
            assert_eq!(altered.is_empty(), word == own, "{word}: {altered:?}");
        }
    }
}

fn session_scene(lock: &str) -> Scene {
    session(lock).scene()
}

#[test]
fn what_an_edit_changes_beside_is_locked_too() {
    // "Make panels" gave default weights, and the teacher's check accused the student.
    let mut session = session(r#"["weights"]"#);
    session.edit(Edit::Reset).expect("nothing of it is locked");
    let before = session.scene();
    let asked = session.make_panels("plane", 0.1, PanelStart::Now);
    assert!(refused(asked.map(|()| true)));
    assert_eq!(session.scene(), before);

    // The set is used by a factor of closeness, and by no constraint.
    let mut given = scene(r#"["weights"]"#);
    let text = r#"{ "format": "shape-up-scene", "version": 1, "mesh": { "file": "grid.obj" },
        "sets": { "eaves": { "vertices": [0, 1] } },
        "closeness": { "weights": [{ "on": { "set": "eaves" }, "weight": 9 }] } }"#;
    let other = Scene::from_json(text).expect("the scene is valid");
    (given.sets, given.closeness) = (other.sets, other.closeness);
    let mut session = Session::open(given, bumpy(5)).expect("it fits");
    let other = Edit::NameSet { name: "eaves".to_owned(), vertices: vec![7], faces: Vec::new() };
    assert!(refused(session.edit(other)));
}
