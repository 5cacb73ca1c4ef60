//! Times of one problem, natively: the measurements of `worker.mjs` in the browser, with the same
//! names.
//!
//! `npm run bench` writes the problems, calls this program, and makes the tables:
//! `bench_problems TASK.json RESULT.json`. A task is a scene with its mesh and the measurement;
//! times in the result are milliseconds.

mod parts;
mod stream;

use serde::{Deserialize, Serialize};
use shape_up::mesh::{Point, Topology, read};
use shape_up::scene::{NamedEnum, Scene};
use shape_up::session::{Edit, ExactReport, Report, Session};
use shape_up::solve::{ConformalNorm, ConformalWeights, Parametrization, clock};
use std::hint::black_box;

/// A measurement.
#[derive(Deserialize)]
#[serde(tag = "measure", rename_all = "kebab-case")]
enum Task {
    /// Set-up, single iterations, edits.
    Iterations {
        #[serde(flatten)]
        problem: Problem,
        /// Number of openings; the first one is not counted.
        loads: usize,
        /// Number of runs from the start; the first one is not counted.
        rounds: usize,
        /// Iterations of each run, and how many at its start are not counted.
        steps: [usize; 2],
        /// Number of times that each edit is made.
        edits: usize,
    },
    /// Energy and time of every iteration.
    Convergence {
        #[serde(flatten)]
        problem: Problem,
        /// Ends at this energy.
        goal: f64,
        /// Ends after this number of milliseconds.
        limit: f64,
        /// Ends after this number of iterations in which the energy hardly fell; 0 disables it.
        patience: usize,
    },
    /// Hard constraints met from the soft solution, and steps along each variation by a fraction of
    /// the size.
    Exact {
        #[serde(flatten)]
        problem: Problem,
        step: Option<f64>,
    },
    /// Edits of the handles of all vertices.
    Handles {
        #[serde(flatten)]
        problem: Problem,
        rounds: usize,
    },
    /// A conformal map.
    Map { mesh: String, weights: String, rounds: usize },
    /// Parts on sheets.
    Parts { mesh: String, rounds: usize },
    /// Reading memory.
    Stream { bytes: Vec<usize> },
}

/// A scene, the path of its mesh, and the handles that are moved at the start.
#[derive(Deserialize)]
struct Problem {
    scene: String,
    mesh: String,
    #[serde(rename = "move")]
    moved: Vec<(u32, Point)>,
    /// Vertices that become handles in edits.
    spare: Vec<u32>,
    /// Whether the energies of every iteration are recorded, as on the page.
    traced: bool,
}

impl Problem {
    fn open(&self) -> Session {
        let bytes = std::fs::read(&self.mesh).expect("the mesh was written");
        let file = read(&self.mesh, &bytes).expect("the mesh can be read");
        let scene = Scene::from_json(&self.scene).expect("the scene is valid");
        let mut session = Session::open(scene, file.mesh).expect("the problem can be set up");
        if self.traced {
            session.start_trace();
        }
        session
    }

    /// Opens the problem and moves its handles.
    fn begin(&self) -> Session {
        let mut session = self.open();
        self.drag(&mut session, 1.0);
        session
    }

    /// Moves the handles by a fraction of their displacement.
    fn drag(&self, session: &mut Session, part: f64) {
        let rest = &session.mesh().positions;
        let targets = self.moved.iter().map(|&(v, to)| {
            let from = rest[v as usize];
            (v, std::array::from_fn(|i| from[i] + part * (to[i] - from[i])))
        });
        let targets: Vec<(u32, Point)> = targets.collect();
        session.begin_drag();
        session.drag(targets).expect("the targets are near");
        session.end_drag(true);
    }
}

/// Milliseconds of one iteration: the total, and the parts that the solver reports.
#[derive(Serialize)]
struct Step {
    total: f64,
    shape: f64,
    close: f64,
    smooth: f64,
    global: f64,
}

/// Milliseconds of one opening.
#[derive(Serialize)]
struct Opening {
    total: f64,
    assemble: f64,
    order: f64,
    factor: f64,
    /// Until the end of the first iteration.
    first: f64,
}

#[derive(Serialize)]
struct Iterations {
    report: Report,
    openings: Vec<Opening>,
    steps: Vec<Step>,
    /// The first iteration of each run: the accelerator has no history, as in every step of a drag.
    fresh: Vec<Step>,
    /// A handle is added.
    handle: Vec<f64>,
    /// The set of constraints is changed, and the first iteration after it.
    change: Vec<f64>,
    /// A handle is moved, and the first iteration after it.
    drag: Vec<Step>,
}

#[derive(Serialize)]
struct Convergence {
    /// Total energy before the first iteration, then after each.
    energies: Vec<f64>,
    /// Milliseconds of each iteration.
    steps: Vec<f64>,
}

#[derive(Serialize)]
struct Map {
    eigenvalue: f64,
    runs: Vec<MapRun>,
}

#[derive(Serialize)]
struct MapRun {
    total: f64,
    assemble: f64,
    order: f64,
    factor: f64,
    iterate: f64,
}

/// Milliseconds of an edit of all handles, and of the first iteration after it.
#[derive(Serialize)]
struct HandleEdit {
    what: &'static str,
    edit: f64,
    iteration: f64,
}

/// Result of a call, and its milliseconds.
fn timed<T>(run: impl FnOnce() -> T) -> (T, f64) {
    let started = clock::now();
    let value = black_box(run());
    (value, 1e3 * (clock::now() - started))
}

fn step(session: &mut Session) -> Step {
    let before = session.solver().iterate_seconds();
    let (done, total) = timed(|| session.step());
    done.expect("positions stay finite");
    let after = session.solver().iterate_seconds();
    Step {
        total,
        shape: 1e3 * (after.shape - before.shape),
        close: 1e3 * (after.close - before.close),
        smooth: 1e3 * (after.smooth - before.smooth),
        global: 1e3 * (after.global - before.global),
    }
}

fn edit(session: &mut Session, edit: Edit) {
    session.edit(edit).expect("the edit is valid");
}

fn opening(problem: &Problem) -> (Session, Opening) {
    let (mut session, total) = timed(|| problem.open());
    let set_up = session.solver().set_up_seconds();
    let first = total + step(&mut session).total;
    let [assemble, order, factor] =
        [set_up.assemble, set_up.order, set_up.factor].map(|seconds| 1e3 * seconds);
    (session, Opening { total, assemble, order, factor, first })
}

fn iterations(
    problem: &Problem,
    loads: usize,
    rounds: usize,
    [all, unmeasured]: [usize; 2],
    edits: usize,
) -> Iterations {
    let (mut session, _) = opening(problem);
    let mut openings = Vec::new();
    for _ in 1..loads {
        let (next, opening) = opening(problem);
        session = next;
        openings.push(opening);
    }
    let (mut steps, mut fresh) = (Vec::new(), Vec::new());
    let mut report = session.report();
    problem.drag(&mut session, 1.0);
    for round in 0..rounds {
        edit(&mut session, Edit::Reset);
        for k in 0..all {
            let step = step(&mut session);
            if round > 0 && k == 0 {
                fresh.push(step);
            } else if round > 0 && k >= unmeasured {
                steps.push(step);
            }
        }
        report = session.report();
    }
    let (mut handle, mut change, mut drag) = (Vec::new(), Vec::new(), Vec::new());
    for &vertex in problem.spare.iter().cycle().take(edits) {
        let vertices = vec![vertex];
        let add = Edit::AddHandles { vertices: vertices.clone(), fixed: false };
        handle.push(timed(|| edit(&mut session, add)).1);
        edit(&mut session, Edit::RemoveHandles { vertices });
    }
    for k in 0..edits {
        let weight = Some(1.0 + 0.5 * (k + 1) as f64);
        let params = serde_json::Map::new();
        let set = Edit::SetConstraint { index: 0, weight, require: None, enabled: None, params };
        let edited = timed(|| edit(&mut session, set)).1;
        change.push(edited + step(&mut session).total);
    }
    for k in 0..edits * usize::from(!problem.moved.is_empty()) {
        let dragged = timed(|| problem.drag(&mut session, 1.0 - 0.01 * k as f64)).1;
        let mut step = step(&mut session);
        step.total += dragged;
        drag.push(step);
    }
    Iterations { report, openings, steps, fresh, handle, change, drag }
}

fn handles(problem: &Problem, rounds: usize) -> Vec<HandleEdit> {
    let mut session = problem.begin();
    let all: Vec<u32> = (0..session.mesh().positions.len() as u32).collect();
    let mut edits = Vec::new();
    let mut measure = |what, session: &mut Session, run: &mut dyn FnMut(&mut Session)| {
        let edit = timed(|| run(session)).1;
        edits.push(HandleEdit { what, edit, iteration: step(session).total });
    };
    let undo = |session: &mut Session| _ = session.undo().expect("the state was regular");
    for _ in 0..rounds {
        let fix = Edit::AddHandles { vertices: all.clone(), fixed: true };
        let soft = Edit::AddHandles { vertices: all.clone(), fixed: false };
        let release = Edit::RemoveHandles { vertices: all.clone() };
        measure("fix all", &mut session, &mut |session| edit(session, fix.clone()));
        measure("undo of it", &mut session, &mut |session| undo(session));
        measure("all soft", &mut session, &mut |session| edit(session, soft.clone()));
        measure("undo of it", &mut session, &mut |session| undo(session));
        edit(&mut session, fix.clone());
        measure("fixed to soft", &mut session, &mut |session| edit(session, soft.clone()));
        measure("undo of it", &mut session, &mut |session| undo(session));
        measure("release all", &mut session, &mut |session| edit(session, release.clone()));
        measure("undo of it", &mut session, &mut |session| undo(session));
        edit(&mut session, release.clone());
    }
    edits
}

fn convergence(problem: &Problem, goal: f64, limit: f64, patience: usize) -> Convergence {
    let mut session = problem.begin();
    let mut energies = vec![session.solver().energy().total];
    let mut steps = Vec::new();
    let (mut spent, mut still) = (0.0, 0);
    while spent < limit && (patience == 0 || still < patience) {
        let before = energies[energies.len() - 1];
        let (done, milliseconds) = timed(|| session.step());
        done.expect("positions stay finite");
        let energy = session.solver().energy().total;
        steps.push(milliseconds);
        energies.push(energy);
        spent += milliseconds;
        still = if before - energy > 1e-11 * before { 0 } else { still + 1 };
        if energy <= goal {
            break;
        }
    }
    Convergence { energies, steps }
}

fn map(path: &str, weights: &str, rounds: usize) -> Map {
    let mesh = read(path, &std::fs::read(path).expect("the mesh was written"));
    let mesh = mesh.expect("the mesh can be read").mesh;
    let topology = Topology::new(&mesh);
    let weights = ConformalWeights::of_word(weights);
    let weights = weights.expect("the weights are a word of the command line");
    let run = || {
        let (map, total) =
            timed(|| Parametrization::new(&mesh, &topology, weights, ConformalNorm::Boundary));
        (map.expect("the mesh has an area"), total)
    };
    let (first, _) = run();
    let runs = (0..rounds).map(|_| {
        let (map, total) = run();
        let seconds = map.seconds;
        let [assemble, order, factor, iterate] =
            [seconds.assemble, seconds.order, seconds.factor, seconds.iterate].map(|s| 1e3 * s);
        MapRun { total, assemble, order, factor, iterate }
    });
    Map { eigenvalue: first.eigenvalue, runs: runs.collect() }
}

/// Milliseconds of the soft solution and the exact one together, and the report of the exact one.
#[derive(Serialize)]
struct Exact {
    total: f64,
    exact: Option<ExactReport>,
    varied: Option<Varied>,
}

/// Milliseconds until the modes are computed, and steps along each of them.
#[derive(Serialize)]
struct Varied {
    modes: f64,
    steps: Vec<VariationStep>,
}

#[derive(Serialize)]
struct VariationStep {
    part: Option<f64>,
    ms: f64,
    distance: Option<f64>,
}

fn exact(problem: &Problem, step: Option<f64>) -> Exact {
    let mut session = problem.open();
    let ((), total) = timed(|| {
        session.begin_run();
        while !session.step().expect("positions stay finite").ended {}
        session.end_run();
    });
    let exact = session.exact();
    let varied = step.and_then(|step| varied(&mut session, step));
    Exact { total, exact, varied }
}

fn varied(session: &mut Session, step: f64) -> Option<Varied> {
    let (variations, modes) = timed(|| {
        let mut variations = session.variations().expect("its systems are regular")?;
        while !variations.are_found() {
            variations.step().expect("its systems are regular");
        }
        Some(variations)
    });
    let mut variations = variations?;
    let count = variations.modes().len();
    let steps = (0..count).map(|k| {
        let mut coefficients = vec![0.0; count];
        coefficients[k] = step;
        let (part, ms) = timed(|| session.project_variation(&mut variations, &coefficients));
        let distance = session.exact().map(|exact| exact.max_distance);
        VariationStep { part: part.expect("its systems are regular"), ms, distance }
    });
    Some(Varied { modes, steps: steps.collect() })
}

fn perform(task: Task) -> serde_json::Value {
    let value = match task {
        Task::Iterations { problem, loads, rounds, steps, edits } => {
            serde_json::to_value(iterations(&problem, loads, rounds, steps, edits))
        }
        Task::Convergence { problem, goal, limit, patience } => {
            serde_json::to_value(convergence(&problem, goal, limit, patience))
        }
        Task::Exact { problem, step } => serde_json::to_value(exact(&problem, step)),
        Task::Handles { problem, rounds } => serde_json::to_value(handles(&problem, rounds)),
        Task::Map { mesh, weights, rounds } => serde_json::to_value(map(&mesh, &weights, rounds)),
        Task::Parts { mesh, rounds } => serde_json::to_value(parts::parts(&mesh, rounds)),
        Task::Stream { bytes } => {
            let reads: Vec<f64> = bytes.into_iter().map(stream::milliseconds).collect();
            serde_json::to_value(reads)
        }
    };
    value.expect("results are plain data")
}

fn main() {
    let files: Vec<String> = std::env::args().skip(1).collect();
    let [task, result] = &files[..] else {
        eprintln!("bench_problems TASK.json RESULT.json, as `npm run bench` calls it");
        std::process::exit(2);
    };
    let text = std::fs::read_to_string(task).expect("the task was written");
    let task = serde_json::from_str(&text).expect("a task of this program");
    std::fs::write(result, perform(task).to_string()).expect("the result can be written");
}
