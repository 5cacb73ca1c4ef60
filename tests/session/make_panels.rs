//! "Make panels" in one press: all panels end within the tolerance, the displacement is bounded,
//! and the press is one step of undo.

use crate::support::drag;
use crate::support::grid::grid;
use crate::support::long_or;
use serde_json::{Value, json};
use shape_up::generate::{Plan, PlanLayout, PlanPoint, Support};
use shape_up::mesh::{BoundingSphere, Mesh, folded_faces};
use shape_up::scene::{Lesson, Lock, Scene};
use shape_up::session::{DragPhase, Edit, PanelStart, Session, Verdict};
use shape_up::solve::Require;

/// A session with the weights of an opened mesh.
pub(super) fn session(mesh: Mesh, more: &str) -> Session {
    let text = format!(
        r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "mesh.obj" }},
            "weights": {{ "shape": 1000, "close": 1, "smooth": 1 }}, "closeness": {{ "to": "rest" }},
            "smoothness": {{ "of": "displacement", "weighting": "uniform" }},
            "solver": {{ "tolerance": 1e-7 }} {more} }}"#
    );
    Session::open(Scene::from_json(&text).expect("the scene is valid"), mesh).expect("it fits")
}

pub(super) fn wave() -> Session {
    session(grid(8, 8, |i, j| [f64::from(i), f64::from(j), f64::from(i * j % 5) * 0.3]), "")
}

/// Bumps with edges across the lines of curvature: circular panels would crumple it.
fn bumps() -> Mesh {
    bumps_of(12)
}

/// Fewer of them: some would fold if they were made flat.
fn few_bumps() -> Mesh {
    bumps_of(8)
}

fn bumps_of(size: u32) -> Mesh {
    let sine = |n: u32| libm::sin(f64::from(n) / 2.0);
    // Rounded to six digits, as in a file.
    let height = |i: u32, j: u32| (2e6 * sine(i) * sine(j)).round() / 1e6;
    grid(size, size, |i, j| [f64::from(i), f64::from(j), height(i, j)])
}

fn folded(session: &Session) -> usize {
    folded_faces(session.mesh(), session.topology(), &session.positions()).len()
}

/// Runs to the end and returns the number of iterations.
pub(super) fn run(session: &mut Session) -> usize {
    let ended = (1..20_000).find(|_| session.step().expect("it stays finite").ended);
    session.end_run();
    ended.expect("it converges")
}

pub(super) fn verdict(session: &mut Session) -> Verdict {
    session.verdict(session.tolerance()).expect("all panels are asked for a shape")
}

#[test]
fn a_press_brings_panels_of_real_meshes_within_the_tolerance_but_those_that_would_fold() {
    // With only the weights of an opened mesh, 36 of 871 panels of the roof were within 0.5 mm.
    let all = ["halftunnel.off", "M2_eq_quad2.obj", "botanic-garden-bubble-0.obj", "pillow_1.obj"];
    for &file in long_or(&all[..], &all[..2]) {
        for kind in ["circle", "plane"] {
            let Some(mesh) = crate::support::shared::mesh(file) else { continue };
            let mut soft = session(mesh.clone(), "");
            soft.make_panels(kind, f64::INFINITY, PanelStart::Now).expect("it has quads");
            run(&mut soft);
            let cheaper = verdict(&mut soft).moved;

            let mut session = session(mesh, "");
            session.make_panels(kind, session.tolerance(), PanelStart::Now).expect("it has quads");
            let iterations = run(&mut session);
            let Verdict { of: panels, within, eased, worst, moved, .. } = verdict(&mut session);
            println!(
                "{file} {kind}: {within} of {panels}, worst {worst:.2e}, moved {:.3} (soft {:.3}), mean {:.3} (soft {:.3}), {iterations} iterations",
                moved.max, cheaper.max, moved.mean, cheaper.mean
            );
            let shortest = session.shortest_edge();
            assert!(shortest >= 0.3 * (1.0 - 1e-3), "{file} {kind}: {shortest}");
            let eased = eased.map_or(0, |eased| eased.panels);
            assert!(within >= panels - eased, "{file} {kind}: worst {worst:e}");
            assert!(eased <= panels * 2 / 5, "{file} {kind}: {eased} of {panels} are eased");
            // The mean displacement is not much larger than in the soft result, although edges keep
            // their length and nothing folds.
            assert_eq!(folded(&session), 0, "{file} {kind}");
            let size = BoundingSphere::of(&session.mesh().positions).diameter();
            assert!(moved.mean < 2.5 * cheaper.mean + 1e-3 * size, "{file} {kind}");
        }
    }
}

#[test]
fn a_press_is_one_step_of_undo() {
    let mut session = wave();
    let before = session.scene();
    session.make_panels("plane", 1e-3, PanelStart::Now).expect("it has quads");
    run(&mut session);
    assert_eq!(session.document().constraints[0].require, Require::Within(1e-3));
    let after = session.scene();
    assert_eq!(session.undo().expect("solvable").as_deref(), Some("Make panels flat"));
    assert_eq!(session.scene(), before);
    assert_eq!(session.undo().expect("solvable"), None);
    session.redo().expect("solvable");
    assert_eq!(session.scene(), after);
    let exact = session.exact().expect("it was met");
    assert!(exact.met && exact.max_distance <= 1e-3, "{exact:?}");
}

#[test]
fn a_press_afresh_begins_from_the_original_and_is_one_step_of_undo() {
    let mut expected = wave();
    expected.make_panels("plane", 1e-2, PanelStart::Now).expect("it has quads");
    run(&mut expected);
    let mut session = wave();
    session.make_panels("plane", 1e-3, PanelStart::Now).expect("it has quads");
    run(&mut session);
    let before = session.scene();
    session.make_panels("plane", 1e-2, PanelStart::Original).expect("it has quads");
    run(&mut session);
    assert_eq!(session.positions(), expected.positions());
    session.undo().expect("solvable");
    assert_eq!(session.scene(), before);
}

#[test]
fn a_press_on_what_is_met_already_changes_nothing() {
    let mut session = wave();
    session.make_panels("plane", 1e-3, PanelStart::Now).expect("it has quads");
    run(&mut session);
    let after = session.scene();
    session.make_panels("plane", 1e-3, PanelStart::Now).expect("it has quads");
    run(&mut session);
    assert_eq!(session.scene(), after);
    session.undo().expect("solvable");
    assert_eq!(session.undo().expect("solvable"), None);
}

#[test]
fn a_press_changes_no_weight_and_without_tolerance_requires_nothing() {
    let mut session = wave();
    session.make_panels("plane", f64::INFINITY, PanelStart::Now).expect("it has quads");
    run(&mut session);
    assert_eq!(session.document().constraints[0].require, Require::Soft);
    session.make_panels("plane", 1.0, PanelStart::Now).expect("it has quads");
    run(&mut session);
    assert_eq!(session.document().weights.shape, 1000.0);
}

#[test]
fn what_cannot_be_had_ends_with_what_was_reached_and_says_so() {
    // Four fixed corners that are not coplanar.
    let fixed = r#", "handles": [{ "vertices": [0, 1, 2, 3], "fixed": true }]"#;
    let mesh = grid(1, 1, |i, j| [f64::from(i), f64::from(j), f64::from(i * j)]);
    let mut session = session(mesh, fixed);
    session.make_panels("plane", 1e-3, PanelStart::Now).expect("it has a quad");
    run(&mut session);
    assert_eq!(verdict(&mut session).within, 0);
    let exact = session.exact().expect("it was tried");
    assert_eq!((exact.met, exact.unmet, exact.misses), (false, vec![0], 1));
}

#[test]
fn a_drag_ends_the_press_and_its_end_meets_again_in_the_same_step() {
    let mut session = wave();
    session.make_panels("plane", 1e-3, PanelStart::Now).expect("it has quads");
    session.drag_through(DragPhase::Make, &[0], &[]).expect("it is there");
    assert!(!session.is_running() && session.exact().is_none());
    drag(&mut session, [(0, [-0.5, -0.5, 0.5])]).expect("it is a handle");
    (0..20).for_each(|_| assert!(!session.step().expect("it stays finite").ended));
    session.end_drag(true);
    assert!(session.is_running());
    run(&mut session);
    assert!(session.exact().is_some_and(|exact| exact.met));
    assert_eq!(session.undo_and_redo()[0], Some("Make and move handle"));
}

#[test]
fn a_press_that_would_fold_eases_the_panels_that_would_and_no_others() {
    let pillow = || crate::support::shared::mesh("pillow_1.obj");
    let meshes = [Some(bumps()), long_or(pillow(), None)];
    for mesh in meshes.into_iter().flatten() {
        let kind = "circle";
        let mut session = session(mesh, "");
        let (before, asked) = (session.scene(), session.tolerance());
        session.make_panels(kind, asked, PanelStart::Now).expect("it has quads");
        run(&mut session);
        let verdict = verdict(&mut session);
        println!("{verdict:?}");
        assert_eq!((folded(&session), verdict.folded), (0, 0));
        let exact = session.exact().expect("it was met");
        assert!(exact.met && exact.attempts > 1, "{exact:?}");
        let row = &session.document().constraints[0];
        assert_eq!(row.require, Require::Within(asked));
        let Some(eased) = verdict.eased else {
            assert!(verdict.within == verdict.of && row.eased.is_none());
            continue;
        };
        assert!(verdict.within >= verdict.of - eased.panels, "{verdict:?}");
        assert!(2 * eased.panels < verdict.of, "{verdict:?}");
        assert!(verdict.worst > asked && verdict.worst <= eased.within, "{verdict:?}");
        assert!(exact.eased.is_some_and(|it| it.folded > 0 && it.panels == eased.panels));
        assert!(verdict.would_fold);
        // Another run changes nothing and is one step of undo.
        let after = session.scene();
        session.begin_run();
        run(&mut session);
        assert_eq!(session.scene(), after);
        assert_eq!(session.undo().expect("solvable").as_deref(), Some("Make panels circular"));
        assert_eq!(session.scene(), before);
        session.redo().expect("solvable");
        assert_eq!(session.scene(), after);
        // A file keeps the exact shape and its report.
        let text = session.scene().to_json(session.mesh());
        let mut again =
            Session::open(Scene::from_json(&text).expect("its own"), session.mesh().clone())
                .expect("it fits");
        assert!(again.exact().is_some_and(|exact| exact.met));
        assert_eq!(again.verdict(asked).expect("it is asked").eased, Some(eased));
    }
}

/// Handles that hold the corners of a panel out of a plane need a larger tolerance, but nothing folds:
/// it was said to be relaxed so that none does.
#[test]
fn a_tolerance_that_handles_leave_no_shape_within_is_not_said_to_avoid_folds() {
    let height = |at| if at == (4, 4) { 0.02 } else { 0.0 };
    let mesh = grid(8, 8, |i, j| [f64::from(i), f64::from(j), height((i, j))]);
    let mut session = session(mesh, "");
    let corners = vec![40, 41, 50, 49];
    session.edit(Edit::AddHandles { vertices: corners, fixed: true }).expect("they are there");
    session.make_panels("plane", session.tolerance(), PanelStart::Now).expect("it has quads");
    run(&mut session);
    let verdict = verdict(&mut session);
    assert!(verdict.eased.is_some() && !verdict.would_fold, "{verdict:?}");
    let words = verdict.words("m", 8.0, 1.0).full();
    assert!(words.contains("relaxed tolerance") && !words.contains("fold"), "{words}");
}

#[test]
fn only_the_tolerance_of_all_panels_is_eased_where_another_row_has_the_same() {
    let asked = session(few_bumps(), "").tolerance();
    let own = json!([{ "kind": "plane", "on": { "vertices": [0, 1, 10, 9] },
        "require": { "within": asked } }]);
    let mut session = session(few_bumps(), &format!(r#", "constraints": {own}"#));
    session.make_panels("plane", asked, PanelStart::Now).expect("it has quads");
    run(&mut session);
    assert_eq!(folded(&session), 0);
    let rows = &session.document().constraints;
    assert_eq!((rows[0].require, &rows[0].eased), (Require::Within(asked), &None));
    assert!(rows[1].eased.is_some(), "some panels would fold");
}

#[test]
fn a_press_that_was_undone_says_nothing_about_the_same_constraint_by_hand() {
    // Its run went on as the press had: panels were given a larger tolerance.
    let mut session = session(few_bumps(), "");
    let asked = session.tolerance();
    session.make_panels("plane", asked, PanelStart::Now).expect("it has quads");
    (0..20).for_each(|_| assert!(!session.step().expect("it stays finite").ended));
    session.undo().expect("solvable");
    for own in [
        json!({ "addConstraint": { "kind": "plane", "on": "faces", "weight": 1 } }),
        json!({ "setConstraint": { "index": 0, "require": { "within": asked } } }),
    ] {
        session.edit(Edit::from_json(&own.to_string()).expect("an edit")).expect("it fits");
    }
    session.begin_run();
    run(&mut session);
    let row = &session.document().constraints[0];
    assert_eq!((row.require, &row.eased), (Require::Within(asked), &None));
}

#[test]
fn a_press_that_is_interrupted_eases_no_more_than_one_that_is_not() {
    let asked = session(few_bumps(), "").tolerance();
    let eased = |interruptions: &[usize]| {
        let mut session = session(few_bumps(), "");
        session.make_panels("plane", asked, PanelStart::Now).expect("it has quads");
        for (steps, units) in interruptions.iter().zip(["mm", "cm", "m"]) {
            (0..*steps).for_each(|_| assert!(!session.step().expect("it stays finite").ended));
            session.edit(Edit::SetUnits { units: units.to_owned() }).expect("nothing is locked");
            session.begin_run();
        }
        run(&mut session);
        assert_eq!(folded(&session), 0);
        assert!(session.exact().is_some_and(|exact| exact.met));
        verdict(&mut session).eased.expect("some panels would fold").panels
    };
    let whole = eased(&[]);
    // While it iterates, in the first attempt, and with tolerances eased so far.
    for interruptions in [&[20][..], &[600], &[1150], &[20, 300, 500]] {
        assert_eq!(eased(interruptions), whole, "{interruptions:?}");
    }
}

#[test]
fn a_press_that_would_fold_a_few_panels_may_end_exactly() {
    let Some(mesh) = crate::support::shared::mesh("halftunnel.off") else { return };
    let mut session = session(mesh, "");
    let asked = session.tolerance();
    session.make_panels("circle", asked, PanelStart::Now).expect("it has quads");
    run(&mut session);
    let (verdict, exact) = (verdict(&mut session), session.exact().expect("it was met"));
    assert_eq!((verdict.within, verdict.folded, verdict.eased), (verdict.of, 0, None));
    assert!(exact.met && exact.attempts == 2 && exact.max_distance < 1e-6 * asked, "{exact:?}");
    // The requirement keeps the requested tolerance.
    assert_eq!(exact.tolerance, asked);
    assert_eq!(session.document().constraints[0].require, Require::Within(asked));
}

#[test]
fn exact_panels_are_those_near_the_shape_where_others_crumple() {
    // A roof over a plan, on its four corners: when the approach started again it crumpled into a
    // heap, 4.6 m away, with 43 times the energy.
    let corners = [[-6.0, -2.0], [28.0, -2.0], [28.0, 8.0], [-6.0, 12.0]];
    let plan = Plan {
        outline: corners.map(|at| PlanPoint { at, bulge: 0.0, corner: true }).to_vec(),
        holes: Vec::new(),
        layout: PlanLayout::Follow,
        size: 1.25,
        turn: 0.0,
        height: 6.0,
        support: Support::Corners,
    };
    let surface = plan.surface().expect("it is a plan");
    let feet: Vec<Value> = surface.feet.iter().map(|&foot| json!(foot)).collect();
    let handles = json!([{ "vertices": feet, "fixed": true }]);
    let mut session = session(surface.mesh, &format!(r#", "handles": {handles}"#));
    session.make_panels("circle", 1e-3, PanelStart::Now).expect("it has quads");
    run(&mut session);
    assert_eq!(folded(&session), 0);
    let mut trial = session.exact_trial().expect("regular").expect("it is within");
    while trial.step(&session).expect("regular") {}
    let offer = trial.offer(&session).expect("nothing has changed");
    assert!(offer.met && offer.folded == 0 && offer.moved.max < 1.0, "{offer:?}");
    assert!(offer.after.energy < 4.0 * offer.before.energy, "{offer:?}");
    let lesson = |lock| Lesson { text: "Round.".to_owned(), goals: Vec::new(), lock, given: None };
    let locked = Some(lesson(vec![Lock::Constraints]));
    session.edit(Edit::SetLesson { lesson: locked, unsolved: false }).expect("it may be a lesson");
    let refused = session.make_exact(trial.shape(), &trial.positions(), false);
    assert!(refused.is_err_and(|error| error.to_string().contains("locked by the lesson")));
    session.undo().expect("regular");
    assert!(session.make_exact(trial.shape(), &trial.positions(), false).expect("regular"));
    assert!(session.exact().is_some_and(|exact| exact.met && exact.max_distance < 1e-9));
}

#[test]
fn what_is_asked_exactly_stays_so_and_folds_less_where_it_can() {
    let Some(mesh) = crate::support::shared::mesh("M2_eq_quad2.obj") else { return };
    for (kind, require) in [("circle", Require::Exact), ("plane", Require::Within(5e-4))] {
        let mut scene = Scene::opened("own.obj");
        scene.request_panels(kind, require, &mesh).expect("it has quads");
        let mut session = Session::open(scene, mesh.clone()).expect("it fits");
        session.solve(false).expect("regular");
        let exact = session.exact().expect("it was met");
        assert!(exact.met && exact.attempts > 1 && exact.eased.is_none(), "{kind}: {exact:?}");
        assert_eq!(folded(&session), 0, "{kind}");
        assert_eq!(session.document().constraints[0].require, require);
    }
}

/// Circular panels at the end of the drag of a vertex, which begins a run to meet them again.
fn dragged() -> Session {
    let mut session = session(bumps(), "");
    session.make_panels("circle", session.tolerance(), PanelStart::Now).expect("it has quads");
    run(&mut session);
    let place = session.positions()[84];
    session.drag_through(DragPhase::Make, &[84], &[]).expect("it is there");
    drag(&mut session, [(84, [place[0], place[1], place[2] + 0.3])]).expect("it is a handle");
    session.end_drag(true);
    session
}

#[test]
fn the_end_of_a_drag_stays_near_to_where_it_was_dragged() {
    let mut session = dragged();
    run(&mut session);
    assert_eq!(session.exact().expect("it was met").attempts, 1);
}

#[test]
fn a_tolerance_beyond_what_is_needed_is_used_to_stay_near_the_original() {
    let moved = |within: f64| {
        let mut session = session(bumps(), "");
        session.make_panels("plane", within, PanelStart::Now).expect("it has quads");
        run(&mut session);
        let verdict = session.verdict(within).expect("all panels are asked for a shape");
        assert_eq!(verdict.within, verdict.of, "{within}");
        verdict.moved.mean
    };
    // The panels of the original are flat within 0.2.
    assert_eq!(moved(0.2), 0.0);
    let [tight, loose] = [0.05, 0.12].map(moved);
    assert!(0.0 < loose && loose < 0.8 * tight, "{loose} {tight}");
}

#[test]
fn a_set_that_is_saved_leaves_what_was_reached() {
    let mut session = wave();
    session.make_panels("plane", 1e-3, PanelStart::Now).expect("it has quads");
    run(&mut session);
    let before = (session.exact(), session.converged());
    assert!(before.0.as_ref().is_some_and(|exact| exact.met));
    let set = Edit::NameSet { name: "two".to_owned(), vertices: vec![1, 2], faces: Vec::new() };
    session.edit(set).expect("it is valid");
    assert_eq!((session.exact(), session.converged()), before);
    let beyond =
        Edit::NameSet { name: "three".to_owned(), vertices: vec![9999], faces: Vec::new() };
    assert!(session.edit(beyond).is_err());
}

#[test]
fn without_anything_to_meet_a_run_ends_after_its_iterations() {
    let more = r#", "constraints": [{ "kind": "plane", "on": "faces", "enabled": false }]"#;
    let mut session = session(bumps(), more);
    session
        .edit(Edit::from_json(r#"{ "set": { "id": "tolerance", "value": 0 } }"#).unwrap())
        .unwrap();
    let most = session.document().solver.iterations;
    session.solve_as_pressed(None, 1e-3, false).expect("it stays finite");
    assert!(session.iteration() <= most + 1);
}

#[test]
fn a_press_during_a_run_begins_a_search_though_it_asks_for_what_was_asked() {
    // It left the run, which had none, and its shape became a part of the step before.
    let mut session = dragged();
    session.step().expect("it stays finite");
    session.make_panels("circle", session.tolerance(), PanelStart::Now).expect("it has quads");
    run(&mut session);
    assert!(session.exact().expect("it was met").attempts > 1);
}
