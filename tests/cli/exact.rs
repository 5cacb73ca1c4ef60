//! `shape-up solve` with hard constraints.

use crate::cli::folder::{Folder, PLANES, ROOF, scene};
use serde_json::Value;

fn number(value: &Value) -> f64 {
    value.as_f64().expect("it is a number")
}

#[test]
fn exact_panels_are_still_exact_when_their_file_is_read_again() {
    let folder = Folder::new("exact");
    folder.write("roof.obj", ROOF);
    let asked = ["solve", "roof.obj", "--panels", "circle", "--exact", "--out", "out.obj"];
    let words = folder.run(&[&asked[..], &["--report", "r.json"]].concat()).done();
    assert!(words.contains("hard constraints met: "), "{words}");
    // The verdict of the page.
    assert!(words.contains("\nAll 4 panels are circular within 1 mm. Worst "), "{words}");
    assert!(
        words.contains("\nAll required constraints are exact. The largest error is "),
        "{words}"
    );
    let exact = &folder.json("r.json")["exact"];
    assert_eq!((&exact["met"], &exact["unmet"]), (&true.into(), &Value::Array(vec![])));
    assert!(number(&exact["max_distance"]) <= number(&exact["tolerance"]), "{exact}");
    assert!(exact["refactorizations"].is_u64() && exact["seconds"].is_number(), "{exact}");
    folder.run(&["check", "out.obj", "--report", "check.json"]).done();
    let distance = number(&folder.json("check.json")["circularity"]["max_distance"]);
    assert!(distance <= 1e-12, "{distance}");
}

#[test]
fn a_tolerance_is_met_and_moves_less() {
    let folder = Folder::new("within");
    folder.write("roof.obj", ROOF);
    let report = |require: &[&str]| {
        let asked = [&["solve", "roof.obj", "--panels", "circle", "--report", "r.json"], require];
        folder.run(&asked.concat()).done();
        folder.json("r.json")
    };
    let (within, exact) = (report(&["--within", "0.01"]), report(&["--exact"]));
    assert_eq!(within["exact"]["tolerance"], 0.01);
    assert!(number(&within["exact"]["max_distance"]) <= 0.01, "{within}");
    assert!(number(&within["moved"]["mean"]) < number(&exact["moved"]["mean"]));
    assert!(report(&[]).get("exact").is_none(), "nothing was to be met");
}

#[test]
fn a_requirement_of_the_command_line_replaces_what_a_search_chose() {
    let folder = Folder::new("eased");
    let eased = r#""require": { "within": 0.001 }, "eased": { "within": 0.5, "faces": "0-3" }"#;
    let planes = format!(r#", "constraints": [{{ "kind": "plane", "on": "faces", {eased} }}]"#);
    folder.write("roof.obj", ROOF).write("s.shapeup.json", scene(&planes));
    for require in [&["--exact"][..], &["--within", "0.01"]] {
        let asked = [&["solve", "s.shapeup.json", "--report", "r.json"], require];
        folder.run(&asked.concat()).done();
        let exact = &folder.json("r.json")["exact"];
        assert!(number(&exact["tolerance"]) <= 0.01, "{exact}");
        assert!(number(&exact["max_distance"]) <= number(&exact["tolerance"]), "{exact}");
    }
    // The attempt of other requirements was the only one.
    folder.write("s.shapeup.json", scene(&format!(r#"{planes}, "attempt": {{ "from": "rest" }}"#)));
    folder.run(&["solve", "s.shapeup.json", "--report", "r.json", "--within", "auto"]).done();
    assert_eq!(folder.json("r.json")["verdict"]["attempts"][0]["name"], "soft");
}

#[test]
fn the_trace_begins_at_the_input_where_constraints_are_met() {
    let folder = Folder::new("trace");
    folder.write("roof.obj", ROOF);
    let asked = ["solve", "roof.obj", "--panels", "circle", "--exact", "--trace"];
    for iterations in ["0", "3"] {
        let rest = ["--report", "r.json", "--iterations", iterations];
        folder.run(&[&asked[..], &rest].concat()).done();
        let report = folder.json("r.json");
        let (energy, trace) = (&report["energy"], report["trace"].as_array().unwrap());
        assert_eq!(trace[0]["total"], energy["initial"]["total"]);
        assert_eq!(trace[trace.len() - 1]["total"], energy["final"]["total"]);
        assert_ne!(energy["initial"]["total"], energy["final"]["total"]);
    }
}

#[test]
fn steps_that_meet_constraints_are_no_iterations_and_leave_no_trace() {
    // They were counted, and those were recorded that the clock chose to show.
    let folder = Folder::new("steps");
    folder.write("roof.obj", ROOF);
    let asked = ["solve", "roof.obj", "--panels", "circle", "--trace", "--report", "r.json"];
    let mut seen = Vec::new();
    for within in ["auto", "0.001"] {
        folder.run(&[&asked[..], &["--within", within]].concat()).done();
        let report = folder.json("r.json");
        let iterations = report["iterations"].as_u64().unwrap();
        assert!(number(&report["exact"]["iterations"]) > 0.0, "{}", report["exact"]);
        let trace = report["trace"].as_array().unwrap().iter();
        let own: Vec<u64> = trace.map(|entry| entry["iteration"].as_u64().unwrap()).collect();
        // The last entry is the shape that was met.
        assert_eq!(own, (0..=iterations).chain([iterations]).collect::<Vec<_>>());
        seen.push(iterations);
    }
    assert_eq!(seen[0], seen[1], "both are the soft solution");
}

#[test]
fn meeting_constraints_leaves_what_stopped_the_iterations() {
    let folder = Folder::new("stopped");
    folder.write("roof.obj", ROOF);
    let stopped_by = |limit: &str| {
        let asked = ["solve", "roof.obj", "--panels", "circle", "--exact", "--report", "r.json"];
        let words = folder.run(&[&asked[..], &["--iterations", limit]].concat()).done();
        assert!(words.contains("hard constraints met: "), "{words}");
        folder.json("r.json")["stopped_by"].clone()
    };
    assert_eq!(stopped_by("5000"), "tolerance");
    assert_eq!(stopped_by("1"), "iterations");
}

#[test]
fn an_improvement_says_what_it_gained() {
    let folder = Folder::new("improve");
    folder.write("roof.obj", ROOF);
    let asked = ["solve", "roof.obj", "--panels", "circle", "--report", "r.json", "--improve"];
    let words = folder.run(&[&asked[..], &["--exact"]].concat()).done();
    assert!(words.contains("improved by "), "{words}");
    let exact = &folder.json("r.json")["exact"];
    let [before, after] = ["before", "after"].map(|name| number(&exact["improved"][name]));
    assert!(after <= before && exact["met"] == true, "{exact}");
    let words = folder.run(&asked).done();
    assert!(words.contains("--improve did nothing"), "{words}");
}

#[test]
fn a_scene_says_what_is_to_be_met_and_is_told_what_cannot_be() {
    let folder = Folder::new("unmet");
    folder.write("roof.obj", ROOF);
    let length = |length: f64| {
        format!(
            r#"{{ "kind": "line-segment", "on": {{ "vertices": [0, 1] }}, "length": {length},
                  "require": "exact" }}"#
        )
    };
    let rows = format!(
        r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "roof.obj" }},
              "constraints": [{{ "kind": "plane", "on": "faces", "require": "exact" }}, {}, {}],
              "weights": {{ "shape": 5, "close": 10, "smooth": 2 }},
              "closeness": {{ "to": "rest" }} }}"#,
        length(1.0),
        length(1.2)
    );
    folder.write("two.shapeup.json", rows);
    let words = folder.run(&["solve", "two.shapeup.json", "--report", "r.json"]).done();
    assert!(words.contains("hard constraints not met by 2 constraints"), "{words}");
    // The verdict of the page.
    assert!(words.contains("\n2 of 6 constraints cannot be satisfied together: "), "{words}");
    assert_eq!(folder.json("r.json")["exact"]["unmet"], serde_json::json!([1, 2]));
}

#[test]
fn what_is_to_be_met_is_said_once() {
    let folder = Folder::new("twice");
    folder.write("roof.obj", ROOF);
    folder.run(&["solve", "roof.obj", "--exact", "--within", "1"]).misused("not both");
    folder.run(&["solve", "roof.obj", "--within", "0"]).misused("above 0");
    folder.run(&["solve", "roof.obj", "--within"]).misused("needs a value");
}

#[test]
fn a_boundary_is_held_exactly_or_nearly() {
    let folder = Folder::new("boundary");
    folder.write("roof.obj", ROOF);
    let off = |boundary: &[&str]| {
        let asked = ["solve", "roof.obj", "--panels", "circle", "--out", "out.obj"];
        folder.run(&[&asked[..], boundary].concat()).done();
        let read = |name: &str| shape_up::mesh::read(name, folder.read(name).as_bytes()).unwrap();
        let (rest, now) = (read("roof.obj").mesh.positions, read("out.obj").mesh.positions);
        // Each border vertex except the corners is on the straight segments between these vertices.
        let segments = [[0, 1], [1, 2], [2, 5], [5, 8], [8, 7], [7, 6], [6, 3], [3, 0]];
        let distance = |p: [f64; 3]| {
            let to = |[a, b]: [usize; 2]| {
                let (a, along) = (rest[a], |i: usize| rest[b][i] - rest[a][i]);
                let dot = |f: &dyn Fn(usize) -> f64| (0..3).map(|i| f(i) * along(i)).sum::<f64>();
                let t = (dot(&|i| p[i] - a[i]) / dot(&along)).clamp(0.0, 1.0);
                (0..3).map(|i| (p[i] - a[i] - t * along(i)).powi(2)).sum::<f64>().sqrt()
            };
            segments.map(to).into_iter().fold(f64::INFINITY, f64::min)
        };
        [0, 1, 2, 3, 5, 6, 7, 8].map(|v| distance(now[v])).into_iter().fold(0.0, f64::max)
    };
    let [free, nearly, exact] =
        [off(&[]), off(&["--boundary", "100000"]), off(&["--boundary", "exact"])];
    assert!(exact <= 1e-15, "{exact}");
    assert!(exact < nearly && nearly < free, "{nearly} {free}");
    // The corners of the scene were replaced by those of the default.
    let [own, default] = ["120", "45"].map(|corners| {
        let boundary = format!(r#""boundary": {{ "corners": {corners} }}"#);
        let close = format!(r#", "weights": {{ "close": 1 }}, "closeness": {{ {boundary} }}"#);
        folder.write("s.json", scene(&format!("{PLANES}{close}")));
        folder.run(&["solve", "s.json", "--boundary", "exact", "--out", "own.obj"]).done();
        folder.read("own.obj")
    });
    assert_ne!(own, default);
    folder.run(&["solve", "roof.obj", "--boundary", "tight"]).misused("`exact` or a weight");
    // Without a weight of closeness it did nothing, and did not say so.
    folder.write("s.json", scene(PLANES));
    let said = folder.run(&["solve", "s.json", "--boundary", "100"]).done();
    let why = "note: the boundary is not held, since the weight of Close is 0";
    assert!(said.contains(why), "{said}");
}

#[test]
fn a_requirement_of_nothing_and_a_miss_by_the_guard_are_said() {
    let folder = Folder::new("guard");
    folder.write("roof.obj", ROOF);
    let words = folder.run(&["solve", "roof.obj", "--exact"]).done();
    assert!(words.contains("note: nothing is required: there are no constraints"), "{words}");
    // Edges may not become shorter than half, and a sphere this small needs shorter ones.
    let guarded = r#", "weights": { "close": 1 }, "closeness": { "to": "rest" },
        "solver": { "shortest_edge": 0.5 }, "constraints": [
        { "kind": "sphere", "on": "boundary", "radius": 0.1, "require": "exact" }]"#;
    folder.write("s.json", scene(guarded));
    let words = folder.run(&["solve", "s.json"]).done();
    assert!(words.contains("hard constraints not met by "), "{words}");
    assert!(words.contains(" edges are as short as allowed, down to 0."), "{words}");
}
