//! `shape-up remesh`: quads along the lines of curvature, its report, and its refusals.

use super::keys;
use crate::cli::folder::Folder;
use shape_up::mesh::write_obj;

/// A tube of triangles, of radius 1 and length 4, as OBJ.
fn tube() -> String {
    let tube = crate::quads::tube();
    write_obj(&tube, &tube.positions)
}

#[test]
fn a_tube_of_triangles_becomes_quads_along_its_lines_of_curvature() {
    let folder = Folder::new("remesh");
    folder.write("tube.obj", tube());
    let asked = ["remesh", "tube.obj", "--quads", "200", "--out", "out.obj", "--report", "r.json"];
    let out = folder.run(&asked).done();
    for words in ["tube.obj: ", " panels, 0 irregular vertices", "off the lines of curvature"] {
        assert!(out.contains(words), "expected `{words}` in {out}");
    }
    let report = folder.json("r.json");
    let expected = [
        "angle",
        "boundary",
        "distance",
        "edge",
        "euler",
        "irregular",
        "level",
        "loops",
        "notes",
        "other_faces",
        "quads",
        "seconds",
    ];
    assert_eq!(keys(&report), expected);
    assert_eq!(keys(&report["angle"]), ["mean", "p90"]);
    assert_eq!(keys(&report["irregular"]), ["boundary", "inside"]);
    assert_eq!(keys(&report["edge"]), ["cv", "mean"]);
    assert_eq!(keys(&report["distance"]), ["from_input", "to_input"]);
    assert!(report["seconds"]["total"].as_f64().unwrap() > 0.0);
    let mesh = shape_up::mesh::read("out.obj", folder.read("out.obj").as_bytes()).unwrap().mesh;
    assert_eq!(report["quads"], mesh.faces.len());
    assert_eq!((&report["loops"], &report["euler"]), (&2.into(), &0.into()));
    // Circular without a move that anybody would see.
    folder.run(&["solve", "out.obj", "--panels", "circle", "--report", "c.json"]).done();
    let moved = folder.json("c.json")["moved"]["max"].as_f64().unwrap();
    assert!(moved < 0.02 * report["edge"]["mean"].as_f64().unwrap(), "{moved}");
}

#[test]
fn what_is_not_covered_is_in_the_file_as_it_came() {
    // A panel with a hole, a curve and a group were left out without a word.
    let folder = Folder::new("remesh-rest");
    let count = tube().lines().filter(|line| line.starts_with("v ")).count();
    let at = |k: usize| count + k;
    let beside = [[5, 0], [9, 0], [9, 4], [5, 4], [6, 1], [8, 1], [8, 3], [6, 3]];
    let beside: String = beside.iter().map(|[x, y]| format!("v {x} {y} 0\n")).collect();
    let hole = [1, 2, 3, 4, 1, 5, 8, 7, 6, 5].map(|k| at(k).to_string()).join(" ");
    let guess = format!("v 5 9 0\nv 9 9 0\nv nan 12 0\nf {} {} {}\n", at(9), at(10), at(11));
    let rest = format!("{beside}f {hole}\nl {} {}\n{guess}", at(1), at(3));
    folder.write("site.obj", format!("g skin\n{}g rest\n{rest}", tube()));
    let said = folder.run(&["remesh", "site.obj", "--quads", "200", "--out", "out.obj"]).done();
    let made = shape_up::mesh::read("out.obj", folder.read("out.obj").as_bytes()).unwrap().mesh;
    assert_eq!((made.untouched.len(), made.curves.len()), (1, 1));
    // What has no position is no surface.
    assert!(made.faces.iter().all(|face| face.len() == 4));
    assert!(said.contains("note: 1 face is left out, since it has a vertex"), "{said}");
    let names: Vec<&str> = made.groups.iter().map(|group| &*group.name).collect();
    assert!(names.contains(&"skin") && names.contains(&"rest"), "{names:?}");
}

#[test]
fn size_and_boundary_are_as_asked() {
    let folder = Folder::new("remesh-size");
    folder.write("tube.obj", tube());
    let report = |options: &[&str]| {
        folder.run(&[&["remesh", "tube.obj", "--report", "r.json"], options].concat()).done();
        folder.json("r.json")
    };
    let length = report(&["--size", "0.4"])["edge"]["mean"].as_f64().unwrap();
    assert!((length - 0.4).abs() < 0.06, "{length}");
    let cut = report(&["--size=0.4", "--boundary", "cut", "--follow", "0.3", "--even", "1"]);
    assert_eq!((&cut["euler"], &cut["loops"]), (&0.into(), &2.into()));
    report(&["--quads", "150", "--crease", "180", "--boundary=follow"]);
}

/// It was followed unless one said otherwise, and nothing was said of the other choice.
#[test]
fn the_better_choice_at_the_boundary_is_taken_and_said() {
    let folder = Folder::new("remesh-boundary");
    let hypar = crate::quads::hypar();
    folder.write("hypar.obj", write_obj(&hypar, &hypar.positions)).write("tube.obj", tube());
    let made = |mesh: &str, options: &[&str]| {
        let asked = [&["remesh", mesh, "--quads", "200", "--report", "r.json"], options].concat();
        (folder.run(&asked).done(), folder.json("r.json"))
    };
    let (said, report) = made("hypar.obj", &[]);
    assert_eq!(report["boundary"], "cut");
    let words = "note: The panels are cut at the boundary: along it, they would move about ";
    assert!(said.contains(words), "{said}");
    let (said, report) = made("hypar.obj", &["--boundary", "follow"]);
    assert_eq!(report["boundary"], "follow");
    assert!(!said.contains("note: The panels"), "{said}");
    // What hardly moves follows it.
    let (said, report) = made("tube.obj", &[]);
    assert_eq!(report["boundary"], "follow");
    assert!(!said.contains("note: The panels"), "{said}");
}

#[test]
fn what_remesh_cannot_do_is_one_line_and_no_file() {
    let folder = Folder::new("remesh-refused");
    folder.write("tube.obj", tube()).write("line.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n");
    let refused = |options: &[&str], words: &[&str]| {
        let asked = [&["remesh"], options, &["--out", "out.obj", "--report", "r.json"]].concat();
        folder.run(&asked).refused(words);
    };
    refused(&["line.obj"], &["line.obj: ", "no faces"]);
    refused(&["tube.obj", "--size", "9"], &["tube.obj: ", "too large", "or less", "; at ("]);
    refused(&["tube.obj", "--size", "1e-5"], &["tube.obj: ", "expected", "or more"]);
    assert_eq!(folder.files(), ["line.obj", "tube.obj"]);
    for (options, words) in [
        (vec![], "mesh"),
        (vec!["tube.obj", "--quads", "0"], "from 1"),
        (vec!["tube.obj", "--quads", "9", "--size", "1"], "--quads or --size"),
        (vec!["tube.obj", "--follow", "2"], "0 to 1"),
        (vec!["tube.obj", "--boundary", "keep"], "follow or cut"),
        (vec!["tube.obj", "--out", "out.off"], ".obj, .mesh, .ply or .stl"),
        (vec!["tube.obj", "--trace"], "`--trace`"),
        (vec!["s.json"], "mesh file"),
    ] {
        folder.run(&[vec!["remesh"], options].concat()).misused(words);
    }
}

#[test]
fn quads_are_written_in_every_format_with_their_unit() {
    let folder = Folder::new("remesh-formats");
    folder.write("tube.obj", "# units: cm\n".to_owned() + &tube());
    let faces: Vec<usize> = ["out.obj", "out.ply", "out.mesh", "out.stl"]
        .iter()
        .map(|name| {
            folder.run(&["remesh", "tube.obj", "--quads", "100", "--out", name]).done();
            let file = std::fs::read(folder.0.join(name)).unwrap();
            shape_up::mesh::read(name, &file).unwrap().mesh.faces.len()
        })
        .collect();
    let [obj, ply, medit, stl] = faces[..] else { unreachable!() };
    assert_eq!((ply, medit), (obj, obj));
    // Triangles.
    assert_eq!(stl, 2 * obj);
    assert!(folder.read("out.obj").starts_with("# units: cm\n"));
}
