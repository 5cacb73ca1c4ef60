//! JSON requests of hosts to a session, and the messages for those without meaning.

use serde_json::{Map, json};
use shape_up::constraint::{Element, Selector, Set};
use shape_up::scene::Up;
use shape_up::session::{
    ConstraintTarget, Edit, Mode, NewConstraint, SelectRequest, Selection, SomeWeights,
};

fn read(edit: &serde_json::Value) -> Edit {
    Edit::from_json(&edit.to_string()).expect("it is an edit")
}

fn refused(edit: &serde_json::Value) -> (String, String) {
    let error = Edit::from_json(&edit.to_string()).expect_err("it is no edit");
    (error.path, error.message)
}

#[test]
fn every_edit_is_read_with_its_fields() {
    let (name, vertices) = ("rim".to_owned(), vec![4, 2]);
    let params = json!({ "angle": [10, null] }).as_object().expect("it is one").clone();
    let weights = SomeWeights { close: Some(0.5), ..SomeWeights::default() };
    for (text, expected) in [
        (json!({ "removeConstraint": { "index": 3 } }), Edit::RemoveConstraint { index: 3 }),
        (
            json!({ "setConstraint": { "index": 1, "enabled": false, "weight": null } }),
            Edit::SetConstraint {
                index: 1,
                weight: None,
                require: None,
                enabled: Some(false),
                params: Map::new(),
            },
        ),
        (
            json!({ "setConstraint": { "index": 1, "weight": 0.5, "params": params } }),
            Edit::SetConstraint {
                index: 1,
                weight: Some(0.5),
                require: None,
                enabled: None,
                params,
            },
        ),
        (json!({ "duplicateConstraint": { "index": 0 } }), Edit::DuplicateConstraint { index: 0 }),
        (
            json!({ "renameConstraint": { "index": 0, "name": name } }),
            Edit::RenameConstraint { index: 0, name: name.clone() },
        ),
        (
            json!({ "nameSet": { "name": name, "vertices": vertices, "faces": [] } }),
            Edit::NameSet { name: name.clone(), vertices: vertices.clone(), faces: vec![] },
        ),
        (json!({ "removeSet": { "name": name } }), Edit::RemoveSet { name }),
        (
            json!({ "set": { "id": "solver.window", "value": 7 } }),
            Edit::Set { id: "solver.window".to_owned(), value: json!(7) },
        ),
        (
            json!({ "holdClose": { "vertices": null, "weight": 1 } }),
            Edit::HoldClose { vertices: None, weight: 1.0 },
        ),
        (
            json!({ "weighHandles": { "vertices": vertices, "weight": 30 } }),
            Edit::WeighHandles { vertices: vertices.clone(), weight: 30.0 },
        ),
        (json!({ "setWeights": { "close": 0.5 } }), Edit::SetWeights(weights)),
        (json!({ "setUnits": { "units": "mm" } }), Edit::SetUnits { units: "mm".to_owned() }),
        (
            json!({ "setTolerance": { "tolerance": 0.2 } }),
            Edit::SetTolerance { tolerance: Some(0.2) },
        ),
        (json!({ "setUp": { "up": "y" } }), Edit::SetUp { up: Up::Y }),
        (
            json!({ "setLesson": { "lesson": null } }),
            Edit::SetLesson { lesson: None, unsolved: false },
        ),
        (
            json!({ "setBuild": { "values": { "scale": 20 } } }),
            Edit::SetBuild { values: Map::from_iter([("scale".to_owned(), json!(20))]) },
        ),
        (
            json!({ "addHandles": { "vertices": vertices, "fixed": true } }),
            Edit::AddHandles { vertices: vertices.clone(), fixed: true },
        ),
        (json!({ "removeHandles": { "vertices": vertices } }), Edit::RemoveHandles { vertices }),
        (json!("reset"), Edit::Reset),
    ] {
        assert_eq!(read(&text), expected, "{text}");
    }
}

#[test]
fn a_constraint_is_added_on_a_set_that_has_no_name_yet() {
    let edit = read(&json!({
        "addConstraint": { "kind": "angle", "weight": 2, "params": { "angle": [80, 100] },
            "on": { "each": "corner", "in": "" }, "set": { "faces": [1, 5] } },
    }));
    let Edit::AddConstraint(NewConstraint { spec, set }) = edit else { panic!("found {edit:?}") };
    assert_eq!((spec.kind.info().id, spec.weight), ("angle", 2.0));
    assert_eq!(spec.kind.params()["angle"], json!([80.0, 100.0]));
    assert_eq!(set, Some(Set { vertices: [].into(), faces: [1, 5].into() }));
    let within = Some(ConstraintTarget::UNNAMED.to_owned());
    assert_eq!(spec.on, Selector::Each { element: Element::Corner, within, radius: 0 });
}

#[test]
fn what_has_no_meaning_is_refused_where_it_stands() {
    for (text, path, part) in [
        (json!("explode"), "", "found `explode`, expected one of `addConstraint`"),
        (json!({ "index": 1 }), "", "found `index`, expected one of `addConstraint`"),
        (json!({ "removeConstraint": {} }), "", "`index` is missing"),
        (json!({ "removeHandles": { "vertices": [0, -1] } }), "vertices[1]", "found -1"),
        (json!({ "holdClose": { "weight": "much" } }), "weight", "found \"much\""),
        // It was told that 0 is one.
        (json!({ "weighHandles": { "weight": "x" } }), "weight", "found \"x\", expected a number"),
        (json!({ "setUp": { "up": "w" } }), "up", "expected \"z\" or \"y\""),
        // It replaced the set of that name, or was added to no use.
        (
            json!({ "addConstraint": { "kind": "plane", "on": { "each": "face", "in": "eaves" },
                "set": { "faces": [1] }, "weight": 1 } }),
            "set",
            "found a set",
        ),
        (
            json!({ "addConstraint": { "kind": "plane", "on": "faces", "set": { "faces": [1] },
                "weight": 1 } }),
            "set",
            "found a set",
        ),
        (
            json!({ "addConstraint": { "kind": "plane", "on": "faces", "weight": 1,
                "params": { "angle": 3 } } }),
            "",
            "unknown key `angle`",
        ),
        (
            json!({ "addConstraint": { "kind": "angle", "on": "corners", "weight": 1,
                "params": { "angle": "wide" } } }),
            "angle",
            "wide",
        ),
        (
            json!({ "setLesson": { "lesson": { "text": "", "goals": [{}] } } }),
            "lesson.goals[0]",
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
    let request: SelectRequest = serde_json::from_value(text).expect("it is a request");
    let from = Selection { faces: vec![2], ..Selection::default() };
    let params = Map::new();
    let operation = "grow".to_owned();
    assert_eq!(request, SelectRequest { operation, mode: Mode::Faces, from, params });

    let text = json!([{ "on": { "vertices": [3, 1] } },
        { "on": { "each": "face", "in": "" }, "set": { "vertices": [0] } }]);
    let places: Vec<ConstraintTarget> = serde_json::from_value(text).expect("they are places");
    assert_eq!(places[0], ConstraintTarget { on: Selector::Vertices([3, 1].into()), set: None });
    assert_eq!(places[1].set, Some(Set { vertices: [0].into(), faces: [].into() }));
    let text =
        json!({ "addConstraint": { "kind": "plane", "weight": 1, "on": { "each": "cube" } } });
    assert_eq!(refused(&text).0, "on.each", "there are no cubes");
}

#[test]
fn a_field_that_an_edit_does_not_have_is_refused() {
    // They were ignored: a row that was to be exact from the start became soft.
    let on = json!({ "kind": "plane", "on": "faces", "weight": 1, "require": "exact" });
    let (path, message) = refused(&json!({ "addConstraint": on }));
    assert_eq!(path, "");
    assert!(message.contains("unknown key `require`, known here: kind, on"), "{message}");
    for (name, fields) in [
        ("removeConstraint", json!({ "index": 0 })),
        ("setConstraint", json!({ "index": 0, "weight": 2 })),
        ("nameSet", json!({ "name": "rim", "vertices": [1] })),
        ("set", json!({ "id": "window", "value": 3 })),
        ("holdClose", json!({ "vertices": null, "weight": 1 })),
        ("setWeights", json!({ "close": 1 })),
        ("setLesson", json!({ "lesson": null })),
        ("setSteps", json!({ "steps": [] })),
        ("setBuild", json!({ "values": {} })),
        ("addHandles", json!({ "vertices": [0], "fixed": true })),
        ("refine", json!({ "scheme": "linear", "levels": 1 })),
        ("remesh", json!({ "operation": "dual" })),
    ] {
        read(&json!({ name: fields }));
        let mut more = fields.clone();
        more["surplus"] = json!(1);
        let (path, message) = refused(&json!({ name: more }));
        assert_eq!(path, "", "{name}: {message}");
        assert!(message.contains("unknown key `surplus`"), "{name}: {message}");
    }
    refused(&json!({ "reset": { "surplus": 1 } }));
    refused(&json!({ "removeConstraint": { "index": 0 }, "removeSet": { "name": "rim" } }));
    let request = json!({ "operation": "grow", "mode": "faces", "surplus": 1 });
    let error = serde_json::from_value::<SelectRequest>(request).expect_err("it has no such field");
    assert!(error.to_string().contains("surplus"), "{error}");
    let request = json!({ "operation": "grow", "mode": "faces", "from": { "face": [1] } });
    serde_json::from_value::<SelectRequest>(request).expect_err("a selection has no such field");
}
