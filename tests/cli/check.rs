//! `check MESH`: the report on a mesh.

use crate::folder::{Folder, ROOF};

#[test]
fn rows_of_quads_are_told_with_their_size_laid_flat() {
    let folder = Folder::new("strips");
    folder.write(
        "sheet.obj",
        "v 0 0 0\nv 3 0 0\nv 3 1 0\nv 0 1 0\nv 3 0 2\nv 3 1 2\nf 1 2 3 4\nf 2 5 6 3\n",
    );
    let text = folder.run(&["check", "sheet.obj", "--report", "report.json"]).done();
    assert!(
        text.contains("1 of 2 quads: laid flat 1.000 to 1.000 wide, up to 5.000 long"),
        "{text}"
    );
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
