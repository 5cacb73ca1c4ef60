//! The seams of a paper model: they are edges of the mesh, and go along to another one.

use crate::session::refine::{everything, open};
use crate::session::saved_history::written;
use crate::support::grid::bumpy;
use serde_json::{Map, Value, json};
use shape_up::mesh::{KEPT_TURN, MESH_OPERATIONS, Scheme};
use shape_up::scene::Scene;
use shape_up::session::{Edit, Remeshing, Session};
use std::collections::BTreeSet;

/// A grid of 4 by 4 quads, cut between its two middle columns and once across.
const CUT: &str = r#""constraints": [{ "kind": "circle", "on": "faces" }], "build": { "product": "paper",
    "seams": [[2, 7], [7, 12], [12, 17], [17, 22], [13, 12]] }"#;

fn set(seams: Value) -> Edit {
    Edit::SetBuild { values: Map::from_iter([("seams".to_owned(), seams)]) }
}

fn seams(session: &Session) -> Vec<[u32; 2]> {
    session.document().build.as_ref().map_or_else(Vec::new, |build| build.seams.to_vec())
}

fn remesh(operation: &str, vertices: &[u32], faces: &[u32]) -> Edit {
    let sizes = Vec::new();
    let (vertices, faces) = (vertices.to_vec(), faces.to_vec());
    Edit::Remesh(Remeshing { operation: operation.to_owned(), sizes, vertices, faces })
}

/// Expects seams that are edges between two faces, and a scene that opens again with them.
fn assert_fit(session: &Session) {
    let topology = session.topology();
    for [a, b] in seams(session) {
        let edge = topology.edge(a, b).expect("a seam is an edge");
        assert_eq!(topology.edge_faces().row(edge as usize).len(), 2);
    }
    let scene = Scene::from_json(&session.scene_with_mesh()).expect("it can be read");
    assert_eq!(scene.build.map(|build| build.seams.to_vec()), Some(seams(session)));
}

#[test]
fn seams_are_set_as_one_step_and_must_be_edges() {
    let mut session = open(r#""constraints": []"#, bumpy(4));
    let before = written(&session);
    assert!(session.edit(set(json!([[7, 12], [12, 13]]))).expect("both are edges"));
    assert_eq!(seams(&session), [[7, 12], [12, 13]]);
    for (wrong, path) in [
        (json!([[7, 12], [7, 13]]), "build.seams[1]"),
        (json!([[7, 999]]), "build.seams[0]"),
        (json!([[7, 12], [12, 7]]), "build.seams[1]"),
        (json!("7-12"), "build.seams"),
        (Value::Null, "build.seams"),
    ] {
        let refused = session.edit(set(wrong)).expect_err("it does not fit").to_string();
        assert!(refused.contains(path), "{refused}");
        assert_eq!(seams(&session), [[7, 12], [12, 13]]);
    }
    assert_eq!(session.undo().expect("it was solvable").as_deref(), Some("Change build settings"));
    assert_eq!(written(&session), before);
    session.redo().expect("it was solvable");
    assert!(session.edit(set(json!([]))).expect("none are a list too"));
    assert_eq!(seams(&session), [[0; 2]; 0]);
}

#[test]
fn a_file_whose_seams_are_no_edges_is_refused() {
    let head = r#"{ "format": "shape-up-scene", "version": 1, "mesh": { "file": "own.obj" }"#;
    let text = format!("{head}, \"build\": {{ \"seams\": [[0, 1], [0, 12]] }} }}");
    let scene = Scene::from_json(&text).expect("its form is right");
    let Err(refused) = Session::open(scene, bumpy(4)) else { panic!("it has no such edge") };
    let words = "build.seams[1]: found [0, 12], expected the ends of an edge";
    assert!(refused.to_string().contains(words), "{refused}");
}

#[test]
fn refined_edges_are_cut_along_their_whole_length() {
    for (scheme, levels, pieces) in
        [(Scheme::CatmullClark, 1, 2), (Scheme::CatmullClark, 2, 4), (Scheme::Linear, 2, 4)]
    {
        let mut session = open(CUT, bumpy(4));
        let before = everything(&session);
        let edit = Edit::Refine { scheme, levels, keep: KEPT_TURN, adopt: false };
        session.edit(edit).expect("it can be refined");
        assert_fit(&session);
        let now = seams(&session);
        assert_eq!(now.len(), 5 * pieces, "{scheme:?}");
        // They join the same vertices: the path branches at 12, and ends at 2, 22 and 13.
        let degree = |v: u32| now.iter().filter(|edge| edge.contains(&v)).count();
        assert_eq!([2, 7, 12, 13, 17, 22].map(degree), [1, 2, 3, 1, 2, 1], "{scheme:?}");
        let inside: BTreeSet<u32> = now.iter().flatten().copied().filter(|v| *v >= 25).collect();
        assert!(inside.len() == 5 * (pieces - 1) && inside.into_iter().all(|v| degree(v) == 2));
        assert_eq!(session.lost(), [""; 0]);
        session.undo().expect("it was solvable");
        assert_eq!(everything(&session), before);
    }
}

#[test]
fn seams_follow_their_vertices_to_other_numbers_and_those_of_edges_that_are_gone_are_told() {
    let mut session = open(CUT, bumpy(4));
    // Vertex 0 is gone with its face: all others have one number less.
    session.edit(remesh("delete", &[], &[0])).expect("it can be deleted");
    assert_fit(&session);
    let mut now = seams(&session);
    now.sort_unstable();
    assert_eq!(now, [[1, 6], [6, 11], [11, 12], [11, 16], [16, 21]]);
    assert_eq!(session.lost(), [""; 0]);
    // With the faces on both sides of an edge it is gone: 9 and 10 are below and above it.
    let mut session = open(CUT, bumpy(4));
    session.edit(remesh("delete", &[], &[5, 9, 6, 10])).expect("they can be deleted");
    let mut now = seams(&session);
    now.sort_unstable();
    assert_eq!(now.len(), 2, "{now:?}");
    let told = "Left out: 3 seams of the paper model, along which there is no edge.";
    assert_eq!(session.lost(), [told]);
    session.undo().expect("it was solvable");
    assert_eq!(seams(&session).len(), 5);
}

#[test]
fn seams_fit_the_mesh_after_every_operation() {
    for operation in MESH_OPERATIONS {
        let mut session = open(CUT, bumpy(4));
        let offered = session.operations();
        let own = offered.iter().find(|own| own.operation.id == operation.id).expect("it is there");
        for (vertices, faces) in [(vec![], vec![]), (vec![], vec![5, 6]), (vec![12, 13], vec![])] {
            let (operation, sizes) = (operation.id.to_owned(), own.defaults.clone());
            let asked = Remeshing { operation, sizes, vertices, faces };
            // Many refuse what is selected, or nothing.
            let _ = session.edit(Edit::Remesh(asked));
            let topology = session.topology();
            assert!(seams(&session).iter().all(|&[a, b]| topology.edge(a, b).is_some()));
            Scene::from_json(&session.scene_with_mesh()).expect("it can be read");
        }
    }
}
