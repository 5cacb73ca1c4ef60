//! The constraint by which panels are judged.

use super::make_panels::{session, verdict};
use crate::support::grid::grid;
use shape_up::session::{Edit, Session};

#[test]
fn panels_are_judged_by_their_own_constraint() {
    let eave = r#", "constraints": [
        { "kind": "plane", "on": "faces", "require": { "within": 0.001 } },
        { "kind": "plane", "on": { "vertices": [0, 1, 2, 3, 4] }, "require": { "within": 0.5 } } ]"#;
    let mesh = grid(4, 4, |i, j| [f64::from(i), f64::from(j), 0.1 * f64::from(i * j)]);
    let mut session = session(mesh, eave);
    assert_eq!((session.tolerance(), verdict(&mut session).required), (0.001, Some(0.001)));
}

#[test]
fn all_panels_are_judged_though_a_later_constraint_is_on_some() {
    // A press enables its constraint where it stands: the verdict was on the five faces below it.
    let rows = r#", "sets": { "some": { "faces": "0-4" } }, "constraints": [
        { "kind": "circle", "on": "faces", "require": { "within": 0.01 } },
        { "kind": "plane", "on": { "each": "face", "in": "some" } } ]"#;
    let mesh = grid(4, 4, |i, j| [f64::from(i), f64::from(j), 0.1 * f64::from(i * j)]);
    let mut session = session(mesh, rows);
    let judged = |session: &mut Session| {
        let verdict = verdict(session);
        (session.tolerance(), verdict.kind, verdict.of)
    };
    assert_eq!(judged(&mut session), (0.01, "circle", 16));
    // Where no other is enabled, those are judged.
    session
        .edit(Edit::from_json(r#"{ "setConstraint": { "index": 0, "enabled": false } }"#).unwrap())
        .unwrap();
    assert_eq!(judged(&mut session).1, "plane");
}

#[test]
fn a_plane_of_given_direction_is_judged_by_its_direction() {
    // All faces are flat, but none is level.
    let level = r#", "constraints": [
        { "kind": "plane", "on": "faces", "normal": [0, 0, 1], "require": { "within": 0.01 } } ]"#;
    let mesh = grid(4, 4, |i, j| [f64::from(i), f64::from(j), 0.5 * f64::from(i)]);
    let mut session = session(mesh, level);
    let verdict = verdict(&mut session);
    assert_eq!((verdict.within, verdict.of), (0, 16));
    assert!((verdict.worst - 0.25).abs() < 1e-9, "{verdict:?}");
}

#[test]
fn panels_are_judged_by_what_a_press_asked_beside_a_plane_of_given_direction() {
    let rows = r#", "constraints": [
        { "kind": "plane", "on": "faces", "enabled": false },
        { "kind": "plane", "on": "faces", "normal": [0, 0, 1], "weight": 1e-9 } ]"#;
    let mesh = grid(4, 4, |i, j| [f64::from(i), f64::from(j), 0.5 * f64::from(i)]);
    let mut session = session(mesh, rows);
    session
        .edit(Edit::from_json(r#"{ "setConstraint": { "index": 0, "enabled": true } }"#).unwrap())
        .unwrap();
    let verdict = verdict(&mut session);
    // Flat, though none is level.
    assert_eq!((verdict.within, verdict.of), (16, 16));
}
