//! The command line as users run it: written files, exit codes, and messages.

mod build;
mod check;
mod edit;
mod exact;
mod experiment;
mod faults;
mod files;
mod folder;
mod lessons;
mod new_mesh;
mod remesh;
mod rhino;
mod watch;
mod written;

use folder::{Folder, PLANES, ROOF, scene};
use serde_json::{Value, json};
use std::path::Path;

#[test]
fn a_mesh_is_solved_and_comes_out_in_its_order() {
    let folder = Folder::new("order");
    folder.write("roof.obj", ROOF);
    let out = folder.run(&["solve", "roof.obj", "--panels", "circle", "--out", "out.obj"]).done();
    assert!(out.contains("9 vertices, 4 faces") && out.contains("4 circle"), "{out}");
    assert_eq!(folder.files(), ["out.obj", "roof.obj"]);
    let read = |name: &str| shape_up::mesh::read(name, folder.read(name).as_bytes()).unwrap().mesh;
    let (before, after) = (read("roof.obj"), read("out.obj"));
    assert_eq!(after.faces, before.faces);
    assert_eq!(after.curves, before.curves);
    assert_eq!(after.groups, before.groups);
    assert_ne!(after.positions, before.positions);
}

#[test]
fn no_iteration_gives_back_the_same_positions() {
    let folder = Folder::new("none");
    folder.write("roof.obj", ROOF);
    folder
        .run(&["solve", "roof.obj", "--panels", "plane", "--iterations=0", "--out=out.obj"])
        .done();
    let read = |name: &str| shape_up::mesh::read(name, folder.read(name).as_bytes()).unwrap().mesh;
    let (before, after) = (read("roof.obj").positions, read("out.obj").positions);
    for (a, b) in before.as_flattened().iter().zip(after.as_flattened()) {
        // The solver works relative to the centre of the mesh: the last digit may differ.
        assert!((a - b).abs() <= 2.0 * f64::EPSILON, "{a} {b}");
    }
}

/// The keys in alphabetical order.
fn keys(value: &Value) -> Vec<&str> {
    let mut keys: Vec<_> = value.as_object().unwrap().keys().map(String::as_str).collect();
    keys.sort_unstable();
    keys
}

#[test]
fn the_report_has_the_fields_that_are_agreed_on() {
    let folder = Folder::new("report");
    folder.write("roof.obj", ROOF).write("roof.shapeup.json", scene(PLANES));
    let out = folder.run(&["solve", "roof.shapeup.json", "--trace", "--report", "r.json"]).done();
    let report = folder.json("r.json");
    let mut expected = vec![
        "vertices",
        "faces",
        "constraints",
        "skipped",
        "unknowns",
        "factor_nonzeros",
        "iterations",
        "stopped_by",
        "accelerator",
        "pinned",
        "energy",
        "planarity",
        "circularity",
        "moved",
        "shortest_edge",
        "seconds",
        "trace",
    ];
    expected.sort_unstable();
    assert_eq!(keys(&report), expected);
    assert_eq!(report["vertices"], 9);
    assert_eq!(report["faces"], 4);
    assert_eq!(report["constraints"], serde_json::json!({ "plane": 4 }));
    assert_eq!(report["skipped"], 0);
    assert_eq!(report["pinned"].as_array().unwrap().len(), 1, "nothing holds this mesh");
    assert_eq!(keys(&report["energy"]), ["final", "initial"]);
    let terms = ["close", "handles", "shape", "smooth", "total"];
    assert_eq!(keys(&report["energy"]["initial"]), terms);
    assert_eq!(keys(&report["energy"]["final"]), terms);
    let planarity = ["diagonal_ratio_max", "e_p_max", "e_p_mean", "max_distance", "mean_distance"];
    assert_eq!(keys(&report["planarity"]), planarity);
    let circularity = ["e_c_max", "e_c_mean", "max_distance", "mean_distance"];
    assert_eq!(keys(&report["circularity"]), circularity);
    assert_eq!(keys(&report["moved"]), ["max", "mean"]);
    let [most, mean] = ["max", "mean"].map(|which| report["moved"][which].as_f64().unwrap());
    assert!(0.0 < mean && mean < most && most < 1.0, "{mean} {most}");
    assert!((0.5..1.5).contains(&report["shortest_edge"].as_f64().unwrap()));
    for stage in ["load", "assemble", "order", "factor", "iterate"] {
        assert!(report["seconds"][stage].as_f64().unwrap() >= 0.0, "{stage}");
    }
    assert!(report["seconds"]["load"].as_f64().unwrap() > 0.0);

    let trace = report["trace"].as_array().unwrap();
    let iterations = report["iterations"].as_u64().unwrap();
    assert_eq!(trace.len() as u64, iterations + 1);
    for (i, entry) in trace.iter().enumerate() {
        assert_eq!(keys(entry), ["close", "handles", "iteration", "shape", "smooth", "total"]);
        assert_eq!(entry["iteration"], i);
    }
    assert_eq!(trace[0]["total"], report["energy"]["initial"]["total"]);
    let total = |energy: &Value| energy["total"].as_f64().unwrap();
    assert!(total(&report["energy"]["final"]) < 1e-3 * total(&report["energy"]["initial"]));

    for words in ["energy total", "stopped by", "planarity   worst", " mm, mean", "fixed at"] {
        assert!(out.contains(words), "expected `{words}` in {out}");
    }
    assert_eq!(out.lines().filter(|line| line.starts_with("iteration ")).count(), trace.len());
}

#[test]
fn a_mesh_of_which_nothing_is_asked_comes_out_as_it_came_in() {
    let folder = Folder::new("asked-nothing");
    folder.write("roof.obj", ROOF);
    folder.run(&["solve", "roof.obj", "--out", "out.obj"]).done();
    folder.run(&["solve", "out.obj", "--out", "again.obj"]).done();
    let roof = shape_up::mesh::read("roof.obj", ROOF.as_bytes()).unwrap().mesh;
    let out = folder.read("out.obj");
    assert_eq!(shape_up::mesh::read("out.obj", out.as_bytes()).unwrap().mesh, roof);
    assert_eq!(folder.read("again.obj"), out);
}

#[test]
fn without_trace_the_report_has_none() {
    let folder = Folder::new("untraced");
    folder.write("roof.obj", ROOF);
    folder.run(&["solve", "roof.obj", "--panels", "plane", "--report", "r.json"]).done();
    assert!(folder.json("r.json").get("trace").is_none());
}

#[test]
fn options_replace_the_settings_of_the_scene() {
    let folder = Folder::new("options");
    let settings =
        r#", "solver": { "iterations": 50, "tolerance": 0.5, "accelerator": "anderson" }"#;
    folder.write("roof.obj", ROOF).write("s.json", scene(&format!("{PLANES}{settings}")));
    let solve = |options: &[&str]| {
        let mut arguments = vec!["solve", "s.json", "--report", "r.json"];
        arguments.extend(options);
        folder.run(&arguments).done();
        folder.json("r.json")
    };
    let report = solve(&[]);
    assert_eq!(report["stopped_by"], "tolerance");
    assert_eq!(report["accelerator"], "anderson");
    let report = solve(&["--iterations", "7", "--tolerance", "0", "--accelerator", "none"]);
    assert_eq!(report["iterations"], 7);
    assert_eq!(report["stopped_by"], "iterations");
    assert_eq!(report["accelerator"], "none");
    assert_eq!(solve(&["--accelerator=quasi-newton"])["accelerator"], "quasi-newton");
    let report = solve(&["--panels=sphere"]);
    assert_eq!(report["constraints"], serde_json::json!({ "plane": 4, "sphere": 4 }));
}

#[test]
fn a_scene_finds_its_mesh_beside_itself() {
    let folder = Folder::new("beside");
    std::fs::create_dir(folder.0.join("sub")).unwrap();
    folder.write("sub/roof.obj", ROOF).write("sub/s.json", scene(PLANES));
    folder.run(&["solve", "sub/s.json"]).done();
    folder.run(&["solve", "s.json"]).refused(&["s.json"]);
}

#[test]
fn a_scene_says_what_is_kept_close_and_how_much() {
    let folder = Folder::new("close");
    folder.write("roof.obj", ROOF);
    let close_and_moved = |closeness: &str| {
        let rest = format!(r#"{PLANES}, "weights": {{ "close": 1 }}, "closeness": {closeness}"#);
        folder.write("s.json", scene(&rest));
        folder.run(&["solve", "s.json", "--out", "out.obj", "--report", "r.json"]).done();
        let read =
            |name: &str| shape_up::mesh::read(name, folder.read(name).as_bytes()).unwrap().mesh;
        let (before, after) = (read("roof.obj").positions, read("out.obj").positions);
        let close = folder.json("r.json")["energy"]["final"]["close"].as_f64().unwrap();
        (close, before.iter().zip(after).filter(|(a, b)| *a != b).count())
    };
    let (plain, all) = close_and_moved(r#"{ "to": "rest" }"#);
    assert_eq!(all, 9);
    // Corners are fixed; zero weights add nothing.
    assert_eq!(close_and_moved(r#"{ "to": "rest", "boundary": {} }"#).1, 5);
    let (none, _) =
        close_and_moved(r#"{ "to": "rest", "weights": [{ "on": "faces", "weight": 0 }] }"#);
    assert!(plain > 0.0 && none == 0.0, "{plain} {none}");
}

#[test]
fn elements_that_do_not_fit_a_kind_are_counted_and_named() {
    // Three quads in a row and a triangle at their end.
    let folder = Folder::new("misfits");
    folder.write(
        "row.obj",
        "v 0 0 0\nv 1 0 0.1\nv 2 0 0\nv 3 0 0.1\nv 0 1 0\nv 1 1 0\nv 2 1 0.2\nv 3 1 0\nv 4 0 0\n\
         l 1 2\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 9 8\n",
    );
    let solve = |on: &str, kind: &str| {
        let constraint = format!(r#"{{ "kind": "{kind}", "on": {on} }}"#);
        folder.write(
            "s.json",
            format!(
                r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "row.obj" }},
                    "constraints": [{constraint}] }}"#
            ),
        );
        let out = folder.run(&["solve", "s.json", "--report", "r.json"]).done();
        let report = folder.json("r.json");
        (out, report["constraints"][kind].clone(), report["skipped"].clone())
    };
    for (on, kind, fit, skipped, words) in [
        ("\"faces\"", "square", 3, 1, "square on each face: 1 of 4 skipped; it takes exactly 4"),
        // One strip along the row, of eight vertices, and three across.
        ("\"strips\"", "square", 3, 1, "square on each strip of faces: 1 of 4 skipped"),
        // Four ribs have two vertices, one of them the curve of the file; the two sides have five.
        (
            "\"curves\"",
            "circle",
            2,
            4,
            "circle on each curve: 4 of 6 skipped; it takes 3 or more vertices",
        ),
        ("\"rings\"", "square", 6, 3, "square on each vertex with its neighbours: 3 of 9 skipped"),
    ] {
        let (out, found, left_out) = solve(on, kind);
        assert_eq!((found, left_out), (fit.into(), skipped.into()), "{kind} on {on}: {out}");
        assert!(out.contains(&format!("note: {words}")), "{out}");
    }
    let (out, _, none) = solve("\"boundary\"", "circle");
    assert!(none == 0 && !out.contains("skipped"), "{out}");
}

#[test]
fn a_scene_with_its_mesh_inside_is_solved() {
    let folder = Folder::new("inline");
    folder.write(
        "s.shapeup.json",
        r#"{ "format": "shape-up-scene", "version": 1, "mesh": {
            "positions": [[0,0,0],[1,0,0.5],[1,1,0],[0,1,0.5]], "faces": [[0,1,2,3]] },
            "constraints": [{ "kind": "plane", "on": "faces" }] }"#,
    );
    folder.run(&["solve", "s.shapeup.json", "--out", "out.obj"]).done();
    assert_eq!(folder.read("out.obj").lines().filter(|line| line.starts_with("v ")).count(), 4);
}

#[test]
fn an_output_replaces_the_file_of_its_name_but_never_the_input() {
    let folder = Folder::new("replace");
    let roof = scene(PLANES);
    folder.write("roof.obj", ROOF).write("out.obj", "old").write("s.shapeup.json", &roof);
    folder.run(&["solve", "roof.obj", "--panels", "plane", "--out", "out.obj"]).done();
    assert_ne!(folder.read("out.obj"), "old");
    for (arguments, word) in [
        // A scene became the text of a mesh.
        (
            vec!["solve", "s.shapeup.json", "--out", "s.shapeup.json"],
            "--out writes .obj, .mesh, .ply or .stl",
        ),
        (vec!["solve", "roof.obj", "--out", "x.off"], "found `x.off`"),
        (
            vec!["solve", "roof.obj", "--out", "./roof.obj"],
            "roof.obj would replace a file that is read",
        ),
        (vec!["solve", "s.shapeup.json", "--report", "s.shapeup.json"], "a file that is read"),
        (vec!["check", "roof.obj", "--report", "roof.obj"], "a file that is read"),
        (vec!["edit", "roof.obj", "triangles", "--out", "roof.obj"], "a file that is read"),
        (
            vec!["build", "roof.obj", "--report", "x.html", "--report-page", "./x.html"],
            "another file that is written",
        ),
        (
            vec!["build", "roof.obj", "--report-page", "r.pdf"],
            "--report-page writes .html, found `r.pdf`",
        ),
        (vec!["build", "roof.obj", "--report-page", "r"], "--report-page writes .html, found `r`"),
    ] {
        folder.run(&arguments).misused(word);
    }
    assert_eq!(folder.read("roof.obj"), ROOF);
    assert_eq!(folder.read("s.shapeup.json"), roof);
    assert_eq!(folder.files(), ["out.obj", "roof.obj", "s.shapeup.json"]);
}

#[test]
fn a_file_whose_name_is_like_an_option_goes_after_two_dashes() {
    let folder = Folder::new("dashes");
    folder.write("--roof.obj", ROOF);
    folder.run(&["solve", "--panels", "plane", "--", "--roof.obj"]).done();
}

#[test]
fn check_says_what_a_mesh_is_like() {
    let folder = Folder::new("check");
    folder.write("roof.obj", format!("{ROOF}v 9 9 9\nf 1 2\n"));
    let out = folder.run(&["check", "roof.obj", "--report", "r.json"]).done();
    let report = folder.json("r.json");
    for (key, expected) in
        [("vertices", 10), ("edges", 12), ("faces", 4), ("curves", 1), ("components", 1)]
    {
        assert_eq!(report[key], expected, "{key}");
    }
    assert_eq!(report["face_degrees"], serde_json::json!({ "4": 4 }));
    assert_eq!(report["vertex_degrees"], serde_json::json!({ "0": 1, "2": 4, "3": 4, "4": 1 }));
    assert_eq!(report["boundary"], serde_json::json!({ "loops": 1, "edges": 8 }));
    assert!(report["planarity"]["max_distance"].as_f64().unwrap() > 0.01);
    assert!(report["circularity"]["e_c_max"].as_f64().unwrap() > 0.0);
    let problems = report["problems"].as_array().unwrap();
    assert!(problems.iter().any(|problem| problem["line"] == 20), "{problems:?}");
    for words in ["10", "4 of 4", "loops: 1, edges: 8", "planarity", "circularity", "problem: "] {
        assert!(out.contains(words), "expected `{words}` in {out}");
    }
}

/// The form of a parameter value, as README.md describes it.
fn form_of(value: &Value) -> Value {
    match value {
        Value::Null => "nothing".into(),
        Value::Number(_) => "number".into(),
        Value::String(word) => serde_json::json!({ "word": word }),
        Value::Array(numbers) if numbers.len() == 2 => "range".into(),
        Value::Array(numbers) if numbers.len() == 3 => "vector".into(),
        other => panic!("{other} has no form"),
    }
}

#[test]
fn a_mesh_is_flattened_with_its_texture_coordinates() {
    let folder = Folder::new("parametrize");
    folder.write("roof.obj", format!("# units: ft\n# up: y\n{ROOF}"));
    let out =
        folder.run(&["parametrize", "roof.obj", "--out", "uv.obj", "--report", "r.json"]).done();
    assert!(out.contains("quasi-conformal"), "{out}");
    let report = folder.json("r.json");
    assert!(report["eigenvalue"].as_f64().unwrap() >= 0.0);
    let error = &report["quasi_conformal"];
    assert!(error["max"].as_f64().unwrap() >= error["mean"].as_f64().unwrap());
    assert!(error["mean"].as_f64().unwrap() >= 1.0);
    assert_eq!(report["flipped"], 0);
    assert!(report["seconds"]["total"].as_f64().unwrap() > 0.0);
    let text = folder.read("uv.obj");
    assert!(text.starts_with("# units: ft\n# up: y\nv "), "{text}");
    let mesh = shape_up::mesh::read("uv.obj", text.as_bytes()).unwrap().mesh;
    let count = |statement: &str| text.lines().filter(|line| line.starts_with(statement)).count();
    assert_eq!(count("vt "), mesh.positions.len());
    assert!(text.lines().filter(|line| line.starts_with("f ")).all(|line| line.contains('/')));
}

#[test]
fn a_mesh_is_refined_and_solved_at_every_level() {
    let folder = Folder::new("refine");
    folder.write("roof.obj", ROOF);
    let count = |file: &str| {
        let mesh = shape_up::mesh::read(file, folder.read(file).as_bytes()).unwrap().mesh;
        (mesh.positions.len(), mesh.faces.len())
    };
    let (vertices, faces) = count("roof.obj");
    folder.run(&["refine", "roof.obj", "--scheme", "linear", "--out", "fine.obj"]).done();
    let (fine_vertices, fine_faces) = count("fine.obj");
    assert!(fine_vertices > vertices && fine_faces > faces);
    let asked = ["refine", "roof.obj", "--panels", "plane", "--levels", "2"];
    let out = [&asked[..], &["--out", "fine.json", "--report", "r.json"]].concat();
    folder.run(&out).done();
    let report = folder.json("r.json");
    let levels = report["levels"].as_array().unwrap();
    assert_eq!(levels.len(), 3);
    assert_eq!(levels[1]["faces"], fine_faces);
    assert_eq!(levels[2]["faces"], report["report"]["faces"]);
    // The written scene opens with the same energy.
    folder.run(&["solve", "fine.json", "--iterations", "0", "--report", "again.json"]).done();
    let total = |json: &Value| json["energy"]["final"]["total"].as_f64().unwrap();
    let (again, last) = (total(&folder.json("again.json")), total(&report["report"]));
    assert!((again - last).abs() <= 1e-9 * last, "{again} {last}");
    // If each level is the original of the next, the last one has hardly moved from it.
    folder.run(&[&asked[..], &["--adopt", "--report", "adopt.json"]].concat()).done();
    let moved = |file: &str| folder.json(file)["levels"][2]["verdict"]["moved"]["max"].as_f64();
    assert!(2.0 * moved("adopt.json").unwrap() < moved("r.json").unwrap());
    // The first level was solved with what a search had chosen for other panels.
    let of_attempt = r#""closeness": { "to": "surface", "boundary": { "corners": 45 } },
        "attempt": { "on_surface": true, "holds_boundary": true, "smoother": 100 }"#;
    let levels = [("100", of_attempt), ("1", r#""closeness": { "to": "rest" }"#)].map(|scenes| {
        let weights =
            format!(r#""weights": {{ "shape": 10, "close": 1, "smooth": {} }}"#, scenes.0);
        folder.write("s.json", scene(&format!(", {weights}, {}", scenes.1)));
        folder.run(&["refine", "s.json", "--panels", "plane", "--report", "r.json"]).done();
        let mut levels = folder.json("r.json")["levels"].clone();
        levels.as_array_mut().unwrap().iter_mut().for_each(|level| level["seconds"] = 0.into());
        levels
    });
    assert_eq!(levels[0], levels[1]);
    // Triangles are no panels, but the quads of the levels are.
    folder.run(&["edit", "roof.obj", "triangles", "--out", "tri.obj"]).done();
    let triangles = ["refine", "tri.obj", "--panels", "plane"];
    folder.run(&[&triangles[..], &["--report", "r.json"]].concat()).done();
    let levels = &folder.json("r.json")["levels"];
    assert_eq!((&levels[0]["verdict"], &levels[1]["faces"]), (&Value::Null, &24.into()));
    assert_eq!(levels[1]["verdict"]["of"], 24);
    let loops = folder.run(&[&triangles[..], &["--scheme", "loop"]].concat());
    loops.refused(&["tri.obj: --panels: All panels are triangles"]);
    folder.run(&["refine", "roof.obj", "--levels", "9"]).refused(&["1 to 6"]);
    let levels = |levels| ["refine", "roof.obj", "--panels", "plane", "--levels", levels];
    folder.run(&levels("9")).refused(&["1 to 6"]);
    for wrong in ["0", "x"] {
        folder.run(&levels(wrong)).misused("--levels takes a whole number from 1, found `");
    }
}

#[test]
fn operators_are_listed_with_their_parameters() {
    let out = Folder::new("operators").run(&["operators"]).done();
    let kinds: Value = serde_json::from_str(&out).unwrap();
    let ids: Vec<_> =
        kinds.as_array().unwrap().iter().map(|kind| kind["id"].as_str().unwrap()).collect();
    let known: Vec<_> = shape_up::constraint::KINDS.iter().map(|info| info.id).collect();
    assert_eq!(ids, known);
    for kind in kinds.as_array().unwrap() {
        for key in
            ["label", "summary", "paper", "arity", "centring", "elements", "exact", "measure"]
        {
            assert!(kind.get(key).is_some(), "{kind}");
        }
        for param in kind["params"].as_array().unwrap() {
            let mut found = keys(param);
            found.retain(|key| *key != "labels");
            assert_eq!(found, ["default", "forms", "id", "label", "range", "unit"]);
            let forms = param["forms"].as_array().unwrap();
            // Only words have names of their own on the page.
            for named in param.get("labels").and_then(Value::as_array).into_iter().flatten() {
                assert!(named[1].is_string() && forms.contains(&json!({ "word": named[0] })));
            }
            assert!(forms.contains(&form_of(&param["default"])), "{param}");
            let shown = forms.iter().all(|form| match form {
                Value::String(name) => ["number", "range", "vector", "nothing"].contains(&&**name),
                form => keys(form) == ["word"] && form["word"].is_string(),
            });
            assert!(shown, "{param}");
            let range = param["range"].as_array().unwrap();
            assert!(range.len() == 2 && range.iter().all(|end| end.is_null() || end.is_number()));
        }
    }
}

#[test]
fn examples_are_written_and_can_be_solved() {
    let folder = Folder::new("examples");
    let listed = folder.run(&["examples"]).done();
    assert!(folder.files().is_empty(), "listing writes nothing");
    folder.run(&["examples", "--out", "a/b"]).done();
    let index: Value = serde_json::from_str(&folder.read("a/b/index.json")).unwrap();
    for entry in index.as_array().unwrap() {
        let texts = ["id", "mesh", "scene", "statement", "summary", "title"];
        assert!(texts.iter().all(|key| entry[key].is_string()), "{entry}");
        assert!(["vertices", "faces", "tets"].iter().all(|key| entry[key].is_u64()), "{entry}");
        assert_eq!(entry["weights"].as_array().map(Vec::len), Some(3), "{entry}");
        assert!(entry["kinds"].is_array(), "{entry}");
        let of_figure = entry["id"].as_str().is_some_and(|id| id.starts_with("fig-"));
        assert_eq!(entry["figure"].is_u64(), of_figure, "{entry}");
        assert!(listed.contains(entry["id"].as_str().unwrap()), "{listed}");
        let scene = Path::new("a/b").join(entry["scene"].as_str().unwrap());
        let scene = scene.to_str().unwrap();
        folder.run(&["solve", scene, "--iterations", "20", "--report", "r.json"]).done();
        let energy = &folder.json("r.json")["energy"];
        let [initial, reached] =
            ["initial", "final"].map(|when| energy[when]["total"].as_f64().unwrap());
        // Without constraints the shape stays.
        let asks = entry["kinds"].as_array().is_some_and(|kinds| !kinds.is_empty());
        assert!(if asks { reached < initial } else { reached == initial }, "{entry}");
        let mesh = Path::new("a/b").join(entry["mesh"].as_str().unwrap());
        let out = folder.run(&["check", mesh.to_str().unwrap()]).done();
        assert!(!out.contains("problem: "), "{out}");
    }
    assert_eq!(index[0]["id"], "canopy");
    assert!(Path::new(&folder.0).join("a/b/canopy.shapeup.json").exists());
}
