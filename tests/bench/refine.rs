//! Solving level by level while a mesh is refined, against solving the fine mesh at once: a row for each way.
//!
//! `bench_refine MESH:KIND:LEVELS...`: panels of that kind, after so many levels of Catmull-Clark. Energies, shape and
//! smoothness are those of the fine mesh with the weights of a mesh that is opened, against the refined original, for all
//! ways; `off` and `moved` are in mean edges of the fine mesh, `within` counts panels within its tolerance.
//!
//! | way | does |
//! |---|---|
//! | at once | refines the original and solves it |
//! | levels | solves each level and refines it; closeness is to the refined original |
//! | design | the same, but each solved level is the original of the next one |
//! | rough | as levels, but a level ends at a thousand times the tolerance, only the last one goes on |
//! | start | solves only the coarse mesh, and refines it all the way |

use shape_up::mesh::{KEPT_TURN, Mesh, Scheme, read};
use shape_up::scene::Scene;
use shape_up::session::{Edit, Session};
use shape_up::solve::Require;
use std::time::Instant;

/// A level that is refined further ends at so many times the tolerance.
const ROUGH: f64 = 1e3;

fn main() {
    println!(
        "{:<22} {:<7} {:>6} {:<8} {:>7} {:>6} {:>11} {:>11} {:>11} {:>8} {:>7} {:>7}",
        "mesh",
        "kind",
        "faces",
        "way",
        "s",
        "its",
        "energy",
        "shape",
        "smooth",
        "off",
        "within",
        "moved"
    );
    for argument in std::env::args().skip(1) {
        let parts: Vec<&str> = argument.split(':').collect();
        let [path, kind, levels] = parts[..] else { panic!("expected MESH:KIND:LEVELS") };
        let levels: u32 = levels.parse().expect("a number of levels");
        let bytes = std::fs::read(path).expect("the mesh can be read");
        let mesh = read(path, &bytes).expect("it is a mesh").mesh;
        let name = path.rsplit('/').next().unwrap_or_default();
        for way in ["at once", "levels", "design", "rough", "start"] {
            row(name, kind, way, &mesh, levels);
        }
    }
}

fn opened(mesh: Mesh, kind: &str) -> Session {
    let mut scene = Scene::opened("own.obj");
    scene.ask_of_panels(kind, Require::Soft, &mesh).expect("it is offered");
    Session::open(scene, mesh).expect("it can be solved")
}

fn refine(session: &mut Session, levels: u32) {
    let edit = Edit::Refine { scheme: Scheme::CatmullClark, levels, keep: KEPT_TURN };
    session.edit(edit).expect("it can be refined");
}

/// Iterates until the tolerance times a factor, and counts the iterations.
fn solve(session: &mut Session, factor: f64) -> u32 {
    let before = session.iteration();
    let limit = session.document().solver.iterations;
    let tolerance = factor * session.document().solver.tolerance;
    let mut last = session.solver().energy().total;
    for _ in 0..limit {
        let ended = session.step().expect("positions stay finite").ended;
        let now = session.solver().energy().total;
        if ended || (factor > 1.0 && last - now <= tolerance * now) {
            break;
        }
        last = now;
    }
    session.iteration() - before
}

fn row(name: &str, kind: &str, way: &str, mesh: &Mesh, levels: u32) {
    let begun = Instant::now();
    let mut session = opened(mesh.clone(), kind);
    let mut iterations = 0;
    match way {
        "at once" => {
            refine(&mut session, levels);
            iterations += solve(&mut session, 1.0);
        }
        "start" => {
            iterations += solve(&mut session, 1.0);
            refine(&mut session, levels);
            iterations += solve(&mut session, 1.0);
        }
        _ => {
            for level in 0..=levels {
                let is_rough = way == "rough" && level < levels;
                iterations += solve(&mut session, if is_rough { ROUGH } else { 1.0 });
                if level == levels {
                    break;
                }
                if way == "design" {
                    let now = Mesh { positions: session.positions(), ..session.mesh().clone() };
                    session = opened(now, kind);
                }
                refine(&mut session, 1);
            }
        }
    }
    let seconds = begun.elapsed().as_secs_f64();
    // All ways by the same measure: against the refined original.
    let mut measured = opened(mesh.clone(), kind);
    refine(&mut measured, levels);
    let mut scene = measured.scene();
    scene.current = Some(session.positions());
    let mut measured = Session::open(scene, measured.mesh().clone()).expect("it can be solved");
    let energy = measured.solver().energy();
    let tolerance = measured.tolerance();
    let edge = measured.mean_edge();
    let verdict = measured.verdict(tolerance).expect("panels are asked");
    println!(
        "{name:<22} {kind:<7} {:>6} {way:<8} {seconds:>7.2} {iterations:>6} {:>11.4e} {:>11.4e} {:>11.4e} {:>8.4} {:>6.1}% {:>7.3}",
        measured.mesh().faces.len(),
        energy.total,
        energy.shape,
        energy.smooth,
        verdict.worst / edge,
        100.0 * verdict.within as f64 / verdict.panels as f64,
        verdict.moved.mean / edge,
    );
}
