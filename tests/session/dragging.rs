//! Drags as steps of undo: cancelled, without a move, and ended by an edit.

use crate::session::asked::new;
use crate::session::saved_history::{reopened, written};
use crate::session::undo::{Deed, VERTICES, act, everything, open};
use crate::support::drag;
use shape_up::session::{DragPhase, Edit, Session};

/// A session whose panels are exactly flat, with a handle at vertex 6.
fn met() -> Session {
    let mut session = open();
    session.edit(new("plane", "\"faces\"")).expect("faces can be planes");
    session.edit(Edit::AddHandles { vertices: vec![6], fixed: false }).expect("it is there");
    let exact = r#"{ "setConstraint": { "index": 0, "require": "exact" } }"#;
    session.edit(Edit::from_json(exact).expect("it is an edit")).expect("it can be required");
    session.solve(false).expect("it can be solved");
    session
}

#[test]
fn an_edit_that_ends_a_drag_is_a_step_after_it_and_leaves_no_run() {
    // The run that was to meet the constraints again stayed open: the next one joined the edit, and
    // what was saved led back to another shape.
    let mut session = met();
    let target = [482_114.0, -65_220.0, 433.0];
    session.begin_drag();
    drag(&mut session, [(6, target)]).expect("it is near");
    session.step().expect("positions stay finite");
    let dragged = session.positions();
    session.edit(Edit::Reset).expect("nothing is locked");
    assert!(!session.is_running());
    let (text, history) = (written(&session), session.saved_history());
    let mut again = reopened(&text, session.iteration(), &history, &[]);
    for session in [&mut session, &mut again] {
        assert_eq!(session.undo_and_redo()[0], Some("Reset"));
        act(session, Deed::Undo);
        assert_eq!(session.positions(), dragged);
        assert_eq!(session.undo_and_redo()[0], Some("Move handle"));
    }
}

#[test]
fn a_handle_that_is_taken_and_released_where_it_is_changes_nothing() {
    // The soft iterations in between left the exact shape, without a step of undo.
    let mut session = met();
    let (before, report) = (everything(&session), session.exact());
    assert!(report.as_ref().is_some_and(|report| report.met), "{report:?}");
    let at = session.solver().handles()[0].target;
    session.begin_drag();
    drag(&mut session, [(6, at)]).expect("it is near");
    for _ in 0..3 {
        session.step().expect("positions stay finite");
    }
    session.end_drag(true);
    assert!(!session.is_running());
    assert_eq!(everything(&session), before);
    assert_eq!(session.exact(), report);
}

#[test]
fn a_cancelled_drag_leaves_nothing_behind() {
    let mut session = open();
    session.edit(new("plane", "\"faces\"")).expect("faces can be planes");
    session.edit(Edit::AddHandles { vertices: vec![6], fixed: false }).expect("it is there");
    let before = everything(&session);
    act(&mut session, Deed::Drag { vertex: 0, by: [0.1, 0.2, 0.5], steps: 3, keep: false });
    assert_eq!(everything(&session), before);
    assert_eq!(session.convergence_csv().lines().count(), 2, "the head and iteration 0");
}

#[test]
fn a_handle_that_is_made_and_moved_at_once_is_one_step_or_none() {
    let mut session = open();
    session.edit(new("plane", "\"faces\"")).expect("faces can be planes");
    let before = everything(&session);
    let deed = |keep| Deed::DragNew { vertex: 7, by: [0.1, 0.2, 0.5], steps: 3, keep };
    act(&mut session, deed(false));
    assert_eq!(everything(&session), before);
    assert_eq!(session.undo_and_redo(), [Some("Add plane"), None]);
    act(&mut session, deed(true));
    assert_eq!(session.undo_and_redo(), [Some("Make and move handle"), None]);
    act(&mut session, Deed::Undo);
    assert_eq!(everything(&session), before);
    // A click makes it and moves nothing.
    session.drag_through(DragPhase::Make, &[7], &[]).expect("the vertex is there");
    session.end_drag(true);
    assert_eq!(session.undo_and_redo()[0], Some("Make handle"));
    act(&mut session, Deed::Undo);
    session.drag_through(DragPhase::Make, &[7, 8], &[]).expect("the vertices are there");
    session.end_drag(true);
    assert_eq!(session.undo_and_redo()[0], Some("Make 2 handles"));
    act(&mut session, Deed::Undo);
    assert!(session.drag_through(DragPhase::Make, &[VERTICES], &[]).is_err());
    session.end_drag(true);
    assert_eq!(everything(&session), before);
}

#[test]
fn a_drag_goes_on_after_an_edit_that_is_refused_late() {
    // It had ended, and what was dragged on had no effect.
    let mut session = open();
    let before = everything(&session);
    let [first, then] = [[482_114.0, -65_220.0, 433.0], [482_114.0, -65_220.0, 434.0]];
    session.drag_through(DragPhase::Make, &[6], &[first]).expect("it is near");
    let remesh = Edit::from_json(r#"{ "remesh": { "operation": "none" } }"#);
    session.edit(remesh.expect("it is an edit")).expect_err("there is no such operation");
    assert!(session.is_dragging());
    session.drag_through(DragPhase::Move, &[6], &[then]).expect("it is near");
    assert_eq!(session.solver().handles()[0].target, then);
    session.drag_through(DragPhase::End, &[], &[]).expect("nothing moves");
    for name in ["Move handle", "Make and move handle"] {
        assert_eq!(session.undo(), Ok(Some(name.to_owned())));
    }
    assert_eq!(everything(&session), before);
}

#[test]
fn a_drag_that_is_refused_leaves_a_run_as_it_is() {
    // It ended the run: a press became two steps of undo.
    let mut session = open();
    session.begin_run();
    session.step().expect("positions stay finite");
    let error =
        session.drag_through(DragPhase::Make, &[VERTICES], &[]).expect_err("it does not exist");
    assert!(error.to_string().contains("out of range"), "{error}");
    assert!(session.is_running());
}
