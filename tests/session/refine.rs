//! Refining the mesh of a session: what is carried over, what is dropped and reported, undo, and
//! refining at once or level by level.

use crate::support::grid::{bumpy, grid};
use crate::support::shared;
use shape_up::mesh::{KEPT_TURN, Mesh, Scheme};
use shape_up::scene::{MeshSource, Scene};
use shape_up::session::{Edit, Session};

pub(crate) fn open(text: &str, mesh: Mesh) -> Session {
    let head = r#"{ "format": "shape-up-scene", "version": 1, "mesh": { "file": "own.obj" }"#;
    let scene = Scene::from_json(&format!("{head}, {text} }}")).expect("the scene is valid");
    Session::open(scene, mesh).expect("it fits the mesh")
}

fn refine(scheme: Scheme, levels: u32) -> Edit {
    Edit::Refine { scheme, levels, keep: KEPT_TURN, adopt: false }
}

pub(crate) fn everything(session: &Session) -> (String, Vec<[u64; 3]>) {
    (session.scene().to_json(session.mesh()), bits(session))
}

/// The same, with the mesh.
fn with_mesh(session: &Session) -> (String, Vec<[u64; 3]>) {
    (session.scene_with_mesh(), bits(session))
}

fn bits(session: &Session) -> Vec<[u64; 3]> {
    session.positions().iter().map(|point| point.map(f64::to_bits)).collect()
}

/// Sets, constraints and handles of every sort, for a wavy grid of 4 by 4 quads.
const ALL: &str = r#"
    "sets": { "eaves": { "vertices": "0-4" }, "corner": { "vertices": [0, 1, 5, 6], "faces": [0] } },
    "constraints": [
        { "kind": "circle", "on": "faces", "require": { "within": 0.01 } },
        { "kind": "plane", "on": { "set": "eaves" } },
        { "kind": "line", "on": { "vertices": [20, 21, 22, 23, 24] } },
        { "kind": "line-segment", "on": { "each": "edge", "in": "corner" }, "length": 1.5 },
        { "kind": "square", "on": { "vertices": [0, 1, 6, 5] } } ],
    "handles": [ { "vertices": [0, 1], "fixed": true }, { "vertices": [12], "targets": [[2, 2, 3]], "weight": 7 } ],
    "weights": { "shape": 10, "close": 1, "smooth": 1 },
    "closeness": { "to": "rest", "weights": [{ "on": { "vertices": [4, 9] }, "weight": 0 }] },
    "smoothness": { "of": "displacement" }"#;

#[test]
fn sets_constraints_handles_and_weights_go_along_to_the_new_mesh() {
    let mut session = open(ALL, bumpy(4));
    session.edit(refine(Scheme::CatmullClark, 1)).expect("it can be refined");
    assert_eq!((session.mesh().positions.len(), session.mesh().faces.len()), (81, 64));
    let (scene, topology) = (session.document(), session.topology());
    let eaves = &scene.sets["eaves"].vertices;
    assert_eq!(&eaves[..5], [0, 1, 2, 3, 4]);
    assert_eq!(eaves.len(), 9, "a curve gets its new vertices");
    let line: Vec<_> =
        eaves.iter().map(|&v| topology.boundary_loops().iter().any(|l| l.contains(&v))).collect();
    assert!(line.iter().all(|on| *on));
    let corner = &scene.sets["corner"];
    assert_eq!((corner.vertices.len(), &corner.faces[..]), (9, &[0, 1, 2, 3][..]));
    let sizes = session.rows().iter().map(|row| row.constraints.members.indices().len());
    // All quads; the eaves; the line with its new vertices; the edges of the corner; four vertices
    // of a square.
    assert_eq!(sizes.collect::<Vec<_>>(), [256, 9, 9, 24, 4]);
    // Vertices 0 and 1 and the new one between them are fixed.
    let handles = session.solver().handles();
    assert_eq!(handles.len(), 4);
    let target = handles.iter().find(|h| h.vertex == 12).expect("it stays at its vertex").target;
    let rest = bumpy(4).positions[12];
    let moved: [f64; 3] = std::array::from_fn(|i| session.positions()[12][i] - rest[i]);
    for i in 0..3 {
        assert!((target[i] - [2.0, 2.0, 3.0][i] - moved[i]).abs() < 1e-12, "it moves along");
    }
    assert_eq!(session.lost().len(), 1, "{:?}", session.lost());
    assert!(session.lost()[0].contains("keeps its given sizes"), "{:?}", session.lost());
    // The saved file opens to the same scene and mesh.
    let again = Scene::from_json(&session.scene_with_mesh()).expect("it can be read");
    let MeshSource::Inline(mesh) = again.mesh.clone() else { panic!("the mesh is in the file") };
    assert_eq!(&*mesh, session.mesh());
    let again = Session::open(again, *mesh).expect("it can be opened");
    assert_eq!(again.positions(), session.positions());
    assert_eq!(again.rows(), session.rows());
}

#[test]
fn moved_is_measured_from_the_refined_original() {
    let mut session = open(
        r#""constraints": [{ "kind": "plane", "on": "faces" }], "weights": { "shape": 9, "close": 1, "smooth": 1 }"#,
        bumpy(4),
    );
    session.edit(refine(Scheme::CatmullClark, 1)).expect("it can be refined");
    assert_eq!(session.moved().max, 0.0, "refined where nothing has moved, nothing has");
    session.undo().expect("it was solvable");
    session.solve(false).expect("it can be solved");
    let before = session.moved();
    session.edit(refine(Scheme::CatmullClark, 1)).expect("it can be refined");
    let after = session.moved();
    assert!(after.max > 0.2 * before.max && after.max < 1.2 * before.max, "{before:?} {after:?}");
}

#[test]
fn a_row_that_has_no_element_any_more_is_left_out_and_said() {
    let mut mesh = grid(2, 2, |i, j| [f64::from(i), f64::from(j), 0.0]);
    mesh.faces = mesh.faces.iter().flat_map(|f| [[f[0], f[1], f[2]], [f[0], f[2], f[3]]]).collect();
    let rows = r#""constraints": [{ "kind": "bending", "on": "hinges" }, { "kind": "plane", "on": "rings" }]"#;
    let mut session = open(rows, mesh);
    session.edit(refine(Scheme::CatmullClark, 1)).expect("it can be refined");
    assert_eq!(session.document().constraints.len(), 1);
    let lost = session.lost();
    assert!(lost.len() == 1 && lost[0].starts_with("Left out: "), "{lost:?}");
    session.undo().expect("it was solvable");
    assert_eq!(session.document().constraints.len(), 2);
}

#[test]
fn refining_is_one_step_of_undo_with_the_run_that_follows() {
    let mut session = open(ALL, bumpy(4));
    session.solve(false).expect("it can be solved");
    let before = everything(&session);
    session.edit_and_run(refine(Scheme::CatmullClark, 1)).expect("it can be refined");
    for _ in 0..5 {
        session.step().expect("positions stay finite");
    }
    session.end_run();
    let after = everything(&session);
    assert_eq!(session.undo_and_redo(), [Some("Refine to 64 faces"), None]);
    session.undo().expect("it was solvable");
    assert_eq!(everything(&session), before);
    assert_eq!(session.mesh_generation(), 0);
    session.redo().expect("it was solvable");
    assert_eq!(everything(&session), after);
    assert_eq!(session.mesh_generation(), 1);
}

/// Undo was empty after a reload.
#[test]
fn a_session_that_is_opened_again_goes_back_to_the_mesh_before() {
    let mut session = open(ALL, bumpy(4));
    session.edit(Edit::AddHandles { vertices: vec![18], fixed: true }).expect("it is there");
    session.edit(refine(Scheme::Linear, 1)).expect("it can be refined");
    session.edit(Edit::RemoveHandles { vertices: vec![18] }).expect("it is there");
    let scene = Scene::from_json(&session.scene_with_mesh()).expect("it can be read");
    let mut again = Session::open(scene, session.mesh().clone()).expect("it can be opened");
    again.restore(&session.saved_history(), &[]).expect("it was saved a moment ago");
    assert_eq!(again.undo_and_redo(), [Some("Remove 1 handle"), None]);
    assert_eq!(again.saved_history(), session.saved_history());
    let generation = again.mesh_generation();
    for _ in 0..3 {
        let undone = again.undo().expect("it was solvable");
        assert_eq!(undone, session.undo().expect("it was solvable"));
        assert!(undone.is_some());
        assert_eq!(with_mesh(&again), with_mesh(&session));
    }
    assert_ne!(again.mesh_generation(), generation, "a host is told of the other mesh");
    assert!(again.undo().expect("it was solvable").is_none());

    // From the first state, the same forward.
    let scene = Scene::from_json(&session.scene_with_mesh()).expect("it can be read");
    let mut first = Session::open(scene, session.mesh().clone()).expect("it can be opened");
    first.restore(&session.saved_history(), &[]).expect("it was saved a moment ago");
    for _ in 0..3 {
        let redone = first.redo().expect("it was solvable");
        assert_eq!(redone, session.redo().expect("it was solvable"));
        assert!(redone.is_some());
        assert_eq!(with_mesh(&first), with_mesh(&session));
    }

    let history = session.saved_history();
    for end in (1..history.len()).step_by(7) {
        again.restore(&history[..end], &[]).expect_err("it is cut off");
    }
}

#[test]
fn a_mesh_that_cannot_be_refined_leaves_the_session_as_it_is() {
    let mut session = open(ALL, bumpy(4));
    let before = everything(&session);
    let refused = session.edit(refine(Scheme::Loop, 1)).expect_err("they are quads");
    assert!(refused.to_string().contains("16 faces are not triangles"), "{refused}");
    assert_eq!(everything(&session), before);
    assert_eq!(session.undo_and_redo(), [None, None]);
}

#[test]
fn level_by_level_the_panels_of_a_real_mesh_become_flat_and_it_is_as_good_as_all_at_once() {
    let Some(mesh) = shared::mesh("compas_hypar.obj") else { return };
    let start = || {
        let mut scene = Scene::opened("own.obj");
        let require = shape_up::solve::Require::Soft;
        scene.request_panels("plane", require, &mesh).expect("they can be flat");
        Session::open(scene, mesh.clone()).expect("it fits")
    };
    let mut level_by_level = start();
    level_by_level.solve(false).expect("it can be solved");
    for _ in 0..2 {
        level_by_level.edit(refine(Scheme::CatmullClark, 1)).expect("it can be refined");
        level_by_level.solve(false).expect("it can be solved");
    }
    let mut at_once = start();
    at_once.edit(refine(Scheme::CatmullClark, 2)).expect("it can be refined");
    at_once.solve(false).expect("it can be solved");
    // Both have the same original mesh, so that energies are comparable.
    for (a, b) in level_by_level.mesh().positions.iter().zip(&at_once.mesh().positions) {
        (0..3).for_each(|i| {
            assert!((a[i] - b[i]).abs() < 1e-9 * level_by_level.mean_edge().max(1.0));
        });
    }
    let [a, b] = [&level_by_level, &at_once].map(|session| session.solver().energy().total);
    assert!(a < 1.05 * b, "{a} {b}");
}

#[test]
fn where_each_level_is_the_original_of_the_next_it_is_smoother_and_folds_nowhere() {
    let Some(mesh) = shared::mesh("compas_hypar.obj") else { return };
    let flat = |levels: u32, adopt: bool| {
        let mut scene = Scene::opened("own.obj");
        let require = shape_up::solve::Require::Exact;
        scene.request_panels("plane", require, &mesh).expect("they can be flat");
        let mut session = Session::open(scene, mesh.clone()).expect("it fits");
        if adopt {
            for _ in 0..levels {
                session.solve(false).expect("it can be solved");
                let once = Edit::Refine {
                    scheme: Scheme::CatmullClark,
                    levels: 1,
                    keep: KEPT_TURN,
                    adopt,
                };
                session.edit(once).expect("it can be refined");
                // The refined shape is the new rest shape: "moved" is measured from it.
                assert_eq!(session.moved().max, 0.0);
            }
        } else {
            session.edit(refine(Scheme::CatmullClark, levels)).expect("it can be refined");
        }
        session.solve(false).expect("it can be solved");
        assert!(session.exact().is_some_and(|report| report.met));
        let tolerance = session.tolerance();
        let verdict = session.verdict(tolerance).expect("panels are asked");
        println!("{:?}", verdict.attempts);
        let folded = verdict.folded;
        (session.solver().energy().smooth, folded)
    };
    let (at_once, by_levels) = (flat(3, false), flat(3, true));
    assert_eq!(by_levels.1, 0);
    assert!(4.0 * by_levels.0 < at_once.0, "{by_levels:?} {at_once:?}");
}

#[test]
fn undo_brings_back_the_original_that_another_shape_replaced() {
    let mut session = open(ALL, bumpy(4));
    session.solve(false).expect("it can be solved");
    let before = everything(&session);
    let moved = session.moved();
    let adopt =
        Edit::Refine { scheme: Scheme::CatmullClark, levels: 1, keep: KEPT_TURN, adopt: true };
    session.edit(adopt).expect("it can be refined");
    assert_eq!(session.moved().max, 0.0);
    session.undo().expect("it was solvable");
    assert_eq!((everything(&session), session.moved()), (before, moved));
}

#[test]
fn an_original_that_another_shape_replaced_is_the_design_too() {
    // Closeness stayed to the variation that was open before.
    let mut session = open(ALL, bumpy(4));
    let start = session.positions().into();
    session.edit(Edit::KeepVariant { start }).expect("there is room");
    session.solve(false).expect("it can be solved");
    let adopt = Edit::Refine { scheme: Scheme::Linear, levels: 1, keep: KEPT_TURN, adopt: true };
    session.edit(adopt).expect("it can be refined");
    let variants = &session.document().variants;
    assert_eq!((variants.kept.len(), variants.design), (2, None));
    assert_eq!(session.scene().current, None);
}

#[test]
fn what_refining_makes_is_said_beforehand() {
    let said = |session: &Session, scheme| session.refinements(scheme, KEPT_TURN);
    let mut session = open(ALL, bumpy(4));
    let made = said(&session, Scheme::CatmullClark).expect("it can be refined");
    assert!(made.len() >= 3);
    for (levels, known) in (1..).zip(&made[..3]) {
        session.edit(refine(Scheme::CatmullClark, levels)).expect("it can be refined");
        let mesh = session.mesh();
        assert_eq!((mesh.positions.len(), mesh.faces.len()), (known.vertices, known.faces));
        let edge = session.mean_edge() / known.edge;
        assert!((0.8..1.1).contains(&edge), "about: {edge}");
        session.undo().expect("it was solvable");
    }
    // No triangle scheme on quads, and at most 100,000 faces.
    assert!(said(&session, Scheme::Loop).is_err());
    assert!(made.iter().all(|one| one.faces <= 100_000));
}
