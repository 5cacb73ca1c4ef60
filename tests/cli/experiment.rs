//! `shape-up experiment`: the list, the table, and the file with every iteration.

use crate::cli::folder::Folder;

#[test]
fn experiments_are_listed_and_run() {
    let folder = Folder::new("experiment");
    let listed = folder.run(&["experiment"]).done();
    assert!(listed.contains("fig-10-collapse") && listed.contains("fig-11-strip"), "{listed}");
    let asked = ["experiment", "fig-11-strip", "--iterations", "3", "--csv", "strip.csv"];
    let table = folder.run(&asked).done();
    let lines: Vec<_> = table.lines().collect();
    assert_eq!(lines.len(), 3, "{table}");
    assert!(lines[0].contains("shortest edge"), "{table}");
    assert!(
        lines[1].starts_with("Shape-Up ") && lines[1].contains("limit of iterations"),
        "{table}"
    );
    let csv = folder.read("strip.csv");
    assert_eq!(csv.lines().count(), 1 + 2 * 4, "{csv}");
    assert!(csv.starts_with("method,iteration,seconds,smooth,e_c,shortest\n"), "{csv}");
}

#[test]
fn a_limit_of_no_iterations_leaves_the_start() {
    // The limit was checked only after the first iteration.
    let folder = Folder::new("start");
    folder.run(&["experiment", "fig-11-strip", "--iterations=0", "--csv=start.csv"]).done();
    let csv = folder.read("start.csv");
    assert_eq!(csv.lines().count(), 1 + 2, "{csv}");
    assert!(csv.lines().skip(1).all(|line| line.split(',').nth(1) == Some("0")), "{csv}");
}

#[test]
fn any_scene_can_be_compared() {
    let folder = Folder::new("compared");
    let table = folder.run(&["experiment", "hypar", "--iterations", "2"]).done();
    assert!(table.contains("BFGS") && table.contains("Shape-Up, accelerated"), "{table}");
    folder.run(&["examples", "--out", "."]).done();
    let asked = ["experiment", "hypar.shapeup.json", "--iterations", "2", "--csv", "all.csv"];
    folder.run(&asked).done();
    assert_eq!(folder.read("all.csv").lines().count(), 1 + 6 * 3);
    folder.run(&["experiment", "hypar.obj"]).refused(&["hypar.obj", "no constraints"]);
}
