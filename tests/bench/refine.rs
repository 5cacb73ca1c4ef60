//! Solving level by level while a mesh is refined, against solving the fine mesh at once: a row for
//! each way.
//!
//! `bench_refine MESH:KIND:LEVELS...`: panels of that kind, after LEVELS levels of Catmull-Clark,
//! exact as with "make panels"; with `MESH:KIND:LEVELS:soft` they are soft. For all ways, energies,
//! shape and smoothness are those of the fine mesh with the weights of an opened mesh, against the
//! refined original; `off` and `moved` are in mean edges of the fine mesh, `within` counts panels
//! within its tolerance.
//!
//! | way | does |
//! |---|---|
//! | at once | refines the original and solves it |
//! | levels | solves each level and refines it; closeness is to the refined original |
//! | adopt | the same, but each solved level is the original of the next one |
//! | rough | as levels, but levels that are refined further are soft and end at a thousand times the tolerance |
//! | start | solves only the coarse mesh, and refines it to the finest level |

use shape_up::mesh::{KEPT_TURN, Mesh, Scheme, read};
use shape_up::scene::Scene;
use shape_up::session::{Edit, Session};
use shape_up::solve::Require;
use std::time::Instant;

/// Factor of the tolerance for levels that are refined further.
const ROUGH: f64 = 1e3;

fn main() {
    println!(
        "{:<22} {:<7} {:>6} {:<8} {:>7} {:>7} {:>11} {:>11} {:>11} {:>8} {:>7} {:>7} {:>7} {:>6}",
        "mesh",
        "kind",
        "faces",
        "way",
        "s",
        "before",
        "energy",
        "shape",
        "smooth",
        "off",
        "within",
        "moved",
        "most",
        "folded"
    );
    for argument in std::env::args().skip(1) {
        let parts: Vec<&str> = argument.split(':').collect();
        let (path, kind, levels, require) = match parts[..] {
            [path, kind, levels] => (path, kind, levels, Require::Exact),
            [path, kind, levels, "soft"] => (path, kind, levels, Require::Soft),
            _ => panic!("expected MESH:KIND:LEVELS or MESH:KIND:LEVELS:soft"),
        };
        let levels: u32 = levels.parse().expect("a number of levels");
        let bytes = std::fs::read(path).expect("the mesh can be read");
        let mesh = read(path, &bytes).expect("it is a mesh").mesh;
        let name = path.rsplit('/').next().unwrap_or_default();
        for way in ["at once", "levels", "adopt", "rough", "start"] {
            row(name, kind, way, &mesh, levels, require);
        }
    }
}

fn opened(mesh: Mesh, kind: &str, require: Require) -> Session {
    let mut scene = Scene::opened("own.obj");
    scene.request_panels(kind, require, &mesh).expect("it is offered");
    Session::open(scene, mesh).expect("it can be solved")
}

fn refine(session: &mut Session, levels: u32, adopt: bool) {
    let edit = Edit::Refine { scheme: Scheme::CatmullClark, levels, keep: KEPT_TURN, adopt };
    session.edit(edit).expect("it can be refined");
}

/// Iterates up to a thousand times the tolerance, with soft panels.
fn solve_roughly(session: &mut Session) {
    let solver = session.document().solver;
    let mut last = session.solver().energy().total;
    for _ in 0..solver.iterations {
        let ended = session.step().expect("positions stay finite").ended;
        let now = session.solver().energy().total;
        if ended || last - now <= ROUGH * solver.tolerance * now {
            break;
        }
        last = now;
    }
}

fn solve(session: &mut Session) {
    session.solve(false).expect("positions stay finite");
}

fn row(name: &str, kind: &str, way: &str, mesh: &Mesh, levels: u32, require: Require) {
    let begun = Instant::now();
    let mut session = opened(mesh.clone(), kind, require);
    match way {
        "at once" => refine(&mut session, levels, false),
        "start" => {
            solve(&mut session);
            refine(&mut session, levels, false);
        }
        _ => {
            for _ in 0..levels {
                match way {
                    "rough" => solve_roughly(&mut session),
                    _ => solve(&mut session),
                }
                refine(&mut session, 1, way == "adopt");
            }
        }
    }
    let before = begun.elapsed().as_secs_f64();
    solve(&mut session);
    let seconds = begun.elapsed().as_secs_f64();
    // The same measure for all ways: against the refined original.
    let mut measured = opened(mesh.clone(), kind, require);
    refine(&mut measured, levels, false);
    let mut scene = measured.scene();
    scene.current = Some(session.positions());
    let mut measured = Session::open(scene, measured.mesh().clone()).expect("it can be solved");
    let energy = measured.solver().energy();
    let tolerance = measured.tolerance();
    let edge = measured.mean_edge();
    let verdict = measured.verdict(tolerance).expect("panels are asked");
    println!(
        "{name:<22} {kind:<7} {:>6} {way:<8} {seconds:>7.2} {before:>7.2} {:>11.4e} {:>11.4e} {:>11.4e} {:>8.4} {:>6.1}% {:>7.3} {:>7.3} {:>6}",
        measured.mesh().faces.len(),
        energy.total,
        energy.shape,
        energy.smooth,
        verdict.worst / edge,
        100.0 * verdict.within as f64 / verdict.panels as f64,
        verdict.moved.mean / edge,
        verdict.moved.max / edge,
        verdict.folded,
    );
}
