//! Variations in a session: showing, projecting, keeping, undo, and reading from a file.

use crate::support::grid::grid;
use serde_json::json;
use shape_up::mesh::{Mesh, Point};
use shape_up::scene::{ConstraintSpec, MeshSource, Require, Scene, Variants};
use shape_up::session::{DragPhase, Edit, Session, Variations};

/// Bumps on which all panels are flat.
fn flat() -> Session {
    let mesh = grid(5, 5, |i, j| {
        let (x, y) = (f64::from(i), f64::from(j));
        [x, y, 0.05 * (x - 2.0) * (x - 2.0) - 0.06 * (y - 2.0) * (y - 2.0) + 0.01 * x * y]
    });
    let text = json!({
        "format": "shape-up-scene", "version": 1, "mesh": { "file": "bumps.obj" },
        "constraints": [{ "kind": "plane", "on": "faces", "require": "exact" }],
        "weights": { "shape": 100, "close": 1, "smooth": 1 }, "closeness": { "to": "rest" },
        "smoothness": { "of": "displacement" },
        "handles": [{ "vertices": [14], "weight": 10 }],
    });
    let scene = Scene::from_json(&text.to_string()).expect("it is a scene");
    let mut session = Session::open(scene, mesh).expect("it opens");
    run(&mut session);
    session
}

fn run(session: &mut Session) {
    session.begin_run();
    while !session.step().expect("positions stay finite").ended {}
    session.end_run();
}

fn found(session: &Session) -> Variations {
    let mut variations = session.variations().expect("regular").expect("all is exact");
    while variations.step().expect("regular") {}
    assert_eq!(variations.modes().len(), 8);
    variations
}

fn farthest(a: &[Point], b: &[Point]) -> f64 {
    let away = a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| (a - b).abs());
    away.fold(0.0, f64::max)
}

/// Shows a variation; returns false if the session has another shape than the varied one.
fn show(session: &mut Session, variations: &Variations, coefficients: &[f64]) -> bool {
    let positions = variations.towards(coefficients);
    session.show_variation(variations.generation(), &positions, None)
}

/// Shows a variation that was brought back onto the constraints; returns the fraction reached.
fn bring_back(session: &mut Session, variations: &mut Variations, coefficients: &[f64]) -> f64 {
    let varied = variations.go(coefficients).expect("regular");
    assert!(session.show_variation(
        variations.generation(),
        &varied.positions,
        Some(varied.report)
    ));
    varied.part
}

/// Moves along the first two variations and keeps the result.
fn keep_one(session: &mut Session) -> Vec<Point> {
    let mut variations = found(session);
    assert_eq!(bring_back(session, &mut variations, &[0.05, 0.02]), 1.0);
    assert!(session.keep_variation().expect("there is room"));
    session.positions()
}

#[test]
fn a_shape_that_is_too_large_is_refused_before_its_system_is_made() {
    // Its plane couples all vertices: a dense system of 400 million numbers.
    let mesh = grid(70, 70, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let text = json!({
        "format": "shape-up-scene", "version": 1, "mesh": { "file": "floor.obj" },
        "constraints": [{ "kind": "plane", "on": { "vertices": "0-4899" }, "require": "exact" }],
    });
    let scene = Scene::from_json(&text.to_string()).expect("it is a scene");
    let mut session = Session::open(scene, mesh).expect("it opens");
    run(&mut session);
    assert!(session.exact().expect("there is a hard row").met);
    let refused = session.variations().err().expect("it is refused");
    assert!(refused.to_string().contains("too large"), "{refused}");
}

#[test]
fn undo_of_a_variation_that_is_not_kept_undoes_nothing_else() {
    // The variation was discarded, and the step before it was undone with it.
    let mut session = flat();
    let start = session.positions();
    let mut variations = found(&session);
    let steps = session.undo_and_redo().map(|name| name.map(str::to_owned));
    bring_back(&mut session, &mut variations, &[0.05]);
    assert_eq!(session.undo_and_redo()[0], Some("Variation"));
    assert_eq!(session.undo().expect("it was solvable").as_deref(), Some("Variation"));
    assert_eq!(session.positions(), start);
    assert_eq!(session.undo_and_redo().map(|name| name.map(str::to_owned)), steps);
    assert_eq!(session.undo().expect("it was solvable"), steps[0]);
}

#[test]
fn what_is_kept_is_exact_and_one_step_of_undo() {
    let mut session = flat();
    let start = session.positions();
    let mut variations = found(&session);
    let before = session.undo_and_redo().map(|name| name.map(str::to_owned));
    assert!(show(&mut session, &variations, &[0.05]));
    assert!(farthest(&session.positions(), &start) > 0.01, "the way is shown at once");
    assert_eq!(session.keep_variation(), Ok(false), "it is not brought back yet");
    assert_eq!(bring_back(&mut session, &mut variations, &[0.05]), 1.0);
    assert!(session.exact().expect("there is a hard row").met);
    assert_eq!(session.undo_and_redo(), [Some("Variation"), before[1].as_deref()]);
    assert_eq!(session.keep_variation(), Ok(true));
    let kept = session.positions();
    assert_eq!(session.undo_and_redo()[0], Some("Keep Variation 1"));
    let names = |session: &Session| -> Vec<String> {
        session.document().variants.kept.iter().map(|variant| variant.name.clone()).collect()
    };
    assert_eq!(names(&session), ["Start", "Variation 1"]);
    assert!(!show(&mut session, &variations, &[0.01]), "those are of the shape before");
    session.undo().expect("it was solvable");
    assert!(session.positions() == start && names(&session).is_empty());
    session.redo().expect("it was solvable");
    assert!(session.positions() == kept && session.exact().is_some_and(|exact| exact.met));
}

#[test]
fn what_is_not_kept_is_left() {
    let mut session = flat();
    let start = session.positions();
    let mut variations = found(&session);
    let generation = session.generation();
    show(&mut session, &variations, &[0.05]);
    assert_ne!(session.generation(), generation);
    session.leave_variation();
    assert_eq!(session.positions(), start);
    assert_eq!(session.generation(), generation, "what was made for that shape holds again");
    bring_back(&mut session, &mut variations, &[0.0, 0.05]);
    run(&mut session);
    assert_eq!(session.positions(), start, "a run begins at the shape that is open");
    assert!(show(&mut session, &variations, &[0.05]));
    session.edit(Edit::SetUnits { units: "m".to_owned() }).expect("a unit");
    assert_eq!(session.positions(), start);
    let ways = session.document().constraints[0].clone();
    let soft = ConstraintSpec { require: Require::Soft, ..ways };
    let mut scene = session.scene();
    scene.constraints = vec![soft];
    let session = Session::open(scene, session.mesh().clone()).expect("it opens");
    assert!(session.variations().expect("regular").is_none(), "nothing is hard there");
}

#[test]
fn an_edit_that_is_refused_or_changes_nothing_leaves_the_variation_that_is_shown() {
    // The shape was that before, while the page went on showing the variation.
    let mut session = flat();
    let mut variations = found(&session);
    bring_back(&mut session, &mut variations, &[0.05]);
    let (shown, generation) = (session.positions(), session.generation());
    // There is no target surface.
    let near = Edit::Set { id: "closeness".to_owned(), value: "target".into() };
    session.edit(near).expect_err("there is no target");
    let weights = session.document().weights;
    assert_eq!(session.edit(Edit::SetWeights(weights.into())), Ok(false));
    assert!(session.positions() == shown && session.generation() == generation);
    assert_eq!(session.keep_variation(), Ok(true));
    assert_eq!(session.positions(), shown);
}

#[test]
fn a_design_that_was_kept_is_held_to() {
    let mut session = flat();
    let start = session.positions();
    let kept = keep_one(&mut session);
    let way = farthest(&kept, &start);
    // A drag, soft at first and exact at its end, by a small distance: the shape stays near the new
    // design.
    let target = [kept[14][0], kept[14][1], kept[14][2] + 0.01 * way];
    session.drag_through(DragPhase::Start, &[14], &[target]).expect("a handle");
    for _ in 0..30 {
        session.step().expect("finite");
    }
    session.drag_through(DragPhase::End, &[14], &[target]).expect("a handle");
    while session.is_running() && !session.step().expect("finite").ended {}
    session.end_run();
    let after = session.positions();
    assert!(session.exact().is_some_and(|exact| exact.met));
    assert!(farthest(&after, &kept) < 0.1 * way, "{} of {way}", farthest(&after, &kept));
    // A reset also discards the design.
    session.edit(Edit::Reset).expect("it was solvable");
    assert_eq!(session.document().variants.design, None);
}

#[test]
fn variants_are_saved_gone_to_compared_and_taken_away() {
    let mut session = flat();
    let start = session.positions();
    let first = keep_one(&mut session);
    let second = keep_one(&mut session);
    let text = session.scene_with_mesh();
    let history = session.saved_history();
    let scene = Scene::from_json(&text).expect("it is read");
    let MeshSource::Inline(mesh) = scene.mesh.clone() else { panic!("the mesh is in the scene") };
    let mut opened = Session::open(scene, *mesh).expect("it opens");
    assert_eq!(opened.scene_with_mesh(), text);
    opened.restore(&history, &[]).expect("it is of that scene");
    assert_eq!(opened.saved_history(), history);
    opened.undo().expect("solvable");
    assert_eq!(opened.positions(), first);
    opened.redo().expect("solvable");

    opened.edit(Edit::GoToVariant { index: 1 }).expect("it is there");
    assert!(opened.positions() == first && opened.exact().is_some_and(|exact| exact.met));
    let table = opened.variant_table(1e-6);
    assert_eq!(opened.positions(), first, "comparing moves nothing");
    let names: Vec<&str> = table.iter().map(|row| &*row.name).collect();
    assert_eq!(names, ["Start", "Variation 1", "Variation 2"]);
    for (row, shape) in table.iter().zip([&start, &first, &second]) {
        assert_eq!(row.is_current, *shape == first);
        assert_eq!(row.is_design, *shape == first);
        assert!(row.distance.is_some_and(|distance| distance < 1e-9));
        assert!(row.area > 20.0 && row.moved.max > 0.0);
        assert_eq!((row.panels, row.beyond), (25, 0));
    }
    // They are the numbers of each shape by itself.
    for (index, row) in table.iter().enumerate() {
        let mut at = Session::open(opened.scene(), opened.mesh().clone()).expect("it opens");
        let _ = at.edit(Edit::GoToVariant { index }).expect("it is there");
        let verdict = at.verdict(1e-6).expect("its panels are constrained");
        assert_eq!((row.panels, row.panels - row.beyond), (verdict.of, verdict.within));
        assert_eq!(row.moved, at.moved());
        assert!((at.worst_distance() - row.distance.unwrap_or(f64::NAN)).abs() < 1e-12);
    }
    // Nor does it disturb what is known of the shape.
    opened.solve(false).expect("solvable");
    opened.set_build_numbers(vec![("sheets".to_owned(), 3.0)]);
    let before = (opened.converged(), opened.iteration(), opened.goals(), opened.exact());
    opened.variant_table(1e-6);
    assert_eq!((opened.converged(), opened.iteration(), opened.goals(), opened.exact()), before);
    let refused = opened.edit(Edit::RemoveVariant { index: 1 });
    assert!(refused.is_err_and(|error| error.to_string().contains("this shape is open")));
    opened.edit(Edit::RemoveVariant { index: 0 }).expect("it is not the design");
    assert_eq!(opened.document().variants.design, Some(0));
}

#[test]
fn files_with_variants_that_do_not_fit_are_refused_by_name() {
    let session = flat();
    let (mesh, scene) = (session.mesh().clone(), session.scene());
    let positions = session.positions();
    let variant = |name: &str, positions: Vec<Point>| shape_up::scene::Variant {
        name: name.to_owned(),
        positions: positions.into(),
    };
    let refused = |variants: Variants, mesh: &Mesh| {
        let scene = Scene { variants, ..scene.clone() };
        let error = Session::open(scene, mesh.clone()).err().expect("it is refused");
        error.to_string()
    };
    let kept = vec![variant("short", positions[1..].to_vec())];
    assert!(refused(Variants { kept, design: None }, &mesh).contains("variants.kept[0].positions"));
    let kept = vec![variant("one", positions.clone())];
    assert!(refused(Variants { kept, design: Some(1) }, &mesh).contains("variants.design"));
    let kept = vec![variant("many", positions); Variants::MOST + 1];
    assert!(refused(Variants { kept, design: None }, &mesh).contains("variants.kept"));
}
