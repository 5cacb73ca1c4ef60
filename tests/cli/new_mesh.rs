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
