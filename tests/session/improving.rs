//! Improving an exact shape in a session, and single steps on a scene with hard constraints.

use crate::support::grid::grid;
use serde_json::json;
use shape_up::mesh::Mesh;
use shape_up::scene::{Scene, UnitsAndUp};
use shape_up::session::{DragPhase, Edit, FileReader, HalfStep, Session};

/// Rough bumps on which all panels are required to be flat.
fn rough() -> Session {
    let mesh = grid(6, 6, |i, j| {
        let (x, y) = (f64::from(i), f64::from(j));
        let off = |k: u32| f64::from((i * 31 + j * 17 + k * 11) % 23) / 23.0 - 0.5;
        let height = 0.05 * (x - 2.0) * (x - 2.0) - 0.06 * (y - 2.0) * (y - 2.0);
        [x + 0.2 * off(0), y + 0.2 * off(1), height + 0.3 * off(2)]
    });
    let text = json!({
        "format": "shape-up-scene", "version": 1, "mesh": { "file": "bumps.obj" },
        "constraints": [{ "kind": "plane", "on": "faces", "require": "exact" }],
        "weights": { "shape": 5, "close": 10, "smooth": 2 }, "closeness": { "to": "rest" },
        "smoothness": { "of": "displacement" },
    });
    let scene = Scene::from_json(&text.to_string()).expect("it is a scene");
    Session::open(scene, mesh).expect("it opens")
}

fn run(session: &mut Session) {
    session.begin_run();
    while !session.step().expect("positions stay finite").ended {}
    session.end_run();
}

fn edit(session: &mut Session, text: &serde_json::Value) {
    let edit = Edit::from_json(&text.to_string()).expect("it is an edit");
    session.edit(edit).expect("regular");
}

#[test]
fn an_improvement_is_one_step_of_undo_and_as_exact() {
    let mut session = rough();
    assert!(session.improvement().expect("regular").is_none(), "nothing is met yet");
    run(&mut session);
    let before = session.positions();
    let mut trial = session.improvement().expect("regular").expect("all is met");
    // A trial that is stopped after some steps keeps the gain so far.
    for _ in 0..3 {
        trial.step(&session).expect("regular");
    }
    let offer = trial.offer(&session).expect("nothing has changed");
    assert!(offer.met && offer.after.energy < offer.before.energy, "{offer:?}");
    assert_eq!(session.positions(), before, "nothing has changed yet");
    assert!(session.make_exact(trial.shape(), &trial.positions(), false).expect("regular"));
    assert!(session.exact().expect("there is a hard row").met);
    assert_eq!(session.undo_and_redo()[0], Some("Improve"));
    assert_ne!(session.positions(), before);
    session.undo().expect("regular");
    assert_eq!(session.positions(), before);
    // The trial began at another shape than the current one.
    run(&mut session);
    session.redo().expect("regular");
    assert!(!session.make_exact(trial.shape(), &trial.positions(), false).expect("regular"));
}

#[test]
fn an_improvement_is_not_applied_to_constraints_that_changed_since_it_began() {
    let mut session = rough();
    let circles = json!({ "addConstraint": { "kind": "circle", "on": "faces", "weight": 1 } });
    edit(&mut session, &circles);
    edit(&mut session, &json!({ "setConstraint": { "index": 1, "enabled": false } }));
    run(&mut session);
    let begin = |session: &Session| session.improvement().expect("regular").expect("all is met");
    let mut trial = begin(&session);
    trial.step(&session).expect("regular");
    let circular = json!({ "setConstraint": { "index": 1, "enabled": true, "require": "exact" } });
    edit(&mut session, &circular);
    assert_eq!(trial.offer(&session), None);
    let before = session.positions();
    assert!(!session.make_exact(trial.shape(), &trial.positions(), false).expect("regular"));
    assert_eq!(session.positions(), before);
    assert!(session.exact().is_none_or(|exact| !exact.met), "nobody has made the faces circular");

    // Nor to another mesh, whose faces have other vertices.
    let mut session = rough();
    run(&mut session);
    let mut trial = begin(&session);
    let larger = Session::open(
        Scene::opened("other.obj"),
        grid(9, 9, |i, j| [f64::from(i), f64::from(j), 0.0]),
    );
    assert_eq!(trial.offer(&larger.expect("it opens")), None);
}

#[test]
fn a_trial_on_a_copy_is_accepted_unless_the_shape_has_changed() {
    let mut session = rough();
    run(&mut session);
    let file = FileReader::default()
        .read("copy.json", session.scene_with_mesh().as_bytes(), UnitsAndUp::default(), false)
        .expect("it was written by the session");
    let copy = Session::open_copy(file.scene, file.mesh, session.generation());
    let copy = copy.expect("it is open already");
    assert_eq!(copy.positions(), session.positions(), "to the last bit");
    let mut trial = copy.improvement().expect("regular").expect("all is met");
    while trial.step(&copy).expect("regular") {}
    let shape = trial.shape();
    session.edit(Edit::SetUnits { units: "m".to_owned() }).expect("a unit");
    assert_eq!(session.generation(), shape.generation, "a unit is no change of the shape");
    let positions = trial.positions();
    assert!(session.make_exact(shape.clone(), &positions, false).expect("regular"));
    assert_eq!(session.positions(), positions);
    let report = session.exact().expect("there is a hard row");
    assert!(report.met && report.improved.is_some(), "the report comes with the shape");
    session.undo().expect("regular");
    assert!(!session.make_exact(shape, &positions, false).expect("regular"));
}

#[test]
fn what_is_found_during_a_drag_is_not_applied_and_does_not_end_the_drag() {
    // A drag became a step of undo when a trial that had begun before it was accepted.
    let mut session = rough();
    edit(&mut session, &json!({ "addHandles": { "vertices": [14], "fixed": false } }));
    run(&mut session);
    let mut trial = session.improvement().expect("regular").expect("all is met");
    while trial.step(&session).expect("regular") {}
    let mut variations = session.variations().expect("regular").expect("all is met");
    while variations.step().expect("regular") {}
    let [x, y, z] = session.positions()[14];
    session.drag_through(DragPhase::Start, &[14], &[[x, y, z]]).expect("it is a handle");
    assert!(!session.make_exact(trial.shape(), &trial.positions(), false).expect("regular"));
    let varied = variations.towards(&[0.05]);
    assert!(!session.show_variation(variations.generation(), &varied, None));
    assert!(session.is_dragging());
    session.drag_through(DragPhase::Move, &[14], &[[x, y, z + 0.1]]).expect("it is a handle");
    session.step().expect("positions stay finite");
    session.drag_through(DragPhase::End, &[14], &[[x, y, z + 0.1]]).expect("it is a handle");
    assert_eq!(session.undo_and_redo()[0], Some("Move handle"));
    assert_eq!(session.solver().handles()[0].target, [x, y, z + 0.1]);
}

#[test]
fn the_generation_goes_on_when_another_scene_is_opened() {
    let mut open = Some(rough());
    let session = open.as_mut().expect("it is open");
    run(session);
    let last = session.generation();
    let (scene, mesh) = (session.scene(), session.mesh().clone());
    Session::replace(&mut open, scene.clone(), mesh.clone()).expect("it fits");
    let next = open.as_ref().expect("it is open").generation();
    assert!(next > last, "what was made for the scene before is not taken for one of this");
    // The scene that stays when another one is refused has its number still.
    let none = Mesh { positions: mesh.positions, ..Mesh::default() };
    assert!(Session::replace(&mut open, scene, none).is_err());
    assert_eq!(open.as_ref().expect("it stays").generation(), next);
}

#[test]
fn a_single_step_iterates_softly_and_leaves_the_rest_to_a_run() {
    let mut session = rough();
    let (mut steps, start) = (0, session.positions());
    while !session.single_step().expect("positions stay finite").ended {
        steps += 1;
        assert_eq!(session.iteration(), steps);
        assert!(steps < 1000, "it converges");
    }
    assert!(session.exact().is_none_or(|exact| !exact.met), "steps meet nothing");
    // One more step leaves the shape unchanged and does not report unmet constraints.
    let there = session.positions();
    session.single_step().expect("positions stay finite");
    assert!(session.exact().is_none(), "nobody has tried");
    run(&mut session);
    assert!(session.exact().expect("there is a hard row").met);
    let exact = session.positions();
    assert!(exact != there && there != start);
    let single = session.single_step().expect("positions stay finite");
    assert!(single.ended, "what is met stays");
    // It was said to have moved as the last soft step had.
    assert!(matches!(session.half_step(), Ok(HalfStep::Local { .. })));
    assert_eq!(session.half_step(), Ok(HalfStep::Held { met: true }));
    assert!(!session.halfway());
    assert_eq!(session.positions(), exact);
}
