//! Editing the mesh of a session: what is carried over, what is dropped and reported, undo, and the
//! forecast.

use crate::session::refine::{everything, open};
use crate::support::grid::{bumpy, grid};
use shape_up::mesh::{Mesh, Ragged, Scheme};
use shape_up::session::{Edit, Remeshing, RemeshingPreview, Session};

fn remeshing(operation: &str, sizes: &[f64], vertices: &[u32], faces: &[u32]) -> Remeshing {
    Remeshing {
        operation: operation.to_owned(),
        sizes: sizes.to_vec(),
        vertices: vertices.to_vec(),
        faces: faces.to_vec(),
    }
}

fn flat(columns: u32, rows: u32) -> Mesh {
    grid(columns, rows, |i, j| [f64::from(i), f64::from(j), 0.0])
}

/// Sets, constraints and handles of every sort, for a grid of 4 by 4 quads.
const ALL: &str = r#"
    "sets": { "left": { "faces": [0, 4, 8, 12] }, "corner": { "vertices": [23, 24], "faces": [15] } },
    "constraints": [
        { "kind": "circle", "on": "faces" },
        { "kind": "plane", "on": { "each": "face", "in": "left" } },
        { "kind": "line", "on": { "vertices": [20, 21, 22, 23, 24] } },
        { "kind": "line-segment", "on": { "vertices": [23, 24] }, "length": 1.5 } ],
    "handles": [ { "vertices": [0, 24], "fixed": true }, { "vertices": [12], "targets": [[2, 2, 3]], "weight": 7 } ],
    "closeness": { "to": "rest", "weights": [{ "on": { "vertices": [24] }, "weight": 0 }] }"#;

#[test]
fn what_is_left_goes_along_and_what_is_gone_is_said() {
    let mut session = open(ALL, bumpy(4));
    let before = everything(&session);
    // The corner face is deleted together with vertex 24.
    let asked = remeshing("delete", &[], &[], &[15]);
    let said = session.remeshing(&asked).expect("it can be deleted");
    assert_eq!(everything(&session), before, "asking changes nothing");
    session.edit(Edit::Remesh(asked)).expect("it can be deleted");
    assert_eq!((session.mesh().positions.len(), session.mesh().faces.len()), (24, 15));
    let scene = session.document();
    assert_eq!(*scene.sets["left"].faces, [0, 4, 8, 12]);
    assert_eq!(
        (&scene.sets["corner"].vertices[..], scene.sets["corner"].faces.len()),
        (&[23][..], 0)
    );
    // The line keeps its remaining vertices; a segment needs both ends.
    let labels: Vec<_> = scene.constraints.iter().map(|row| row.kind.info().id).collect();
    assert_eq!(labels, ["circle", "plane", "line"]);
    assert_eq!(session.rows()[2].constraints.members.row(0), [20, 21, 22, 23]);
    assert_eq!(session.solver().handles().len(), 2);
    assert!(scene.closeness.weights.is_empty());
    let lost = session.lost();
    assert_eq!(said.lost, lost);
    assert!(lost.len() == 3 && lost.iter().all(|s| s.starts_with("Left out: ")), "{lost:?}");
    assert!(lost.iter().any(|sentence| sentence.contains("1 handle")), "{lost:?}");
    assert!(lost.iter().any(|sentence| sentence.contains("closeness of 1 vertex:")), "{lost:?}");
    session.undo().expect("it was solvable");
    assert_eq!(everything(&session), before);
    session.redo().expect("it was solvable");
    assert_eq!(session.mesh().faces.len(), 15);
}

#[test]
fn closeness_where_nothing_is_left_is_left_out_as_constraints_are() {
    // A cube without its lid: filling the hole leaves no boundary.
    let positions = (0..8u32).map(|v| [v & 1, v >> 1 & 1, v >> 2].map(f64::from)).collect();
    let sides = [[0, 2, 3, 1], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]];
    let mut faces = Ragged::new();
    sides.iter().for_each(|side| faces.push(side));
    let cube = Mesh { positions, faces, ..Mesh::default() };
    let rim = r#""closeness": { "to": "rest", "weights": [{ "on": "boundary", "weight": 5 }] }"#;
    let mut session = open(rim, cube);
    session.edit(Edit::Remesh(remeshing("fill", &[], &[4], &[]))).expect("there is a hole");
    assert!(session.document().closeness.weights.is_empty());
    let lost = session.lost();
    assert!(lost.len() == 1 && lost[0].starts_with("Left out: the closeness of "), "{lost:?}");

    let named = r#""sets": { "corner": { "faces": [15] } }, "closeness": { "to": "rest",
        "weights": [{ "on": { "each": "face", "in": "corner" }, "weight": 5 }] }"#;
    let mut session = open(named, bumpy(4));
    session.edit(Edit::Remesh(remeshing("delete", &[], &[], &[15]))).expect("it can be deleted");
    assert!(session.document().closeness.weights.is_empty());
    assert_eq!(session.lost().len(), 2, "{:?}", session.lost());
}

#[test]
fn sets_go_to_what_was_made_of_them_alone() {
    let mut session = open(ALL, bumpy(4));
    session.edit(Edit::Remesh(remeshing("triangles", &[], &[], &[]))).expect("it can be cut");
    assert_eq!(*session.document().sets["left"].faces, [0, 1, 8, 9, 16, 17, 24, 25]);
    session.edit(Edit::Remesh(remeshing("quads", &[180.0], &[], &[]))).expect("they are pairs");
    assert_eq!(session.mesh().faces.len(), 16);
    assert_eq!(session.document().sets["left"].faces.len(), 4);
    for _ in 0..2 {
        session.undo().expect("it was solvable");
    }
    assert_eq!(session.mesh_generation(), 0);
}

#[test]
fn the_mesh_is_edited_as_it_is_seen_and_moved_stays_what_it_was() {
    let mut session = open(
        r#""constraints": [{ "kind": "plane", "on": "faces" }], "weights": { "shape": 9, "close": 1, "smooth": 1 }"#,
        bumpy(4),
    );
    session.solve(false).expect("it can be solved");
    let (shape, moved) = (session.positions(), session.moved());
    session
        .edit(Edit::Remesh(remeshing("extrude", &[1.0, 0.5], &[], &[])))
        .expect("it has a boundary");
    let now = session.positions();
    assert_eq!(now[..shape.len()], shape[..], "what was there stays where it is");
    // A new vertex is displaced as far as the vertex that it is attached to.
    let after = session.moved();
    assert!((after.max - moved.max).abs() < 1e-12 * moved.max, "{moved:?} {after:?}");
    // The row also acts on the new faces.
    assert_eq!(session.rows()[0].constraints.members.len(), 16 + 16);
}

#[test]
fn what_it_will_do_is_said_in_numbers() {
    let session = open(r#""constraints": []"#, flat(6, 4));
    let said = |asked: Remeshing| session.remeshing(&asked).expect("it can be done");
    let found = said(remeshing("dual", &[75.0], &[], &[]));
    let expected = RemeshingPreview {
        vertices: [35, 48],
        faces: [24, 35],
        corners: [0, 35, 0],
        lost: Vec::new(),
    };
    assert_eq!(found, expected);
    let refused =
        session.remeshing(&remeshing("fill", &[], &[], &[])).expect_err("there is no hole");
    assert!(
        refused.to_string().contains("to close the outline, select one of its vertices"),
        "{refused}"
    );
}

#[test]
fn lengths_fit_the_mesh() {
    for scale in [1e-3, 1.0, 2500.0] {
        let mesh = grid(5, 5, |i, j| [scale * f64::from(i), scale * f64::from(j), 0.0]);
        let session: Session = open(r#""constraints": []"#, mesh);
        let offered = session.operations();
        let extrude =
            offered.iter().find(|one| one.operation.id == "extrude").expect("it is there");
        assert_eq!(extrude.defaults, [scale, 0.0]);
    }
}

#[test]
fn a_refused_operation_changes_nothing() {
    let mut session = open(ALL, bumpy(4));
    let before = everything(&session);
    for asked in [
        remeshing("iron", &[], &[], &[]),
        remeshing("delete", &[], &[], &[]),
        remeshing("delete", &[], &[], &[99]),
        remeshing("weld", &[f64::NAN], &[], &[]),
        remeshing("remove-strip", &[], &[0, 12], &[]),
    ] {
        session.edit(Edit::Remesh(asked)).expect_err("it cannot be done");
        assert_eq!(everything(&session), before);
    }
    assert_eq!(session.undo_and_redo(), [None, None]);
}

#[test]
fn a_seam_that_has_opened_is_joined_where_it_lies_on_itself_at_rest() {
    // Two quads with vertices of their own along x = 1; the second has moved at one of them.
    let mut mesh = flat(1, 1);
    mesh.positions.extend([1.0, 2.0].into_iter().flat_map(|x| [0.0, 1.0].map(|y| [x, y, 0.0])));
    mesh.faces.push(&[4, 6, 7, 5]);
    let mut now = mesh.positions.clone();
    now[5] = [1.0, 1.0, 0.5];
    let mut session = open(&format!(r#" "current": {now:?} "#), mesh);
    session.edit(Edit::Remesh(remeshing("join", &[], &[], &[]))).expect("it has a seam");
    assert_eq!(session.topology().boundary_loops().len(), 1);
    assert_eq!((session.mesh().positions.len(), session.positions()[3]), (6, [1.0, 1.0, 0.25]));
    assert_eq!(session.mesh().positions[3], [1.0, 1.0, 0.0]);
}

#[test]
fn new_faces_that_lie_over_others_are_said() {
    let slab = [[0, 0], [3, 0], [3, 3], [2, 3], [2, 1], [1, 1], [1, 3], [0, 3]];
    let mesh = Mesh {
        positions: slab.map(|[x, y]| [f64::from(x), f64::from(y), 0.0]).to_vec(),
        faces: [(0..8).collect::<Vec<u32>>()].into_iter().collect(),
        ..Mesh::default()
    };
    let mut session = open(r#""title": "slab""#, mesh);
    let refine = Edit::Refine { scheme: Scheme::Linear, levels: 1, keep: 75.0, adopt: false };
    session.edit(refine).expect("it can be refined");
    assert!(session.lost()[0].contains("turned over or without area"), "{:?}", session.lost());
}
