//! Saved steps: what a session that is opened again can undo and redo.

use crate::session::asked::new;
use crate::session::undo::{Deed, act, deed, everything, open, site};
use crate::support::drag;
use crate::support::grid::grid;
use proptest::prelude::*;
use serde_json::Map;
use shape_up::mesh::write_obj;
use shape_up::scene::{MeshSource, Scene, Weights};
use shape_up::session::{DragPhase, Edit, Session};

/// Opens a saved session again, as the page does after a reload.
pub(crate) fn reopened(text: &str, iteration: u32, history: &[u8], progress: &[u8]) -> Session {
    let scene = Scene::from_json(text).expect("what was written can be read");
    let mut session = Session::open(scene, site()).expect("it can be opened");
    session.restore_iteration(iteration);
    session.restore(history, progress).expect("it was saved a moment ago");
    session
}

pub(crate) fn written(session: &Session) -> String {
    session.scene().to_json(session.mesh())
}

/// The scene as text, the bits of the positions, the iteration.
type State = (String, Vec<[u64; 3]>, u32);

/// All states back to the start and forward to the end, each with the name of its step.
fn all_states(session: &mut Session) -> Vec<(String, State)> {
    let mut states = Vec::new();
    while let Some(name) = session.undo().expect("the state was solvable") {
        states.push((name, everything(session)));
    }
    while let Some(name) = session.redo().expect("the state was solvable") {
        states.push((name, everything(session)));
    }
    states
}

proptest! {
    #![proptest_config(crate::support::fuzz::cases(48))]

    // The history was lost with every reload and with every replacement of the worker.
    #[test]
    fn a_session_that_is_opened_again_can_undo_and_redo_all_that_it_could(
        deeds in proptest::collection::vec(deed(), 1..24),
    ) {
        let mut session = open();
        deeds.into_iter().for_each(|deed| act(&mut session, deed));
        let (text, history) = (written(&session), session.saved_history());
        let mut again = reopened(&text, session.iteration(), &history, &[]);
        prop_assert_eq!(again.undo_and_redo(), session.undo_and_redo());
        prop_assert_eq!(again.saved_history(), history);
        prop_assert_eq!(all_states(&mut again), all_states(&mut session));
    }
}

/// Where handles are dragged to.
const TARGET: [f64; 3] = [482_114.0, -65_220.0, 433.0];

/// Begins to drag a vertex that is no handle yet, a handle, and a run of a constraint that is added.
fn begin_new(session: &mut Session) {
    session.drag_through(DragPhase::Make, &[7], &[]).expect("it is there");
    drag(session, [(7, TARGET)]).expect("it is near");
}

fn begin_drag(session: &mut Session) {
    session.begin_drag();
    drag(session, [(6, TARGET)]).expect("it is near");
}

fn begin_press(session: &mut Session) {
    session.edit_and_run(new("circle", "\"faces\"")).expect("faces can be circles");
}

/// What begins something, and the name of the step that it is after three iterations.
type Begin = (fn(&mut Session), &'static str);

const BEGIN: [Begin; 4] = [
    (Session::begin_run, "Run, 3 iterations"),
    (begin_drag, "Move handle"),
    (begin_new, "Make and move handle"),
    (begin_press, "Add circle"),
];

/// A session with a constraint, a handle, and a run.
fn edited() -> Session {
    let mut session = open();
    session.edit(new("plane", "\"faces\"")).expect("faces can be planes");
    session.edit(Edit::AddHandles { vertices: vec![6], fixed: false }).expect("it is there");
    act(&mut session, Deed::Run(2));
    session
}

#[test]
fn rows_behind_a_removed_one_keep_their_numbers_in_a_session_that_is_opened_again() {
    let mut session = open();
    for kind in ["plane", "circle", "regular-polygon"] {
        session.edit(new(kind, "\"faces\"")).expect("faces can be these");
    }
    session.edit(Edit::RemoveConstraint { index: 0 }).expect("there is a row");
    let mut again = reopened(&written(&session), 0, &session.saved_history(), &[]);
    let numbers = |session: &Session| -> Vec<u32> {
        session.document().constraints.iter().map(|row| row.number.get()).collect()
    };
    let kept = numbers(&again);
    act(&mut again, Deed::Undo);
    assert_eq!(numbers(&again)[1..], kept);
    assert!(!kept.contains(&numbers(&again)[0]));
    act(&mut again, Deed::Redo);
    assert_eq!(numbers(&again), kept);
}

#[test]
fn a_run_and_a_drag_that_were_cut_off_are_steps_of_undo() {
    for (begin, name) in BEGIN.into_iter().take(3) {
        let mut session = edited();
        let (text, history) = (written(&session), session.saved_history());
        let before = everything(&session);
        begin(&mut session);
        for _ in 0..3 {
            session.step().expect("positions stay finite");
        }
        let mut again = reopened(&text, before.2, &history, &session.saved_progress());
        assert_eq!(everything(&again), everything(&session));
        assert_eq!(again.undo_and_redo(), [Some(name), None]);
        act(&mut again, Deed::Undo);
        assert_eq!(everything(&again), before);
    }
}

#[test]
fn what_is_written_while_something_is_under_way_leads_back_to_where_it_began() {
    // The steps fitted the scene before, and the text was that of the scene as it was: after a reload
    // Undo led to the shape of half a run, without its constraint.
    for (begin, name) in BEGIN {
        let mut session = edited();
        let before = everything(&session);
        begin(&mut session);
        for _ in 0..3 {
            session.step().expect("positions stay finite");
        }
        let (text, iteration) = (written(&session), session.iteration());
        let (history, now) = (session.saved_history(), everything(&session));
        let mut again = reopened(&text, iteration, &history, &[]);
        assert_eq!(again.undo_and_redo(), [Some(name), None]);
        act(&mut again, Deed::Undo);
        assert_eq!(everything(&again), before, "{name}");
        act(&mut again, Deed::Redo);
        assert_eq!(everything(&again), now, "{name}");
        // It went on after that.
        session.step().expect("positions stay finite");
        let mut later = reopened(&text, iteration, &history, &session.saved_progress());
        assert_eq!(everything(&later), everything(&session), "{name}");
        act(&mut later, Deed::Undo);
        assert_eq!(everything(&later), now, "{name}");
    }
}

#[test]
fn saved_steps_that_are_damaged_are_refused_and_leave_the_scene_as_it_was() {
    let mut session = open();
    session.edit(new("plane", "\"faces\"")).expect("faces can be planes");
    act(&mut session, Deed::Run(2));
    let (text, history) = (written(&session), session.saved_history());
    let open_again = || {
        let scene = Scene::from_json(&text).expect("what was written can be read");
        Session::open(scene, site()).expect("it can be opened")
    };
    let mut again = open_again();
    for end in 1..history.len() {
        again.restore(&history[..end], &[]).expect_err("it is cut off");
        again.restore(&[], &history[..end]).expect_err("it is something else");
    }
    let error = again.restore(b"anything", &[]).expect_err("it is something else").to_string();
    assert!(error.starts_with("saved steps: damaged 8 bytes before their end"), "{error}");
    assert_eq!(again.undo_and_redo(), [None, None]);
    assert_eq!(everything(&again), everything(&open_again()));
    // A scene with fewer vertices.
    let small = grid(1, 1, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let scene = Scene::new(MeshSource::File("small.obj".to_owned()));
    let mut small = Session::open(scene, small).expect("the scene is valid");
    small.restore(&history, &[]).expect_err("it is of another mesh");
}

#[test]
fn of_a_long_history_of_a_large_mesh_the_newest_steps_are_saved() {
    let mesh = grid(99, 99, |i, j| [f64::from(i), f64::from(j), f64::from((i + j) % 3)]);
    let mut scene = Scene::new(MeshSource::File("large.obj".to_owned()));
    scene.weights = Weights { shape: 1.0, close: 0.1, smooth: 0.1 };
    let mut session = Session::open(scene, mesh).expect("the scene is valid");
    // Each step moves every vertex: 240 kB.
    for _ in 0..45 {
        act(&mut session, Deed::Run(1));
        act(&mut session, Deed::Edit(Box::new(Edit::Reset)));
    }
    let history = session.saved_history();
    assert!((19_000_000..=20_000_000).contains(&history.len()), "{}", history.len());
    let text = written(&session);
    let scene = Scene::from_json(&text).expect("what was written can be read");
    let mut again = Session::open(scene, session.mesh().clone()).expect("it can be opened");
    again.restore_iteration(session.iteration());
    again.restore(&history, &[]).expect("it was saved a moment ago");
    for _ in 0..9 {
        act(&mut again, Deed::Undo);
        act(&mut session, Deed::Undo);
    }
    assert_eq!(everything(&again), everything(&session));
}

#[test]
fn the_surface_that_panels_are_close_to_is_saved_once() {
    // It was written for every step: ten edits after new panels on a scan were all that was kept.
    let mut session = open();
    let before = session.saved_history().len();
    let target = grid(40, 40, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let text = write_obj(&target, &target.positions);
    let fit = Edit::FitTo { name: "scan.obj".to_owned(), text: text.clone() };
    session.edit(fit).expect("it has faces");
    let begun = session.saved_history().len();
    for scale in 1..20 {
        let values = Map::from_iter([("scale".to_owned(), scale.into())]);
        session.edit(Edit::SetBuild { values }).expect("it is valid");
    }
    let after = session.saved_history().len();
    assert!(begun > before && after < begun + text.len(), "{before} {begun} {after}");
    let (scene, history) = (written(&session), session.saved_history());
    let mut again = reopened(&scene, session.iteration(), &history, &[]);
    assert_eq!(all_states(&mut again), all_states(&mut session));
}
