//! The two halves of an iteration, and the measures of the shape that it started from.

use crate::support::grid::bumpy;
use shape_up::generate::example::EXAMPLES;
use shape_up::mesh::Point;
use shape_up::scene::Scene;
use shape_up::session::{Edit, FACE_MEASURES, FittedCount, HalfStep, Session, Shape};

/// Squares on the faces of a bumpy grid, with a scene's `rest`.
fn squares(rest: &str) -> Session {
    let text = format!(
        r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "grid.obj" }},
            "constraints": [{{ "kind": "square", "on": "faces" }},
                            {{ "kind": "line", "on": {{ "each": "boundary" }}, "enabled": false }}]{rest} }}"#
    );
    let scene = Scene::from_json(&text).expect("the scene is valid");
    Session::open(scene, bumpy(4)).expect("it can be solved")
}

/// One whole iteration: the local half, then the global half.
fn whole(session: &mut Session) -> HalfStep {
    let local = session.half_step().expect("nothing moves");
    assert!(matches!(local, HalfStep::Local { .. }));
    // Reading the projections changes nothing.
    session.projections();
    session.half_step().expect("positions stay finite")
}

fn step(session: &mut Session) {
    session.begin_run();
    session.step().expect("positions stay finite");
    session.end_run();
}

#[test]
fn two_halves_are_one_step_to_the_last_bit() {
    for rest in [
        "",
        r#", "solver": { "accelerator": "none" }"#,
        r#", "solver": { "accelerator": "anderson" }"#,
        r#", "solver": { "monotone": true }"#,
    ] {
        let (mut halves, mut steps) = (squares(rest), squares(rest));
        for _ in 0..6 {
            whole(&mut halves);
            step(&mut steps);
            assert_eq!(halves.positions(), steps.positions(), "{rest}");
            assert_eq!(halves.iteration(), steps.iteration());
        }
    }
}

#[test]
fn two_halves_are_one_step_on_every_example() {
    for example in EXAMPLES {
        let open = || {
            let (scene, mesh) = example.build();
            Session::open(scene, mesh).expect("it can be solved")
        };
        let (mut halves, mut steps) = (open(), open());
        // The second iteration may be accelerated.
        for _ in 0..2 {
            whole(&mut halves);
            step(&mut steps);
        }
        assert!(halves.positions() == steps.positions(), "{}", example.id);
    }
}

#[test]
fn the_local_step_tells_what_is_fitted_and_moves_nothing() {
    let mut session = squares("");
    let before = session.positions();
    let local = session.half_step().expect("nothing moves");
    assert_eq!(local, HalfStep::Local { fitted: vec![FittedCount { label: "Square", count: 16 }] });
    assert!(session.halfway());
    assert_eq!(session.positions(), before);
    assert_eq!(session.undo_and_redo(), [None, None], "there is nothing to take back");

    let global = session.half_step().expect("positions stay finite");
    assert_eq!(global, HalfStep::Global { converged: false, accelerated: false });
    assert_ne!(session.positions(), before);
    assert_eq!(session.undo_and_redo()[0], Some("Run, 1 iteration"));
    // The accelerator has a history now and accelerates the second iteration.
    let HalfStep::Global { accelerated, .. } = whole(&mut session) else {
        panic!("it is the second")
    };
    assert!(accelerated);
    let mut plain = squares(r#", "solver": { "accelerator": "none" }"#);
    whole(&mut plain);
    assert_eq!(whole(&mut plain), HalfStep::Global { converged: false, accelerated: false });
}

/// Without acceleration, closeness and smoothness, the global step places every vertex at the mean
/// of its projected points, up to the translation of each square.
#[test]
fn the_global_step_is_the_least_squares_answer() {
    let mut session =
        squares(r#", "weights": { "shape": 1, "close": 0 }, "solver": { "accelerator": "none" }"#);
    session.half_step().expect("nothing moves");
    let found = session.projections();
    let before = session.positions();
    let moved: Vec<Point> = (0..)
        .zip(&found.vertices)
        .map(|(k, &v): (usize, _)| add(before[v as usize], found.displacements[k]))
        .collect();
    session.half_step().expect("positions stay finite");
    // The sum of `|N (V - P)|^2` over the squares, whose four points are consecutive.
    let misfit = |positions: &[Point]| -> f64 {
        let apart = (0..).zip(&found.vertices).map(|(k, &v): (usize, _)| {
            let (p, q) = (positions[v as usize], moved[k]);
            [p[0] - q[0], p[1] - q[1], p[2] - q[2]]
        });
        let apart: Vec<Point> = apart.collect();
        apart.chunks_exact(4).map(spread).sum()
    };
    let now = session.positions();
    let least = misfit(&now);
    assert!(least < misfit(&before));
    for vertex in [1, 7, 12, 18] {
        for axis in 0..3 {
            for way in [-1e-3, 1e-3] {
                let mut other = now.clone();
                other[vertex][axis] += way;
                assert!(misfit(&other) > least, "vertex {vertex} could do better");
            }
        }
    }
}

/// Both rows were said to be satisfied.
#[test]
fn after_a_run_that_failed_the_global_step_is_held_without_what_is_required() {
    let text = r#"{ "format": "shape-up-scene", "version": 1, "mesh": { "file": "grid.obj" },
        "constraints": [
            { "kind": "line-segment", "on": { "vertices": [0, 1] }, "length": 1, "require": "exact" },
            { "kind": "line-segment", "on": { "vertices": [0, 1] }, "length": 1.2, "require": "exact" }] }"#;
    let scene = Scene::from_json(text).expect("the scene is valid");
    let mut session = Session::open(scene, bumpy(4)).expect("it can be solved");
    session.solve(false).expect("positions stay finite");
    assert_eq!(whole(&mut session), HalfStep::Held { met: false });
}

fn add(a: Point, b: Point) -> Point {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// Sum of squared distances from the mean.
fn spread(points: &[Point]) -> f64 {
    let mean = points.iter().copied().fold([0.0; 3], add).map(|sum| sum / points.len() as f64);
    points.iter().flatten().zip(mean.iter().cycle()).map(|(x, m)| (x - m) * (x - m)).sum()
}

#[test]
fn whatever_changes_the_shape_or_the_scene_ends_the_half_step() {
    type Change = fn(&mut Session);
    let changes: [(&str, Change); 5] = [
        ("a step", step),
        ("a drag", |session| session.begin_drag()),
        ("an edit", |session| {
            session.edit(Edit::Reset).expect("it can be solved");
        }),
        ("undo", |session| drop(session.undo().expect("it can be solved"))),
        ("a run", |session| session.begin_run()),
    ];
    for (what, change) in changes {
        let mut session = squares("");
        step(&mut session);
        session.half_step().expect("nothing moves");
        change(&mut session);
        assert!(!session.halfway(), "{what}");
        assert!(matches!(session.half_step(), Ok(HalfStep::Local { .. })), "{what}");
    }
}

#[test]
fn the_original_keeps_its_measures_while_the_shape_changes() {
    let mut session = squares("");
    let values = |session: &mut Session, shape: &Shape| -> Vec<Vec<f64>> {
        let ids = FACE_MEASURES.iter().map(|measure| measure.id);
        ids.map(|id| session.face_values_of(id, shape).expect("it is declared")).collect()
    };
    let before = values(&mut session, &Shape::Now);
    let angles = session.angles(&Shape::Now);
    assert_eq!(angles.iter().sum::<u32>(), 64);
    for _ in 0..30 {
        step(&mut session);
    }
    let original = values(&mut session, &Shape::Original);
    for (measure, (before, original)) in FACE_MEASURES.iter().zip(before.iter().zip(&original)) {
        for (a, b) in before.iter().zip(original) {
            let same = (a.is_nan() && b.is_nan()) || (a - b).abs() <= 1e-12 * (1.0 + a.abs());
            assert!(same, "{}: {a} and {b}", measure.id);
        }
    }
    assert_ne!(values(&mut session, &Shape::Now), original);
    assert_eq!(session.angles(&Shape::Original), angles);
    // Squares have right angles: more corners come near 90 degrees.
    let right = |angles: &[u32]| angles[17] + angles[18];
    assert!(right(&session.angles(&Shape::Now)) > right(&angles));
}

#[test]
fn asking_for_the_original_does_not_disturb_the_iteration() {
    let (mut asked, mut left_alone) =
        [(); 2].map(|()| squares(r#", "solver": { "monotone": true }"#)).into();
    for _ in 0..4 {
        step(&mut asked);
        step(&mut left_alone);
        for measure in FACE_MEASURES {
            asked.face_values_of(measure.id, &Shape::Original);
        }
    }
    assert_eq!(asked.positions(), left_alone.positions());
}

#[test]
fn the_table_of_angles_counts_every_corner_before_and_after() {
    let mut session = squares("");
    step(&mut session);
    let text = session.angles_csv();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("from (°),to (°),original,now"));
    let rows: Vec<Vec<u32>> = lines
        .map(|line| line.split(',').map(|cell| cell.parse().expect("a whole number")).collect())
        .collect();
    assert_eq!(rows.len(), 36);
    assert_eq!((rows[35][0], rows[35][1]), (175, 180));
    let sum = |column: usize| rows.iter().map(|row| row[column]).sum::<u32>();
    assert_eq!((sum(2), sum(3)), (64, 64));
}
