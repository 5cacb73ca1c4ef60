//! `check RESULTS --scene SCENE`: handed-in results are measured again.

use crate::cli::folder::{Folder, PLANES, ROOF, scene};
use shape_up::scene::Scene;
use shape_up::session::Session;

const LESSON: &str = r#", "lesson": { "text": "Make it flat.", "goals": [
    { "measure": "planarity", "at_most": 0.001 }, { "constraint": "Plane", "at_most": 0.01 }] }"#;

/// The scene with a lesson, as opened.
fn session(lesson: &str) -> Session {
    let mesh = shape_up::mesh::read("roof.obj", ROOF.as_bytes()).unwrap().mesh;
    let scene = Scene::from_json(&scene(&format!("{PLANES}{lesson}"))).unwrap();
    Session::open(scene, mesh).unwrap()
}

/// Results of the student Ada for that scene: as opened, or solved.
fn results(solved: bool) -> String {
    let mut session = session(LESSON);
    if solved {
        session.solve(false).unwrap();
    }
    session.results("Ada Lovelace", "2026-11-20").unwrap().to_json()
}

fn folder(name: &str) -> Folder {
    let folder = Folder::new(name);
    folder.write("roof.obj", ROOF).write("s.json", scene(&format!("{PLANES}{LESSON}")));
    folder.write("good.json", results(true)).write("bad.json", results(false));
    folder
}

#[test]
fn results_that_meet_the_goals_pass() {
    let out = folder("passed").run(&["check", "good.json", "--scene", "s.json"]).done();
    assert!(out.contains("Ada Lovelace") && out.contains("met         planarity: "), "{out}");
    assert!(!out.contains("not met") && !out.contains("otherwise"), "{out}");
}

#[test]
fn what_is_left_as_it_is_in_the_mesh_is_said_wherever_it_is_read() {
    let folder = Folder::new("noted");
    let text = format!("{ROOF}f 1 2 5 1 4\n");
    let mesh = shape_up::mesh::read("roof.obj", text.as_bytes()).unwrap().mesh;
    let scene = scene(&format!("{PLANES}{LESSON}"));
    let mut session = Session::open(Scene::from_json(&scene).unwrap(), mesh).unwrap();
    session.solve(false).unwrap();
    folder.write("roof.obj", text).write("s.shapeup.json", scene);
    folder.write("a.results.json", session.results("Ada", "").unwrap().to_json());
    for asked in [
        &["check", "a.results.json", "--scene", "s.shapeup.json"][..],
        &["check", "."],
        &["experiment", "s.shapeup.json", "--iterations", "2"],
    ] {
        let out = folder.run(asked).done();
        assert!(out.contains("note: 1 face with the same vertex at two corners"), "{out}");
    }
}

#[test]
fn results_that_only_say_so_do_not() {
    let folder = folder("missed");
    let claimed = folder.read("bad.json").replace("\"met\": false", "\"met\": true");
    let ended = folder.write("bad.json", claimed).run(&["check", "bad.json", "--scene", "s.json"]);
    assert_eq!(ended.code, Some(1), "{ended:?}");
    assert_eq!(ended.err, "bad.json: 2 of 2 goals not met, expected all\n");
    assert_eq!(ended.out.matches("not met").count(), 2, "{ended:?}");
    assert_eq!(ended.out.matches("but the file says otherwise").count(), 2, "{ended:?}");
}

#[test]
fn results_with_one_locked_part_altered_do_not_pass() {
    let locked = LESSON.replace("\"goals\"", "\"lock\": [\"weights\"], \"goals\"");
    let mut session = session(&locked);
    session.solve(false).unwrap();
    let mut results = session.results("Mallory", "").unwrap();
    results.weights.as_mut().unwrap().close = 0.5;
    let folder = Folder::new("altered");
    folder.write("roof.obj", ROOF).write("s.json", scene(&format!("{PLANES}{locked}")));
    folder.write("r.json", results.to_json());
    let ended = folder.run(&["check", "r.json", "--scene", "s.json"]);
    assert_eq!(ended.code, Some(1), "{ended:?}");
    assert_eq!(ended.err, "r.json: locked weights altered, expected the same as in the scene\n");
}

#[test]
fn results_of_something_else_are_refused() {
    let folder = folder("else");
    let check = |results: &str, scene: &str| folder.run(&["check", results, "--scene", scene]);
    folder.write("easy.json", folder.read("s.json").replace("0.001", "0.5"));
    check("good.json", "easy.json").refused(&["good.json: scene: ", "another mesh or lesson"]);
    folder.write("plain.json", scene(PLANES));
    check("good.json", "plain.json").refused(&["good.json: ", "no lesson"]);
    check("s.json", "s.json").refused(&["s.json: format: ", "shape-up-results"]);
    check("gone.json", "s.json").refused(&["gone.json: cannot be read", "results"]);
    folder.write("cut.json", folder.read("good.json").replace("\"student\"", "\"name\""));
    check("cut.json", "s.json").refused(&["cut.json: ", "unknown key `name`"]);
    folder
        .run(&["check", "good.json", "--scene", "s.json", "--report", "r.json"])
        .misused("report");
}

#[test]
fn a_folder_of_results_becomes_a_table() {
    let folder = folder("class");
    let class = folder.0.join("class");
    std::fs::create_dir_all(&class).unwrap();
    folder.write("class/roof.obj", ROOF).write("class/s.shapeup.json", folder.read("s.json"));
    folder.write("class/1.results.json", folder.read("good.json"));
    let other = folder.read("bad.json").replace("Ada Lovelace", "=HYPERLINK(\\\"x\\\")");
    folder.write("class/2.results.json", other.replace("\"passed\": false", "\"passed\": true"));
    let scene = folder.read("bad.json");
    let at = scene.find("\"scene\": \"").unwrap() + 10;
    let strange = format!("{}0000000000000000{}", &scene[..at], &scene[at + 16..]);
    folder.write("class/3.results.JSON", strange.replace("Ada Lovelace", "Charles Babbage"));
    let out = folder.run(&["check", "class", "--csv", "t.csv"]).done();
    let lines: Vec<&str> = out.lines().collect();
    assert_eq!(lines.len(), 5, "{out}");
    assert!(lines[0].starts_with("student ") && lines[0].contains("worst distance"), "{out}");
    assert!(lines[1].starts_with("=HYPERLINK") && lines[1].contains("0 of 2"), "{out}");
    assert!(lines[2].starts_with("Ada Lovelace ") && lines[2].contains("2 of 2"), "{out}");
    assert!(lines[3].contains("another mesh or lesson"), "{out}");
    assert_eq!(lines[4], "1 passed, of 3 files");
    let table = folder.read("t.csv");
    assert!(table.contains("\"'=HYPERLINK(\"\"x\"\")\",\"0\",\"2\""), "{table}");
    assert_eq!(table.lines().count(), 4);
    // An unreadable file has a row too, and the summary reports it.
    folder.write("class/4.results.json", "{");
    let ended = folder.run(&["check", "class", "--scene", "s.json"]);
    assert_eq!(ended.code, Some(1), "{ended:?}");
    assert!(
        ended.out.contains("unreadable") && ended.err.starts_with("class/4.results.json: "),
        "{ended:?}"
    );
}

#[test]
fn positions_that_do_not_fit_are_called_so() {
    let folder = folder("positions");
    let mut cut = shape_up::scene::Results::from_json(&results(true)).unwrap();
    cut.positions.pop();
    std::fs::create_dir_all(folder.0.join("class")).unwrap();
    folder.write("class/cut.json", cut.to_json());
    let message = "positions: found 8 positions, expected one for each of the 9 vertices";
    folder.run(&["check", "class/cut.json", "--scene", "s.json"]).refused(&[message]);
    let table = folder.run(&["check", "class", "--scene", "s.json"]).done();
    assert!(table.contains(message), "{table}");
    // The scene is no result, however its name is written.
    folder.write("class/roof.obj", ROOF).write("class/s.json", folder.read("s.json"));
    let table = folder.run(&["check", "./class", "--scene", "class/../class/s.json"]).done();
    assert!(table.contains(message) && table.ends_with("of 1 file\n"), "{table}");
}

#[test]
fn a_folder_without_a_scene_or_results_is_refused() {
    let folder = Folder::new("no-class");
    std::fs::create_dir_all(folder.0.join("class")).unwrap();
    folder.run(&["check", "class"]).refused(&["class: no scene", "--scene"]);
    folder.write("roof.obj", ROOF).write("s.json", scene(&format!("{PLANES}{LESSON}")));
    folder.run(&["check", "class", "--scene", "s.json"]).refused(&["class: no results"]);
    folder.run(&["check", "class", "--report", "r.json"]).misused("--csv");
    folder.run(&["check", "s.json", "--csv", "t.csv"]).misused("folder");
}
