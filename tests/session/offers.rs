//! Constraint kinds that hosts may offer, and parameters that are changed later.

use crate::support::grid::bumpy;
use serde_json::{Value, json};
use shape_up::constraint::{Element, KINDS, Selector};
use shape_up::mesh::Mesh;
use shape_up::scene::{ConstraintSpec, MeshSource, Scene};
use shape_up::session::Error;
use shape_up::session::{
    ConstraintOffers, ConstraintTarget, Edit, NewConstraint, OfferedKind, OfferedPlace,
    OfferedStart, Session,
};
use shape_up::words;

fn session(mesh: Mesh) -> Session {
    Session::open(Scene::new(MeshSource::File("grid.obj".to_owned())), mesh)
        .expect("the mesh can be solved")
}

fn each(element: Element) -> ConstraintTarget {
    ConstraintTarget { on: Selector::Each { element, within: None, radius: 0 }, set: None }
}

fn entry(kind: &str, place: &ConstraintTarget) -> Edit {
    let mut spec =
        serde_json::from_str::<ConstraintSpec>(&json!({ "kind": kind, "on": "faces" }).to_string())
            .unwrap_or_else(|error| panic!("{kind}: {error}"));
    spec.on = place.on.clone();
    Edit::AddConstraint(NewConstraint { spec, set: place.set.clone() })
}

/// What is offered while these vertices are selected.
fn offers(session: &Session, vertices: &[u32]) -> ConstraintOffers {
    session.constraint_offers(vertices.to_vec(), Vec::new()).expect("everything is there")
}

fn place<'a>(offers: &'a ConstraintOffers, id: &str) -> &'a OfferedPlace {
    offers.places.iter().find(|place| place.id == id).expect("it is a place")
}

#[test]
fn an_offer_says_what_adding_makes() {
    let mut session = session(bumpy(4));
    let before = session.scene();
    let found = session.constraint_offers(vec![3, 4, 8, 9, 10, 11, 15, 16], vec![3, 7]);
    let found = found.expect("everything is there");
    assert_eq!(session.scene(), before, "looking changes nothing");
    let mut offered = 0;
    for info in KINDS {
        let of_kind = found.kinds.iter().find(|one| one.kind == info.id);
        for place in &found.places {
            let offers = of_kind.iter().flat_map(|one| &one.offers);
            let offer = offers.into_iter().find(|offer| offer.place == place.id);
            let added = session.edit(entry(info.id, &place.target));
            let Some(offer) = offer else {
                // It does not fit, or it is not meant for this place.
                if added.is_ok() {
                    session.undo().expect("undo works");
                }
                continue;
            };
            added.unwrap_or_else(|error| panic!("{} on {place:?}: {error}", info.id));
            let row = &session.rows()[0];
            let members = &row.constraints.members;
            assert_eq!(members.len(), offer.constraints, "{}", info.id);
            // Points of edges are their ends.
            let each = if offer.words.contains(" edge") { 2 } else { 1 };
            let sizes: Vec<usize> = members.iter().map(|member| member.len() / each).collect();
            let mean = sizes.iter().sum::<usize>() as f64 / sizes.len() as f64;
            let is_one = sizes.iter().all(|size| *size == sizes[0]);
            let size = if is_one { sizes[0].to_string() } else { words::decimal(mean, 1) };
            assert!(offer.words.contains(&format!(" of {size} ")), "{}: {size}", offer.words);
            assert_eq!(row.skipped, offer.skipped, "{}", info.id);
            session.undo().expect("undo works");
            offered += 1;
        }
    }
    assert!(offered > KINDS.len(), "most kinds fit in several places: {offered}");
}

#[test]
fn constraints_of_several_sizes_are_not_said_to_have_one() {
    // Of a triangle and a pentagon it said "2 constraints of 4 vertices."
    let outlines = [vec![[0, 0], [2, 0], [1, 1]], vec![[4, 0], [6, 0], [7, 1], [5, 2], [3, 1]]];
    let mut mesh = Mesh::default();
    for outline in outlines {
        let first = mesh.positions.len() as u32;
        mesh.positions.extend(outline.iter().map(|[x, y]| [f64::from(*x), f64::from(*y), 0.0]));
        mesh.faces.push(&(first..mesh.positions.len() as u32).collect::<Vec<u32>>());
    }
    let found = offers(&session(mesh), &[]);
    let of_plane = found.kinds.iter().find(|one| one.kind == "plane").expect("faces can be planes");
    let offer = of_plane.offers.iter().find(|offer| offer.place == "each-face").expect("each face");
    assert_eq!(offer.words, "2 constraints of 4.0 vertices on average.");
}

#[test]
fn a_kind_that_can_be_added_to_every_element_of_a_type_is_offered_there() {
    let mut session = session(bumpy(3));
    let found = offers(&session, &[]);
    for info in KINDS {
        let of_kind = found.kinds.iter().find(|one| one.kind == info.id);
        for element in Element::ALL {
            let id = format!("each-{}", element.id());
            let is_offered =
                of_kind.is_some_and(|one| one.offers.iter().any(|offer| offer.place == id));
            let is_meant = info.elements.is_empty() || info.elements.contains(&element);
            let added = session.edit(entry(info.id, &place(&found, &id).target)).is_ok();
            if added {
                session.undo().expect("undo works");
            }
            assert_eq!(is_offered, added && is_meant, "{} on {id}", info.id);
        }
    }
}

#[test]
fn a_place_is_written_in_a_form_that_reads_back() {
    let session = session(bumpy(4));
    for (vertices, faces) in
        [(vec![], vec![]), (vec![0, 1, 5], vec![]), (vec![0, 1, 5, 6], vec![0])]
    {
        let found = session.constraint_offers(vertices, faces).expect("everything is there");
        for place in found.places {
            let text = serde_json::to_string(&place.target).expect("it is plain data");
            assert_eq!(
                serde_json::from_str::<ConstraintTarget>(&text).unwrap(),
                place.target,
                "{text}"
            );
        }
    }
}

#[test]
fn within_a_selection_a_kind_is_offered_on_the_elements_that_it_is_meant_for() {
    let session = session(bumpy(4));
    let labels = |found: &ConstraintOffers, kind: &str| -> Vec<String> {
        let of_kind = found.kinds.iter().find(|one| one.kind == kind).expect("it is offered");
        of_kind.offers.iter().map(|offer| place(found, &offer.place).label.clone()).collect()
    };
    let of_vertices = offers(&session, &[0, 1, 2, 5, 6, 7, 10, 11, 12]);
    let of_faces = session
        .constraint_offers(vec![0, 1, 2, 5, 6, 7, 10, 11, 12], vec![0, 1, 4, 5])
        .expect("everything is there");
    // A plane acts on any element: within the selection it is offered on what is selected.
    assert!(!labels(&of_vertices, "plane").iter().any(|label| label.contains("within")));
    assert_eq!(labels(&of_vertices, "plane")[0], "whole selection together");
    assert_eq!(labels(&of_faces, "plane")[1], "each selected face");
    // A conical vertex needs an inner vertex and its neighbours.
    assert_eq!(labels(&of_vertices, "conical")[0], "each inner vertex, within the selection");
    // Without a selection there is none of this.
    let of_nothing = offers(&session, &[]);
    assert!(of_nothing.places.iter().all(|place| !place.label.contains("select")));
    assert_eq!(of_nothing.places.len(), Element::ALL.len());
}

#[test]
fn kinds_that_fit_nowhere_are_named_with_what_they_are_for() {
    let found = offers(&session(bumpy(3)), &[]);
    assert_eq!(found.kinds.len() + found.misfits.len(), KINDS.len());
    let number = words::count(found.misfits.len(), "shape does", "shapes do");
    assert_eq!(found.misfit, format!("{number} not fit here"));
    // A grid of quads has no tetrahedra and no edges between triangles.
    let of = |label: &str| found.misfits.iter().find(|one| one.starts_with(label));
    assert_eq!(of("Volume").unwrap(), "Volume: it is for each tetrahedron");
    assert_eq!(of("Bending").unwrap(), "Bending: it is for each edge between two triangles");
}

#[test]
fn an_offer_is_said_in_words() {
    let mut mesh = bumpy(4);
    mesh.faces.push(&[0, 1, 6]);
    let words = |found: &ConstraintOffers, kind: &str, id: &str| {
        let of_kind = found.kinds.iter().find(|one| one.kind == kind).expect("it is offered");
        let offer = of_kind.offers.iter().find(|offer| offer.place == id).expect("it fits");
        offer.words.clone()
    };
    let found = offers(&session(mesh), &[0, 1, 2]);
    let even = offers(&session(bumpy(4)), &[]);
    assert_eq!(words(&found, "line", "selection"), "1 constraint of 3 vertices.");
    assert_eq!(words(&found, "plane", "each-face"), "17 constraints of 3.9 vertices on average.");
    let skipped = "16 constraints of 4 vertices. 1 skipped: its number of vertices does not fit.";
    assert_eq!(words(&found, "square", "each-face"), skipped);
    // Kinds on edges counted the two ends of each: "16 constraints of 8 vertices".
    assert_eq!(words(&even, "equal-length", "each-face"), "16 constraints of 4 edges.");
    assert_eq!(words(&even, "equal-length", "each-boundary"), "1 constraint of 16 edges.");
}

#[test]
fn the_usual_kind_follows_from_what_the_place_is_to_the_mesh() {
    // 5 by 5 vertices, row by row.
    let session = session(bumpy(4));
    let usual = |vertices: &[u32], id: &str| -> Vec<&str> {
        let kinds = offers(&session, vertices).kinds.into_iter();
        let is_usual =
            |one: &OfferedKind| one.offers.iter().any(|offer| offer.place == id && offer.usual);
        kinds.filter(is_usual).map(|one| one.kind).collect()
    };
    let selected = |vertices: &[u32]| usual(vertices, "selection");
    assert_eq!(usual(&[], "each-face"), ["plane", "circle"]);
    assert_eq!(usual(&[], "each-boundary"), ["circle"]);
    assert_eq!(usual(&[], "each-edge"), ["line-segment"]);
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
fn the_usual_kind_of_the_first_place_that_has_one_is_chosen_at_first() {
    let session = session(bumpy(4));
    let start = |vertices: &[u32]| {
        let OfferedStart { kind, place } = offers(&session, vertices).start.expect("kinds fit");
        (kind, place)
    };
    assert_eq!(start(&[]), ("plane", "each-face".to_owned()));
    assert_eq!(start(&[0, 1, 2, 5, 6, 7, 10, 11, 12]), ("sphere", "selection".to_owned()));
    // The whole mesh has no usual kind together: each of its faces has.
    let all: Vec<u32> = (0..25).collect();
    assert_eq!(start(&all).0, "plane");
    // One vertex has none: the first kind that fits, at its first place.
    let points = Mesh { positions: bumpy(2).positions, ..Mesh::default() };
    let found = offers(&self::session(points), &[3]);
    let first = &found.kinds[0];
    assert!(found.kinds.iter().all(|one| one.offers.iter().all(|offer| !offer.usual)));
    let expected = OfferedStart { kind: first.kind, place: first.offers[0].place.clone() };
    assert_eq!(found.start, Some(expected));
}

#[test]
fn an_unknown_place_is_an_error() {
    let error = session(bumpy(2)).constraint_offers(vec![99], Vec::new());
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
