//! Replacing a scene by another: a refused scene leaves the previous one unchanged.

use crate::support::grid::grid;
use shape_up::mesh::Mesh;
use shape_up::scene::Scene;
use shape_up::session::{Edit, Remeshing, Session};

fn bumpy() -> Mesh {
    grid(6, 5, |i, j| [f64::from(i), f64::from(j), 0.3 * f64::from((i * 7 + j * 3) % 4)])
}

fn scene(handles: &str) -> Scene {
    let text = format!(
        r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "grid.obj" }},
            "constraints": [ {{ "kind": "plane", "on": "faces" }} ],
            "closeness": {{ "to": "none" }}, "handles": {handles} }}"#
    );
    Scene::from_json(&text).expect("the scene is valid")
}

const HELD: &str =
    r#"[ { "vertices": [0, 6], "weight": 10 }, { "vertices": [41], "fixed": true } ]"#;
/// The weight is negligible beside the weights of the planes.
const SINGULAR: &str = r#"[ { "vertices": [0], "weight": 1e-20 } ]"#;

/// A session in use: iterated, a handle added, iterated again.
fn begun() -> Session {
    let mut session = Session::open(scene(HELD), bumpy()).expect("the scene can be opened");
    session.start_trace();
    let run = |session: &mut Session| {
        session.begin_run();
        for _ in 0..5 {
            session.step().expect("positions stay finite");
        }
        session.end_run();
    };
    run(&mut session);
    session.edit(Edit::AddHandles { vertices: vec![20], fixed: false }).expect("the edit is valid");
    run(&mut session);
    session
}

#[test]
fn a_scene_that_is_refused_leaves_the_one_before_as_it_was() {
    let off_the_mesh = scene(r#"[ { "vertices": [900], "weight": 1 } ]"#);
    for refused in [scene(SINGULAR), off_the_mesh] {
        let mut open = Some(begun());
        let error = Session::replace(&mut open, refused, bumpy()).err();
        error.expect("the scene is refused");
        let (mut after, mut before) = (open.expect("the one before is open"), begun());
        assert_eq!(after.scene(), before.scene());
        assert_eq!(after.positions(), before.positions());
        assert_eq!(after.solver().energy(), before.solver().energy());
        assert_eq!(after.solver().handles(), before.solver().handles());
        assert_eq!(after.iteration(), 10);
        assert_eq!(after.trace(), before.trace());
        // Everything can be undone, and the session can continue from there.
        for _ in 0..3 {
            assert_eq!(after.undo(), before.undo());
            assert_eq!(after.positions(), before.positions());
        }
        assert_eq!(after.undo(), Ok(None));
        after.step().expect("positions stay finite");
    }
}

#[test]
fn a_scene_takes_the_place_of_the_one_before_or_of_none() {
    let mut open = None;
    Session::replace(&mut open, scene(SINGULAR), bumpy()).err().expect("the scene is refused");
    assert!(open.is_none());
    for _ in 0..2 {
        let session = Session::replace(&mut open, scene(HELD), bumpy()).expect("it can be opened");
        assert_eq!(session.iteration(), 0);
        session.step().expect("positions stay finite");
    }
    assert_eq!(open.map(|session| session.iteration()), Some(1));
}

#[test]
fn a_scene_that_is_refused_leaves_a_refined_mesh_one_that_was_derived() {
    let mut session = Session::open(scene("[]"), bumpy()).expect("the scene can be opened");
    let corner = Edit::Remesh(Remeshing {
        operation: "delete".to_owned(),
        sizes: Vec::new(),
        vertices: Vec::new(),
        faces: vec![0],
    });
    session
        .edit(Edit::AddHandles { vertices: vec![0], fixed: true })
        .and_then(|_| session.edit(corner))
        .expect("the edits are valid");
    let (generation, lost) = (session.mesh_generation(), session.lost().to_vec());
    assert_eq!((generation, lost.len()), (1, 1));
    let mut open = Some(session);
    Session::replace(&mut open, scene(SINGULAR), bumpy()).err().expect("the scene is refused");
    let mut session = open.expect("the one before is open");
    assert_eq!((session.mesh_generation(), session.lost()), (generation, &*lost));
    // The page asks for the mesh again because its generation is another one.
    session.undo().expect("it was solvable");
    assert_eq!(session.mesh_generation(), 0);
}
