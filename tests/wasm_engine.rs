//! The solver's wasm class, in a worker of a real browser, as the page uses it.

#![cfg(all(target_arch = "wasm32", feature = "engine"))]

#[path = "data/golden.rs"]
mod golden;
#[path = "support/grid.rs"]
mod grid;

use js_sys::{Float32Array, Float64Array, JSON, Reflect, Uint8Array, Uint32Array};
use shape_up::constraint::{Arity, KINDS};
use shape_up::web::jobs::ModelCopy;
use shape_up::web::warm_up::WarmUp;
use shape_up::web::worker::Solver;
use std::fmt::Write;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_dedicated_worker);

const OBJ: &str =
    "v 0 0 0\nv 1 0 0.2\nv 1 1 0\nv 0 1 0.2\nv 2 0 0\nv 2 1 0.3\nf 1 2 3 4\nf 2 5 6 3\n";

/// The value as a type of the interface, whether it is one or not.
fn object<T: JsCast>(json: &str) -> T {
    JSON::parse(json).expect("it is JSON").unchecked_into()
}

fn word<T: JsCast>(word: &str) -> T {
    JsValue::from_str(word).unchecked_into()
}

/// The value at a path such as `energy.total`.
fn get(value: &JsValue, path: &str) -> JsValue {
    path.split('.').fold(value.clone(), |value, key| {
        Reflect::get(&value, &key.into()).expect("the value is an object")
    })
}

fn number(value: &JsValue, path: &str) -> f64 {
    get(value, path).as_f64().unwrap_or_else(|| panic!("{path} is not a number"))
}

fn message(error: JsValue) -> String {
    error.dyn_into::<js_sys::Error>().expect("what is thrown is an Error").message().into()
}

fn loaded() -> Solver {
    let mut solver = Solver::new();
    let about = solver.load("two.obj", OBJ.as_bytes(), None, None).expect("the mesh is valid");
    assert_eq!(number(&about, "vertices"), 6.0);
    assert_eq!(number(&about, "faces"), 2.0);
    assert_eq!(number(&about, "problems.length"), 0.0);
    solver
}

/// The copy of the open model, as in the second worker.
fn copy(solver: &Solver) -> ModelCopy {
    let (scene, generation) = (solver.scene(), solver.generation());
    let scene = scene.expect("a model is open");
    let told = js_sys::Function::new_no_args("");
    ModelCopy::new(&scene, generation.expect("a model is open"), told).expect("it is open already")
}

const ADD: &str =
    r#"{ "addConstraint": { "kind": "circle", "params": {}, "on": "faces", "weight": 2 } }"#;

#[wasm_bindgen_test]
fn thirty_steps_give_the_same_bits_in_a_browser() {
    golden::check();
}

#[wasm_bindgen_test]
fn a_mesh_is_opened_constrained_run_and_undone() {
    let mut solver = loaded();
    solver.edit(object(ADD)).expect("circles fit quads");
    let document = solver.document().expect("a model is open");
    assert_eq!(number(&document, "constraints.0.count"), 2.0);
    assert_eq!(number(&document, "constraints.0.weight"), 2.0);
    assert_eq!(get(&document, "undo").as_string().as_deref(), Some("Add circle"));
    assert!(get(&document, "redo").is_null());

    let before = solver.frame(false).expect("a model is open");
    solver.begin_run().expect("a model is open");
    for _ in 0..200 {
        if solver.step().expect("positions stay finite") {
            break;
        }
    }
    solver.end_run().expect("a model is open");
    let after = solver.frame(false).expect("a model is open");
    assert!(number(&after, "energy.shape") < 1e-3 * number(&before, "energy.shape"));
    assert!(
        number(&after, "circularity.max_distance")
            < 0.05 * number(&before, "circularity.max_distance")
    );
    let iterations = number(&after, "iteration");
    let trace = solver.trace().expect("a model is open").to_vec();
    let (rows, rest) = trace.as_chunks::<6>();
    assert!(rest.is_empty(), "six numbers per iteration");
    assert_eq!([rows[0][0], rows[rows.len() - 1][0]], [0.0, iterations]);

    let positions = Float64Array::new_with_length(18);
    solver.write_positions(&positions).expect("a model is open");
    let moved = positions.to_vec();
    assert_eq!(solver.undo().expect("undo works"), Some(format!("Run, {iterations} iterations")));
    solver.write_positions(&positions).expect("a model is open");
    assert_eq!(positions.get_index(5), 0.2, "vertex 1 is at rest");
    assert_ne!(positions.to_vec(), moved);
}

#[wasm_bindgen_test]
fn what_the_second_worker_finds_on_a_copy_is_accepted_for_that_shape_only() {
    let mut solver = loaded();
    let planes =
        r#"{ "addConstraint": { "kind": "plane", "params": {}, "on": "faces", "weight": 1 } }"#;
    solver.edit(object(planes)).expect("planes fit quads");
    let within = r#"{ "setConstraint": { "index": 0, "require": { "within": 0.01 } } }"#;
    solver.edit(object(within)).expect("the row is there");
    solver.begin_run().expect("a model is open");
    while !solver.step().expect("positions stay finite") {}
    solver.end_run().expect("a model is open");

    let mut copied = copy(&solver);
    assert!(copied.offer().expect("it can be asked").is_none(), "nothing is tried yet");
    copied.try_exact().expect("regular");
    while copied.advance().expect("regular") {}
    let offer = copied.offer().expect("it can be asked").expect("it is found");
    assert!(get(&offer, "met").is_truthy());
    let shape = || copied.shape().expect("it can be asked").expect("it is found");
    let positions = copied.positions().to_vec();
    assert!(solver.make_exact(shape(), &positions, false).expect("regular"));
    let now = Float64Array::new_with_length(18);
    solver.write_positions(&now).expect("a model is open");
    assert_eq!(now.to_vec(), positions);
    let document = solver.document().expect("a model is open");
    assert_eq!(get(&document, "undo").as_string().as_deref(), Some("Make exact"));
    assert_eq!(get(&document, "constraints.0.require").as_string().as_deref(), Some("exact"));
    assert!(!solver.make_exact(shape(), &positions, false).expect("regular"), "it is another now");

    let mut copied = copy(&solver);
    let of = solver.generation().expect("a model is open");
    assert!(copied.find_variations().expect("regular"));
    while get(&copied.advance_variations().expect("regular"), "more").is_truthy() {}
    let towards = copied.towards(&[0.02]).expect("there is one").to_vec();
    assert!(solver.show_variation(of, &towards, None).expect("a model is open"));
    assert!(!solver.keep_variation().expect("nothing is wrong"), "it is not brought back");
    let varied = copied.go(&[0.02]).expect("regular");
    let reached = Float64Array::from(get(&varied, "positions")).to_vec();
    let shown = solver.show_variation(of, &reached, Some(get(&varied, "report").unchecked_into()));
    assert!(shown.expect("a model is open"));
    assert!(solver.keep_variation().expect("there is room"));
    assert!(!solver.show_variation(of, &towards, None).expect("a model is open"));
}

#[wasm_bindgen_test]
fn a_handle_is_dragged() {
    let mut solver = loaded();
    solver.edit(object(ADD)).expect("circles fit quads");
    solver
        .edit(object(r#"{ "addHandles": { "vertices": [0, 4], "fixed": true } }"#))
        .expect("the vertices are there");
    solver.drag(&[4], &[2.0, 0.0, 1.0], word("start")).expect("it is a handle");
    solver.step().expect("positions stay finite");
    solver.drag(&[4], &[2.0, 0.0, 1.5], word("move")).expect("it is a handle");
    solver.step().expect("positions stay finite");
    solver.drag(&[4], &[2.0, 0.0, 1.5], word("end")).expect("it is a handle");
    let positions = Float64Array::new_with_length(18);
    solver.write_positions(&positions).expect("a model is open");
    assert_eq!(positions.get_index(14), 1.5);
    let document = solver.document().expect("a model is open");
    assert_eq!(get(&document, "undo").as_string().as_deref(), Some("Move handle"));
    assert_eq!(number(&document, "handles.1.target.2"), 1.5);
}

#[wasm_bindgen_test]
fn a_drag_that_makes_no_sense_is_refused_and_moves_nothing() {
    // Any unknown phase was taken for a move, and for arrays of unequal length the rest was
    // ignored.
    let mut solver = loaded();
    solver.drag(&[4], &[2.0, 0.0, 1.0], word("make")).expect("the vertex is there");
    let target = |solver: &Solver| {
        number(&solver.document().expect("a model is open"), "handles.0.target.2")
    };
    for (vertices, targets, phase, words) in [
        (&[4][..], &[2.0, 0.0, 9.0][..], "shove", "found `shove`, expected one of `make`"),
        (&[4], &[2.0, 0.0, 9.0, 1.0], "move", "found 4 coordinates, expected three per target"),
        (&[4, 5], &[2.0, 0.0, 9.0], "move", "found 1 targets, expected one for each of the 2"),
        (&[4], &[2.0, 0.0, f64::NAN], "move", "the target of vertex 4 is not finite"),
        (&[4], &[2.0, 0.0, 1e51], "end", "the target of vertex 4 is not finite or too far out"),
    ] {
        let error = solver.drag(vertices, targets, word(phase)).expect_err("it makes no sense");
        let error = message(error);
        assert!(error.contains(words), "{error}");
        assert_eq!(target(&solver), 1.0);
    }
}

#[wasm_bindgen_test]
fn a_handle_is_made_where_its_vertex_is_before_it_is_moved() {
    let mut solver = loaded();
    solver.drag(&[4], &[], word("make")).expect("the vertex is there");
    assert_eq!(number(&solver.document().expect("a model is open"), "handles.0.vertex"), 4.0);
    solver.drag(&[4], &[], word("cancel")).expect("it is dragged");
    let document = solver.document().expect("a model is open");
    assert_eq!(number(&document, "handles.length"), 0.0);
}

#[wasm_bindgen_test]
fn a_selection_becomes_a_set_of_the_scene() {
    let mut solver = loaded();
    let offers = solver.constraint_offers(vec![1, 2, 4, 5], vec![1]).expect("the face is there");
    let found = |list: &str, key: &str, id: &str| {
        let of = |k: u32| get(&offers, &format!("{list}.{k}"));
        let is_this = |one: &JsValue| get(one, key).as_string().as_deref() == Some(id);
        let length = number(&offers, &format!("{list}.length")) as u32;
        (0..length).map(of).find(is_this).unwrap_or_else(|| panic!("{id} is not among {list}"))
    };
    let plane = found("kinds", "kind", "plane");
    assert_eq!(get(&plane, "offers.1.place").as_string().as_deref(), Some("each-face-selected"));
    assert_eq!(number(&plane, "offers.1.constraints"), 1.0);
    let words = get(&plane, "offers.1.words").as_string();
    assert_eq!(words.as_deref(), Some("1 constraint of 4 vertices."));
    let segment = KINDS.iter().find(|info| info.arity == Arity::Exactly(2));
    let segment = found("kinds", "kind", segment.expect("some kind takes two vertices").id);
    let place = get(&segment, "offers.0.place").as_string();
    assert_eq!(place.as_deref(), Some("each-edge"), "a quad is no edge");
    // The place is passed back as it is.
    let selected = found("places", "id", "each-face-selected");
    let [on, set] = ["on", "set"].map(|key| {
        let value = JSON::stringify(&get(&selected, key));
        String::from(value.expect("it is plain data"))
    });
    let add = format!(
        r#"{{ "addConstraint": {{ "kind": "plane", "params": {{}}, "on": {on}, "set": {set}, "weight": 1 }} }}"#
    );
    solver.edit(object(&add)).expect("a plane fits a quad");
    let members = solver.members(0).expect("the row is there");
    let faces: Uint32Array = get(&members, "faces").unchecked_into();
    assert_eq!(faces.to_vec(), [1]);

    // The face has the only colour of the palette.
    let colours = solver.row_colours().expect("a model is open");
    let places: Uint8Array = get(&colours, "faces").unchecked_into();
    assert_eq!(places.to_vec(), [0, 1]);
    let palette: Float32Array = get(&colours, "palette").unchecked_into();
    assert_eq!(palette.length(), 3);

    // The saved scene opens again, with the set.
    let scene = solver.scene().expect("a model is open");
    let mut again = Solver::new();
    assert_eq!(again.scene_files(scene.as_bytes()), Ok(Vec::new()), "the mesh is inline");
    again
        .load("saved.shapeup.json", scene.as_bytes(), None, None)
        .expect("what is saved can be opened");
    let document = again.document().expect("a model is open");
    assert_eq!(number(&document, "constraints.0.count"), 1.0);
    assert_eq!(again.obj(), solver.obj());
}

#[wasm_bindgen_test]
fn kinds_come_with_parameters_and_a_drawing() {
    let kinds = Solver::new().kinds().expect("there are kinds");
    for (i, info) in KINDS.iter().enumerate() {
        assert_eq!(get(&kinds[i], "id").as_string().as_deref(), Some(info.id));
        for (k, param) in info.params.iter().enumerate() {
            let path = format!("params.{k}");
            assert_eq!(
                get(&kinds[i], &format!("{path}.id")).as_string().as_deref(),
                Some(param.id)
            );
            assert_eq!(
                number(&kinds[i], &format!("{path}.forms.length")),
                param.forms.len() as f64
            );
            assert!(!get(&kinds[i], &format!("{path}.default")).is_undefined());
        }
        assert!(number(&kinds[i], "sketch.points.length") >= 2.0);
        assert!(number(&kinds[i], "sketch.projected.0.0") <= 1.0);
    }
}

#[wasm_bindgen_test]
fn a_parameter_is_changed_and_a_wrong_one_is_told_with_its_place() {
    let mut solver = loaded();
    let add = r#"{ "addConstraint": { "kind": "line-segment", "params": { "length": [0.5, null] },
                   "on": "edges", "weight": 1 } }"#;
    solver.edit(object(add)).expect("segments fit edges");
    let set = |length: &str| {
        object(&format!(
            r#"{{ "setConstraint": {{ "index": 0, "params": {{ "length": {length} }} }} }}"#
        ))
    };
    let length = |solver: &Solver| {
        let params = get(&solver.document().expect("a model is open"), "constraints.0.params");
        String::from(JSON::stringify(&get(&params, "length")).expect("it is plain"))
    };
    assert_eq!(length(&solver), "[0.5,null]");
    solver.edit(set("1.25")).expect("a segment may have that length");
    assert_eq!(length(&solver), "1.25");
    let error = solver.edit(set("-3")).expect_err("no length is negative");
    assert_eq!(get(&error, "path").as_string().as_deref(), Some("constraints[0].length"));
    assert!(message(error).contains("-3"));
    assert_eq!(length(&solver), "1.25");
    assert_eq!(solver.undo().expect("undo works").as_deref(), Some("Change line segment"));
    assert_eq!(length(&solver), "[0.5,null]");
}

#[wasm_bindgen_test]
fn a_field_that_an_edit_does_not_have_is_refused_and_nothing_is_done() {
    let mut solver = loaded();
    let exact = r#"{ "addConstraint": { "kind": "plane", "on": "faces", "weight": 1, "require": "exact" } }"#;
    let error = message(solver.edit(object(exact)).expect_err("there is no such field"));
    assert!(error.contains("unknown key `require`, known here: kind, on"), "{error}");
    let named = r#"{ "setLesson": { "lesson": { "text": "", "goals": [{ "measure": "planarity", "at_most": 1 }], "hint": "" } } }"#;
    let error = solver.edit(object(named)).expect_err("there is no such field");
    assert_eq!(get(&error, "path").as_string().as_deref(), Some("lesson"));
    let request = r#"{ "operation": "grow", "mode": "faces", "surplus": 1 }"#;
    let error = message(solver.select(object(request)).err().expect("there is no such field"));
    assert!(error.contains("unknown key `surplus`"), "{error}");
    let document = solver.document().expect("a model is open");
    assert_eq!(number(&document, "constraints.length"), 0.0);
    assert!(get(&document, "undo").is_null());
    // A field that is there without a value is as good as absent.
    let steps: JsValue = object(r#"{ "setSteps": { "steps": [{ "title": "First" }] } }"#);
    let step = get(&steps, "setSteps.steps.0");
    Reflect::set(&step, &"variant".into(), &JsValue::UNDEFINED).expect("it is an object");
    solver.edit(steps.unchecked_into()).expect("the step has no variant");
    assert!(solver.edit(JsValue::UNDEFINED.unchecked_into()).is_err());
}

#[wasm_bindgen_test]
fn what_is_wrong_is_said_in_one_line_and_the_old_model_stays() {
    let mut solver = loaded();
    let error =
        message(solver.load("broken.obj", b"", None, None).err().expect("the file is empty"));
    assert_eq!(error, "broken.obj: the file is empty");
    let scene = br#"{ "format": "shape-up-scene", "version": 9 }"#;
    let error = message(
        solver.load("later.json", scene, None, None).err().expect("it is of a later version"),
    );
    assert!(error.starts_with("later.json: version: ") && !error.contains('\n'), "{error}");
    let error = message(
        solver
            .edit(object(r#"{ "removeConstraint": { "index": 3 } }"#))
            .expect_err("there is no row"),
    );
    assert!(error.contains("constraints[3]"), "{error}");
    assert_eq!(solver.face_offsets().expect("the old model is open").to_vec(), [0, 4, 8]);
}

#[wasm_bindgen_test]
fn a_model_is_flattened_and_exported_with_its_map() {
    let solver = loaded();
    let copied = copy(&solver);
    let map = copied.parametrize(word("inverse-area"), word("boundary")).expect("it is a surface");
    let uv = get(&map, "uv").unchecked_into::<Float64Array>().to_vec();
    let errors = get(&map, "faceErrors").unchecked_into::<Float32Array>().to_vec();
    assert_eq!((uv.len(), errors.len()), (12, 2));
    let (mean, max) = (number(&map, "mean"), number(&map, "max"));
    assert!(1.0 < mean && mean < max && max < 1.5, "{mean} {max}");
    assert!(errors.iter().any(|&error| (f64::from(error) - max).abs() < 1e-6));
    assert_eq!([number(&map, "parts"), number(&map, "closedParts")], [1.0, 0.0]);
    assert_eq!(number(&map, "flipped"), 0.0);
    assert!(copied.fewer_flips(0).expect("there is a model").is_none());
    let fewer = copied.fewer_flips(1).expect("there is a model").expect("one flips none");
    assert_eq!(number(&fewer, "flipped"), 0.0);
    let histogram = get(&map, "histogram").unchecked_into::<Uint32Array>().to_vec();
    assert_eq!(histogram.iter().sum::<u32>(), 2);
    assert!(number(&map, "seconds") > 0.0);

    let obj = solver.obj_with_uv(&uv).expect("there is a place for each vertex");
    assert_eq!(obj.lines().filter(|line| line.starts_with("vt ")).count(), 6);
    assert!(obj.contains("\nf 1/1 2/2 3/3 4/4\n"), "{obj}");
    assert!(solver.obj_with_uv(&uv[..10]).is_err());
}

#[wasm_bindgen_test]
fn what_cannot_be_flattened_is_told() {
    let mut solver = Solver::new();
    let refused = |solver: &Solver, weights: &str| {
        let flattened = copy(solver).parametrize(word(weights), word("vertices"));
        message(flattened.err().expect("it cannot be flattened"))
    };
    assert_eq!(
        refused(&loaded(), "two"),
        "found \"two\", expected \"inverse-area\" or \"one\" or \"lscm\""
    );
    solver.load("line.obj", b"v 0 0 0\nv 1 0 0\nl 1 2\n", None, None).expect("it is a curve");
    assert_eq!(refused(&solver, "one"), "the mesh has no faces, expected a surface");
    let tetrahedron = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
    solver.load("closed.obj", tetrahedron, None, None).expect("it is a surface");
    let map = copy(&solver).parametrize(word("one"), word("boundary")).expect("it is folded");
    assert_eq!(number(&map, "closedParts"), 1.0);
}

/// OBJ text of a bumpy grid of quads with `side` vertices per side.
fn bumpy(side: u32) -> String {
    let mut obj = String::new();
    for v in 0..side * side {
        let (i, j) = (v % side, v / side);
        writeln!(obj, "v {i} {j} {}", f64::from((7 * i + 3 * j) % 5) / 9.0)
            .expect("it is a string");
        if i > 0 && j > 0 {
            let [a, b, c, d] = [v - side, v - side + 1, v + 1, v];
            writeln!(obj, "f {a} {b} {c} {d}").expect("it is a string");
        }
    }
    obj
}

const CIRCLES: &str = r#"{ "format": "shape-up-scene", "version": 1, "mesh": { "file": "grid.obj" },
    "constraints": [ { "kind": "circle", "on": "faces" } ],
    "weights": { "shape": 5, "close": 10, "smooth": 2 } }"#;

fn open_grid(solver: &mut Solver, scene: &str, obj: &str) -> Result<(), JsValue> {
    solver.add_file("grid.obj", obj.as_bytes().to_vec());
    solver.load("a.shapeup.json", scene.as_bytes(), None, None).map(|_| ())
}

#[wasm_bindgen_test]
fn one_model_after_another_takes_no_room_for_two() {
    let pages = || core::arch::wasm32::memory_size::<0>();
    let before = pages();
    let mut solver = Solver::new();
    let obj = bumpy(90);
    let mut taken = Vec::new();
    for _ in 0..5 {
        open_grid(&mut solver, CIRCLES, &obj).expect("the scene is valid");
        solver.step().expect("positions stay finite");
        taken.push(pages() - before);
    }
    assert!(taken[0] > 100, "the model is large enough to see: {taken:?}");
    assert!(taken[4] - taken[0] < taken[0] / 2, "{taken:?}");
}

#[wasm_bindgen_test]
fn a_model_that_is_refused_late_leaves_the_one_before_as_it_was() {
    let mut solver = Solver::new();
    let obj = bumpy(6);
    open_grid(&mut solver, CIRCLES, &obj).expect("the scene is valid");
    solver.begin_run().expect("a model is open");
    for _ in 0..3 {
        solver.step().expect("positions stay finite");
    }
    solver.end_run().expect("a model is open");
    let before = solver.scene().expect("a model is open");
    let singular = CIRCLES.replace(
        r#""weights": { "shape": 5, "close": 10, "smooth": 2 }"#,
        r#""handles": [ { "vertices": [0], "weight": 1e-20 } ], "closeness": { "to": "none" }"#,
    );
    let refused = open_grid(&mut solver, &singular, &obj).expect_err("the system is singular");
    assert!(message(refused).contains("differ too much from the others"));
    assert_eq!(solver.scene().expect("a model is open"), before);
    let undone = solver.undo().expect("a model is open");
    assert_eq!(undone.as_deref(), Some("Run, 3 iterations"));
}

#[wasm_bindgen_test]
fn warming_up_comes_to_an_end() {
    let mut warm_up = WarmUp::new();
    let slices = (0..).take_while(|_| warm_up.advance()).count();
    assert!((4..1000).contains(&slices), "{slices}");
    assert!(!warm_up.advance());
}
