//! Constraint kinds that hosts may offer, and parameters that are changed later.

use crate::support::grid::bumpy;
use serde_json::{Value, json};
use shape_up::constraint::{Arity, Centring, Element, KINDS, Selector, Set};
use shape_up::mesh::Mesh;
use shape_up::scene::{ConstraintSpec, MeshSource, Scene};
use shape_up::session::Error;
use shape_up::session::{ConstraintTarget, Edit, NewConstraint, Preview, Session};

fn session(mesh: Mesh) -> Session {
    Session::open(Scene::new(MeshSource::File("grid.obj".to_owned())), mesh)
        .expect("the mesh can be solved")
}

fn each(element: Element) -> ConstraintTarget {
    ConstraintTarget { on: Selector::Each { element, within: None, radius: 0 }, set: None }
}

fn entry(kind: &str, place: &ConstraintTarget) -> Edit {
    let mut spec = ConstraintSpec::from_json(&json!({ "kind": kind, "on": "faces" }).to_string())
        .unwrap_or_else(|error| panic!("{kind}: {error}"));
    spec.on = place.on.clone();
    Edit::AddConstraint(NewConstraint { spec, set: place.set.clone() })
}

#[test]
fn a_preview_says_what_adding_makes() {
    let places = [
        vec![each(Element::Face), each(Element::Edge), each(Element::Curve)],
        vec![each(Element::Boundary), each(Element::Corner), each(Element::Star)],
        vec![ConstraintTarget { on: Selector::Vertices(vec![0, 1, 5, 6]), set: None }],
        vec![ConstraintTarget {
            on: Selector::Each {
                element: Element::Face,
                within: Some(ConstraintTarget::UNNAMED.to_owned()),
                radius: 0,
            },
            set: Some(Set { vertices: Vec::new(), faces: vec![3, 7] }),
        }],
    ]
    .concat();
    let mut session = session(bumpy(4));
    let before = session.scene();
    let previews = session.previews(&places).expect("everything is there");
    assert_eq!(session.scene(), before, "looking changes nothing");
    assert_eq!(previews.len(), KINDS.len());
    let mut offered = 0;
    for (info, previews) in KINDS.iter().zip(&previews) {
        for (place, preview) in places.iter().zip(previews) {
            let added = session.edit(entry(info.id, place));
            let Some(preview) = preview else {
                let elsewhere = !info.elements.is_empty();
                assert!(added.is_err() || elsewhere, "{} is not offered {place:?}", info.id);
                if added.is_ok() {
                    session.undo().expect("undo works");
                }
                continue;
            };
            added.unwrap_or_else(|error| panic!("{} on {place:?}: {error}", info.id));
            let row = &session.rows()[0];
            assert_eq!(row.constraints.members.len(), preview.constraints, "{}", info.id);
            assert_eq!(row.constraints.members.indices().len(), preview.vertices, "{}", info.id);
            assert_eq!(row.skipped, preview.skipped, "{}", info.id);
            session.undo().expect("undo works");
            offered += 1;
        }
    }
    assert!(offered > KINDS.len(), "most kinds fit in several places: {offered}");
}

#[test]
fn what_a_kind_is_not_meant_for_is_not_offered() {
    let session = session(bumpy(3));
    let places: Vec<_> = Element::ALL.into_iter().map(each).collect();
    let previews = session.previews(&places).expect("everything is there");
    for (info, previews) in KINDS.iter().zip(previews) {
        for (element, preview) in Element::ALL.iter().zip(previews) {
            if !info.elements.is_empty() && !info.elements.contains(element) {
                assert_eq!(preview, None, "{} on each {}", info.id, element.id());
            }
            let fits = |n| info.centring == Centring::Together && info.arity == Arity::Exactly(n);
            if *element == Element::Face && info.elements.is_empty() && fits(4) {
                assert_eq!(preview.map(|one| one.constraints), Some(9), "{}", info.id);
            }
        }
    }
}

/// The kinds marked as usual for a target.
fn usual(session: &Session, place: ConstraintTarget) -> Vec<&'static str> {
    let previews = session.previews(&[place]).expect("everything is there");
    let is_usual = |row: &[Option<Preview>]| row[0].is_some_and(|one| one.usual);
    KINDS.iter().zip(previews).filter(|(_, row)| is_usual(row)).map(|(info, _)| info.id).collect()
}

#[test]
fn the_usual_kind_follows_from_what_the_place_is_to_the_mesh() {
    // 5 by 5 vertices, row by row.
    let session = session(bumpy(4));
    let selected = |vertices: &[u32]| {
        usual(&session, ConstraintTarget { on: Selector::Vertices(vertices.to_vec()), set: None })
    };
    assert_eq!(usual(&session, each(Element::Face)), ["plane", "circle"]);
    assert_eq!(usual(&session, each(Element::Boundary)), ["circle"]);
    assert_eq!(usual(&session, each(Element::Edge)), ["line-segment"]);
    // A cap of two by two faces, one face, the boundary, an inner loop, a chain, an edge.
    assert_eq!(selected(&[0, 1, 2, 5, 6, 7, 10, 11, 12]), ["sphere"]);
    assert_eq!(selected(&[0, 1, 5, 6]), ["plane", "circle"]);
    let boundary = [0, 1, 2, 3, 4, 9, 14, 19, 24, 23, 22, 21, 20, 15, 10, 5];
    assert_eq!(selected(&boundary), ["circle"]);
    assert_eq!(selected(&[6, 7, 8, 13, 18, 17, 16, 11]), ["circle"]);
    assert_eq!(selected(&[10, 11, 12, 13]), ["line"]);
    assert_eq!(selected(&[0, 1]), ["line-segment"]);
    // Two separate chains are not a chain; the whole mesh is not a patch; one vertex has no usual
    // kind.
    assert_eq!(selected(&[0, 1, 2, 20, 21, 22]), ["plane"]);
    assert_eq!(selected(&(0..25).collect::<Vec<_>>()), [""; 0]);
    assert_eq!(selected(&[12]), [""; 0]);
}

#[test]
fn an_unknown_place_is_an_error() {
    let session = session(bumpy(2));
    let error =
        session.previews(&[ConstraintTarget { on: Selector::Vertices(vec![99]), set: None }]);
    assert!(error.expect_err("there is no vertex 99").message.contains("99"));
}

fn length(session: &Session) -> Value {
    session.document().constraints[0].kind.params()["length"].clone()
}

fn set(params: Value) -> Edit {
    let Value::Object(params) = params else { panic!("parameters are an object") };
    Edit::SetConstraint { index: 0, weight: None, require: None, enabled: None, params }
}

#[test]
fn parameters_are_changed_one_by_one_and_undone() {
    let mut session = session(bumpy(2));
    session.edit(entry("line-segment", &each(Element::Edge))).expect("segments fit edges");
    assert_eq!(session.solver().energy().shape, 0.0, "edges are as at rest");
    session.edit(set(json!({ "length": 2 }))).expect("it is a length");
    assert!(session.solver().energy().shape > 1.0, "the new length counts at once");
    session.edit(set(json!({ "strain": [0.9, 1.1] }))).expect("they are limits");
    assert_eq!(length(&session), json!(2.0), "the other parameter stays");
    for expected in [json!(2.0), json!("rest")] {
        assert_eq!(session.undo(), Ok(Some("Change line segment".to_owned())));
        assert_eq!(length(&session), expected);
    }
}

#[test]
fn a_wrong_parameter_is_refused_with_its_place() {
    let entry_text = json!({ "kind": "line-segment", "on": "edges", "length": [3, 2] }).to_string();
    let error =
        ConstraintSpec::from_json(&entry_text).expect_err("the least is above the greatest");
    assert_eq!(error.path, "length[1]");

    let mut session = session(bumpy(2));
    session.edit(entry("line-segment", &each(Element::Edge))).expect("segments fit edges");
    let before = session.scene();
    for (params, path) in [
        (json!({ "length": -1 }), "constraints[0].length"),
        (json!({ "length": "long" }), "constraints[0].length"),
        (json!({ "strain": [1, 0.5] }), "constraints[0].strain[1]"),
    ] {
        match session.edit(set(params.clone())) {
            Err(Error::Scene(error)) => assert_eq!(error.path, path, "{params}"),
            other => panic!("{params}: {other:?}"),
        }
        assert_eq!(session.scene(), before);
    }
    assert_eq!(session.undo_and_redo()[0], Some("Add line segment"));
}
