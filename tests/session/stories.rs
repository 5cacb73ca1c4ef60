//! Sequences of session calls in the order in which a user causes them.

use crate::session::asked::{new, scene};
use crate::support::drag;
use crate::support::grid::bumpy;
use serde_json::Map;
use shape_up::mesh::Mesh;
use shape_up::scene::{Accelerator, Hold, MeshSource, Scene, Weights};
use shape_up::session::{DragPhase, Edit, Session, check_targets};

pub(crate) const PLANES: &str = r#", "constraints": [{ "kind": "plane", "on": "faces" }]"#;

pub(crate) fn run(session: &mut Session, steps: usize) {
    session.begin_run();
    for _ in 0..steps {
        session.step().expect("positions stay finite");
    }
    session.end_run();
}

#[test]
fn a_part_that_nothing_holds_is_pinned_and_named() {
    // Two separate quads and an isolated vertex.
    let mut mesh = bumpy(1);
    let second: Vec<_> = mesh.positions.iter().map(|p| [p[0] + 5.0, p[1], p[2]]).collect();
    mesh.positions.extend(second);
    mesh.faces.push(&[4, 5, 7, 6]);
    mesh.positions.push([9.0, 9.0, 9.0]);
    let mut session = Session::open(scene(PLANES), mesh.clone()).expect("pins make it regular");
    assert_eq!(session.report().pinned, [0, 4, 8]);
    assert_eq!(session.report().unknowns, 6);
    run(&mut session, 5);
    for v in [0, 4, 8] {
        assert_eq!(session.positions()[v], mesh.positions[v], "a pinned vertex stays");
    }
    // A handle on the second quad replaces its pin.
    session.edit(Edit::AddHandles { vertices: vec![6], fixed: false }).expect("it is regular");
    assert_eq!(session.report().pinned, [0, 8]);
}

#[test]
fn what_only_constraints_without_weight_act_on_is_pinned() {
    // Constraints of weight 0 were counted as if they connected their vertices, and the system was
    // singular.
    let rows = r#", "constraints": [{ "kind": "plane", "on": "faces", "weight": 0 },
        { "kind": "sphere", "on": { "vertices": "0-35" }, "weight": 0 },
        { "kind": "plane", "on": { "vertices": "0-3" } }]"#;
    let mut session = Session::open(scene(rows), bumpy(5)).expect("pins make it regular");
    assert_eq!(session.report().pinned.len(), 1 + 32, "one of the four, and all others");
    run(&mut session, 3);
    assert_eq!(session.positions()[20], session.mesh().positions[20]);
}

#[test]
fn a_mesh_of_one_vertex_stays_where_it_is() {
    // The underlying factorisation panics below two unknowns.
    let mesh = Mesh { positions: vec![[1.0, 2.0, 3.0]], ..Mesh::default() };
    for handles in ["", r#", "handles": [{ "vertices": [0], "targets": [[4, 5, 6]] }]"#] {
        let mut session = Session::open(scene(handles), mesh.clone()).expect("it is regular");
        session.solve(false).expect("positions stay finite");
        let expected = if handles.is_empty() { [1.0, 2.0, 3.0] } else { [4.0, 5.0, 6.0] };
        for (found, expected) in session.positions()[0].iter().zip(expected) {
            assert!((found - expected).abs() < 1e-12, "{found} is not {expected}");
        }
    }
}

#[test]
fn a_fixed_handle_is_met_exactly_and_a_soft_one_by_its_weight() {
    let handles = r#", "handles": [{ "vertices": [0], "targets": [[0, 0, 1]], "fixed": true },
                                    { "vertices": [15], "targets": [[3, 3, 2]], "weight": 50 }]"#;
    let mut session =
        Session::open(scene(&format!("{PLANES}{handles}")), bumpy(3)).expect("it is regular");
    session.solve(false).expect("positions stay finite");
    assert_eq!(session.positions()[0], [0.0, 0.0, 1.0]);
    let energy = session.solver().energy();
    let soft = session.positions()[15];
    let away: f64 = soft.iter().zip([3.0, 3.0, 2.0]).map(|(a, b)| (a - b) * (a - b)).sum();
    assert!((energy.handles - 50.0 * away).abs() <= 1e-12, "{energy:?}");
    assert!((energy.total - energy.shape - energy.handles).abs() <= 1e-12, "{energy:?}");
}

#[test]
fn every_edit_is_undone_and_redone() {
    let mut session = Session::open(scene(PLANES), bumpy(4)).expect("it is regular");
    let start = (session.scene(), session.positions());
    let edits = [
        new("circle", "\"faces\""),
        Edit::SetConstraint {
            index: 1,
            weight: Some(2.0),
            require: None,
            enabled: None,
            params: Map::new(),
        },
        Edit::AddHandles { vertices: vec![0, 4], fixed: true },
        Edit::AddHandles { vertices: vec![24, 4], fixed: false },
        Edit::SetWeights(Weights { shape: 5.0, close: 1.0, smooth: 0.5 }.into()),
        Edit::SetConstraint {
            index: 0,
            weight: None,
            require: None,
            enabled: Some(false),
            params: Map::new(),
        },
        Edit::RemoveHandles { vertices: vec![0] },
        Edit::RemoveConstraint { index: 0 },
        Edit::Reset,
    ];
    let mut states = vec![start];
    for edit in edits {
        session.edit(edit).expect("the edit fits");
        run(&mut session, 2);
        states.push((session.scene(), session.positions()));
    }
    for state in states.iter().rev().skip(1) {
        assert_eq!(session.undo(), Ok(Some("Run, 2 iterations".to_owned())));
        assert!(session.undo().expect("undo works").is_some(), "the edit itself");
        assert_eq!((&session.scene(), &session.positions()), (&state.0, &state.1));
    }
    assert_eq!(session.undo(), Ok(None));
    for state in &states[1..] {
        assert!(session.redo().expect("redo works").is_some(), "the edit itself");
        assert_eq!(session.redo(), Ok(Some("Run, 2 iterations".to_owned())));
        assert_eq!((&session.scene(), &session.positions()), (&state.0, &state.1));
    }
    assert_eq!(session.redo(), Ok(None));
}

#[test]
fn a_drag_is_one_step_and_can_be_cancelled() {
    let handles = r#", "handles": [{ "vertices": [0, 20], "fixed": true }, { "vertices": [24] }]"#;
    let mut session =
        Session::open(scene(&format!("{PLANES}{handles}")), bumpy(4)).expect("it is regular");
    let before = session.positions();
    let drag_up = |session: &mut Session| {
        session.begin_drag();
        for k in 1..=5 {
            drag(session, [(24, [4.0, 4.0, 0.2 * f64::from(k)])]).expect("the targets are near");
            session.step().expect("positions stay finite");
        }
    };
    drag_up(&mut session);
    session.end_drag(false);
    assert_eq!(session.positions(), before, "a cancelled drag leaves nothing");
    assert_eq!(session.undo_and_redo(), [None, None]);

    drag_up(&mut session);
    session.end_drag(true);
    assert!(session.positions()[24][2] > 0.9, "the vertex follows: {:?}", session.positions()[24]);
    assert_eq!(session.undo(), Ok(Some("Move handle".to_owned())));
    assert_eq!(session.positions(), before);

    session.begin_drag();
    drag(&mut session, [(0, [0.0, 0.0, 0.5]), (20, [0.0, 4.0, 0.5])])
        .expect("the targets are near");
    assert!(session.is_dragging());
    session.end_drag(true);
    assert!(!session.is_dragging());
    assert_eq!(session.undo(), Ok(Some("Move 2 handles".to_owned())));

    // A drag that ends at its start is not a step of undo.
    session.begin_drag();
    session.end_drag(true);
    assert_eq!(session.undo_and_redo()[0], None);
}

#[test]
fn a_refused_edit_leaves_everything_as_it_was() {
    let mut session = Session::open(scene(PLANES), bumpy(2)).expect("it is regular");
    run(&mut session, 3);
    let before = (session.scene(), session.positions());
    let refused = [
        (new("sphere", r#"{ "set": "eaves" }"#), "eaves"),
        (new("circle", "\"tets\""), "no such element"),
        (Edit::RemoveConstraint { index: 7 }, "constraints[7]"),
        (Edit::AddHandles { vertices: vec![99], fixed: true }, "99"),
        (
            Edit::SetConstraint {
                index: 0,
                weight: Some(-1.0),
                require: None,
                enabled: None,
                params: Map::new(),
            },
            "weight",
        ),
        (
            Edit::SetWeights(Weights { shape: f64::NAN, close: 0.0, smooth: 0.0 }.into()),
            "weights.shape",
        ),
    ];
    for (edit, names) in refused {
        let error = session.edit(edit).expect_err("the edit does not fit").to_string();
        assert!(error.contains(names), "{error}");
        assert_eq!((&session.scene(), &session.positions()), (&before.0, &before.1));
        assert_eq!(session.undo_and_redo()[0], Some("Run, 3 iterations"));
    }
}

#[test]
fn a_scene_that_is_saved_opens_where_it_was() {
    let mut session = Session::open(scene(PLANES), bumpy(3)).expect("it is regular");
    session.edit(Edit::AddHandles { vertices: vec![0, 3], fixed: true }).expect("it fits");
    session.edit(new("sphere", r#"{ "vertices": "0-7" }"#)).expect("it fits");
    run(&mut session, 4);
    let mut saved = session.scene();
    saved.mesh = MeshSource::Inline(Box::new(session.mesh().clone()));
    let text = saved.to_json(session.mesh());
    let read = Scene::from_json(&text).expect("what is written can be read");
    let MeshSource::Inline(mesh) = read.mesh.clone() else { panic!("the mesh is inline") };
    let reopened = Session::open(read, *mesh).expect("it fits");
    assert_eq!(reopened.positions(), session.positions());
    assert_eq!(reopened.solver().handles(), session.solver().handles());
    let (found, expected) = (reopened.solver().energy().total, session.solver().energy().total);
    assert!((found - expected).abs() <= 1e-12 * expected, "{found} is not {expected}");
}

#[test]
fn far_from_the_origin_and_at_any_scale_the_answer_is_the_same() {
    let total = |accelerator: Accelerator, iterations: usize, scale: f64, offset: f64| {
        let mut mesh = bumpy(5);
        for coordinate in mesh.positions.as_flattened_mut() {
            *coordinate = *coordinate * scale + offset;
        }
        let extra = r#", "constraints": [{ "kind": "circle", "on": "faces" }],
                        "weights": { "shape": 5, "close": 10, "smooth": 2 }"#;
        let mut scene = scene(extra);
        scene.solver.accelerator = accelerator;
        let mut session = Session::open(scene, mesh).expect("it is regular");
        run(&mut session, iterations);
        session.solver().energy().total / (scale * scale)
    };
    // Accelerated steps use single precision: before the minimum their totals differ by its
    // rounding.
    for (accelerator, iterations, tolerance) in
        [(Accelerator::None, 30, 1e-7), (Accelerator::QuasiNewton, 20, 1e-5)]
    {
        let expected = total(accelerator, iterations, 1.0, 0.0);
        for (scale, offset) in [(1e-3, 0.0), (1e3, 0.0), (1.0, 4096.0), (1.0, 1e6)] {
            let found = total(accelerator, iterations, scale, offset);
            assert!(
                (found - expected).abs() <= tolerance * expected,
                "{accelerator:?}, {scale}, {offset}: {found} is not {expected}"
            );
        }
    }
}

#[test]
fn a_big_set_has_the_same_minimiser_with_its_extra_unknown() {
    // 36 vertices need an extra unknown for their mean, 30 do not; one plain iteration solves the
    // same dense problem either way, so the energy cannot rise in either.
    for last in [29, 35] {
        let extra = format!(
            r#", "constraints": [{{ "kind": "sphere", "on": {{ "vertices": "0-{last}" }} }}],
               "weights": {{ "shape": 1, "smooth": 0.01 }}, "solver": {{ "accelerator": "none", "monotone": true }}"#
        );
        let mut session = Session::open(scene(&extra), bumpy(6)).expect("it is regular");
        let mut before = session.solver().energy().total;
        let first = before;
        for _ in 0..50 {
            session.step().expect("positions stay finite");
            let now = session.solver().energy().total;
            assert!(now <= before * (1.0 + 1e-12), "0-{last}: {before} rises to {now}");
            before = now;
        }
        assert!(before < 0.9 * first, "0-{last}: {first} falls to {before}");
    }
}

#[test]
fn accelerators_reach_the_plain_minimum_in_fewer_iterations() {
    let handles = r#", "handles": [{ "vertices": [0, 8, 72], "fixed": true },
                                    { "vertices": [80], "targets": [[8, 8, 3]] }],
                      "weights": { "shape": 1, "smooth": 0.001 },
                      "constraints": [{ "kind": "plane", "on": "faces" }]"#;
    let iterations = |accelerator, until: Option<f64>| {
        let mut scene = scene(handles);
        scene.solver.accelerator = accelerator;
        scene.solver.tolerance = 0.0;
        let mut session = Session::open(scene, bumpy(8)).expect("it is regular");
        for k in 0..3000 {
            let total = session.solver().energy().total;
            if until.is_some_and(|until| total <= until) {
                return (k, total);
            }
            session.step().expect("positions stay finite");
        }
        (3000, session.solver().energy().total)
    };
    let (_, lowest) = iterations(Accelerator::None, None);
    let until = Some(lowest * 1.001);
    let (plain, _) = iterations(Accelerator::None, until);
    for accelerator in [Accelerator::QuasiNewton, Accelerator::Anderson] {
        let (accelerated, _) = iterations(accelerator, until);
        assert!(accelerated * 2 < plain, "{accelerator:?}: {accelerated} against {plain}");
    }
}

#[test]
fn a_handle_group_is_written_as_it_holds() {
    let handles =
        r#", "handles": [{ "vertices": [0, 1], "fixed": true }, { "vertices": [2], "weight": 7 }]"#;
    let session = Session::open(scene(handles), bumpy(2)).expect("it is regular");
    let specs = session.scene().handles;
    assert_eq!(specs.len(), 2);
    assert_eq!((specs[0].vertices.as_slice(), specs[0].hold), (&[0, 1][..], Hold::Fixed));
    assert_eq!(
        (specs[1].vertices.as_slice(), specs[1].hold),
        (&[2][..], Hold::Soft { weight: 7.0 })
    );
}

#[test]
fn a_target_that_a_scene_could_not_have_is_refused_and_nothing_moves() {
    // A fixed vertex became NaN, and the error named another vertex.
    let handles = r#", "handles": [{ "vertices": [3, 20], "fixed": true }, { "vertices": [24] }]"#;
    let mut session =
        Session::open(scene(&format!("{PLANES}{handles}")), bumpy(4)).expect("it is regular");
    session.begin_drag();
    drag(&mut session, [(24, [4.0, 4.0, 0.5])]).expect("the target is near");
    let before = (session.scene(), session.positions());
    for wrong in [f64::NAN, f64::INFINITY, -1e51] {
        let targets = [(24, [4.0, 4.0, 0.1]), (20, [0.0, wrong, 0.0])];
        let error = drag(&mut session, targets).expect_err("it is no place").to_string();
        assert!(error.contains("the target of vertex 20 is not finite or too far out"), "{error}");
        assert_eq!((session.scene(), session.positions()), before);
    }
    session.end_drag(true);
    let again = Session::open(session.scene(), bumpy(4)).map(|_| ());
    assert_eq!(again, Ok(()), "what was dragged can be opened");
    let error = check_targets(&[1, 2], &[[0.0; 3]]).expect_err("one is missing").to_string();
    assert!(error.contains("found 1 targets, expected one for each of the 2 vertices"), "{error}");
}

#[test]
fn handles_are_found_by_their_vertex() {
    // A linear search per handle took 3.0 s for fixing 100,000 vertices and 5.4 s for moving them.
    let mut session = Session::open(scene(PLANES), bumpy(200)).expect("it is regular");
    let all: Vec<u32> = (0..201 * 201).collect();
    let timed = |session: &mut Session, what: &mut dyn FnMut(&mut Session)| {
        let started = std::time::Instant::now();
        what(session);
        started.elapsed().as_secs_f64()
    };
    let step = timed(&mut session, &mut |session| {
        (0..3).for_each(|_| _ = session.step().expect("positions stay finite"));
    });
    let fix = |fixed| Edit::AddHandles { vertices: all.clone(), fixed };
    for edit in [fix(true), fix(false), Edit::RemoveHandles { vertices: all.clone() }, fix(true)] {
        let words = format!("{edit:?}").chars().take(30).collect::<String>();
        let time = timed(&mut session, &mut |session| {
            session.edit(edit.clone()).expect("every vertex is there");
        });
        // The linear search took as long as hundreds of steps; a new factor takes as long as a few.
        assert!(time < 30.0 * step, "{words}: {time} s, where three steps take {step} s");
    }
    let targets: Vec<(u32, [f64; 3])> =
        (0..).zip(session.positions()).map(|(v, [x, y, z])| (v, [x, y, z + 1.0])).collect();
    let time = timed(&mut session, &mut |session| {
        session.begin_drag();
        drag(session, targets.iter().copied()).expect("the targets are near");
        session.end_drag(true);
    });
    assert!(time < 10.0 * step, "moving all: {time} s, where three steps take {step} s");
    let time = timed(&mut session, &mut |session| drop(session.undo().expect("it was solvable")));
    assert!(time < 10.0 * step, "undo: {time} s, where three steps take {step} s");
}

#[test]
fn a_drag_goes_through_its_phases_and_bad_targets_move_nothing() {
    let mut session = Session::open(scene(PLANES), bumpy(2)).expect("it is regular");
    let target = |session: &Session| session.solver().handles().last().map(|handle| handle.target);
    let (vertex, up) = ([0], |z| [[0.0, 0.0, z]]);
    session.drag_through(DragPhase::Move, &vertex, &up(9.0)).expect("nobody drags: no error");
    assert_eq!(session.solver().handles().len(), 0);
    session.drag_through(DragPhase::Make, &vertex, &up(1.0)).expect("the vertex is there");
    assert_eq!(target(&session), Some([0.0, 0.0, 1.0]));
    session.drag_through(DragPhase::Move, &vertex, &up(f64::NAN)).expect_err("no place");
    session.drag_through(DragPhase::End, &vertex, &[]).expect("it may end where it is");
    assert_eq!(target(&session), Some([0.0, 0.0, 1.0]));
    assert_eq!(session.undo_and_redo()[0], Some("Make and move handle"));
    session.drag_through(DragPhase::Start, &vertex, &up(2.0)).expect("it is a handle");
    session.drag_through(DragPhase::End, &vertex, &up(f64::NAN)).expect_err("no place");
    assert_eq!(target(&session), Some([0.0, 0.0, 2.0]), "the move before is kept");
    assert!(!session.is_dragging());
    session.drag_through(DragPhase::Start, &vertex, &up(3.0)).expect("it is a handle");
    session.drag_through(DragPhase::Cancel, &vertex, &[]).expect("it is dragged");
    assert_eq!(target(&session), Some([0.0, 0.0, 2.0]));
}
