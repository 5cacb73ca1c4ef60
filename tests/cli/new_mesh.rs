//! `shape-up new`.

use super::folder::Folder;

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
    let printed = folder.run(&["new", "tube", "--units", "mm"]).done();
    assert!(printed.contains("units: mm") && printed.contains("\nf "), "{printed}");
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
    folder.run(&["new", "plan"]).misused("new plan needs the file of a plan");
}
