//! What becomes exact after a press, because the user asks for it or because it costs little.

use super::make_panels::{run, wave};
use shape_up::mesh::Point;
use shape_up::session::{Edit, ExactShape, PanelStart, Session};
use shape_up::solve::Require;

/// A wave whose panels were made flat within the tolerance.
fn pressed(tolerance: f64) -> Session {
    let mut session = wave();
    press(&mut session, tolerance);
    session
}

fn press(session: &mut Session, tolerance: f64) {
    session.make_panels("plane", tolerance, PanelStart::Now).expect("it has quads");
    run(session);
}

/// The exact shape of what is within a tolerance, as the page tries it after a run.
fn exact_trial(session: &mut Session) -> (ExactShape, Vec<Point>) {
    let mut trial = session.exact_trial().expect("regular").expect("something is within");
    while trial.step(session).expect("regular") {}
    (trial.shape(), trial.positions())
}

#[test]
fn what_panels_are_judged_by_stays_when_they_become_exact() {
    // It was lost with the requirement, and the next press took another one.
    let mut session = pressed(0.3);
    let (shape, positions) = exact_trial(&mut session);
    assert!(session.make_exact(shape, &positions, false).expect("regular"));
    assert_eq!(session.document().constraints[0].require, Require::Exact);
    assert_eq!(session.tolerance(), 0.3);
    press(&mut session, 0.2);
    assert_eq!(session.tolerance(), 0.2);
    for _ in 0..3 {
        session.undo().expect("solvable");
    }
    assert_eq!((session.document().tolerance, session.document().constraints.len()), (None, 0));
}

#[test]
fn exactness_that_nobody_asked_for_is_no_requirement() {
    // A larger tolerance did nothing after it, and no press was tried that ends better.
    let mut session = pressed(1e-3);
    let (shape, positions) = exact_trial(&mut session);
    assert!(session.make_exact(shape, &positions, true).expect("regular"));
    let exact = session.exact().expect("there is a hard row");
    assert!(exact.met && exact.max_distance < 1e-9 && exact.tolerance == 1e-3, "{exact:?}");
    assert_eq!(session.document().constraints[0].require, Require::Within(1e-3));
    let (tight, moved) = (session.verdict(1e-3).expect("it has panels"), session.moved().mean);
    assert_eq!(tight.required, Some(1e-3));
    // What is improved stays exact.
    let mut improvement = session.improvement().expect("regular").expect("all is met");
    while improvement.step(&session).expect("regular") {}
    assert!(improvement.shape().report.max_distance < 1e-9);
    // A run left it as it was, and a trial of what it was already dropped what could be redone.
    run(&mut session);
    assert!(session.exact_trial().expect("regular").is_none());
    // So does what is varied: it was brought back within the tolerance only.
    let mut variations = session.variations().expect("regular").expect("all is met");
    while variations.step().expect("regular") {}
    let varied = variations.go(&[0.02]).expect("regular");
    assert!(varied.report.max_distance < 1e-9, "{:?}", varied.report);
    let of = variations.generation();
    assert!(session.show_variation(of, &varied.positions, Some(varied.report)));
    assert!(session.exact().is_some_and(|exact| exact.met && exact.tolerance == 1e-3));
    session.leave_variation();
    press(&mut session, 0.3);
    assert!(session.moved().mean < 0.9 * moved, "{} {moved}", session.moved().mean);
}

#[test]
fn what_becomes_exact_is_a_part_of_the_step_that_led_to_the_shape_and_of_no_other() {
    let mut session = pressed(1e-3);
    let (shape, positions) = exact_trial(&mut session);
    session.edit(Edit::SetUnits { units: "ft".to_owned() }).expect("any unit will do");
    assert!(session.make_exact(shape.clone(), &positions, true).expect("regular"));
    assert_eq!(session.undo_and_redo()[0], Some("Make exact"));
    session.undo().expect("solvable");
    session.undo().expect("solvable");
    assert_eq!(session.document().constraints[0].require, Require::Within(1e-3));
    // What was undone before can no longer be redone: it was done to another shape.
    let (shape, positions) = exact_trial(&mut session);
    assert!(session.make_exact(shape, &positions, true).expect("regular"));
    assert_eq!(session.undo_and_redo(), [Some("Make panels flat"), None]);
}

#[test]
fn a_row_that_leaves_exactness_has_its_own_tolerance_again() {
    let mut session = pressed(0.3);
    let (shape, positions) = exact_trial(&mut session);
    assert!(session.make_exact(shape, &positions, false).expect("regular"));
    let within = r#"{ "setConstraint": { "index": 0, "require": { "within": 0.1 } } }"#;
    session.edit(Edit::from_json(within).expect("it is an edit")).expect("it is valid");
    assert_eq!(session.tolerance(), 0.1);
}
