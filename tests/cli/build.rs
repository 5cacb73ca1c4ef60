//! `shape-up build`.

use crate::cli::folder::{Folder, ROOF, scene};
use shape_up::scene::{BUILD_SETTINGS, BuildForm};

#[test]
fn sheets_tables_and_a_report_are_written_whole() {
    let folder = Folder::new("build");
    folder.write("roof.obj", ROOF);
    let asked = ["build", "roof.obj", "--kind", "face", "--distance", "-0.1", "--joint", "0.02"];
    let rest = ["--scale=20", "--sheet=1200x600", "--out", "parts", "--report", "r.json"];
    let words = folder.run(&[&asked[..], &rest[..]].concat()).done();
    assert!(words.contains("4 panels on 1 sheet, "), "{words}");
    assert!(words.contains("sheets of 1200 x 600 mm") && words.contains("no unit"), "{words}");
    let report = folder.json("r.json");
    assert_eq!(report["offset"]["kind"], "face");
    assert_eq!(report["offset"]["distance_mm"], -100.0);
    assert_eq!(report["joint_mm"], 1.0);
    assert_eq!(report["check"].as_array().map(Vec::len), Some(5));
    let mut names: Vec<_> = std::fs::read_dir(folder.0.join("parts"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    let expected = [
        "edges.csv",
        "key-1.svg",
        "key-2.svg",
        "key-3.svg",
        "key.pdf",
        "model.glb",
        "nodes.csv",
        "panels.csv",
        "panels.obj",
        "sheet-01.dxf",
        "sheet-01.svg",
        "sheets.pdf",
        "summary.csv",
        "types.csv",
    ];
    assert_eq!(names, expected);
}

#[test]
fn presets_set_what_belongs_together() {
    let folder = Folder::new("build-presets");
    folder.write("roof.obj", ROOF);
    let asked = ["--machine", "laser", "--material", "plywood-4", "--sheet", "A2"];
    folder.run(&[&["build", "roof.obj", "--out", "parts"], &asked[..]].concat()).done();
    let summary = folder.read("parts/summary.csv");
    for line in [
        "Kerf (kerf),0.15,mm",
        "Gap (gap),1,mm",
        "Thickness (thickness),4,mm",
        "Sheet label (material),plywood,",
        "Sheet width (sheet[0]),594,mm",
    ] {
        assert!(summary.lines().any(|own| own == line), "{line}: {summary}");
    }
    // A workshop that has only the tables sees that panels of this thickness would meet.
    let value = |name: &str| -> f64 {
        let line = summary.lines().find(|line| line.contains(name)).expect("it is a row");
        line.rsplit(',').nth(1).and_then(|value| value.parse().ok()).expect("it is a number")
    };
    let [outside, inside] = ["outside", "inside"].map(|side| value(&format!("panels {side}\"")));
    assert_eq!(value("joint on the sheet"), 0.0);
    assert!(outside.max(inside) > 0.0, "{outside} {inside}");
    // What is asked for by itself holds, wherever the preset stands.
    let asked = ["--kerf", "0.3", "--machine", "laser", "--out", "own"];
    folder.run(&[&["build", "roof.obj"], &asked[..]].concat()).done();
    assert!(folder.read("own/summary.csv").contains("Kerf (kerf),0.3,mm"));
    folder
        .run(&["build", "roof.obj", "--machine", "axe"])
        .misused("or laser or mill or mill-6, found `axe`");
    folder
        .run(&["build", "roof.obj", "--sheet", "a9"])
        .misused("such as 1200x600, or a3, found `a9`");
}

#[test]
fn fins_and_paper_models_are_made_on_demand() {
    let folder = Folder::new("build-products");
    folder.write("roof.obj", ROOF);
    let names = |out: &str| -> Vec<String> {
        let files = std::fs::read_dir(folder.0.join(out)).unwrap();
        let mut names: Vec<_> =
            files.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    };
    let fins = ["build", "roof.obj", "--product", "fins", "--thickness", "3", "--out", "fins"];
    let words = folder.run(&fins).done();
    assert!(words.contains("12 fins on 1 sheet") && words.contains("types of nodes"), "{words}");
    for name in ["beams.csv", "beams.obj", "fins.csv", "node-beams.csv", "node-types.csv"] {
        assert!(names("fins").iter().any(|own| own == name), "{name}");
    }
    let paper =
        ["build", "roof.obj", "--product=paper", "--pieces=strips", "--page=a4", "--out=paper"];
    let words = folder.run(&paper).done();
    assert!(words.contains("2 pieces on ") && words.contains("2 tabs"), "{words}");
    for name in ["joins.csv", "pieces.csv", "sheets.pdf"] {
        assert!(names("paper").iter().any(|own| own == name), "{name}");
    }
}

#[test]
fn fins_that_are_all_cut_away_are_not_said_to_be_cut_back_by_nothing() {
    let folder = Folder::new("build-cut-away");
    folder.write("roof.obj", ROOF);
    let asked = ["build", "roof.obj", "--units=m", "--product=fins", "--scale=20"];
    let words = folder.run(&[&asked[..], &["--thickness=3"]].concat()).done();
    assert!(words.contains("; fins cut back by up to "), "{words}");
    let words = folder.run(&[&asked[..], &["--thickness=300"]].concat()).done();
    assert!(words.starts_with("0 of 12 fins") && !words.contains("cut back by"), "{words}");
}

#[test]
fn a_report_page_has_the_title_of_the_scene_or_file_and_the_link() {
    let folder = Folder::new("build-page");
    let scene =
        r#"{"format":"shape-up-scene","version":1,"title":"A <b>","mesh":{"file":"roof.obj"}}"#;
    folder.write("roof.obj", ROOF).write("s.shapeup.json", scene);
    let page = |file: &str, rest: &[&str]| {
        let words =
            folder.run(&[&["build", file, "--report-page", "r.html"], rest].concat()).done();
        assert!(words.ends_with("r.html\n"), "{words}");
        folder.read("r.html")
    };
    let of_scene = page("s.shapeup.json", &["--link", "https://example.org/?a&b"]);
    assert!(of_scene.contains("<h1>A &lt;b&gt;</h1>"), "{of_scene}");
    assert!(of_scene.contains("href=\"https://example.org/?a&amp;b\""), "{of_scene}");
    let of_file = page("roof.obj", &[]);
    assert!(of_file.contains("<h1>roof</h1>") && !of_file.contains("<a "), "{of_file}");
    for link in ["javascript:alert(1)", "data:text/html,a", "example.org", " https://example.org"] {
        let asked = ["build", "roof.obj", "--report-page", "r.html", "--link", link];
        folder.run(&asked).misused("--link takes an address that begins with https:// or http://");
    }
}

#[test]
fn files_of_an_earlier_build_in_the_same_folder_are_named() {
    let folder = Folder::new("build-again");
    folder.write("roof.obj", ROOF);
    let asked = ["build", "roof.obj", "--scale=10", "--out=parts"];
    let words = folder.run(&[&asked[..], &["--sheet=160x160"]].concat()).done();
    assert!(words.contains("sheet-02.svg") && !words.contains("earlier"), "{words}");
    let words = folder.run(&[&asked[..], &["--sheet=1200x600"]].concat()).done();
    assert!(words.contains("earlier one: sheet-02.dxf, sheet-02.svg"), "{words}");
    let words = folder.run(&[&asked[..], &["--sheet=1200x600", "--product=paper"]].concat()).done();
    assert!(words.contains("earlier one: panels.csv, sheet-02.dxf"), "{words}");
    assert!(folder.0.join("parts/sheet-02.svg").exists());
}

#[test]
fn a_piece_without_room_for_its_name_is_named_in_words_and_in_the_report() {
    let folder = Folder::new("build-unnamed");
    folder.write("roof.obj", ROOF);
    let asked = ["build", "roof.obj", "--product=paper", "--scale=320", "--sheet=20x18"];
    let words = folder.run(&[&asked[..], &["--report", "r.json"]].concat()).done();
    assert!(words.contains("2 pieces have no room for a name: S1, S3.\n"), "{words}");
    assert_eq!(folder.json("r.json")["unnamed"], serde_json::json!(["S1", "S3"]));
}

#[test]
fn a_mesh_without_a_unit_has_the_one_of_its_size_or_of_the_command_line() {
    let folder = Folder::new("build-units");
    folder.write("large.obj", "v 0 0 0\nv 2000 0 0\nv 2000 1000 0\nv 0 1000 0\nf 1 2 3 4\n");
    let built = |options: &[&str]| {
        let asked = [&["build", "large.obj", "--scale=10", "--report", "r.json"], options];
        let words = folder.run(&asked.concat()).done();
        (words, folder.json("r.json")["unit"].clone())
    };
    let (words, unit) = built(&[]);
    assert_eq!(unit, "mm");
    assert!(words.contains("note: the file has no unit: taken as mm by its size"), "{words}");
    assert!(!words.contains("up axis"), "{words}");
    let standing = "v 0 0 0\nv 2000 0 0\nv 2000 0 1000\nv 0 0 1000\nv 0 90 0\nf 4 3 2 1\nf 5 2 1\n";
    folder.write("standing.obj", standing);
    let words = folder.run(&["solve", "standing.obj", "--out", "b.obj"]).done();
    assert!(words.contains("note: the file has no up axis: taken as y by its shape"), "{words}");
    assert!(folder.read("b.obj").contains("# up: y"));
    let (words, unit) = built(&["--units", "cm"]);
    assert!(unit == "cm" && !words.contains("the file has no unit"), "{words}");
    // A guess is not stated in a file: whoever reads that one guesses as well.
    for asked in [
        &["solve", "large.obj", "--out", "b.obj"][..],
        &["refine", "large.obj", "--out", "b.obj"],
        &["edit", "large.obj", "triangles", "--out", "b.obj"],
    ] {
        folder.run(asked).done();
        assert!(!folder.read("b.obj").contains("units"), "{asked:?}");
    }
    folder.run(&["build", "large.obj", "--units", "yd"]).misused("m or cm or mm or ft or in");
}

#[test]
fn nothing_is_built_in_a_unit_that_is_not_known() {
    let folder = Folder::new("build-unknown-unit");
    folder.write("roof.obj", format!("# units: inches\n{ROOF}"));
    let asked = ["build", "roof.obj", "--scale=10", "--out", "parts"];
    folder.run(&asked).refused(&["roof.obj", "the unit \"inches\" is not known", "--units"]);
    assert_eq!(folder.files(), ["roof.obj"]);
    let words = folder.run(&[&asked[..], &["--units=in"]].concat()).done();
    assert!(words.contains("unit in"), "{words}");
}

#[test]
fn no_files_of_parts_are_written_if_nothing_can_be_cut() {
    let folder = Folder::new("build-nothing");
    folder.write("roof.obj", ROOF);
    let large = ["build", "roof.obj", "--units=m", "--scale=0.1", "--report=r.json"];
    folder
        .run(&[&large[..], &["--out=parts"]].concat())
        .refused(&["nothing can be cut", "Larger than the sheet within its margins: P0"]);
    assert_eq!(folder.files(), ["roof.obj"]);
    // The check alone has its numbers.
    folder.run(&large).done();
    assert_eq!(folder.json("r.json")["placed"], 0);
    // Three panels at one edge have no outside, and so no fins.
    let wall = "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nv 0 -9 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n";
    folder.write("wall.obj", wall);
    folder
        .run(&["build", "wall.obj", "--product=fins", "--out=parts"])
        .refused(&["nothing can be cut", "more than two panels"]);
}

#[test]
fn the_scene_says_what_the_command_line_does_not() {
    let folder = Folder::new("build-scene");
    let scene = r#"{ "format": "shape-up-scene", "version": 1, "units": "mm", "mesh": { "file": "roof.obj" },
        "current": [[0,0,0],[1,0,0],[2,0,0],[0,1,0],[1,1,0],[2,1,0],[0,2,0],[1,2,0],[2,2,0]],
        "build": { "kind": "corner", "distance": 2, "scale": 0.01, "sheet": [500, 400] } }"#;
    folder.write("roof.obj", ROOF).write("s.shapeup.json", scene);
    folder.run(&["build", "s.shapeup.json", "--distance", "0.5", "--report", "r.json"]).done();
    let report = folder.json("r.json");
    assert_eq!(report["unit"], "mm");
    assert_eq!(report["sheet_mm"], serde_json::json!([500.0, 400.0]));
    assert_eq!(
        (&report["offset"]["kind"], &report["offset"]["distance_mm"]),
        (&"corner".into(), &0.5.into())
    );
    // Four squares of 1 mm, a hundred times as large on the sheet: the current shape is built.
    let area = report["cut_area_mm2"].as_f64().unwrap();
    assert!((area - 4e4).abs() < 1e-6, "{area}");
    assert_eq!(folder.files(), ["r.json", "roof.obj", "s.shapeup.json"]);
}

#[test]
fn a_scene_saved_at_its_design_is_built_as_designed() {
    let folder = Folder::new("build-design");
    let square = |size: u32| format!("[[0,0,0],[{size},0,0],[{size},{size},0],[0,{size},0]]");
    let (opened, design) = (square(1), square(3));
    let scene = format!(
        r#"{{ "format": "shape-up-scene", "version": 1, "units": "mm",
            "mesh": {{ "positions": {opened}, "faces": [[0, 1, 2, 3]] }},
            "variants": {{ "kept": [{{ "name": "Wide", "positions": {design} }}], "design": 0 }},
            "build": {{ "scale": 1 }} }}"#
    );
    folder.write("s.shapeup.json", scene);
    folder.run(&["build", "s.shapeup.json", "--report", "r.json"]).done();
    let area = folder.json("r.json")["cut_area_mm2"].as_f64().unwrap();
    assert!((area - 9.0).abs() < 1e-9, "{area}");
}

#[test]
fn what_cannot_be_built_or_asked_is_refused_in_one_line() {
    let folder = Folder::new("build-faults");
    folder.write("points.obj", "v 0 0 0\nv 1 0 0\n").write("roof.obj", ROOF);
    folder.run(&["build", "points.obj", "--out", "parts"]).refused(&["points.obj", "no faces"]);
    assert_eq!(folder.files(), ["points.obj", "roof.obj"]);
    let scene = |build: &str| {
        format!(
            r#"{{ "format": "shape-up-scene", "version": 1, "mesh": {{ "file": "roof.obj" }}, "build": {build} }}"#
        )
    };
    for (build, words) in [
        (r#"{ "scale": 0 }"#, ["build.scale", "expected a number above 0"]),
        (r#"{ "scale": "1:50" }"#, ["build.scale", "expected a number"]),
        (r#"{ "kind": "corners" }"#, ["build.kind", "corner"]),
        (r#"{ "shet": [1, 2] }"#, ["build", "unknown key `shet`"]),
        (r#"{ "sheet": [1200] }"#, ["build.sheet", "expected"]),
        // Typing errors, at which files would not end or numbers would not be numbers.
        (r#"{ "scale": 1e-300 }"#, ["build.scale", "expected at least 0.001"]),
        (r#"{ "sheet": [1e300, 1e300] }"#, ["build.sheet[0]", "expected at most 100000"]),
        (r#"{ "joint": 1e300 }"#, ["build.joint", "expected at most"]),
        (r#"{ "distance": -1e300 }"#, ["build.distance", "at most"]),
    ] {
        folder.write("s.shapeup.json", scene(build));
        folder.run(&["build", "s.shapeup.json"]).refused(&words);
    }
    for asked in [
        ["--kind", "corners"],
        ["--product", "boxes"],
        ["--pieces", "bits"],
        ["--page", "a5"],
        ["--sheet", "1200"],
        ["--distance", "0"],
        ["--scale", "-1"],
    ] {
        let ended = folder.run(&["build", "roof.obj", asked[0], asked[1]]);
        assert_eq!(ended.code, Some(2), "{ended:?}");
        assert!(ended.err.contains(asked[0]), "{ended:?}");
    }
}

#[test]
fn every_setting_of_a_scene_is_an_option() {
    let folder = Folder::new("build-settings");
    folder.write("roof.obj", ROOF);
    for setting in BUILD_SETTINGS {
        let Some(option) = setting.option() else { continue };
        let value = match setting.form {
            BuildForm::Number { .. } if option == "--scale" => "20".to_owned(),
            BuildForm::Number { .. } => "0.25".to_owned(),
            BuildForm::Choice { options } => options[options.len() - 1].word.to_owned(),
            BuildForm::Switch => "on".to_owned(),
            BuildForm::Text => "oak".to_owned(),
            BuildForm::Edges => "0-1".to_owned(),
        };
        folder.run(&["build", "roof.obj", &option, &value]).done();
        if !setting.absent.is_empty() {
            folder.run(&["build", "roof.obj", &option, "auto"]).done();
        }
        let wrong = match setting.form {
            BuildForm::Number { .. } => "much",
            BuildForm::Choice { .. } => "none",
            BuildForm::Switch => continue,
            BuildForm::Text => "",
            BuildForm::Edges => "0-1-2",
        };
        let refused = folder.run(&["build", "roof.obj", &option, wrong]);
        refused.misused(&option);
    }
}

#[test]
fn paper_is_cut_along_seams_and_a_seam_that_is_no_edge_is_refused_with_its_path() {
    let folder = Folder::new("build-seams");
    folder.write("roof.obj", ROOF);
    let asked = ["build", "roof.obj", "--product", "paper", "--units=m", "--out", "parts"];
    let run = |more: &[&str]| folder.run(&[&asked[..], more].concat());
    assert!(run(&[]).done().contains("1 piece on "));
    let words = run(&["--seams", "1-4,7-4", "--report", "r.json"]).done();
    assert!(words.contains("2 pieces on ") && words.contains(", seams 2\n"), "{words}");
    assert_eq!(folder.json("r.json")["paper"]["seams"], 2);
    assert!(folder.read("parts/summary.csv").contains("Seams (seams),B1-4 B4-7,"));
    run(&["--seams", "1-4,0-4"]).refused(&[
        "roof.obj",
        "build.seams[1]",
        "[0, 4]",
        "ends of an edge",
    ]);
    run(&["--seams", "1-4,4-1"]).refused(&["build.seams[1]", "listed twice"]);
    run(&["--seams", "1-4,B4"]).misused("edges by their vertices, such as 3-4,4-9, or none");
    // A scene has them, unless others are asked for.
    let seams = r#", "build": { "product": "paper", "seams": [[1, 4], [7, 4]] }"#;
    folder.write("roof.json", scene(seams));
    assert!(folder.run(&["build", "roof.json"]).done().contains("2 pieces on "));
    let whole = folder.run(&["build", "roof.json", "--seams", "none"]).done();
    assert!(whole.contains("1 piece on ") && !whole.contains("seams"), "{whole}");
    folder.write("wrong.json", scene(&seams.replace("[7, 4]", "[8, 4]")));
    folder.run(&["build", "wrong.json"]).refused(&["wrong.json", "build.seams[1]", "[8, 4]"]);
    // They go along to another mesh.
    folder.run(&["refine", "roof.json", "--scheme", "linear", "--out", "fine.json"]).done();
    assert_eq!(folder.json("fine.json")["build"]["seams"].as_array().map(Vec::len), Some(4));
    assert!(folder.run(&["build", "fine.json"]).done().contains(", seams 4\n"));
}

#[test]
fn settings_of_the_workshop_are_used_and_listed_in_the_summary() {
    let folder = Folder::new("build-workshop");
    folder.write("roof.obj", ROOF);
    let asked = ["build", "roof.obj", "--units=m", "--scale", "1:20", "--sheet=1200x600"];
    let own = ["--kerf=0.2", "--gap", "4", "--margin=7", "--dxf=r12", "--outlines-only"];
    let more =
        ["--limits-warp=2", "--alike_deg", "1", "--mirror", "off", "--distance=0.1", "--out=parts"];
    folder.run(&[&asked[..], &own, &more].concat()).done();
    let summary = folder.read("parts/summary.csv");
    for line in [
        "Scale 1 : (scale),20,",
        "Sheet width (sheet[0]),1200,mm",
        "Kerf (kerf),0.2,mm",
        "Gap (gap),4,mm",
        "Margin (margin),7,mm",
        "Thickness (thickness),0.5,mm",
        "Joint (joint),0,m",
        "Distance (distance),0.1,m",
        "Drawings (dxf),r12,",
        "\"Outlines only, without names (outlines_only)\",on,",
        "Mirror images are alike (mirror),off,",
        "Warped beams (limits.warp),2,mm",
    ] {
        assert!(summary.contains(&format!("\r\n{line}\r\n")), "{line}: {summary}");
    }
    assert!(folder.read("parts/sheet-01.dxf").contains("AC1009"));
    let twice = ["build", "roof.obj", "--one_file_each", "--one-file-each", "off"];
    folder.run(&twice).misused("--one-file-each is given twice");
    let words = folder.run(&["build", "roof.obj", "--product=paper", "--tool=2"]).done();
    assert!(words.contains("note: of no effect on paper: --tool\n"), "{words}");
    // Those of a preset are no options that were given.
    let paper = ["build", "roof.obj", "--units", "m", "--product", "paper", "--machine", "laser"];
    let words = folder.run(&paper).done();
    assert!(!words.contains("of no effect"), "{words}");
}

#[test]
fn parts_alone_are_in_a_folder_of_their_own_and_those_of_an_earlier_build_are_named() {
    let folder = Folder::new("build-each");
    folder.write("roof.obj", ROOF);
    let asked = ["build", "roof.obj", "--one-file-each", "--out", "made"];
    let words = folder.run(&asked).done();
    assert!(words.contains("made/parts/P0.svg\n") && !words.contains("earlier one"), "{words}");
    assert!(folder.read("made/parts/P0.dxf").contains("CUT"));
    let words = folder.run(&[&asked[..], &["--product", "fins", "--thickness=1"]].concat()).done();
    assert!(
        words.contains("made/parts: not of this build, but of an earlier one: P0.dxf"),
        "{words}"
    );
    // The folder is not left behind if nothing can be written.
    folder.write("busy", "");
    folder.run(&["build", "roof.obj", "--one-file-each", "--out", "busy"]).refused(&["cannot be"]);
    folder
        .run(&["build", "roof.obj", "--one-file-each", "--out", "new", "--report", "gone/r.json"])
        .refused(&["cannot be"]);
    assert_eq!(folder.files(), ["busy", "made", "roof.obj"]);
}

#[test]
fn what_cannot_be_written_leaves_every_file_as_it_was_and_no_folder_behind() {
    let folder = Folder::new("build-half");
    folder.write("roof.obj", ROOF).write("busy", "");
    std::fs::create_dir_all(folder.0.join("parts/sheets.pdf")).unwrap();
    folder.write("parts/panels.csv", "of before").write("parts/sheet-01.svg", "of before");
    let mut places = vec![
        // One of the drawings is a folder: some files are written before it, and some after.
        ["parts", "r.json"],
        ["new/deep", "gone/r.json"],
        ["new/deep", "busy/r.json"],
        ["new/deep", "parts"],
        ["busy", "r.json"],
        ["busy/parts", "r.json"],
    ];
    // A full disk when only the last file is left to write.
    if std::path::Path::new("/dev/full").exists() {
        places.push(["new/deep", "/dev/full"]);
    }
    for [out, report] in places {
        folder
            .run(&["build", "roof.obj", "--out", out, "--report", report])
            .refused(&["cannot be"]);
        assert_eq!(folder.files(), ["busy", "parts", "roof.obj"], "{out} {report}");
        let mut parts: Vec<_> = std::fs::read_dir(folder.0.join("parts"))
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        parts.sort();
        assert_eq!(parts, ["panels.csv", "sheet-01.svg", "sheets.pdf"], "{out} {report}");
        for kept in ["parts/panels.csv", "parts/sheet-01.svg"] {
            assert_eq!(folder.read(kept), "of before", "{out} {report}");
        }
    }
    std::fs::remove_dir(folder.0.join("parts/sheets.pdf")).unwrap();
    folder.run(&["build", "roof.obj", "--out", "parts"]).done();
    assert!(folder.read("parts/panels.csv").starts_with("name,"));
    // The report was refused, as its folder was made with that of the parts only afterwards.
    let beside = ["--report", "job/report.json", "--report-page", "job/report.html"];
    folder.run(&[&["build", "roof.obj", "--out", "job/parts"][..], &beside].concat()).done();
    assert!(folder.read("job/report.json").starts_with('{'));
}
