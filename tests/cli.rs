//! The command line, run as its users run it: what it writes, how it ends, and what it says.

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A folder of one test's own, removed at its end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Folder {
        let path = std::env::temp_dir().join(format!("shape-up-cli-{name}-{}", std::process::id()));
        let _ = std::fs::remove_dir_all(&path);
        std::fs::create_dir_all(&path).unwrap();
        Folder(path)
    }

    fn write(&self, name: &str, text: impl AsRef<[u8]>) -> &Folder {
        std::fs::write(self.0.join(name), text).unwrap();
        self
    }

    fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.0.join(name)).unwrap()
    }

    fn json(&self, name: &str) -> Value {
        serde_json::from_str(&self.read(name)).unwrap()
    }

    /// Names of the files in it, hidden ones included.
    fn files(&self) -> Vec<String> {
        let entries = std::fs::read_dir(&self.0).unwrap();
        let mut names: Vec<_> =
            entries.map(|e| e.unwrap().file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    fn run(&self, arguments: &[&str]) -> Ended {
        let output = Command::new(env!("CARGO_BIN_EXE_shape-up"))
            .args(arguments)
            .current_dir(&self.0)
            .output()
            .unwrap();
        Ended {
            code: output.status.code(),
            out: String::from_utf8(output.stdout).unwrap(),
            err: String::from_utf8(output.stderr).unwrap(),
        }
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

#[derive(Debug)]
struct Ended {
    code: Option<i32>,
    out: String,
    err: String,
}

impl Ended {
    #[track_caller]
    fn done(self) -> String {
        assert_eq!((self.code, self.err.as_str()), (Some(0), ""), "{}", self.out);
        self.out
    }

    /// The input is at fault: one line on standard error with these words, and nothing else.
    #[track_caller]
    fn refused(self, words: &[&str]) {
        assert_eq!(self.code, Some(1), "{self:?}");
        assert_eq!(self.out, "", "{self:?}");
        assert_eq!(self.err.lines().count(), 1, "{self:?}");
        for word in words {
            assert!(self.err.contains(word), "expected `{word}` in {:?}", self.err);
        }
    }

    #[track_caller]
    fn misused(self, word: &str) {
        assert_eq!((self.code, self.out.as_str()), (Some(2), ""), "{self:?}");
        let first = self.err.lines().next().unwrap();
        assert!(first.contains(word), "expected `{word}` in {first:?}");
        assert!(self.err.contains("usage: shape-up solve"), "{self:?}");
    }
}

/// Four bent quads with everything that must come out as it went in: a group of two words, a
/// polyline, names of its own, and positions that no short decimal gives.
const ROOF: &str = "\
o roof
v 0 0 0
v 1 0 0.1
v 2 0 0
v 0 1 0.30000000000000004
v 1.1 1 0.7
v 2 1 0.2
v 0 2 0
v 1 2 0.1
v 2 2 -0.3
g left shared
f 1 2 5 4
f 4 5 8 7
g right
usemtl glass
f 2 3 6 5
f 5 6 9 8
l 1 2 3
";

fn scene(rest: &str) -> String {
    format!(
        r#"{{ "format": "shape-up-scene", "version": 1, "units": "m", "mesh": {{ "file": "roof.obj" }}{rest} }}"#
    )
}

const PLANES: &str = r#", "constraints": [{ "kind": "plane", "on": "faces" }]"#;

#[test]
fn a_mesh_is_solved_and_comes_out_in_its_order() {
    let folder = Folder::new("order");
    folder.write("roof.obj", ROOF);
    let out = folder.run(&["solve", "roof.obj", "--circle", "--out", "out.obj"]).done();
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
    folder.run(&["solve", "roof.obj", "--plane", "--iterations=0", "--out=out.obj"]).done();
    let read = |name: &str| shape_up::mesh::read(name, folder.read(name).as_bytes()).unwrap().mesh;
    assert_eq!(read("out.obj"), read("roof.obj"));
}

fn keys(value: &Value) -> Vec<&str> {
    value.as_object().unwrap().keys().map(String::as_str).collect()
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
    assert_eq!(keys(&report["seconds"]), ["assemble", "factor", "iterate", "load", "order"]);
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

    for words in ["energy total", "stopped by", "planarity   worst", " m, mean", "pinned"] {
        assert!(out.contains(words), "expected `{words}` in {out}");
    }
    assert_eq!(out.lines().filter(|line| line.starts_with("iteration ")).count(), trace.len());
}

#[test]
fn without_trace_the_report_has_none() {
    let folder = Folder::new("untraced");
    folder.write("roof.obj", ROOF);
    folder.run(&["solve", "roof.obj", "--plane", "--report", "r.json"]).done();
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
    let report = solve(&["--sphere"]);
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

/// A scene that is at fault, and words of the one line that says so.
#[rustfmt::skip]
const FAULTY: &[(&str, &[&str])] = &[
    ("", &["s.json: ", "empty"]),
    ("{ \"format\": }", &["s.json: line 1, column 13"]),
    ("[1, 2]", &["s.json: ", "expected a scene"]),
    (r#"{ "format": "shape-up-scene", "version": 9 }"#, &["s.json: version: ", "version 9"]),
    (r#"{ "format": "shape-up-scene", "version": 1, "mesh": { "file": "gone.obj" } }"#, &["s.json: mesh.file: ", "gone.obj"]),
    (r#"{ "format": "shape-up-scene", "version": 1, "mesh": { "file": "empty.obj" } }"#, &["empty.obj: ", "empty"]),
    (r#", "constraints": [{ "kind": "circel", "on": "faces" }]"#, &["s.json: constraints[0].kind: ", "circle"]),
    (r#", "constraints": [{ "kind": "plane", "on": { "set": "eavs" } }], "sets": { "eaves": { "vertices": "0-3" } }"#, &["s.json: constraints[0].on.set: ", "eavs", "eaves, glass"]),
    (r#", "constraints": [{ "kind": "plane", "on": "tets" }]"#, &["s.json: constraints[0].on: "]),
    (r#", "constraints": [{ "kind": "plane", "on": { "vertices": "0-1" } }]"#, &["s.json: constraints[0].on: "]),
    (r#", "handles": [{ "vertices": [9], "fixed": true }]"#, &["s.json: handles[0].vertices[0]: ", "vertex 9", "9, counted from 0"]),
    (r#", "weights": { "smooth": -2 }"#, &["s.json: weights.smooth: ", "-2"]),
    (r#", "smoothness": { "weighting": "cotangent" }"#, &["s.json: smoothness.weighting: ", "triangle"]),
    (r#", "solver": { "threads": 4 }"#, &["s.json: solver: ", "threads"]),
];

#[test]
fn a_faulty_scene_is_one_line_and_no_file() {
    let folder = Folder::new("faulty");
    folder.write("roof.obj", ROOF).write("empty.obj", "");
    for (text, words) in FAULTY {
        let text = if text.starts_with(',') { scene(text) } else { (*text).to_owned() };
        folder.write("s.json", text);
        folder.run(&["solve", "s.json", "--out", "out.obj", "--report", "r.json"]).refused(words);
        assert_eq!(folder.files(), ["empty.obj", "roof.obj", "s.json"]);
    }
    folder.write("s.json", b"\xff\xfe\x00\xd8");
    folder.run(&["solve", "s.json"]).refused(&["s.json: ", "UTF-8"]);
}

#[test]
fn a_faulty_mesh_is_one_line_with_its_place() {
    let folder = Folder::new("mesh");
    folder
        .write("empty.obj", "")
        .write("cut.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n")
        .write("note.txt", "hello\n");
    for file in ["empty.obj", "cut.off", "note.txt", "gone.obj"] {
        for command in [
            vec!["solve", file, "--plane", "--out", "out.obj"],
            vec!["check", file, "--report", "out.json"],
        ] {
            folder.run(&command).refused(&[file]);
        }
    }
    folder.run(&["solve", ".", "--plane"]).refused(&["."]);
    assert_eq!(folder.files(), ["cut.off", "empty.obj", "note.txt"]);
}

#[test]
fn a_kind_that_fits_no_face_names_its_flag() {
    let folder = Folder::new("fits");
    folder.write("curve.obj", "v 0 0 0\nv 1 0 0\nv 2 1 0\nl 1 2 3\n");
    folder.run(&["solve", "curve.obj", "--plane"]).refused(&["curve.obj: --plane: "]);
}

#[test]
fn a_place_that_cannot_be_written_is_one_line_and_leaves_nothing() {
    let folder = Folder::new("unwritable");
    folder.write("roof.obj", ROOF);
    std::fs::create_dir(folder.0.join("taken")).unwrap();
    for (out, report) in [
        ("gone/out.obj", "r.json"),
        ("out.obj", "gone/r.json"),
        ("taken", "r.json"),
        ("out.obj", "taken"),
    ] {
        folder
            .run(&["solve", "roof.obj", "--plane", "--out", out, "--report", report])
            .refused(&["cannot be written"]);
        assert_eq!(folder.files(), ["roof.obj", "taken"], "{out} {report}");
    }
    folder.run(&["examples", "--out", "roof.obj"]).refused(&["roof.obj"]);
    assert_eq!(folder.read("roof.obj"), ROOF);
}

#[test]
fn an_output_replaces_the_file_of_its_name_even_the_input() {
    let folder = Folder::new("replace");
    folder.write("roof.obj", ROOF);
    folder.run(&["solve", "roof.obj", "--plane", "--out", "roof.obj"]).done();
    assert_ne!(folder.read("roof.obj"), ROOF);
    assert_eq!(folder.files(), ["roof.obj"]);
}

#[test]
fn a_wrong_call_says_how_it_is_called() {
    let folder = Folder::new("usage");
    folder.write("roof.obj", ROOF);
    for (arguments, word) in [
        (vec![], "expected a command"),
        (vec!["sovle"], "`sovle`"),
        (vec!["solve"], "needs a scene or a mesh"),
        (vec!["solve", "roof.obj"], "--plane"),
        (vec!["solve", "roof.obj", "roof.obj"], "second"),
        (vec!["solve", "roof.obj", "--plain"], "`--plain`"),
        (vec!["solve", "roof.obj", "-o", "x.obj"], "`-o`"),
        (vec!["solve", "roof.obj", "--plane", "--plane"], "twice"),
        (vec!["solve", "roof.obj", "--plane=1"], "no value"),
        (vec!["solve", "roof.obj", "--plane", "--out"], "--out needs a value"),
        (vec!["solve", "roof.obj", "--plane", "--out", "--trace"], "--out needs a value"),
        (vec!["solve", "roof.obj", "--plane", "--out", "x", "--report", "x"], "same file"),
        (vec!["solve", "roof.obj", "--plane", "--iterations", "-1"], "`-1`"),
        (vec!["solve", "roof.obj", "--plane", "--iterations", "2.5"], "`2.5`"),
        (vec!["solve", "roof.obj", "--plane", "--tolerance", "nan"], "`nan`"),
        (vec!["solve", "roof.obj", "--plane", "--accelerator", "newton"], "quasi-newton"),
        (vec!["check"], "needs a mesh"),
        (vec!["check", "roof.obj", "--out", "x"], "`--out`"),
        (vec!["examples", "canopy"], "`canopy`"),
        (vec!["operators", "--json"], "`--json`"),
        (vec!["parametrize", "roof.obj"], "`parametrize`"),
    ] {
        folder.run(&arguments).misused(word);
    }
    assert_eq!(folder.files(), ["roof.obj"]);
    let help = folder.run(&["--help"]).done();
    for info in shape_up::constraint::KINDS {
        assert!(help.contains(&format!("--{}", info.id)), "{help}");
    }
    assert!(folder.run(&["--version"]).done().starts_with("shape-up "));
}

#[test]
fn a_file_whose_name_is_like_an_option_goes_after_two_dashes() {
    let folder = Folder::new("dashes");
    folder.write("--roof.obj", ROOF);
    folder.run(&["solve", "--plane", "--", "--roof.obj"]).done();
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
    for words in ["10", "4 of 4", "1 loops", "planarity", "circularity", "problem: "] {
        assert!(out.contains(words), "expected `{words}` in {out}");
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
        for key in ["label", "summary", "paper", "arity", "exact", "params"] {
            assert!(kind.get(key).is_some(), "{kind}");
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
        assert_eq!(keys(entry), ["id", "mesh", "scene", "summary", "title"]);
        assert!(listed.contains(entry["id"].as_str().unwrap()), "{listed}");
        let scene = Path::new("a/b").join(entry["scene"].as_str().unwrap());
        let scene = scene.to_str().unwrap();
        folder.run(&["solve", scene, "--iterations", "20", "--report", "r.json"]).done();
        let energy = &folder.json("r.json")["energy"];
        assert!(energy["final"]["total"].as_f64() < energy["initial"]["total"].as_f64());
        let mesh = Path::new("a/b").join(entry["mesh"].as_str().unwrap());
        let out = folder.run(&["check", mesh.to_str().unwrap()]).done();
        assert!(!out.contains("problem: "), "{out}");
    }
    assert_eq!(index[0]["id"], "canopy");
    assert!(Path::new(&folder.0).join("a/b/canopy.shapeup.json").exists());
}
