//! Faults of the input or the call: exit code, one line, no file left.

use crate::cli::folder::{Folder, ROOF, scene};

/// A faulty scene, and words of its one-line message.
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
    (r#", "closeness": { "weights": [{ "on": { "set": "rim" }, "weight": 5 }] }"#, &["s.json: closeness.weights[0].on.set: ", "rim"]),
    (r#", "closeness": { "weights": [{ "on": "tets", "weight": 5 }] }"#, &["s.json: closeness.weights[0].on: ", "nothing is selected"]),
    (r#", "closeness": { "boundary": { "corners": 200 } }"#, &["s.json: closeness.boundary.corners: ", "200", "degrees"]),
    (r#", "current": [[0,0,0],[0,0,0],[0,0,0],[0,0,0],[0,1e60,0],[0,0,0],[0,0,0],[0,0,0],[0,0,0]]"#, &["s.json: current[4]: ", "from -1e50 to 1e50"]),
    (r#", "handles": [{ "vertices": [0], "targets": [[1e200, 0, 0]] }]"#, &["s.json: handles[0].targets[0]: ", "from -1e50 to 1e50"]),
    (r#", "smoothness": { "weighting": "cotangent" }"#, &["s.json: smoothness.weighting: ", "triangle"]),
    (r#", "solver": { "threads": 4 }"#, &["s.json: solver: ", "threads"]),
    (r#", "build": { "kind": 0 }"#, &["s.json: build.kind: found 0, expected a word"]),
    (r#", "build": { "kind": {} }"#, &["s.json: build.kind: found an object, expected a word"]),
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
            vec!["solve", file, "--panels", "plane", "--out", "out.obj"],
            vec!["check", file, "--report", "out.json"],
        ] {
            folder.run(&command).refused(&[file]);
        }
    }
    folder.run(&["solve", ".", "--panels", "plane"]).refused(&["."]);
    assert_eq!(folder.files(), ["cut.off", "empty.obj", "note.txt"]);
}

#[test]
fn a_mesh_that_is_too_large_to_be_measured_is_refused_and_no_report_has_holes() {
    // Squares of such lengths are infinite: energies and measures were not numbers, and null in
    // reports.
    let folder = Folder::new("large");
    folder.write("large.obj", "v 1e200 0 0\nv 0 1e200 0\nv 0 0 1e200\nf 1 2 3\n");
    for command in ["solve", "check", "parametrize"] {
        let words = ["large.obj: mesh: vertex 0 is too far out", "from -1e50 to 1e50"];
        folder.run(&[command, "large.obj", "--report", "r.json"]).refused(&words);
    }
    assert_eq!(folder.files(), ["large.obj"]);
    folder.write("large.obj", "v 1e50 0 0\nv 0 1e50 0\nv 0 0 1e50\nv 1e50 1e50 1e50\nf 1 2 3 4\n");
    for command in [vec!["solve", "--panels", "circle"], vec!["check"]] {
        folder.run(&[&command[..], &["large.obj", "--report", "r.json"]].concat()).done();
        assert!(!folder.read("r.json").contains("null"), "{}", folder.read("r.json"));
    }
}

#[test]
fn a_surface_without_area_is_called_so_when_it_is_flattened() {
    let folder = Folder::new("line");
    folder.write("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    let words =
        ["line.obj: cannot be flattened: the part with vertex 0 has almost no area", "expected"];
    folder.run(&["parametrize", "line.obj", "--out", "uv.obj"]).refused(&words);
}

#[cfg(unix)]
#[test]
fn a_scene_that_names_a_device_as_its_mesh_is_refused_before_it_is_read() {
    // The device has no end: 8 GB of it were read.
    let folder = Folder::new("device");
    let scene = r#"{ "format": "shape-up-scene", "version": 1, "mesh": { "file": "/dev/zero" } }"#;
    folder.write("zero.shapeup.json", scene);
    let words = ["zero.shapeup.json: mesh.file: cannot read /dev/zero: it is not a regular file"];
    folder.run(&["solve", "zero.shapeup.json"]).refused(&words);
}

#[test]
fn a_flat_map_says_what_is_left_out_of_it() {
    let folder = Folder::new("left-out");
    let point = "v 1 1 0\nv 1 1 0\nv 1 1 0\nf 5 6 7\n";
    folder.write("roof.obj", format!("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n{point}f 1 2 3 4\n"));
    let done = folder.run(&["parametrize", "roof.obj", "--report", "r.json"]).done();
    assert!(done.contains("left out         1 face without area"), "{done}");
    assert_eq!(folder.json("r.json")["left_out"], 1);
    // A face and its back: no map is conformal on both, so one is left out.
    folder.write("back.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 3 2 1\n");
    folder.run(&["parametrize", "back.obj", "--report", "r.json"]).done();
    assert_eq!(folder.json("r.json")["left_out"], 1);
}

#[test]
fn a_kind_that_fits_no_face_names_its_flag() {
    let folder = Folder::new("fits");
    folder.write("curve.obj", "v 0 0 0\nv 1 0 0\nv 2 1 0\nl 1 2 3\n");
    folder
        .run(&["solve", "curve.obj", "--panels", "plane"])
        .refused(&["curve.obj: --panels: ", "There are no panels"]);
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
            .run(&["solve", "roof.obj", "--panels", "plane", "--out", out, "--report", report])
            .refused(&["cannot be written"]);
        assert_eq!(folder.files(), ["roof.obj", "taken"], "{out} {report}");
    }
    folder.run(&["examples", "--out", "roof.obj"]).refused(&["roof.obj"]);
    let words = ["canapé: cannot be found, expected a scene file or one of ", "fig-11-strip"];
    folder.run(&["experiment", "canapé"]).refused(&words);
    assert_eq!(folder.read("roof.obj"), ROOF);
}

#[test]
fn a_wrong_call_says_how_it_is_called() {
    let folder = Folder::new("usage");
    folder.write("roof.obj", ROOF);
    for (arguments, word) in [
        (vec![], "expected a command"),
        (vec!["sovle"], "`sovle`"),
        (vec!["solve"], "needs a scene or a mesh"),
        (vec!["solve", ""], "empty"),
        (vec!["solve", "roof.obj", "roof.obj"], "second"),
        (vec!["solve", "roof.obj", "--plain"], "`--plain`"),
        (vec!["solve", "roof.obj", "-o", "x.obj"], "`-o`"),
        (vec!["solve", "roof.obj", "--panels", "plane", "--panels=plane"], "twice"),
        (vec!["solve", "roof.obj", "--trace=1"], "no value"),
        (vec!["solve", "roof.obj", "--panels", "plate"], "plane or circle"),
        (vec!["solve", "roof.obj", "--panels", "plane", "--out"], "--out needs a value"),
        (vec!["solve", "roof.obj", "--panels", "plane", "--out", "--trace"], "--out needs a value"),
        (
            vec!["solve", "roof.obj", "--panels", "plane", "--out", "x", "--report", "x"],
            "another file that is written",
        ),
        (vec!["solve", "roof.obj", "--panels", "plane", "--iterations", "-1"], "`-1`"),
        (vec!["solve", "roof.obj", "--panels", "plane", "--iterations", "2.5"], "`2.5`"),
        (vec!["solve", "roof.obj", "--panels", "plane", "--tolerance", "nan"], "`nan`"),
        (vec!["solve", "roof.obj", "--panels", "plane", "--accelerator", "newton"], "quasi-newton"),
        (vec!["check"], "needs a mesh"),
        (vec!["check", "roof.obj", "--out", "x"], "`--out`"),
        (vec!["check", "roof.shapeup.json"], "check takes a mesh file, or results with --scene"),
        (vec!["examples", "canopy"], "`canopy`"),
        (vec!["experiment", "--csv", "a.csv"], "needs the name of an example"),
        (vec!["experiment", "fig-11-strip", "--seconds", "-1"], "--seconds takes a number from 0"),
        (vec!["operators", "--json"], "`--json`"),
        (vec!["flatten", "roof.obj"], "`flatten`"),
        (vec!["parametrize"], "mesh"),
        (vec!["parametrize", "roof.obj", "--weights", "two"], "inverse-area or one or lscm"),
        (vec!["parametrize", "roof.obj", "--norm", "all"], "boundary or vertices"),
        (vec!["parametrize", "roof.obj", "--trace"], "`--trace`"),
    ] {
        folder.run(&arguments).misused(word);
    }
    assert_eq!(folder.files(), ["roof.obj"]);
    let help = folder.run(&["--help"]).done();
    for info in shape_up::constraint::KINDS {
        assert!(help.contains(&format!(" {}", info.id)), "{help}");
    }
    assert!(help.lines().all(|line| line.len() <= 106), "{help}");
    // In any position; after `--` it is a file name.
    for asked in [&["-h"][..], &["help"], &["solve", "--help"], &["check", "roof.obj", "-h"]] {
        assert_eq!(folder.run(asked).done(), help);
    }
    folder.run(&["check", "--", "--help"]).refused(&["--help: cannot be read"]);
    assert!(folder.run(&["--version"]).done().starts_with("shape-up "));
}
