//! `shape-up experiment`: the list, the table, and the files with every iteration and with the plots.

use crate::cli::folder::Folder;
use roxmltree::Document;

/// What the vertical axes of the plots show.
fn plots(svg: &str) -> Vec<String> {
    let svg = Document::parse(svg).expect("it is XML");
    let turned = svg.descendants().filter(|node| {
        node.attribute("transform").is_some_and(|transform| transform.contains("rotate"))
    });
    turned.filter_map(|node| node.text().map(str::to_owned)).collect()
}

#[test]
fn experiments_are_listed_and_run() {
    let folder = Folder::new("experiment");
    let listed = folder.run(&["experiment"]).done();
    assert!(listed.contains("fig-10-collapse") && listed.contains("fig-11-strip"), "{listed}");
    let limited = ["experiment", "fig-11-strip", "--iterations", "3"];
    let asked = [&limited[..], &["--csv", "strip.csv", "--svg", "strip.svg"]].concat();
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
    let svg = folder.read("strip.svg");
    assert_eq!(plots(&svg), ["Smoothness energy in m²", "Shortest edge in m"]);
    let svg = Document::parse(&svg).expect("it is XML");
    for line in svg.descendants().filter(|node| node.has_tag_name("polyline")) {
        let points = line.attribute("points").expect("it has points");
        let across: Vec<f64> = points
            .split(' ')
            .map(|point| point.split(',').next().and_then(|x| x.parse().ok()).expect("a number"))
            .collect();
        assert_eq!(across.len(), 4, "{points}");
        assert!(across.windows(2).all(|pair| pair[0] < pair[1]), "{points}");
        assert_eq!((across[0], across[3]), (76.0, 500.0), "from the start to the last iteration");
    }
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
    let limited = ["experiment", "hypar.shapeup.json", "--iterations", "2"];
    let asked = [&limited[..], &["--csv", "all.csv", "--svg", "all.svg"]].concat();
    folder.run(&asked).done();
    assert_eq!(folder.read("all.csv").lines().count(), 1 + 6 * 3);
    let svg = folder.read("all.svg");
    assert_eq!(plots(&svg), ["Energy above the lowest in m²", "Energy above the lowest in m²"]);
    assert!(svg.contains(">Methods compared: hypar.shapeup.json<"), "{svg}");
    assert!(svg.contains(">iterations<") && svg.contains(">seconds<"), "{svg}");
    folder.run(&["experiment", "hypar.obj"]).refused(&["hypar.obj", "no constraints"]);
}

/// It was left out, as if it were not one of the six.
#[test]
fn a_method_that_is_not_run_is_in_the_table_with_the_reason() {
    let folder = Folder::new("too-large");
    let mut text = String::from("# units: m\n");
    (0..26 * 26).for_each(|k| text += &format!("v {} {} {}\n", k % 26, k / 26, k * k % 7));
    for k in (0..26 * 25).filter(|k| k % 26 < 25) {
        text += &format!("f {} {} {} {}\n", k + 1, k + 2, k + 28, k + 27);
    }
    folder.write("large.obj", text);
    let scene = r#"{ "format": "shape-up-scene", "version": 1, "mesh": { "file": "large.obj" },
        "constraints": [ { "kind": "plane", "on": "faces" } ] }"#;
    folder.write("large.json", scene);
    let table = folder.run(&["experiment", "large.json", "--iterations", "0"]).done();
    assert_eq!(table.lines().count(), 1 + 6, "{table}");
    let bfgs = table.lines().find(|line| line.contains("not run: mesh too large"));
    assert!(bfgs.is_some_and(|line| line.starts_with("BFGS")), "{table}");
}
