//! Presentations: steps are part of the scene, and showing one can be undone.

use crate::support::grid::bumpy;
use serde_json::{Value, json};
use shape_up::scene::{Lesson, Scene, Slide, Variant, Variants, Weights};
use shape_up::session::{Edit, Session};

/// Two steps: the rest shape with other weights, and a kept shape.
fn scene_with(steps: &Value) -> Scene {
    let text = json!({ "format": "shape-up-scene", "version": 1, "mesh": { "file": "grid.obj" },
        "constraints": [{ "kind": "plane", "on": "faces" }],
        "weights": { "close": 0.01 }, "steps": steps });
    let mut scene = Scene::from_json(&text.to_string()).expect("it is a scene");
    let raised = bumpy(3).positions.iter().map(|[x, y, z]| [*x, *y, z + 1.0]).collect();
    scene.variants = Variants {
        kept: vec![Variant { name: "Raised".to_owned(), positions: raised }],
        design: None,
    };
    scene
}

fn steps() -> Value {
    json!([
        { "title": "Design", "original": true, "weights": { "shape": 5, "close": 2 },
          "camera": [0, 0, 0, 10, 0.5, 0.5, 1], "measure": "planarity" },
        { "title": "Raised", "text": "One\nmetre", "notes": "Ask who has\nseen it", "variant": 0, "run": true, "parallel": true },
    ])
}

fn session() -> Session {
    Session::open(scene_with(&steps()), bumpy(3)).expect("it fits")
}

#[test]
fn showing_a_step_gives_its_shape_and_weights_and_is_undone() {
    let mut session = session();
    session.solve(false).expect("positions stay finite");
    let solved = session.positions();
    assert!(session.edit(Edit::ShowStep { index: 0 }).expect("it is there"));
    assert_eq!(session.positions(), bumpy(3).positions);
    assert_eq!(session.document().weights, Weights { shape: 5.0, close: 2.0, smooth: 0.0 });
    // Showing the same step again changes nothing.
    assert!(!session.edit(Edit::ShowStep { index: 0 }).expect("it is there"));

    assert!(session.edit(Edit::ShowStep { index: 1 }).expect("it is there"));
    assert_eq!(session.positions(), session.document().variants.kept[0].positions.to_vec());
    assert_eq!(session.document().weights.shape, 5.0, "a step without weights leaves them");
    assert_eq!(session.undo().expect("it was solvable"), Some("Show Raised".to_owned()));
    assert_eq!(session.undo().expect("it was solvable"), Some("Show Design".to_owned()));
    assert_eq!(session.positions(), solved);
    assert_eq!(session.document().weights.close, 0.01);

    let error = session.edit(Edit::ShowStep { index: 2 }).expect_err("there are two");
    assert!(error.to_string().contains("steps[2]"), "{error}");
}

#[test]
fn steps_are_written_set_and_undone() {
    let mut session = session();
    let before = session.document().steps.clone();
    let text = session.document().to_json(session.mesh());
    assert_eq!(Scene::from_json(&text).expect("it reads back").steps, before);

    let edit = json!({ "setSteps": { "steps": [{ "title": "Only one" }] } }).to_string();
    let edit = Edit::from_json(&edit).expect("it is an edit");
    assert!(session.edit(edit).expect("they fit"));
    let only = Slide { title: "Only one".to_owned(), ..Slide::default() };
    assert_eq!(session.document().steps, [only]);
    session.undo().expect("it was solvable");
    assert_eq!(session.document().steps, before);
}

#[test]
fn a_variant_that_is_taken_away_is_in_no_step() {
    let mut session = session();
    session.edit(Edit::RemoveVariant { index: 0 }).expect("it is not the design");
    assert_eq!(session.document().steps[1].variant, None);
    session.undo().expect("it was solvable");
    assert_eq!(session.document().steps[1].variant, Some(0));
}

#[test]
fn a_lesson_saved_without_its_variants_has_no_step_that_goes_to_one() {
    let mut session = session();
    let goal = r#"{ "text": "Flat.", "goals": [{ "measure": "planarity", "at_most": 1 }] }"#;
    let lesson = Some(serde_json::from_str::<Lesson>(goal).expect("it is a lesson"));
    session.edit(Edit::SetLesson { lesson, unsolved: true }).expect("it can be measured");
    let text = session.scene().to_json(session.mesh());
    let saved = Scene::from_json(&text).expect("it reads back");
    Session::open(saved, bumpy(3)).expect("what is saved can be opened");
    session.undo().expect("it was solvable");
    assert_eq!(session.document().steps[1].variant, Some(0));
}

#[test]
fn steps_that_cannot_be_are_refused_with_their_path() {
    let step = |more: Value| {
        let mut step = json!({ "title": "One" });
        step.as_object_mut()
            .expect("it is one")
            .extend(more.as_object().expect("it is one").clone());
        step
    };
    for (more, path) in [
        (json!({ "variant": 1 }), "steps[0].variant"),
        (json!({ "variant": 0, "original": true }), "steps[0].variant"),
        (json!({ "weights": { "close": -1 } }), "steps[0].weights.close"),
        (json!({ "measure": "beauty" }), "steps[0].measure"),
    ] {
        let one = json!([step(more)]);
        let error = Session::open(scene_with(&one), bumpy(3)).err().expect(path);
        assert!(error.to_string().contains(path), "{error}");
        let edit = json!({ "setSteps": { "steps": one } }).to_string();
        let mut session = session();
        let edit = Edit::from_json(&edit).expect("its form is right");
        let error = session.edit(edit).expect_err(path);
        assert!(error.to_string().contains(path), "{error}");
        assert_eq!(session.document().steps.len(), 2, "nothing has changed");
    }
    let many: Vec<_> = (0..=Slide::MOST).map(|_| step(json!({}))).collect();
    let error = Session::open(scene_with(&json!(many)), bumpy(3)).err().expect("too many");
    assert!(error.to_string().contains("steps: found 100"), "{error}");
    for (wrong, path) in [
        (json!({ "camera": [1, 2] }), "steps[0].camera"),
        (json!({ "colour": "red" }), "steps[0]"),
        (json!({ "title": 3 }), "steps[0].title"),
    ] {
        let text = json!({ "format": "shape-up-scene", "version": 1,
            "mesh": { "file": "grid.obj" }, "steps": [step(wrong)] });
        let error = Scene::from_json(&text.to_string()).expect_err(path);
        assert_eq!(error.path, path, "{error}");
    }
}
