//! Saddles of the energy are left.

use crate::support::grid::grid;
use crate::support::shared;
use shape_up::mesh::Mesh;
use shape_up::scene::Scene;
use shape_up::session::{PanelStart, Session};

/// A flat grid whose edges are to be longer: it has to buckle, but each step of the iteration stays in
/// its plane.
fn too_long(mesh: Mesh, accelerator: &str) -> Session {
    let text = r#"{ "format": "shape-up-scene", "version": 1, "mesh": { "file": "own.obj" },
        "constraints": [{ "kind": "line-segment", "on": "edges", "length": 1.1 }],
        "weights": { "shape": 100, "close": 1, "smooth": 0 }, "closeness": { "to": "rest" },
        "solver": { "iterations": 5000, "accelerator": "ACCELERATOR" } }"#;
    let text = &text.replace("ACCELERATOR", accelerator);
    Session::open(Scene::from_json(text).expect("a scene"), mesh).expect("it fits")
}

#[test]
fn a_flat_grid_of_too_long_edges_buckles() {
    // The plain iteration is the one of the paper: it stands still.
    for (accelerator, buckles) in [("quasi-newton", true), ("anderson", true), ("none", false)] {
        let flat = grid(6, 6, |i, j| [f64::from(i), f64::from(j), 0.0]);
        let mut session = too_long(flat, accelerator);
        session.solve(false).expect("it can be solved");
        let heights = session.positions().into_iter().map(|[_, _, z]| z.abs());
        let highest = heights.fold(0.0, f64::max);
        assert!(session.converged());
        assert_eq!(highest > 0.1, buckles, "{accelerator}: {highest}");
    }
}

#[test]
fn a_hypar_made_flat_does_not_end_at_a_saddle() {
    // It was said to have converged at 26.60; the rounding errors of more iterations lead to 16.45.
    let Some(mesh) = shared::mesh("compas_hypar.obj") else { return };
    let mut session = Session::open(Scene::opened("own.obj"), mesh).expect("it fits");
    session.make_panels("plane", f64::INFINITY, PanelStart::Now).expect("it has quads");
    while !session.step().expect("it stays finite").ended {}
    session.end_run();
    let total = session.solver().energy().total;
    assert!(session.converged());
    assert!((total - 16.452).abs() < 0.01, "{total}");
}

/// The step for differences of gradients is a fraction of the extent: without one it was 0, and an
/// assertion about the matrix failed.
#[test]
fn vertices_that_all_lie_at_one_place_converge_there() {
    let mesh = grid(3, 3, |_, _| [1.0, 2.0, 3.0]);
    let mut session = Session::open(Scene::opened("own.obj"), mesh).expect("it fits");
    session.solve(false).expect("it stays finite");
    assert!(session.converged());
    assert!(session.positions().iter().all(|&place| place == [1.0, 2.0, 3.0]));
}
