//! Written files: links, pipes, formats, and data that a format cannot store.

use crate::cli::folder::{Folder, PLANES, ROOF, scene};

fn mesh(folder: &Folder, name: &str) -> shape_up::mesh::Mesh {
    shape_up::mesh::read(name, folder.read(name).as_bytes()).unwrap().mesh
}

#[cfg(unix)]
#[test]
fn a_link_stays_and_the_file_behind_it_is_written() {
    // Renaming a file to the name of a link would replace the link.
    let folder = Folder::new("link");
    std::fs::create_dir(folder.0.join("store")).unwrap();
    folder.write("roof.obj", ROOF).write("store/out.obj", "");
    std::os::unix::fs::symlink("store/out.obj", folder.0.join("out.obj")).unwrap();
    folder.run(&["solve", "roof.obj", "--panels", "plane", "--out", "out.obj"]).done();
    assert!(folder.0.join("out.obj").is_symlink());
    assert_eq!(mesh(&folder, "store/out.obj").positions.len(), 9);
    assert_eq!(std::fs::read_dir(folder.0.join("store")).unwrap().count(), 1);
}

#[cfg(unix)]
#[test]
fn a_pipe_is_written_to_and_stays() {
    // The same holds for a device: renaming a file to its name would replace it.
    use std::os::unix::fs::FileTypeExt;
    let folder = Folder::new("pipe");
    let pipe = folder.0.join("out.obj");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status();
    assert!(made.is_ok_and(|status| status.success()), "mkfifo makes a pipe");
    folder.write("roof.obj", ROOF);
    let reader = {
        let pipe = pipe.clone();
        std::thread::spawn(move || std::fs::read_to_string(pipe).unwrap())
    };
    folder.run(&["solve", "roof.obj", "--panels", "plane", "--out", "out.obj"]).done();
    assert_eq!(reader.join().unwrap().lines().filter(|line| line.starts_with("v ")).count(), 9);
    assert!(std::fs::metadata(&pipe).unwrap().file_type().is_fifo());
}

#[test]
fn one_file_cannot_take_two_outputs_whatever_it_is_called() {
    let folder = Folder::new("same");
    folder.write("roof.obj", ROOF);
    let absolute = folder.0.join("x").to_string_lossy().into_owned();
    for report in ["x", "./x", ".//x", &absolute] {
        folder
            .run(&["solve", "roof.obj", "--out", "x", "--report", report])
            .misused("another file");
    }
    // Nor can a device: both would be mixed.
    if cfg!(unix) {
        let both = ["--out", "/dev/null", "--report", "/dev/null"];
        folder.run(&[&["solve", "roof.obj"][..], &both].concat()).misused("another file");
    }
    assert_eq!(folder.files(), ["roof.obj"]);
}

#[test]
fn an_ending_of_another_format_is_refused_before_anything_is_solved() {
    // OBJ text in a file named .off cannot be read by any program.
    let folder = Folder::new("ending");
    folder.write("roof.obj", ROOF);
    for (command, out, words) in [
        ("solve", "out.off", "--out writes .obj, .mesh, .ply or .stl, found `out.off`"),
        ("solve", "out.OFF", ".ply or .stl"),
        ("parametrize", "out.off", "--out writes .obj, found"),
        ("parametrize", "out.mesh", "--out writes .obj, found"),
    ] {
        folder.run(&[command, "roof.obj", "--out", out]).misused(words);
    }
    assert_eq!(folder.files(), ["roof.obj"]);
    folder.run(&["solve", "roof.obj", "--out", "solved"]).done();
    assert_eq!(mesh(&folder, "solved").positions.len(), 9);
}

/// Two tetrahedra on a quad.
const TETS: &str = "MeshVersionFormatted 2\nDimension 3\nVertices\n5\n0 0 0 0\n1 0 0 0\n1 1 0.2 0\n\
    0 1 0 0\n0.5 0.5 1 0\nQuadrilaterals\n1\n1 2 3 4 0\nTetrahedra\n2\n1 2 3 5 0\n1 3 4 5 0\nEnd\n";

#[test]
fn tetrahedra_come_out_in_the_format_that_has_them() {
    let folder = Folder::new("tets");
    folder.write("block.mesh", TETS);
    let out = folder.run(&["solve", "block.mesh", "--panels", "plane", "--out", "out.mesh"]).done();
    assert!(!out.contains("cannot store"), "{out}");
    let (before, after) = (mesh(&folder, "block.mesh"), mesh(&folder, "out.mesh"));
    assert_eq!((&after.tets, &after.faces), (&before.tets, &before.faces));
    assert_ne!(after.positions, before.positions);
    let out = folder.run(&["solve", "block.mesh", "--panels", "plane", "--out", "out.obj"]).done();
    assert!(out.contains("note: out.obj is OBJ, which cannot store 2 tetrahedra\n"), "{out}");
    folder.write("roof.obj", format!("{ROOF}f 1 2 3 6 5\n"));
    let out = folder.run(&["solve", "roof.obj", "--panels", "plane", "--out", "out.mesh"]).done();
    let lost = "which cannot store 1 face of more than four corners, 1 whole polyline, 5 groups\n";
    assert!(out.contains(lost), "{out}");
}

#[test]
fn one_of_something_is_not_several() {
    let folder = Folder::new("one");
    folder.write("roof.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nf 1 2 3 4\n");
    let out = folder.write("s.json", scene(PLANES)).run(&["solve", "s.json"]).done();
    assert!(out.contains("4 vertices, 1 face, ") && out.contains("fixed at vertex 0\n"), "{out}");
}

#[test]
fn faces_with_vertices_of_their_own_are_solved_together_and_come_out_as_they_came() {
    // If they were solved separately, they would move apart.
    let folder = Folder::new("pieces");
    let mut text = String::new();
    for (x, y) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
        for (x, y) in [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)] {
            let z = f64::from(x * y) * 0.1 + f64::from(x * x) * 0.05;
            text += &format!("v {x} {y} {z}\n");
        }
    }
    text += "f 1 2 3 4\nf 5 6 7 8\nf 9 10 11 12\nf 13 14 15 16\n";
    folder.write("pieces.obj", &text);
    let solve = ["solve", "pieces.obj", "--panels", "plane", "--out", "out.obj"];
    let out = folder.run(&[&solve[..], &["--report", "r.json"]].concat()).done();
    assert!(out.contains("7 coincident vertices were welded, and the mesh has 9"), "{out}");
    assert_eq!(folder.json("r.json")["vertices"], 9);
    let (before, after) = (mesh(&folder, "pieces.obj"), mesh(&folder, "out.obj"));
    assert_eq!((after.faces, after.positions.len()), (before.faces, 16));
    assert_ne!(after.positions, before.positions);
    // The middle has four vertices, which still coincide.
    let middle = [2, 7, 9, 12].map(|v| after.positions[v]);
    assert!(middle.iter().all(|at| *at == middle[0]), "{middle:?}");
}

#[test]
fn a_mesh_that_shrinks_to_a_dot_is_told() {
    // It was once written without a message.
    let folder = Folder::new("dot");
    folder.write("roof.obj", ROOF);
    folder.write("s.json", scene(r#", "weights": { "shape": 1, "smooth": 10 }"#));
    let out = folder.run(&["solve", "s.json", "--panels", "plane", "--out", "out.obj"]).done();
    assert!(out.contains("note: in this run the mesh shrank to "), "{out}");
}

#[test]
fn a_scene_is_fitted_to_the_surface_of_a_file_beside_it() {
    let folder = Folder::new("target");
    let raised = "v -5 -5 1\nv 5 -5 1\nv 5 5 1\nv -5 5 1\nf 1 2 3 4\n";
    folder.write("roof.obj", ROOF).write("flat.obj", raised);
    for target in [r#"{ "file": "flat.obj" }"#, r#""flat.obj""#] {
        let weights = r#""weights": { "shape": 0, "close": 1 }"#;
        let keys = format!(r#", {weights}, "closeness": {{ "to": {{ "mesh": {target} }} }}"#);
        folder.write("scene.json", scene(&keys));
        folder.run(&["solve", "scene.json", "--out", "out.obj"]).done();
        assert!(mesh(&folder, "out.obj").positions.iter().all(|p| (p[2] - 1.0).abs() < 1e-9));
    }
    std::fs::remove_file(folder.0.join("flat.obj")).unwrap();
    folder.run(&["solve", "scene.json"]).refused(&["closeness.to.mesh.file", "flat.obj"]);
}

#[test]
fn no_file_that_is_read_is_replaced() {
    // The mesh of a scene was replaced by the solved shape: every later run had another original.
    let folder = Folder::new("written-read");
    let roof = "v 0 0 0\nv 1 0 0.1\nv 1 1 0\nv 0 1 0.1\nf 1 2 3 4\n";
    folder.write("roof.obj", roof);
    let scene = r#"{ "format": "shape-up-scene", "version": 1, "mesh": { "file": "roof.obj" },
        "constraints": [{ "kind": "plane", "on": "faces" }] }"#;
    folder.write("roof.shapeup.json", scene);
    for asked in [
        "solve roof.shapeup.json --out roof.obj",
        "solve roof.shapeup.json --report roof.obj",
        "refine roof.shapeup.json --out roof.obj",
        "new fill roof.obj --out roof.obj",
        "experiment roof.shapeup.json --iterations 2 --csv roof.shapeup.json",
    ] {
        let words: Vec<&str> = asked.split(' ').collect();
        folder.run(&words).misused(" would replace a file that is read");
        assert_eq!(folder.read("roof.obj"), roof, "{asked}");
        assert_eq!(folder.read("roof.shapeup.json"), scene, "{asked}");
    }
}

/// `new` said nothing of the faces that Medit lost; units and points were lost without a word in all
/// commands.
#[test]
fn whatever_a_format_cannot_store_is_said_by_every_command() {
    let folder = Folder::new("lost");
    let said = |arguments: &[&str]| folder.run(arguments).done();
    let out = said(&["new", "hexagons", "--out", "h.mesh"]);
    assert!(out.contains("note: h.mesh is Medit, which cannot store "), "{out}");
    assert!(out.contains(" faces of more than four corners"), "{out}");
    let out = said(&["new", "barrel", "--units", "in", "--out", "b.stl"]);
    assert!(out.ends_with("note: b.stl is STL, which cannot store its unit (in)\n"), "{out}");
    // What would be guessed anyway is not lost.
    let out = said(&["new", "barrel", "--out", "b.stl"]);
    assert!(!out.contains("note"), "{out}");

    folder.write("wall.obj", format!("# units: ft\n# up: y\n{ROOF}"));
    let out = said(&["refine", "wall.obj", "--scheme", "linear", "--out", "w.mesh"]);
    assert!(out.contains(", its unit (ft), its up axis (y)\n"), "{out}");

    folder.write("points.obj", "# units: m\n# up: z\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n");
    let out = said(&["solve", "points.obj", "--out", "p.stl"]);
    assert!(out.contains("p.stl is STL, which cannot store 4 vertices without a face"), "{out}");
    folder.write("block.mesh", TETS);
    let out = said(&["parametrize", "block.mesh", "--out", "uv.obj"]);
    assert!(out.contains("note: uv.obj is OBJ, which cannot store 2 tetrahedra\n"), "{out}");
}

#[test]
fn two_files_of_one_name_are_refused_before_any_is_written() {
    let folder = Folder::new("twice");
    folder.write("roof.obj", ROOF);
    let report = ["--units", "m", "--scale", "50", "--report", "./parts/summary.csv"];
    let ended = folder.run(&[&["build", "roof.obj", "--out", "parts"][..], &report].concat());
    ended.misused("parts/summary.csv would replace another file that is written, expected another");
    assert_eq!(folder.files(), ["roof.obj"]);
    let twice = ["experiment", "fig-11-strip", "--csv", "a", "--svg", "a"];
    folder.run(&twice).misused("a would replace another file that is written");
}
