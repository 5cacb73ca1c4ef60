//! The script for Rhino and Grasshopper, `www/rhino/shape_up.py`, under `CPython` and without Rhino.

use crate::cli::folder::{Ended, Folder};
use serde_json::Value;
use shape_up::mesh::{Measures, Point, Ragged};
use std::io::ErrorKind;
use std::path::Path;
use std::process::Command;

/// Quads along a side of the grid.
const SIDE: u32 = 6;

/// A bumpy grid of quads: its vertices, most without a short decimal form, and its faces.
fn grid() -> (Vec<Point>, Vec<[u32; 4]>) {
    let line = 0..=SIDE;
    let places = line.clone().flat_map(|j| line.clone().map(move |i| [i, j].map(f64::from)));
    let height = |[x, y]: [f64; 2]| 0.03 * (x * x - 0.7 * y * y) + x * y / 90.0;
    let points = places.map(|[x, y]| [x / 3.0, y / 3.0, height([x, y])]).collect();
    let corner = |i, j| j * (SIDE + 1) + i;
    let quad = |i, j| [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
    let faces = (0..SIDE).flat_map(|j| (0..SIDE).map(move |i| quad(i, j))).collect();
    (points, faces)
}

fn obj((points, faces): &(Vec<Point>, Vec<[u32; 4]>)) -> String {
    let vertices = points.iter().map(|[x, y, z]| format!("v {x} {y} {z}\n"));
    let faces = faces.iter().map(|face| {
        let [a, b, c, d] = face.map(|vertex| vertex + 1);
        format!("f {a} {b} {c} {d}\n")
    });
    ["# units: m\n".to_owned()].into_iter().chain(vertices).chain(faces).collect()
}

/// The file of the script.
fn script() -> String {
    format!("{}/www/rhino/shape_up.py", env!("CARGO_MANIFEST_DIR"))
}

/// Runs Python in the folder, with the built program on the path and the module where it is found; none
/// without Python.
fn python(folder: &Folder, arguments: &[&str]) -> Option<Ended> {
    let beside = |file: &str| Path::new(file).parent().unwrap().to_owned();
    let path = std::env::var_os("PATH").unwrap_or_default();
    let program = beside(env!("CARGO_BIN_EXE_shape-up"));
    let path = std::env::join_paths([program].into_iter().chain(std::env::split_paths(&path)));
    let output = Command::new("python3")
        // It writes nothing beside the script.
        .arg("-B")
        .args(arguments)
        .env("PATH", path.unwrap())
        .env("PYTHONPATH", beside(&script()))
        .current_dir(&folder.0)
        .output();
    let output = match output {
        Err(error) if error.kind() == ErrorKind::NotFound => {
            println!("skipped: there is no python3 on the path");
            return None;
        }
        output => output.unwrap(),
    };
    Some(Ended {
        code: output.status.code(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    })
}

/// Solves the mesh in `mesh.json`, and prints what comes back.
const SOLVE: &str = "
import json, shape_up
vertices, faces = json.load(open('mesh.json'))
solved, report = shape_up.solve(vertices, faces, units='m')
print(json.dumps([solved, report]))
";

#[test]
fn a_mesh_of_python_comes_back_with_circular_panels_and_the_verdict() {
    let folder = Folder::new("rhino-mesh");
    let (points, faces) = grid();
    folder.write("mesh.json", serde_json::to_string(&(&points, &faces)).unwrap());
    let Some(ended) = python(&folder, &["-c", SOLVE]) else { return };
    let (solved, report): (Vec<Point>, Value) = serde_json::from_str(&ended.done()).unwrap();
    assert_eq!(solved.len(), points.len());
    assert_ne!(solved, points);
    let verdict = &report["verdict"];
    assert_eq!((verdict["kind"].as_str(), &verdict["of"]), (Some("circle"), &faces.len().into()));
    let tolerance = verdict["tolerance"].as_f64().unwrap();
    let faces: Ragged = faces.iter().collect();
    let worst = Measures::new(&solved, &faces, 0.0).circularity.max_distance;
    assert!(worst <= tolerance * 1.000_001, "{worst} {tolerance}");
    assert!(Measures::new(&points, &faces, 0.0).circularity.max_distance > 5.0 * tolerance);
    assert_eq!(folder.files(), ["mesh.json"]);

    // What the program writes of the same mesh, digit for digit.
    folder.write("roof.obj", obj(&grid()));
    folder
        .run(&["solve", "roof.obj", "--panels", "circle", "--within", "auto", "--out=o.obj"])
        .done();
    let read = shape_up::mesh::read("o.obj", folder.read("o.obj").as_bytes()).unwrap().mesh;
    assert_eq!(read.positions, solved);
}

#[test]
fn a_file_is_solved_and_the_verdict_printed() {
    let folder = Folder::new("rhino-file");
    // Its names come back.
    folder.write("roof.obj", obj(&grid()).replacen("\nf ", "\ng north\nf ", 1));
    let Some(ended) = python(&folder, &[&script(), "roof.obj", "out.obj"]) else { return };
    let out = ended.done();
    let press = ["--panels", "circle", "--within", "auto", "--out", "o.obj", "--report", "r.json"];
    folder.run(&[&["solve", "roof.obj"][..], &press].concat()).done();
    assert_eq!(out.trim_end(), folder.json("r.json")["verdict"]["words"].as_str().unwrap());
    assert!(out.contains("All 36 panels are circular within "), "{out}");
    assert_eq!(folder.read("out.obj"), folder.read("o.obj"));
    assert!(folder.read("out.obj").contains("\ng north\n"));
}

/// Prints the message of each refusal on a line.
const REFUSED: &str = "
import shape_up
square = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2, 3)]
for wrong in (
    lambda: shape_up.solve_file('none.obj', 'out.obj'),
    lambda: shape_up.solve(square[0], []),
    lambda: shape_up.solve(*square, panels='round'),
    lambda: shape_up.solve(*square, program='not-shape-up'),
):
    try:
        print('not refused', wrong())
    except (RuntimeError, OSError) as error:
        print(error)
";

#[test]
fn what_is_refused_is_an_exception_with_the_words_of_the_program() {
    let folder = Folder::new("rhino-refused");
    let Some(ended) = python(&folder, &["-c", REFUSED]) else { return };
    let out = ended.done();
    let said: Vec<&str> = out.lines().collect();
    let expected =
        ["none.obj: cannot be read: ", "There are no panels.", "--panels takes ", "not-shape-up"];
    assert_eq!(said.len(), expected.len(), "{out}");
    for (said, words) in said.iter().zip(expected) {
        assert!(said.contains(words), "expected `{words}` in {said}");
    }

    // As a script: one line, and an exit code.
    let Some(ended) = python(&folder, &[&script(), "none.obj", "out.obj"]) else { return };
    ended.refused(&["none.obj: cannot be read: "]);
    assert_eq!(folder.files().len(), 0);
}
