//! Folded faces of real meshes after their panels are made circular and flat, natively.
//!
//! `bench_folds MESH...`: a row for each kind and way: `press` (within a thousandth of the mean
//! edge, with a larger tolerance for panels that would fold), `within` (that tolerance for all) and
//! `exact`. Lengths are relative to the mean edge, energies are without the constraints and
//! relative to its square.

use shape_up::mesh::{Mesh, folded_faces, read};
use shape_up::scene::{Require, Scene};
use shape_up::session::{PanelStart, Session};
use shape_up::solve::clock;

const WAYS: [&str; 3] = ["press", "within", "exact"];

fn main() {
    println!(
        "{:<32} {:<7} {:<7} {:>6} {:>4} {:>6} {:>9} {:>9} {:>7} {:>7} {:>9} {:>5} {:>6}",
        "mesh",
        "kind",
        "way",
        "folded",
        "met",
        "eased",
        "tolerance",
        "farthest",
        "moved",
        "mean",
        "energy",
        "tries",
        "s"
    );
    for path in std::env::args().skip(1) {
        let bytes = std::fs::read(&path).expect("the mesh can be read");
        let mesh = read(&path, &bytes).expect("it is a mesh").mesh;
        let name = path.rsplit('/').next().unwrap_or_default();
        for kind in ["circle", "plane"] {
            WAYS.iter().for_each(|way| row(name, kind, way, &mesh));
        }
    }
}

fn row(name: &str, kind: &str, way: &str, mesh: &Mesh) {
    let mut session = Session::open(Scene::opened(name), mesh.clone()).expect("it can be opened");
    let (edge, tolerance) = (session.mean_edge(), session.tolerance());
    let started = clock::now();
    if way == "press" {
        if session.make_panels(kind, tolerance, PanelStart::Now).is_err() {
            return;
        }
        while !session.step().expect("it stays finite").ended {}
        session.end_run();
    } else {
        let require = if way == "exact" { Require::Exact } else { Require::Within(tolerance) };
        let mut scene = session.scene();
        if scene.request_panels(kind, require, mesh).is_err() {
            return;
        }
        session = Session::open(scene, mesh.clone()).expect("it can be opened");
        session.solve(false).expect("it stays finite");
    }
    let seconds = clock::now() - started;
    let folded = folded_faces(session.mesh(), session.topology(), &session.positions()).len();
    let (moved, energy) = (session.moved(), session.solver().energy());
    let Some(exact) = session.exact() else { return };
    println!(
        "{name:<32} {kind:<7} {way:<7} {folded:>6} {:>4} {:>6} {:>9.1e} {:>9.1e} {:>7.2} {:>7.3} {:>9.4} {:>5} {seconds:>6.2}",
        if exact.met { "yes" } else { "no" },
        exact.eased.map_or(0, |eased| eased.panels),
        exact.tolerance / edge,
        exact.max_distance / edge,
        moved.max / edge,
        moved.mean / edge,
        (energy.close + energy.smooth) / (edge * edge),
        exact.attempts,
    );
}
