//! JSON requests of hosts to a session, and the messages for those without meaning.

use serde_json::json;
use shape_up::constraint::{Element, Selector, Set};
use shape_up::scene::{MeshSource, Scene, Up, Weights};
use shape_up::session::{ConstraintTarget, Edit, Mode, NewConstraint, SelectRequest, Selection};

fn document() -> Scene {
    let mut scene = Scene::new(MeshSource::File("none.obj".to_owned()));
    scene.weights = Weights { shape: 5.0, close: 10.0, smooth: 2.0 };
    scene
}

fn read(edit: &serde_json::Value) -> Edit {
    Edit::from_json(&edit.to_string(), &document()).expect("it is an edit")
}

fn refused(edit: &serde_json::Value) -> (String, String) {
    let error = Edit::from_json(&edit.to_string(), &document()).expect_err("it is no edit");
    (error.path, error.message)
}

#[test]
fn every_edit_is_read_with_its_fields() {
    let (name, vertices) = ("rim".to_owned(), vec![4, 2]);
    let params = json!({ "angle": [10, null] }).as_object().expect("it is one").clone();
    let weights = Weights { shape: 5.0, close: 0.5, smooth: 2.0 };
    for (text, expected) in [
        (json!({ "type": "removeConstraint", "index": 3 }), Edit::RemoveConstraint { index: 3 }),
        (
            json!({ "type": "setConstraint", "index": 1, "enabled": false, "weight": null }),
            Edit::SetConstraint {
                index: 1,
                weight: None,
                require: None,
                enabled: Some(false),
                params: serde_json::Map::new(),
            },
        ),
        (
            json!({ "type": "setConstraint", "index": 1, "weight": 0.5, "params": params }),
            Edit::SetConstraint {
                index: 1,
                weight: Some(0.5),
                require: None,
                enabled: None,
                params,
            },
        ),
        (
            json!({ "type": "duplicateConstraint", "index": 0 }),
            Edit::DuplicateConstraint { index: 0 },
        ),
        (
            json!({ "type": "renameConstraint", "index": 0, "name": name }),
            Edit::RenameConstraint { index: 0, name: name.clone() },
        ),
        (
            json!({ "type": "nameSet", "name": name, "vertices": vertices, "faces": [] }),
            Edit::NameSet { name: name.clone(), vertices: vertices.clone(), faces: vec![] },
        ),
        (json!({ "type": "removeSet", "name": name }), Edit::RemoveSet { name }),
        (
            json!({ "type": "set", "id": "solver.window", "value": 7 }),
            Edit::Set { id: "solver.window".to_owned(), value: json!(7) },
        ),
        (
            json!({ "type": "holdClose", "vertices": null, "weight": 1 }),
            Edit::HoldClose { vertices: None, weight: 1.0 },
        ),
        (
            json!({ "type": "weighHandles", "vertices": vertices, "weight": 30 }),
            Edit::WeighHandles { vertices: vertices.clone(), weight: 30.0 },
        ),
        (json!({ "type": "setWeights", "close": 0.5 }), Edit::SetWeights(weights)),
        (json!({ "type": "setUnits", "units": "mm" }), Edit::SetUnits { units: "mm".to_owned() }),
        (json!({ "type": "setUp", "up": "y" }), Edit::SetUp { up: Up::Y }),
        (
            json!({ "type": "setLesson", "lesson": null }),
            Edit::SetLesson { lesson: None, unsolved: false },
        ),
        (
            json!({ "type": "setBuild", "build": { "scale": 20 } }),
            Edit::SetBuild {
                build: Box::new(shape_up::scene::BuildSettings {
                    scale: 20.0,
                    ..Default::default()
                }),
            },
        ),
        (
            json!({ "type": "addHandles", "vertices": vertices, "fixed": true }),
            Edit::AddHandles { vertices: vertices.clone(), fixed: true },
        ),
        (
            json!({ "type": "removeHandles", "vertices": vertices }),
            Edit::RemoveHandles { vertices },
        ),
        (json!({ "type": "reset" }), Edit::Reset),
    ] {
        assert_eq!(read(&text), expected, "{text}");
    }
}

#[test]
fn a_constraint_is_added_on_a_set_that_has_no_name_yet() {
    let edit = read(&json!({
        "type": "addConstraint", "kind": "angle", "weight": 2, "params": { "angle": [80, 100] },
        "on": { "each": "corner", "in": { "faces": [1, 5] } },
    }));
    let Edit::AddConstraint(NewConstraint { spec, set }) = edit else { panic!("found {edit:?}") };
    assert_eq!((spec.kind.info().id, spec.weight), ("angle", 2.0));
    assert_eq!(spec.kind.params()["angle"], json!([80.0, 100.0]));
    assert_eq!(set, Some(Set { vertices: vec![], faces: vec![1, 5] }));
    let within = Some(ConstraintTarget::UNNAMED.to_owned());
    assert_eq!(spec.on, Selector::Each { element: Element::Corner, within, radius: 0 });
}

#[test]
fn what_has_no_meaning_is_refused_where_it_stands() {
    for (text, path, part) in [
        (json!({ "type": "explode" }), "type", "unknown edit `explode`"),
        (json!({ "index": 1 }), "", "`type` is missing"),
        (json!({ "type": "removeConstraint" }), "", "`index` is missing"),
        (json!({ "type": "removeHandles", "vertices": [0, -1] }), "vertices[1]", "found -1"),
        (json!({ "type": "holdClose", "weight": "much" }), "weight", "found \"much\""),
        (json!({ "type": "setUp", "up": "w" }), "up", "expected \"z\" or \"y\""),
        (
            json!({ "type": "addConstraint", "kind": "plane", "on": "faces", "weight": 1,
                "params": { "angle": 3 } }),
            "",
            "unknown key `angle`",
        ),
        (
            json!({ "type": "addConstraint", "kind": "angle", "on": "corners", "weight": 1,
                "params": { "angle": "wide" } }),
            "angle",
            "wide",
        ),
        (
            json!({ "type": "setLesson", "lesson": { "text": "", "goals": [{}] } }),
            "goals[0]",
            "goal",
        ),
    ] {
        let (found, message) = refused(&text);
        assert_eq!(found, path, "{text}: {message}");
        assert!(message.contains(part), "{text}: {message}");
    }
}

#[test]
fn requests_to_select_and_places_are_read() {
    let text = json!({ "operation": "grow", "mode": "faces", "from": { "faces": [2] } });
    let request = SelectRequest::from_json(&text.to_string()).expect("it is a request");
    let from = Selection { faces: vec![2], ..Selection::default() };
    let params = serde_json::Map::new();
    let operation = "grow".to_owned();
    assert_eq!(request, SelectRequest { operation, mode: Mode::Faces, from, params });

    let text =
        json!(["faces", { "vertices": [3, 1] }, { "each": "face", "in": { "vertices": [0] } }]);
    let places = ConstraintTarget::all_from_json(&text.to_string()).expect("they are places");
    assert_eq!(places[1], ConstraintTarget { on: Selector::Vertices(vec![3, 1]), set: None });
    assert_eq!(places[2].set, Some(Set { vertices: vec![0], faces: vec![] }));
    let text = json!(["faces", { "each": "cube" }]);
    let error = ConstraintTarget::all_from_json(&text.to_string()).expect_err("there are no cubes");
    assert_eq!(error.path, "each");
}
