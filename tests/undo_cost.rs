//! Cost of a step of undo: it shares the lists of elements that it does not change with those around
//! it, and the bytes of positions, meshes, handles and constraints in the history are bounded.
//!
//! Each step used to hold a copy of the whole scene, and undo or redo copied it three more times:
//! renaming a row took as long as two iterations at 100,000 vertices.

use crate::support::grid::grid;
use shape_up::constraint::Selector;
use shape_up::mesh::Mesh;
use shape_up::scene::{ConstraintSpec, MeshSource, Scene, Weights};
use shape_up::session::{Edit, NewConstraint, Session};

fn open(mesh: Mesh) -> Session {
    let mut scene = Scene::new(MeshSource::File("site.obj".to_owned()));
    scene.weights = Weights { shape: 1.0, close: 0.1, smooth: 0.1 };
    let row = serde_json::from_str::<ConstraintSpec>(r#"{ "kind": "plane", "on": "faces" }"#);
    scene.constraints.push(row.expect("the constraint is valid"));
    Session::open(scene, mesh).expect("the scene is valid")
}

fn bumpy(side: u32) -> Mesh {
    grid(side, side, |i, j| [f64::from(i), f64::from(j), f64::from((i * 5 + j * 7) % 4) / 7.0])
}

fn rename(name: &str) -> Edit {
    Edit::RenameConstraint { index: 0, name: name.to_owned() }
}

fn undone(session: &mut Session) -> usize {
    let mut steps = 0;
    while session.undo().expect("the state was solvable").is_some() {
        steps += 1;
    }
    steps
}

#[test]
fn edits_and_undo_leave_lists_of_elements_where_they_are() {
    let mut session = open(bumpy(9));
    let vertices: Vec<u32> = (0..50).collect();
    let fixed = Edit::AddHandles { vertices: vec![3], fixed: true };
    let at = |vertices: Vec<u32>| {
        let text = format!(r#"{{ "kind": "sphere", "on": {{ "vertices": {vertices:?} }} }}"#);
        let spec = serde_json::from_str::<ConstraintSpec>(&text).expect("the constraint is valid");
        Edit::AddConstraint(NewConstraint { spec, set: None })
    };
    let (name, faces) = ("eaves".to_owned(), Vec::new());
    session.edit(Edit::NameSet { name, vertices: vertices.clone(), faces }).expect("it is a set");
    session.edit(Edit::HoldClose { vertices: Some(vertices.clone()), weight: 2.0 }).expect("valid");
    session.edit(at(vertices)).expect("any vertices may lie on a sphere");
    let places = |session: &Session| {
        let document = session.document();
        let of = |on: &Selector| match on {
            Selector::Vertices(vertices) => vertices.as_ptr() as usize,
            other => panic!("{other:?}"),
        };
        let set = document.sets["eaves"].vertices.as_ptr() as usize;
        [set, of(&document.closeness.weights[0].on), of(&document.constraints[1].on)]
    };
    let before = places(&session);
    let edits = [
        rename("roof"),
        fixed,
        Edit::SetWeights(Weights { shape: 3.0, close: 0.1, smooth: 0.1 }.into()),
        Edit::SetConstraint {
            index: 0,
            weight: Some(2.0),
            require: None,
            enabled: None,
            params: serde_json::Map::new(),
        },
        Edit::SetUnits { units: "m".to_owned() },
        Edit::Reset,
    ];
    session.begin_run();
    session.step().expect("positions stay finite");
    session.end_run();
    for edit in edits {
        let words = format!("{edit:?}");
        assert!(session.edit(edit).expect("it can be made"), "{words}");
        assert_eq!(places(&session), before, "{words}");
        session.undo().expect("the state was solvable");
        assert_eq!(places(&session), before, "{words} undone");
        session.redo().expect("the state was solvable");
        assert_eq!(places(&session), before, "{words} redone");
    }
}

#[test]
fn what_the_solver_does_not_know_of_leaves_it_converged() {
    let mut session = open(bumpy(4));
    session.begin_run();
    while !session.step().expect("positions stay finite").ended {}
    session.end_run();
    assert!(session.converged());
    session.edit(rename("roof")).expect("the row is there");
    session.edit(Edit::SetUnits { units: "m".to_owned() }).expect("any unit will do");
    assert!(session.converged());
    session.undo().expect("the state was solvable");
    assert!(session.converged());
}

#[test]
fn steps_are_forgotten_by_the_bytes_that_they_hold() {
    // 252 kB of positions: 266 copies would be 64 MB.
    let mut session = open(bumpy(102));
    for _ in 0..300 {
        session.single_step().expect("positions stay finite");
    }
    let steps = undone(&mut session);
    assert!((260..=266).contains(&steps), "{steps}");
    // Undone steps need as much memory.
    let mut redone = 0;
    while session.redo().expect("the state was solvable").is_some() {
        redone += 1;
    }
    assert!((260..=steps).contains(&redone), "{redone}");
}

#[test]
fn the_lists_of_a_document_count_as_well() {
    // Each document that was changed held a list of its own, without a bound.
    let mut session = open(bumpy(1));
    let row = session.document().constraints[0].clone();
    for k in 0..2000 {
        let spec = ConstraintSpec { name: format!("row {k}"), enabled: false, ..row.clone() };
        let added = Edit::AddConstraint(NewConstraint { spec, set: None });
        session.edit(added).expect("any row will do");
    }
    let most = (64 << 20) / (session.document().constraints.len() * size_of::<ConstraintSpec>());
    for k in 0..2 * most {
        session.edit(rename(&format!("roof {k}"))).expect("the row is there");
    }
    let steps = undone(&mut session);
    assert!((most.saturating_sub(2)..=most + 1).contains(&steps), "{steps} of {most}");
}

#[test]
fn steps_that_leave_the_shape_as_it_is_do_not_hold_it() {
    // 252 kB of positions: 266 copies would be 64 MB.
    let mut session = open(bumpy(102));
    for k in 0..300 {
        session.edit(rename(&format!("roof {k}"))).expect("the row is there");
    }
    assert_eq!(undone(&mut session), 300);
}
