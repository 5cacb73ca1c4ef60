//! The guard against shapes that collapse during a run without a drag.

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
fn run(session: &mut Session, iterations: u32, goes_on: bool) -> bool {
    session.begin_run();
    if goes_on {
        session.ignore_collapse();
    }
    let ended = (0..iterations).any(|_| session.step().unwrap().ended);
    let told = session.end_run();
    assert_eq!(told, session.collapse().filter(|_| !goes_on));
    ended
}

#[test]
fn a_roof_that_shrinks_to_a_dot_stops_and_is_never_called_converged() {
    // Without the guard the mesh shrank to a dot: "converged", "worst panel 0 mm".
    for file in ["botanic-garden-bubble-0.obj", "compas_hypar.obj", "pillow_1.obj"] {
        let Some(mesh) = crate::support::shared::mesh(file) else { return };
        let before = mesh.positions.clone();
        let mut session = with_weights_of_fig_5(mesh);
        assert!(run(&mut session, 2000, false), "{file}");
        let collapse = session.collapse().unwrap();
        assert!(!session.converged() && session.report().stopped_by == "iterations", "{file}");
        assert!(session.moved().max > 0.0);

        // The user may continue the run; it still does not count as converged.
        run(&mut session, 1000, true);
        assert!(session.collapse().is_some() && !session.converged(), "{file}");

        // Undo and redo restore the collapse state.
        session.undo().unwrap();
        session.undo().unwrap();
        assert_eq!(session.collapse(), None);
        assert_eq!(session.positions(), before);
        session.redo().unwrap();
        assert_eq!(session.collapse(), Some(collapse), "{file}");

        // Holding closer helps, starting from the shape before the run.
        session.edit(Edit::HoldCloser).unwrap();
        assert_eq!(session.collapse(), None);
        assert_eq!(session.positions(), before);
        assert!(run(&mut session, 2000, false) && session.converged(), "{file}");
        assert!(session.shortest_edge() > 0.0);
    }
}

#[test]
fn a_run_that_stops_says_in_which_way() {
    for (file, reason) in [
        ("compas_hypar.obj", CollapseReason::Shrunk),
        ("compas_tubemesh.obj", CollapseReason::Area),
        ("botanic-garden-bubble-0.obj", CollapseReason::Moved),
    ] {
        let Some(mesh) = crate::support::shared::mesh(file) else { return };
        let mut session = with_weights_of_fig_5(mesh);
        run(&mut session, 2000, false);
        assert_eq!(session.collapse().unwrap().reason, reason, "{file}");
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
}

#[test]
fn what_its_author_meant_is_not_stopped() {
    // The strip of Fig. 11 shrinks by design, and Fig. 10 begins with a shape that has collapsed.
    for example in EXAMPLES {
        let (scene, mesh) = example.build();
        let limit = scene.solver.iterations;
        let is_hard = scene.constraints.iter().any(|row| row.require.is_hard());
        let mut session = Session::open(scene, mesh).unwrap();
        run(&mut session, limit, false);
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
    run(&mut session, 500, false);
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
            assert!(run(&mut session, 2000, false), "{file}");
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
    assert!(run(&mut session, 5000, false) && session.collapse().is_some());
    // The reopened scene was once taken for a scene whose author intends the collapse.
    assert!(run(&mut opened, 5000, false));
    assert_eq!(opened.collapse(), session.collapse());
}
