//! `check MESH`: the report on a mesh.

use crate::cli::folder::{Folder, ROOF};

#[test]
fn rows_of_quads_are_told_with_their_size_laid_flat() {
    let folder = Folder::new("strips");
    folder.write(
        "sheet.obj",
        "v 0 0 0\nv 3 0 0\nv 3 1 0\nv 0 1 0\nv 3 0 2\nv 3 1 2\nf 1 2 3 4\nf 2 5 6 3\n",
    );
    let text = folder.run(&["check", "sheet.obj", "--report", "report.json"]).done();
    assert!(text.contains("1 of 2 quads: laid flat 1.00 to 1.00 wide, up to 5.00 long"), "{text}");
    let report = folder.json("report.json");
    let strips = report["strips"].as_array().unwrap();
    assert_eq!(strips.len(), 3, "one along the bend, two across");
    // There are no interior vertices.
    assert!(report.get("gauss_curvature").is_none());
    folder.write("roof.obj", ROOF).run(&["check", "roof.obj", "--report", "roof.json"]).done();
    assert!(folder.json("roof.json")["gauss_curvature"]["max"].is_number());
}

#[test]
fn how_far_a_mesh_will_move_for_panels_of_one_shape_is_said() {
    let folder = Folder::new("forecast");
    folder.write("roof.obj", ROOF);
    let text = folder.run(&["check", "roof.obj", "--report", "report.json"]).done();
    let line = text.lines().find(|line| line.starts_with("panels "));
    assert!(line.is_some_and(|line| line.contains("This mesh will move ")), "{text}");
    let kinds = &folder.json("report.json")["forecast"]["kinds"];
    for (place, kind) in ["plane", "circle"].into_iter().enumerate() {
        assert_eq!(kinds[place]["kind"], kind);
        assert!(kinds[place]["least_move"].is_number() && kinds[place]["how_far"].is_string());
    }
    folder.write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let text = folder.run(&["check", "triangle.obj", "--report", "report.json"]).done();
    assert!(!text.contains("panels "), "{text}");
    assert!(folder.json("report.json").get("forecast").is_none());
}

/// They were relative to a ball around the lines too.
#[test]
fn errors_of_panels_do_not_depend_on_lines_beside_them() {
    let folder = Folder::new("site-outline");
    let count = ROOF.lines().filter(|line| line.starts_with("v ")).count();
    let site = format!("v -900 0 0\nv 900 0 0\nl {} {}\n", count + 1, count + 2);
    folder.write("roof.obj", ROOF).write("site.obj", format!("{ROOF}\n{site}"));
    let errors = |name: &str| {
        folder.run(&["check", name, "--report", "report.json"]).done();
        let report = folder.json("report.json");
        ["planarity", "circularity"].map(|kind| report[kind].clone())
    };
    assert_eq!(errors("site.obj"), errors("roof.obj"));
}

#[test]
fn faces_that_do_not_share_vertices_are_welded_as_they_are_to_be_solved() {
    let folder = Folder::new("soup");
    let corners = |x: u32, y: u32| {
        let at = |x: u32, y: u32| format!("v {x} {y} {}\n", 0.1 * f64::from(x * y));
        [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)].concat()
    };
    let vertices = [corners(0, 0), corners(1, 0), corners(0, 1), corners(1, 1)].concat();
    let faces = (0..4).map(|k| 4 * k + 1).map(|k| format!("f {k} {} {} {}\n", k + 1, k + 2, k + 3));
    folder.write("soup.obj", vertices + &faces.collect::<String>());
    let note = "7 coincident vertices were welded, and the mesh has 9";
    let text = folder.run(&["check", "soup.obj", "--report", "r.json"]).done();
    assert!(text.contains(note), "{text}");
    let report = folder.json("r.json");
    assert_eq!((&report["vertices"], &report["components"]), (&9.into(), &1.into()));
    let asked = ["parametrize", "soup.obj", "--out", "uv.obj", "--report", "r.json"];
    let text = folder.run(&asked).done();
    assert!(text.contains(note), "{text}");
    assert_eq!(folder.json("r.json")["parts"], 1);
    let out = folder.read("uv.obj");
    let maps: Vec<&str> = out.lines().filter(|line| line.starts_with("vt ")).collect();
    // In the vertices of the file: the second corner of the first face is the first of the second.
    assert_eq!((maps.len(), maps[1]), (16, maps[4]));
    assert_eq!(out.lines().filter(|line| line.starts_with("v ")).count(), 16);
}

#[test]
fn numbers_on_standard_output_can_be_read_by_programs() {
    // As words for readers they have a typographic minus sign, and thin spaces between thousands.
    let folder = Folder::new("plain-numbers");
    let vertices: String = (0..12_000).map(|v| format!("v {v} {} 0\n", v % 7)).collect();
    let quad = "v 0 0 1\nv 1 0 1\nv 1 1 1.000001\nv 0 1 1\nf 12001 12002 12003 12004\n";
    folder.write("fine.obj", vertices + quad);
    let text = folder.run(&["check", "fine.obj"]).done();
    assert!(text.contains("12000 unused vertices"), "{text}");
    let line = text.lines().find_map(|line| line.strip_prefix("planarity   worst "));
    let worst = line.and_then(|line| line.split(',').next()).expect("it is printed");
    let worst: f64 = worst.split(' ').next().unwrap_or_default().parse().expect("it is a number");
    assert!(worst > 0.0 && worst < 1e-5, "{text}");
}
