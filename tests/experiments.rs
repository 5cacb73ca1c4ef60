//! The paper's comparisons (Fig. 10 and 11): properties of the methods, and the claims of the
//! figures.

use crate::support::random::Random;
use shape_up::experiment::{COMPARISON, EXPERIMENTS, EndedBy, Experiment, Limits, Run, Series};
use shape_up::generate::example::EXAMPLES;
use shape_up::math::Vec3;
use shape_up::mesh::Point;
use shape_up::scene::{ClosenessTo, Hold, Weights};
use shape_up::session::Session;

/// Runs the experiment of an example to its end; returns the series with the ids of their methods.
fn run(example: &str, limits: impl Fn(Limits) -> Limits) -> Vec<(&'static str, Series)> {
    let experiment = Experiment::of(example).expect("it has one");
    let (scene, mesh) = EXAMPLES.iter().find(|e| e.id == example).expect("there is one").build();
    let run = Run::of(experiment, scene, &mesh, limits(experiment.limits))
        .expect("positions stay finite");
    let ids = experiment.methods.iter().map(|method| method.id);
    ids.zip(run.series().to_vec()).collect()
}

fn of<'a>(all: &'a [(&str, Series)], id: &str) -> &'a Series {
    &all.iter().find(|(method, _)| *method == id).expect("it was run").1
}

fn without_clock(limits: Limits) -> Limits {
    Limits { seconds: f64::INFINITY, ..limits }
}

#[test]
fn every_experiment_has_examples_and_every_example_at_most_one() {
    for experiment in EXPERIMENTS {
        assert!(!experiment.examples.is_empty(), "{}", experiment.id);
        for id in experiment.examples {
            assert!(EXAMPLES.iter().any(|example| example.id == *id), "{id}");
            assert_eq!(Experiment::of(id).map(|of| of.id), Some(experiment.id));
        }
        for plot in experiment.plots {
            assert!(plot.quantity < experiment.quantities.len(), "{}", experiment.id);
        }
    }
    assert!(Experiment::of("canopy").is_none());
}

/// Fig. 10: energy of each method after the same number of iterations, and after the time of the
/// paper's method.
#[test]
fn mean_centring_beats_all_but_the_accelerated_solver() {
    const ITERATIONS: u32 = 150;
    let all = run("fig-10-collapse", |_| Limits { iterations: ITERATIONS, seconds: f64::INFINITY });
    let start = all[0].1.samples[0].values[0];
    for (method, series) in &all {
        let first = &series.samples[0];
        assert!((first.values[0] - start).abs() < 1e-9 * start, "{method}: the same start");
        for (k, pair) in series.samples.windows(2).enumerate() {
            let [before, after] = [&pair[0], &pair[1]];
            assert!(after.values[0] <= before.values[0] * (1.0 + 1e-12), "{method}: rises in {k}");
            assert!(after.seconds >= before.seconds, "{method}");
        }
    }
    let last = |id: &str| {
        let series = of(&all, id);
        series.samples.last().expect("it has samples").values[0] / start
    };
    assert!(last("centred") < 1e-4, "{}", last("centred"));
    for slow in ["not-centred", "gradient-descent", "l-bfgs"] {
        assert!(last(slow) > 1e-2, "{slow}: {}", last(slow));
    }
    assert!(last("l-bfgs") < 0.8 * last("gradient-descent"));
    assert_eq!(of(&all, "accelerated").ended_by, EndedBy::Reached);
    assert_eq!(of(&all, "l-bfgs").ended_by, EndedBy::Iterations);
    // After the time of the slow methods, the centred one is far below all of them.
    for slow in ["not-centred", "gradient-descent", "l-bfgs"] {
        let given = of(&all, slow).samples.last().expect("it has samples").seconds;
        let centred = of(&all, "centred").samples.iter().take_while(|s| s.seconds <= given).last();
        let centred = centred.expect("setting up is quicker than that").values[0] / start;
        assert!(centred < 0.2 * last(slow), "{slow} in {given} s: {} and {centred}", last(slow));
    }
}

/// Every scene can be compared; a matrix over all coordinates is used if it fits in memory.
#[test]
fn whatever_is_open_can_be_compared_with_bfgs_where_it_fits() {
    let compared = |example: &str, iterations| {
        let (scene, mesh) =
            EXAMPLES.iter().find(|e| e.id == example).expect("there is one").build();
        let limits = Limits { iterations, seconds: f64::INFINITY };
        let run = Run::of(&COMPARISON, scene, &mesh, limits).expect("positions stay finite");
        let ids = COMPARISON.methods.iter().map(|method| method.id);
        ids.zip(run.series().to_vec()).collect::<Vec<_>>()
    };
    let all = compared("hypar", 200);
    let last = |id: &str| of(&all, id).samples.last().expect("it has samples").values[0];
    for (method, series) in &all {
        println!("{method}: {} {:?} {:e}", series.samples.len(), series.ended_by, last(method));
        for pair in series.samples.windows(2) {
            assert!(pair[1].values[0] <= pair[0].values[0] * (1.0 + 1e-12), "{method} rises");
        }
    }
    let lowest = all.iter().map(|(id, _)| last(id)).fold(f64::INFINITY, f64::min);
    assert!(last("bfgs") <= lowest * (1.0 + 1e-6), "{} and {lowest}", last("bfgs"));
    assert!(last("bfgs") < last("gradient-descent"));

    let large = compared("fig-05-planar", 1);
    let bfgs = of(&large, "bfgs");
    assert_eq!((bfgs.samples.len(), bfgs.ended_by), (0, EndedBy::TooLarge));
    assert_eq!(of(&large, "l-bfgs").ended_by, EndedBy::Iterations);
}

/// The length of the shortest edge of an example at its start.
fn shortest_edge_of(example: &str) -> f64 {
    let (scene, mesh) = EXAMPLES.iter().find(|e| e.id == example).expect("there is one").build();
    let session = Session::open(scene, mesh).expect("it fits");
    let at = |v: u32| Vec3::from(session.positions()[v as usize]);
    let lengths = session.topology().edges().iter().map(|&[a, b]| (at(b) - at(a)).length());
    lengths.fold(f64::INFINITY, f64::min)
}

/// Fig. 11: at the same circularity error Shape-Up is smoother, and lets edges shrink further.
#[test]
fn fitted_circles_are_smoother_than_penalised_angles_at_the_same_error() {
    let all = run("fig-11-strip", without_clock);
    let [fitted, penalised] = ["shape-up", "gauss-newton"].map(|id| {
        let series = of(&all, id);
        assert_eq!(series.ended_by, EndedBy::Reached, "{id}");
        let last = &series.samples.last().expect("it has samples").values;
        println!("{id}: {} iterations, {last:?}", series.samples.len() - 1);
        [last[0], last[1], last[2]]
    });
    let start = &all[0].1.samples[0].values;
    for (a, b) in start.iter().zip(&all[1].1.samples[0].values) {
        assert!((a - b).abs() <= 1e-12 * a, "the same start: {a} and {b}");
    }
    assert!((start[2] / shortest_edge_of("fig-11-strip") - 1.0).abs() < 1e-12, "{start:?}");
    assert!((fitted[1] / penalised[1] - 1.0).abs() < 0.1, "{fitted:?} {penalised:?}");
    assert!(fitted[0] < 0.93 * penalised[0], "{fitted:?} {penalised:?}");
    assert!(fitted[2] < 0.05 * start[2], "{fitted:?} of {start:?}");
    assert!(penalised[2] > 5.0 * fitted[2], "{fitted:?} {penalised:?}");
}

/// If closeness keeps edges from collapsing, angle sums and fitted circles have the same solution.
#[test]
fn both_find_the_same_shape_where_no_edge_collapses() {
    let experiment = Experiment::of("fig-11-strip").expect("it has one");
    let (mut scene, mesh) =
        EXAMPLES.iter().find(|e| e.id == "fig-11-strip").expect("there is one").build();
    scene.handles.clear();
    scene.closeness.to = ClosenessTo::Rest;
    scene.weights = Weights { shape: 2000.0, close: 1.0, smooth: 1.0 };
    let run = Run::of(experiment, scene, &mesh, without_clock(experiment.limits))
        .expect("positions stay finite");
    let [fitted, penalised] = [0, 1].map(|k| {
        let series = &run.series()[k];
        println!("{:?} after {}", series.ended_by, series.samples.len());
        series.samples.last().expect("it has samples").values.clone()
    });
    for (a, b) in fitted.iter().zip(&penalised) {
        assert!((a - b).abs() < 0.05 * b, "{fitted:?} {penalised:?}");
    }
    assert!(fitted[2] > 0.5 * run.series()[0].samples[0].values[2], "{fitted:?}");
}

#[test]
fn limits_end_a_method_and_the_next_one_starts() {
    let all = run("fig-10-collapse", |_| Limits { iterations: 2, seconds: f64::INFINITY });
    for (method, series) in &all {
        assert_eq!(series.samples.len(), 3, "{method}");
        assert_eq!(series.ended_by, EndedBy::Iterations, "{method}");
    }
    let none = run("fig-10-collapse", |limits| Limits { seconds: 0.0, ..limits });
    assert!(none.iter().all(|(_, series)| series.ended_by == EndedBy::Seconds));
}

#[test]
fn every_line_of_the_table_has_every_column() {
    let experiment = Experiment::of("fig-11-strip").expect("it has one");
    let (scene, mesh) =
        EXAMPLES.iter().find(|e| e.id == "fig-11-strip").expect("there is one").build();
    let run = Run::of(experiment, scene, &mesh, Limits { iterations: 2, seconds: 10.0 })
        .expect("positions stay finite");
    let csv = run.csv();
    let lines: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(lines[0], ["method", "iteration", "seconds", "smooth", "e_c", "shortest"]);
    assert_eq!(lines.len(), 1 + 2 * 3);
    for line in &lines[1..] {
        assert_eq!(line.len(), lines[0].len());
        assert!(line[1..].iter().all(|cell| cell.parse::<f64>().is_ok()), "{line:?}");
    }
}

#[test]
fn a_scene_that_the_penalty_method_cannot_have_is_refused() {
    let experiment = Experiment::of("fig-11-strip").expect("it has one");
    let (mut scene, mesh) =
        EXAMPLES.iter().find(|e| e.id == "fig-11-strip").expect("there is one").build();
    scene.handles[0].hold = Hold::Soft { weight: 1.0 };
    let run = Run::of(experiment, scene, &mesh, Limits { iterations: 0, seconds: 10.0 });
    let error = run.err().expect("it should be refused").to_string();
    assert!(error.contains("handles[0]") && error.contains("expected \"fixed\": true"), "{error}");
}

/// The gradient of Appendix A against central differences of the total.
#[test]
fn the_gradient_is_that_of_the_energy() {
    let (scene, mesh) =
        EXAMPLES.iter().find(|e| e.id == "fig-11-strip").expect("there is one").build();
    let mut scene = scene;
    scene.constraints[0].kind =
        shape_up::constraint::Kind::new("plane", serde_json::json!({})).expect("it is a kind");
    let mut solver = Session::open(scene, mesh.clone()).expect("it fits").into_solver();
    let mut random = Random::new(7);
    let at: Vec<Point> =
        mesh.positions.iter().map(|p| p.map(|x| x + 0.025 * random.uniform())).collect();
    solver.set_positions(&at);
    let at: Vec<Point> = solver.positions().collect();
    let gradient: Vec<Point> = solver.gradient().collect();
    let largest = gradient.as_flattened().iter().fold(0.0, |a: f64, b| a.max(b.abs()));
    let fixed: Vec<u32> = solver.handles().iter().map(|handle| handle.vertex).collect();
    for v in (0..at.len()).step_by(7) {
        for k in 0..3 {
            if fixed.contains(&(v as u32)) {
                assert_eq!(gradient[v][k], 0.0);
                continue;
            }
            const STEP: f64 = 1e-5;
            let mut total = |step: f64| {
                let mut moved = at.clone();
                moved[v][k] += step;
                solver.set_positions(&moved);
                solver.energy().total
            };
            let difference = (total(STEP) - total(-STEP)) / (2.0 * STEP);
            let error = (difference - gradient[v][k]).abs();
            assert!(error < 1e-6 * largest, "{v}, {k}: {difference} and {}", gradient[v][k]);
        }
    }
}
