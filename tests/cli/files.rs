//! Files as they come: open seams, coordinates that are no numbers, faces with holes, PLY and STL.

use crate::cli::folder::{Folder, ROOF};
use shape_up::mesh::{FileFormat, read};

/// Two patches of 3 by 6 quads side by side, bent, with vertices of their own along the seam.
fn patches() -> String {
    let (mut vertices, mut faces) = (String::new(), String::new());
    for patch in 0..2 {
        let first = 1 + patch * 28;
        for i in 0..4 {
            for j in 0..7 {
                let [x, y] = [f64::from(patch * 3 + i), f64::from(j)];
                let z = 0.15 * x * (6.0 - x) + 0.1 * y * (3.0 - y) + 0.06 * x * y;
                vertices += &format!("v {x} {y} {z}\n");
                if i < 3 && j < 6 {
                    let a = first + i * 7 + j;
                    faces += &format!("f {a} {} {} {}\n", a + 7, a + 8, a + 1);
                }
            }
        }
    }
    vertices + &faces
}

#[test]
fn an_open_seam_is_named_and_can_be_joined_and_the_verdict_says_if_it_opens() {
    let folder = Folder::new("seam");
    folder.write("patches.obj", patches());
    let said = "problem: 7 boundary vertices that lie on others without being joined to them: the \
                seam can open, first at line 29";
    let out = folder.run(&["check", "patches.obj"]).done();
    assert!(out.contains(said) && !out.contains("exactly on an earlier one"), "{out}");
    let press = ["--panels", "plane", "--within", "auto", "--report", "r.json"];
    let out = folder.run(&[&["solve", "patches.obj"][..], &press].concat()).done();
    assert!(out.contains("A seam opened by ") && out.contains("but are not joined"), "{out}");
    let verdict = &folder.json("r.json")["verdict"];
    assert_ne!(verdict["level"], "good");

    let out = folder.run(&["edit", "patches.obj", "join", "--out", "joined.obj"]).done();
    assert!(out.contains("49 vertices"), "{out}");
    let out = folder.run(&["check", "joined.obj"]).done();
    assert!(out.contains("boundary    loops: 1") && !out.contains("problem"), "{out}");
    let out = folder.run(&[&["solve", "joined.obj"][..], &press].concat()).done();
    assert!(!out.contains("seam"), "{out}");
    folder.run(&["edit", "joined.obj", "join"]).refused(&["lie on each other"]);
}

#[test]
fn what_is_reported_of_welded_vertices_is_true_of_the_written_file() {
    // Quads with corners of their own that differ in late digits.
    let folder = Folder::new("digits");
    let (mut vertices, mut faces) = (String::new(), String::new());
    for k in 0..9 {
        let late = f64::from(k) * 1e-7;
        let [i, j] = [f64::from(k % 3), f64::from(k / 3)];
        for (x, y) in [(i, j), (i + 1.0, j), (i + 1.0, j + 1.0), (i, j + 1.0)] {
            vertices += &format!("v {} {y} {}\n", x + late, 0.2 * x * y * (x - y) + late);
        }
        let a = 4 * k + 1;
        faces += &format!("f {a} {} {} {}\n", a + 1, a + 2, a + 3);
    }
    folder.write("soup.obj", vertices + &faces);
    let solve = ["solve", "soup.obj", "--panels", "plane", "--exact"];
    folder.run(&[&solve[..], &["--out", "o.obj", "--report", "r.json"]].concat()).done();
    folder.run(&["check", "o.obj", "--report", "c.json"]).done();
    let [solved, checked] = ["r.json", "c.json"].map(|name| {
        let report = folder.json(name);
        report["planarity"]["max_distance"].as_f64().unwrap()
    });
    assert!(solved < 1e-12 && checked < 1e-12, "{solved} {checked}");
}

const BROKEN: &str = "v 0 0 0\nv 1 0 0\nv 1 x 0\nv 0 1 0\nv -1 0 0\nv -1 1 0\nv -2 0 0\nv -2 1 0\n\
    f 1 2 3 4\nf 5 1 4 6\nf 7 5 6 8\n";

#[test]
fn nothing_is_built_of_a_coordinate_that_is_no_number() {
    let folder = Folder::new("guessed");
    folder.write("roof.obj", BROKEN);
    let out = folder.run(&["check", "roof.obj"]).done();
    assert!(out.contains("1 vertex with a coordinate that is not a number"), "{out}");
    let why = "a coordinate of vertex 2 in the file is not a number";
    folder.run(&["build", "roof.obj", "--out", "parts"]).refused(&[why, "nothing is built"]);
    // Nor of what is made of the mesh, in a scene or not; but without its faces.
    for (scene, made) in [
        ("a.json", &["edit", "roof.obj", "flip"][..]),
        ("b.json", &["edit", "roof.obj", "triangles"]),
        ("c.json", &["refine", "roof.obj", "--scheme", "linear", "--levels", "2"]),
        ("d.json", &["edit", "roof.obj", "delete", "--faces", "2"]),
    ] {
        folder.run(&[made, &["--out", scene]].concat()).done();
        folder.run(&["build", scene]).refused(&["in the file is not a number"]);
    }
    folder.run(&["edit", "roof.obj", "delete", "--faces", "0", "--out", "whole.json"]).done();
    folder.run(&["build", "whole.json"]).done();
    assert_eq!(folder.files().iter().filter(|name| *name == "parts").count(), 0);
}

#[test]
fn a_guessed_place_is_not_welded() {
    // Quads with corners of their own, of which one has two coordinates that are no numbers.
    let folder = Folder::new("welded-guess");
    let (mut vertices, mut faces) = (String::new(), String::new());
    for k in 0..9 {
        for (x, y) in [(0, 0), (1, 0), (1, 1), (0, 1)] {
            vertices += &match (k, y) {
                (0, 0) => "v nan nan nan\n".to_owned(),
                _ => format!("v {} {} 0\n", k % 3 + x, k / 3 + y),
            };
        }
        let a = 4 * k + 1;
        faces += &format!("f {a} {} {} {}\n", a + 1, a + 2, a + 3);
    }
    folder.write("soup.obj", vertices + &faces);
    let out = folder.run(&["check", "soup.obj"]).done();
    // 15 corners of the grid, and the two guesses, which are at one place.
    assert!(out.contains("19 coincident vertices were welded, and the mesh has 17"), "{out}");
    assert!(!out.contains("seam") && !out.contains("exactly on an earlier one"), "{out}");
}

/// A panel with a hole at the end of a slit, and a bent quad beside it.
const HOLE: &str = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 1 3 0\nv 3 3 0\nv 3 1 0\n\
    v 8 0 0\nv 8 4 1\ng holes\ns 1\nf 1 2 3 4 1 5 6 7 8 5\ng others\nf 2 9 10 3\n";

#[test]
fn a_face_with_a_hole_comes_out_as_it_came_and_one_reason_is_given() {
    let folder = Folder::new("hole");
    folder.write("hole.obj", HOLE);
    let press = ["solve", "hole.obj", "--panels", "plane", "--out", "out.obj"];
    let out = folder.run(&press).done();
    assert!(out.contains("as around a hole: exported unchanged"), "{out}");
    let tail = |text: &str| {
        text.lines().filter(|line| !line.starts_with(['v', '#'])).collect::<Vec<_>>().join("\n")
    };
    assert_eq!(tail(&folder.read("out.obj")), tail(HOLE));
    // In a scene too.
    folder.run(&["edit", "hole.obj", "flip", "--out", "hole.json"]).done();
    folder.run(&["edit", "hole.json", "flip", "--out", "back.obj"]).done();
    assert!(folder.read("back.obj").contains("\nf 1 2 3 4 1 5 6 7 8 5\n"));

    // The faces beside it are deleted, or its corners are merged.
    folder.write("two.obj", format!("{HOLE}v 12 0 0\nv 12 4 1\nf 9 11 12 10\n"));
    folder.run(&["edit", "two.obj", "delete", "--faces", "0", "--out", "left.obj"]).done();
    assert!(folder.read("left.obj").contains("\nf 1 2 3 4 1 5 6 7 8 5\n"));
    let merge = ["edit", "two.obj", "merge-vertices", "--vertices", "1,2", "--out", "left.obj"];
    folder.run(&merge).done();
    assert!(folder.read("left.obj").contains("\nf 1 2 3 1 4 5 6 7 4\n"));

    folder.write("only.obj", HOLE.split("g others").next().unwrap());
    let why = "1 face has the same vertex at two corners, as around a hole";
    // It is a panel with a hole to cut, but not to shape.
    let out = folder.run(&["build", "only.obj"]).done();
    assert!(out.contains("1 panel on 1 sheet") && out.contains("1 hole in a panel"), "{out}");
    folder.run(&["solve", "only.obj", "--panels", "plane"]).refused(&["There are no panels", why]);
}

#[test]
fn ply_and_stl_are_read_and_written() {
    let folder = Folder::new("scans");
    folder.write("roof.obj", format!("# units: ft\n{ROOF}"));
    folder.run(&["solve", "roof.obj", "--panels", "plane", "--out", "roof.ply"]).done();
    let bytes = std::fs::read(folder.0.join("roof.ply")).unwrap();
    assert!(bytes.starts_with(b"ply\nformat binary_little_endian 1.0\ncomment units: ft\n"));
    let found = read("roof.ply", &bytes).unwrap().mesh;
    assert_eq!((found.positions.len(), found.faces.len()), (9, 4));
    let out = folder.run(&["solve", "roof.ply", "--out", "roof.STL"]).done();
    assert!(!out.contains("the file has no unit"), "{out}");
    let out = folder.run(&["check", "roof.STL"]).done();
    assert!(out.contains("faces       8, by corners: 8 of 3"), "{out}");
    assert!(out.contains("note: STL has no common vertices: 24 corners are 9 vertices"), "{out}");
    folder.run(&["edit", "roof.STL", "quads", "--out", "quads.ply"]).done();
    let said = folder.run(&["solve", "roof.obj", "--out", "o.ply"]).done();
    assert_eq!(said.contains("o.ply is PLY, which cannot store"), ROOF.contains("\ng "), "{said}");
}

#[test]
fn the_help_has_the_table_of_formats() {
    let folder = Folder::new("table");
    let out = folder.run(&["--help"]).done();
    assert!(out.contains(&FileFormat::table()), "{out}");
}
