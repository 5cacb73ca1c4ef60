//! What is told of a run that collapses the shape.

use super::search::press;
use crate::support::drag;
use shape_up::generate::example::EXAMPLES;
use shape_up::mesh::{Mesh, read};
use shape_up::scene::{Closeness, Scene, Smoothness, Weights};
use shape_up::session::{CollapseReason, Edit, Level, PanelStart, Session};

/// The weights of Fig. 5, which are unsuitable for an open mesh whose boundary is free.
const FIG_5: Weights = Weights { shape: 5.0, close: 10.0, smooth: 2.0 };

/// Circular panels with the weights of Fig. 5 and otherwise default settings, as the page offered
/// them.
fn with_weights_of_fig_5(mesh: Mesh) -> Session {
    let mut scene = Scene::opened("own.obj");
    scene.closeness = Closeness::default();
    scene.smoothness = Smoothness::default();
    let mut session = Session::open(scene, mesh).unwrap();
    session
        .edit(Edit::MakePanels { kind: "circle".to_owned(), within: None, from: PanelStart::Now })
        .unwrap();
    session.edit(Edit::SetWeights(FIG_5.into())).unwrap();
    session
}

/// Runs as hosts do, at most `iterations` iterations; returns whether the run ended by itself.
fn run(session: &mut Session, iterations: u32) -> bool {
    session.begin_run();
    let ended = (0..iterations).any(|_| session.step().unwrap().ended);
    assert_eq!(session.end_run(), session.collapse());
    ended
}

#[test]
fn a_roof_that_shrinks_to_a_dot_is_told_and_never_called_converged() {
    // The mesh shrank to a dot: "converged", "worst panel 0 mm".
    for file in ["botanic-garden-bubble-0.obj", "compas_hypar.obj", "pillow_1.obj"] {
        let Some(mesh) = crate::support::shared::mesh(file) else { return };
        let before = mesh.positions.clone();
        let mut session = with_weights_of_fig_5(mesh);
        run(&mut session, 2000);
        assert!(session.collapse().is_some(), "{file}");
        assert!(!session.converged() && session.report().stopped_by == "iterations", "{file}");

        // Nor is a run that goes on from there.
        run(&mut session, 1000);
        let collapse = session.collapse();
        assert!(collapse.is_some() && !session.converged(), "{file}");

        // It is told of this shape and of that after the first run, and of no other.
        session.undo().unwrap();
        assert!(session.collapse().is_some() && !session.converged(), "{file}");
        session.undo().unwrap();
        assert_eq!(session.collapse(), None);
        assert_eq!(session.positions(), before);
        session.redo().unwrap();
        session.redo().unwrap();
        assert_eq!(session.collapse(), collapse, "{file}");
        session.undo().unwrap();
        session.undo().unwrap();

        // Holding closer helps.
        session.edit(Edit::HoldCloser).unwrap();
        assert!(run(&mut session, 2000) && session.converged(), "{file}");
        assert!(session.shortest_edge() > 0.0);
    }
}

#[test]
fn a_search_for_panels_is_judged_by_its_verdict() {
    // Beside the verdict, a message said that the run was stopped, and another run was proposed.
    let pavilion = "v 0 0 0\nv 6 0 0\nv 6 4 0\nv 0 4 0\nv 0 0 3\nv 6 0 3\nv 6 4 3\nv 0 4 3\nv 0 2 4.5\nv 6 2 4.5
        v 2.5 0 0\nv 3.5 0 0\nv 3.5 0 2.1\nv 2.5 0 2.1\nf 1 11 14 13 12 2 6 5\nf 2 3 7 10 6\nf 3 4 8 7
        f 4 1 5 9 8\nf 5 6 10 9\nf 8 9 10 7\nf 1 4 3 2 12 11";
    let mesh = read("pavilion.obj", pavilion.as_bytes()).expect("it is a mesh").mesh;
    let mut session = Session::open(Scene::opened("pavilion.obj"), mesh).expect("it fits");
    let before = session.positions();
    let verdict = press(&mut session, "circle");
    assert_eq!(verdict.level, Level::Poor);
    assert!(verdict.moved.max > 0.25 * session.mesh().size(), "{:?}", verdict.moved);
    assert!(session.collapse().is_none() && session.converged());
    session.undo().expect("a press can be undone");
    assert_eq!(session.positions(), before, "a press is one step");
    session.redo().expect("it can be redone");
    assert!(session.collapse().is_none() && session.converged());
    // It was told after another press that was undone, which had a verdict of its own.
    press(&mut session, "plane");
    session.undo().expect("a press can be undone");
    assert!(session.collapse().is_none());
}

/// A session on a flat grid of 10 by 10 m with these weights, after these edits.
fn flat(weights: Weights, edits: Vec<Edit>) -> Session {
    let mesh = crate::support::grid::grid(10, 10, |i, j| [f64::from(i), f64::from(j), 0.0]);
    let mut session = Session::open(Scene { weights, ..Scene::opened("flat.obj") }, mesh).unwrap();
    edits.into_iter().for_each(|edit| assert!(session.edit(edit).unwrap()));
    session
}

#[test]
fn what_was_asked_for_is_no_collapse() {
    let weights = Scene::opened("flat.obj").weights;
    // To lie on another surface: it was "Stopped: vertices moved by up to 28 %".
    let text = "v -5 -5 4\nv 15 -5 4\nv 15 15 4\nv -5 15 4\nf 1 2 3 4".to_owned();
    let mut fitted = flat(weights, vec![Edit::FitTo { name: "above.obj".to_owned(), text }]);
    assert!(run(&mut fitted, 2000));
    assert!(fitted.moved().max > 3.9 && fitted.converged(), "{:?}", fitted.collapse());

    // To follow a handle that was dragged, and to go back to the original without it.
    let panels = Edit::MakePanels { kind: "plane".to_owned(), within: None, from: PanelStart::Now };
    let handle = Edit::AddHandles { vertices: vec![0], fixed: false };
    let mut dragged = flat(Weights { shape: 1.0, close: 0.1, smooth: 1.0 }, vec![panels, handle]);
    dragged.begin_drag();
    drag(&mut dragged, [(0, [0.0, 0.0, 12.0])]).unwrap();
    dragged.end_drag(true);
    run(&mut dragged, 2000);
    assert!(dragged.moved().max > 5.0 && dragged.converged(), "{:?}", dragged.collapse());
    dragged.edit(Edit::RemoveHandles { vertices: vec![0] }).unwrap();
    run(&mut dragged, 2000);
    assert!(dragged.moved().max < 1e-3 && dragged.converged(), "{:?}", dragged.collapse());
}

/// Weights that shrink a mesh to a dot: nothing but its own smoothness acts.
const SHRINKING: Weights = Weights { shape: 1.0, close: 0.0, smooth: 10.0 };

/// The diagonal of the bounding box of the current shape.
fn size(session: &Session) -> f64 {
    let positions = session.positions();
    let extent = |axis: usize| {
        let along = || positions.iter().map(|point| point[axis]);
        along().fold(f64::MIN, f64::max) - along().fold(f64::MAX, f64::min)
    };
    (0..3).map(|axis| extent(axis) * extent(axis)).sum::<f64>().sqrt()
}

#[test]
fn a_collapse_beside_a_moved_handle_or_another_surface_is_told() {
    let open = |weights: Weights| {
        let mesh = crate::support::grid::grid(10, 10, |i, j| [f64::from(i), f64::from(j), 0.0]);
        let mut session = with_weights_of_fig_5(mesh);
        session.edit(Edit::SetWeights(weights.into())).unwrap();
        session
    };
    let held = Weights { shape: 1.0, close: 1.0, smooth: 0.1 };
    let collapses = |session: &mut Session| {
        run(session, 5000);
        assert!(size(session) < 2.0, "{}", size(session));
        let found = session.collapse().map(|collapse| collapse.reason);
        assert!(found == Some(CollapseReason::Shrunk) && !session.converged(), "{found:?}");
    };
    // A handle a quarter of the size away excused everything.
    let mut session = open(held);
    session.edit(Edit::AddHandles { vertices: vec![60], fixed: false }).unwrap();
    session.begin_drag();
    drag(&mut session, [(60, [5.0, 5.0, 4.0])]).unwrap();
    session.end_drag(true);
    run(&mut session, 2000);
    assert_eq!(session.collapse(), None);
    session.edit(Edit::SetWeights(SHRINKING.into())).unwrap();
    collapses(&mut session);
    // So did a surface.
    let mut session = open(held);
    let text = "v -5 -5 4\nv 15 -5 4\nv 15 15 4\nv -5 15 4\nf 1 2 3 4".to_owned();
    session.edit(Edit::FitTo { name: "above.obj".to_owned(), text }).unwrap();
    collapses(&mut session);
}

#[test]
fn a_collapse_over_several_runs_or_steps_is_told() {
    // Each of them left more than half of what it began with.
    let slowly = |smooth: f64| Edit::SetWeights(Weights { smooth, ..SHRINKING }.into());
    let open = || {
        let mesh = crate::support::grid::grid(10, 10, |i, j| [f64::from(i), f64::from(j), 0.0]);
        let mut session = with_weights_of_fig_5(mesh);
        session.edit(slowly(0.5)).unwrap();
        // Around its middle, so that no vertex moves far.
        session.edit(Edit::AddHandles { vertices: vec![60], fixed: true }).unwrap();
        session
    };
    let mut session = open();
    let first = size(&session);
    let run_to = |session: &mut Session, part: f64| {
        session.begin_run();
        while size(session) > part * first {
            session.step().unwrap();
        }
        assert!(size(session) > (part - 0.06) * first, "{}", size(session) / first);
        session.end_run()
    };
    assert_eq!(run_to(&mut session, 0.75), None);
    assert!(run_to(&mut session, 0.45).is_some());
    // So it is after an undo, but not with another problem.
    session.undo().unwrap();
    assert_eq!(session.collapse(), None);
    assert!(run_to(&mut session, 0.45).is_some());
    session.undo().unwrap();
    session.edit(Edit::Reset).unwrap();
    assert_eq!(run_to(&mut session, 0.75), None);
    session.edit(slowly(0.4)).unwrap();
    assert_eq!(run_to(&mut session, 0.48), None);

    let mut session = open();
    while size(&session) > 0.45 * first {
        session.single_step().unwrap();
    }
    assert!(session.collapse().is_some());
    session.single_step().unwrap();
    session.undo().unwrap();
    assert!(session.collapse().is_some(), "one of its steps is undone");
}

#[test]
fn what_its_author_meant_is_not_told() {
    // The strip of Fig. 11 shrinks by design, and Fig. 10 begins with a shape that has collapsed.
    for example in EXAMPLES {
        let (scene, mesh) = example.build();
        let limit = scene.solver.iterations;
        let is_hard = scene.constraints.iter().any(|row| row.require.is_hard());
        let mut session = Session::open(scene, mesh).unwrap();
        run(&mut session, limit);
        assert_eq!(session.collapse(), None, "{}", example.id);
        let is_met = is_hard && session.exact().is_some_and(|exact| exact.met);
        assert_eq!(session.converged(), is_met || session.solver().converged(), "{}", example.id);
    }
}

#[test]
fn a_mesh_that_is_dragged_across_the_scene_has_not_collapsed() {
    let mut scene = Scene::opened("own.obj");
    scene.weights = Weights::default();
    let mut session = Session::open(scene, crate::support::grid::bumpy(6)).unwrap();
    session
        .edit(Edit::MakePanels { kind: "plane".to_owned(), within: None, from: PanelStart::Now })
        .unwrap();
    session.edit(Edit::SetWeights(Weights::default().into())).unwrap();
    session.edit(Edit::AddHandles { vertices: vec![0], fixed: true }).unwrap();
    session.begin_drag();
    drag(&mut session, [(0, [100.0, 0.0, 0.0])]).unwrap();
    session.step().unwrap();
    session.end_drag(true);
    run(&mut session, 500);
    assert!(session.moved().max > 50.0);
    assert_eq!(session.collapse(), None);
}

#[test]
fn real_meshes_with_the_settings_of_an_opened_mesh_do_not_trip_it() {
    for file in ["M2_eq_quad2.obj", "compas_hypar.obj", "pillow_1.obj", "horse_quad.obj"] {
        let Some(mesh) = crate::support::shared::mesh(file) else { return };
        for kind in ["circle", "plane"] {
            let mut session = Session::open(Scene::opened("own.obj"), mesh.clone()).unwrap();
            session
                .edit(Edit::MakePanels {
                    kind: kind.to_owned(),
                    within: None,
                    from: PanelStart::Now,
                })
                .unwrap();
            assert!(run(&mut session, 2000), "{file}");
            assert!(session.collapse().is_none() && session.converged(), "{file} {kind}");
        }
    }
}

#[test]
fn a_scene_that_was_edited_is_watched_over_after_a_reload_too() {
    let mesh = crate::support::grid::grid(10, 10, |i, j| {
        [f64::from(i), f64::from(j), f64::from(i * j % 7) * 0.2]
    });
    let mut session = with_weights_of_fig_5(mesh.clone());
    let smooth = Weights { shape: 1.0, close: 0.0, smooth: 10.0 };
    session.edit(Edit::SetWeights(smooth.into())).unwrap();
    let mut opened = Session::open(session.scene(), mesh).unwrap();
    opened.restore(&session.saved_history(), &[]).unwrap();
    assert!(run(&mut session, 5000) && session.collapse().is_some());
    // The reopened scene was once taken for a scene whose author intends the collapse.
    assert!(run(&mut opened, 5000));
    assert_eq!(opened.collapse(), session.collapse());
}
