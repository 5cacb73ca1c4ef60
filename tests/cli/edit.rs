//! `shape-up edit`.

use super::folder::Folder;

#[test]
fn operations_follow_each_other_and_the_scene_goes_along() {
    let folder = Folder::new("edit");
    folder.run(&["new", "grid", "--along", "4", "--across", "3", "--out", "flat.obj"]).done();
    let cut = folder.run(&["edit", "flat.obj", "triangles", "--out", "cut.obj"]).done();
    assert_eq!(cut, "flat.obj: 12 faces became 24 faces, 20 vertices\n");
    let paired = folder.run(&["edit", "cut.obj", "quads", "--corner", "100"]).done();
    assert!(paired.contains("24 faces became 12 faces"), "{paired}");
    let scene = ["edit", "flat.obj", "delete", "--faces", "0-1,5", "--out", "less.json"];
    let less = folder.run(&scene).done();
    assert!(less.contains("12 faces became 9 faces"), "{less}");
    folder.run(&["solve", "less.json", "--iterations", "1"]).done();
    // Faces stand for their corners: all vertices were snapped.
    folder
        .run(&["edit", "flat.obj", "snap", "--step", "7", "--faces", "0", "--out", "few.obj"])
        .done();
    let few = folder.read("few.obj");
    let moved = few.lines().zip(folder.read("flat.obj").lines()).filter(|(a, b)| a != b).count();
    assert!((1..=4).contains(&moved), "{few}");
    let missing = folder.run(&["edit", "flat.obj", "weld", "--faces", "99"]);
    assert!(missing.err.contains("there is no face 99"), "{}", missing.err);
}

#[test]
fn what_it_does_not_take_is_said() {
    let folder = Folder::new("edit-wrong");
    folder.run(&["new", "grid", "--out", "flat.obj"]).done();
    for (asked, expected) in [
        (&["edit"][..], "edit needs a scene or a mesh file first"),
        (&["edit", "flat.obj"], "edit needs an operation after the file: quads, dual"),
        (&["edit", "flat.obj", "iron"], "found `iron`"),
        (&["edit", "flat.obj", "weld", "--corner", "3"], "edit weld takes --distance"),
        // It cut all faces.
        (&["edit", "flat.obj", "triangles", "--faces", "3"], "takes --out, found `--faces`"),
        (&["edit", "flat.obj", "delete", "--vertices", "3"], "takes --faces, --out, found"),
    ] {
        let failed = folder.run(asked);
        assert!(failed.err.contains(expected), "{}", failed.err);
    }
    // A wrong list is an option's, not the file's.
    folder
        .run(&["edit", "flat.obj", "delete", "--faces", "3-1"])
        .misused("--faces: the range \"3-1\" is reversed");
    let failed = folder.run(&["edit", "flat.obj", "delete"]);
    assert!(failed.err.contains("flat.obj: this needs selected faces"), "{}", failed.err);
}
