//! Stories of a session: what hosts do with it, in the order in which people do it.

#[path = "support/grid.rs"]
mod grid;

use grid::grid;
use shape_up::mesh::Mesh;
use shape_up::scene::{Accelerator, Hold, MeshSource, Scene, Weights};
use shape_up::session::{Edit, NewConstraint, Session};

/// A bumpy grid of `n` by `n` quads, a unit apart.
fn bumpy(n: u32) -> Mesh {
    grid(n, n, |i, j| {
        let bump = f64::from((i * 5 + j * 7) % 4) / 8.0;
        [f64::from(i), f64::from(j), bump]
    })
}

fn scene(rest: &str) -> Scene {
    let text = format!(
        r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "grid.obj" }}{rest} }}"#
    );
    Scene::from_json(&text).expect("the scene is valid")
}

fn new(kind: &str, on: &str) -> Edit {
    let text = format!(r#"{{ "kind": "{kind}", "on": {on} }}"#);
    let spec = shape_up::scene::ConstraintSpec::from_json(&text).expect("the constraint is valid");
    Edit::AddConstraint(NewConstraint { spec, set: None })
}

const PLANES: &str = r#", "constraints": [{ "kind": "plane", "on": "faces" }]"#;

fn run(session: &mut Session, steps: usize) {
    session.begin_run();
    for _ in 0..steps {
        session.step().expect("positions stay finite");
    }
    session.end_run();
}

#[test]
fn a_part_that_nothing_holds_is_pinned_and_named() {
    // Two separate quads, and a vertex of nothing.
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
    // A handle on the second quad takes the place of its pin.
    session.edit(Edit::AddHandles { vertices: vec![6], fixed: false }).expect("it is regular");
    assert_eq!(session.report().pinned, [0, 8]);
}

#[test]
fn a_mesh_of_one_vertex_stays_where_it_is() {
    // The factorisation underneath panics below two unknowns.
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
        Edit::SetConstraint { index: 1, weight: Some(2.0), enabled: None },
        Edit::AddHandles { vertices: vec![0, 4], fixed: true },
        Edit::AddHandles { vertices: vec![24, 4], fixed: false },
        Edit::SetWeights(Weights { shape: 5.0, close: 1.0, smooth: 0.5 }),
        Edit::SetConstraint { index: 0, weight: None, enabled: Some(false) },
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
    let drag = |session: &mut Session| {
        session.begin_drag();
        for k in 1..=5 {
            session.drag([(24, [4.0, 4.0, 0.2 * f64::from(k)])]);
            session.step().expect("positions stay finite");
        }
    };
    drag(&mut session);
    session.end_drag(false);
    assert_eq!(session.positions(), before, "a cancelled drag leaves nothing");
    assert_eq!(session.undo_and_redo(), [None, None]);

    drag(&mut session);
    session.end_drag(true);
    assert!(session.positions()[24][2] > 0.9, "the vertex follows: {:?}", session.positions()[24]);
    assert_eq!(session.undo(), Ok(Some("Move handle".to_owned())));
    assert_eq!(session.positions(), before);

    // A drag that ends where it began is no step.
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
        (Edit::SetConstraint { index: 0, weight: Some(-1.0), enabled: None }, "weight"),
        (Edit::SetWeights(Weights { shape: f64::NAN, close: 0.0, smooth: 0.0 }), "weights.shape"),
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
    let total = |scale: f64, offset: f64| {
        let mut mesh = bumpy(5);
        for coordinate in mesh.positions.as_flattened_mut() {
            *coordinate = *coordinate * scale + offset;
        }
        let extra = r#", "constraints": [{ "kind": "circle", "on": "faces" }],
                        "weights": { "shape": 5, "close": 10, "smooth": 2 }"#;
        let mut session = Session::open(scene(extra), mesh).expect("it is regular");
        run(&mut session, 30);
        session.solver().energy().total / (scale * scale)
    };
    let expected = total(1.0, 0.0);
    for (scale, offset) in [(1e-3, 0.0), (1e3, 0.0), (1.0, 4096.0), (1.0, 1e6)] {
        let found = total(scale, offset);
        assert!((found - expected).abs() <= 1e-7 * expected, "{scale}, {offset}: {found}");
    }
}

#[test]
fn a_big_set_has_the_same_minimiser_with_its_extra_unknown() {
    // 36 vertices take an extra unknown for their mean, 30 do not; one step of the plain iteration
    // solves the same dense problem either way, so that the energy of neither can rise.
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

/// Squared lengths of the edges and diagonals of the faces.
fn lengths(mesh: &Mesh, positions: &[[f64; 3]]) -> Vec<f64> {
    let mut lengths = Vec::new();
    for face in mesh.faces.iter() {
        for (k, &a) in face.iter().enumerate() {
            for &b in &face[k + 1..] {
                let (a, b) = (positions[a as usize], positions[b as usize]);
                lengths.push((0..3).map(|i| (a[i] - b[i]) * (a[i] - b[i])).sum::<f64>().sqrt());
            }
        }
    }
    lengths
}

/// A strip of four panels, hinged at its cross edges, is carried off and folded by its last two
/// vertices.
const FOLD: &str = r#", "constraints": [{ "kind": "rigid", "on": "faces" }],
    "handles": [{ "vertices": [0, 5], "fixed": true },
                { "vertices": [4, 9], "targets": [[2.5, 0, 0.5], [2.5, 1, 0.5]], "weight": 1 }]"#;

fn strip() -> Mesh {
    grid(4, 1, |i, j| [f64::from(i), f64::from(j), f64::from(i % 2) / 4.0])
}

#[test]
fn rigid_faces_keep_their_lengths_while_handles_move() {
    let mesh = strip();
    let mut scene = scene(FOLD);
    scene.solver.iterations = 2000;
    scene.solver.tolerance = 0.0;
    let mut session = Session::open(scene, mesh.clone()).expect("it is regular");
    session.solve(false).expect("positions stay finite");
    let moved = session.positions()[4][0];
    assert!((moved - 4.0).abs() > 1.0, "the handle has moved: {moved}");
    let rest = lengths(&mesh, &mesh.positions);
    for (found, rest) in lengths(&mesh, &session.positions()).iter().zip(rest) {
        assert!((found / rest - 1.0).abs() <= 1e-6, "{rest} has become {found}");
    }
}

#[test]
fn relative_shapes_never_raise_the_energy_of_the_plain_iteration() {
    for (id, limits) in [("rigid", ""), ("similar", ""), ("similar", r#", "scale": [0.9, 1.1]"#)] {
        let constraints = format!(
            r#", "constraints": [{{ "kind": "{id}", "on": "faces"{limits} }},
            {{ "kind": "{id}", "on": {{ "each": "ring", "radius": 1 }} }}],
            "handles": [{{ "vertices": [0, 1, 5, 6], "fixed": true }},
                        {{ "vertices": [24], "targets": [[1, 1, 5]] }}]"#
        );
        let mut scene = scene(&constraints);
        scene.solver.accelerator = Accelerator::None;
        let mut session = Session::open(scene, bumpy(4)).expect("it is regular");
        let mut before = f64::INFINITY;
        session.begin_run();
        for step in 0..200 {
            session.step().expect("positions stay finite");
            let total = session.solver().energy().total;
            assert!(
                total <= before * (1.0 + 1e-13),
                "{id}{limits}, step {step}: {before} to {total}"
            );
            before = total;
        }
        session.end_run();
        assert!(before > 1e-3, "the handles contradict the shapes: {before}");
    }
}

#[test]
fn a_face_shows_the_row_that_says_the_most_about_it() {
    // Three by three quads: a plane on all of them, a sphere on the one in the middle, and a line
    // along one side, which covers no face.
    let sets = r#", "sets": { "middle": { "faces": [4] }, "side": { "vertices": [0, 1, 2, 3] } }"#;
    let mut session = Session::open(scene(sets), bumpy(3)).expect("it is regular");
    let shown = |session: &Session| {
        let acting = session.acting_rows();
        let used = |row| acting.faces.iter().filter(|face| **face == Some(row)).count();
        let dots: Vec<usize> =
            (0..16).filter(|&vertex| acting.vertices[vertex].is_some()).collect();
        ([used(0), used(1), used(2)], acting.faces[4], dots)
    };
    assert_eq!(shown(&session), ([0; 3], None, vec![]));
    session.edit(new("sphere", r#"{ "set": "middle" }"#)).expect("four vertices fit");
    session.edit(new("plane", r#""faces""#)).expect("quads fit");
    session.edit(new("line", r#"{ "set": "side" }"#)).expect("four vertices fit");
    assert_eq!(shown(&session), ([1, 8, 0], Some(0), vec![0, 1, 2, 3]));
    // The side's corners are corners of faces too, but no face is on the line.
    assert_eq!(session.members(2), [vec![], vec![0, 1, 2, 3]]);
    let [faces, vertices] = session.members(1);
    assert_eq!((faces.len(), vertices.len()), (9, 16));

    let off = |index| Edit::SetConstraint { index, weight: None, enabled: Some(false) };
    session.edit(off(0)).expect("the row is there");
    session.edit(off(2)).expect("the row is there");
    assert_eq!(shown(&session), ([0, 9, 0], Some(1), vec![]));
}

#[test]
fn projections_are_those_that_the_energy_measures() {
    // Kinds that may be anywhere and one that acts on edges; with the guard a projection may be
    // that of an earlier step.
    for guard in ["", r#", "solver": { "monotone": true }"#] {
        let constraints = r#", "constraints": [
            { "kind": "circle", "on": "faces", "weight": 2 },
            { "kind": "plane", "on": "faces", "enabled": false },
            { "kind": "line", "on": { "each": "curve" } },
            { "kind": "line-segment", "on": { "each": "edge" }, "length": 0.9 } ]"#;
        let mut session =
            Session::open(scene(&format!("{constraints}{guard}")), bumpy(4)).expect("it is valid");
        run(&mut session, 4);
        let found = session.projections();
        let counts = [(0, 16 * 4), (1, 0), (3, 40 * 2)];
        for (row, count) in counts {
            assert_eq!(found.rows.iter().filter(|&&r| r == row).count(), count, "row {row}");
        }
        let weight_of = |row: u32| session.rows()[row as usize].constraints.weight;
        let energy: f64 = found
            .ways
            .iter()
            .zip(&found.rows)
            .map(|(way, &row)| weight_of(row) * way.iter().map(|x| x * x).sum::<f64>())
            .sum();
        let expected = session.solver().energy().shape;
        assert!((energy - expected).abs() < 1e-12 * expected, "{energy} is not {expected}");

        // The outline of a panel is its four sides, between its own four points.
        let outlines_of = |row: u32| {
            let of_row = |ends: &&[u32; 2]| found.rows[ends[0] as usize] == row;
            found.outlines.iter().filter(of_row).count()
        };
        assert_eq!((outlines_of(0), outlines_of(3)), (16 * 4, 40));
        for [a, b] in found.outlines.iter().map(|ends| ends.map(|end| end as usize)) {
            assert_eq!(found.rows[a], found.rows[b]);
            let ends = (found.vertices[a], found.vertices[b]);
            assert!(session.topology().edge(ends.0, ends.1).is_some());
        }
        // The circles of the first panel: four points in a plane, as far from one centre.
        let at = |point: usize| -> [f64; 3] {
            let vertex = session.positions()[found.vertices[point] as usize];
            std::array::from_fn(|i| vertex[i] + found.ways[point][i])
        };
        let corners: Vec<_> = (0..4).map(at).collect();
        let faces: shape_up::mesh::Ragged = [[0, 1, 2, 3]].iter().collect();
        let spread = shape_up::mesh::Measures::new(&corners, &faces, 1.0);
        assert!(spread.circularity.max_distance < 1e-9, "{spread:?}");
    }
}
