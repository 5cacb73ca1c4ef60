//! `shape-up new`.

use super::folder::Folder;
use shape_up::generate::NEW_KINDS;
use shape_up::scene::{UnitsAndUp, Up};
use std::io::Write as _;
use std::process::{Command, Stdio};

#[test]
fn a_new_mesh_is_written_with_its_unit_and_can_be_checked() {
    let folder = Folder::new("new");
    let out = folder.run(&[
        "new",
        "barrel",
        "--span",
        "9",
        "--along=4",
        "--across",
        "3",
        "--out",
        "b.obj",
    ]);
    assert_eq!(out.done(), "b.obj: 20 vertices, 12 faces\n");
    assert!(String::from_utf8_lossy(folder.read("b.obj").as_bytes()).contains("units: m"));
    folder.run(&["check", "b.obj"]).done();
    folder.run(&["new", "tube", "--units", "metres"]).misused("--units takes m or cm");
    folder.run(&["new", "tube", "--wide", "1"]).misused(", --units, --out, found `--wide`");
    let printed = folder.run(&["new", "tube", "--units", "mm"]).done();
    assert!(printed.contains("units: mm") && printed.contains("\nf "), "{printed}");
    folder.run(&["new", "barrel", "--out", "b.ply"]).done();
    assert!(std::fs::read(folder.0.join("b.ply")).unwrap().starts_with(b"ply\n"));
    folder.run(&["new", "barrel", "--out", "b.off"]).misused("--out writes .obj, .mesh");
}

#[test]
fn every_new_mesh_is_opened_as_it_was_made_with_z_up() {
    let folder = Folder::new("new-up");
    for kind in NEW_KINDS {
        for ending in ["obj", "ply"] {
            let file = format!("new.{ending}");
            folder.run(&["new", kind.id, "--out", &file]).done();
            let bytes = std::fs::read(folder.0.join(&file)).unwrap();
            let read = shape_up::mesh::read(&file, &bytes).unwrap();
            let stated = UnitsAndUp::stated(&bytes).up;
            let up = stated.unwrap_or_else(|| UnitsAndUp::guess_up(&read.mesh));
            assert_eq!(up, Up::Z, "{} lies on its side", kind.id);
        }
    }
}

#[test]
fn a_roof_over_a_drawn_plan_becomes_circular_panels() {
    let folder = Folder::new("new-plan");
    folder.write(
        "plan.json",
        r#"{
            "outline": [
                {"at": [0, 0], "bulge": 0.2, "corner": true}, {"at": [20, 0], "corner": true},
                {"at": [20, 12], "corner": true}, {"at": [0, 12], "corner": true}
            ],
            "layout": "follow", "size": 1.25, "height": 5, "stands": "corners"
        }"#,
    );
    let made = folder.run(&["new", "plan", "plan.json", "--out", "roof.obj"]).done();
    assert_eq!(made, "roof.obj: 187 vertices, 160 faces\n");
    assert!(folder.read("roof.obj").contains("# units: m"));
    let solve =
        ["solve", "roof.obj", "--panels", "circle", "--within", "0.02", "--out", "done.obj"];
    let solved = folder.run(&solve).done();
    assert!(solved.contains("hard constraints met"), "{solved}");
    folder.write("wrong.json", r#"{"outline": [], "layout": "cut", "size": 1, "height": 1}"#);
    folder.run(&["new", "plan", "wrong.json"]).refused(&["wrong.json", "stands"]);
    folder
        .run(&["new", "plan", "none.json"])
        .refused(&["none.json: cannot be read", "expected a plan"]);
    folder.run(&["new", "plan"]).misused("new plan needs the file of a plan");
}

#[test]
fn a_surface_between_curves_keeps_the_unit_and_the_up_axis_of_their_file() {
    let folder = Folder::new("new-span-unit");
    let points = "v 0 0 0\nv 900 0 0\nv 900 0 700\nv 0 0 700\nl 1 2 3 4 1\n";
    folder.write("curve.obj", "# units: mm\n# up: y\n".to_owned() + points);
    let head = |arguments: &[&str]| {
        let printed = folder.run(&[&["new", "fill"], arguments].concat()).done();
        printed.lines().take_while(|line| line.starts_with('#')).collect::<Vec<_>>().join("\n")
    };
    assert_eq!(head(&["curve.obj"]), "# units: mm\n# up: y");
    assert_eq!(head(&["curve.obj", "--units", "cm"]), "# units: cm\n# up: y");
    folder.write("bare.obj", points);
    assert_eq!(head(&["bare.obj"]), "", "the file does not say");
}

#[test]
fn the_curves_may_come_through_a_pipe() {
    let points = b"v 0 0 0\nv 9 0 0\nv 9 7 0\nv 0 7 0\nl 1 2 3 4 1\n";
    let mut program = Command::new(env!("CARGO_BIN_EXE_shape-up"));
    program.args(["new", "fill", "/dev/stdin"]).stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut running = program.spawn().unwrap();
    // The pipe is closed at the end of the statement.
    running.stdin.take().unwrap().write_all(points).unwrap();
    let ended = running.wait_with_output().unwrap();
    assert!(ended.status.success());
    assert!(String::from_utf8_lossy(&ended.stdout).contains("\nf "), "it was read once");
}

#[test]
fn a_loft_between_two_curves_and_a_filled_boundary_are_made_from_files() {
    let folder = Folder::new("new-span");
    folder.write(
        "curves.obj",
        "v 0 0 0\nv 6 0 2\nv 12 0 0\nv 0 9 0\nv 6 9 4\nv 9 9 3\nv 12 9 0\nl 1 2 3\nl 7 6 5 4\n",
    );
    let loft = ["new", "loft", "curves.obj", "--size", "1.5", "--out", "loft.obj"];
    assert_eq!(folder.run(&loft).done(), "loft.obj: 70 vertices, 54 faces\n");
    folder.run(&["check", "loft.obj"]).done();
    // Filling the boundary of the new mesh: its four corners are the corners of the curves.
    let fill = ["new", "fill", "loft.obj", "--size=1.5", "--out", "fill.obj"];
    let filled = folder.run(&fill).done();
    assert!(filled.starts_with("fill.obj: ") && filled.ends_with(" faces\n"), "{filled}");
    folder.run(&["new", "fill", "curves.obj"]).refused(&["curves.obj", "closed curve"]);
    folder.run(&["new", "loft", "loft.obj"]).refused(&["loft.obj", "there is no curve 1"]);
    folder
        .run(&["new", "loft", "curves.obj", "--curves", "0"])
        .misused("--curves needs 2 numbers, found `0`");
    folder.run(&["new", "fill"]).misused("new fill needs a file with curves or faces");
}
