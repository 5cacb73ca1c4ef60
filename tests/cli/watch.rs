//! `shape-up watch`.

use crate::cli::folder::{Folder, PLANES, ROOF, scene};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// The program, which is stopped at the end of the test.
struct Watching(Child);

impl Watching {
    /// Begins to watch in a folder; what is wrong is written to the file `wrong` there.
    fn begin(folder: &Folder, arguments: &[&str]) -> Watching {
        let wrong = std::fs::File::create(folder.0.join("wrong")).unwrap();
        let mut program = Command::new(env!("CARGO_BIN_EXE_shape-up"));
        program.arg("watch").args(arguments).current_dir(&folder.0);
        Watching(program.stdout(Stdio::null()).stderr(wrong).spawn().unwrap())
    }
}

impl Drop for Watching {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// Waits until the text of a file is as wanted, and returns it.
#[track_caller]
fn wait_for(folder: &Folder, name: &str, wanted: impl Fn(&str) -> bool) -> String {
    let begun = Instant::now();
    loop {
        let text = std::fs::read_to_string(folder.0.join(name)).unwrap_or_default();
        if wanted(&text) {
            return text;
        }
        assert!(begun.elapsed() < Duration::from_secs(60), "{name} stays {text:?}");
        std::thread::sleep(Duration::from_millis(50));
    }
}

#[test]
fn a_file_is_solved_again_whenever_it_is_saved() {
    let folder = Folder::new("watch");
    folder.write("roof.obj", ROOF);
    let press = ["roof.obj", "--panels", "circle", "--within", "auto", "--out", "out.obj"];
    let _watching = Watching::begin(&folder, &press);
    let first = wait_for(&folder, "out.obj", |text| text.contains("\nf "));
    // What is wrong is said, and the last result stays.
    folder.write("roof.obj", "f 1 2 3\n");
    wait_for(&folder, "wrong", |text| text.starts_with("roof.obj: the file has no vertices"));
    assert_eq!(folder.read("out.obj"), first);
    folder.write("roof.obj", ROOF.replace("v 2 2 -0.3", "v 2 2 0.4"));
    wait_for(&folder, "out.obj", |text| text != first && text.contains("\nf "));
}

#[test]
fn a_scene_is_solved_again_when_its_mesh_is_saved() {
    let folder = Folder::new("watch-scene");
    folder.write("roof.obj", ROOF).write("roof.json", scene(PLANES));
    let _watching = Watching::begin(&folder, &["roof.json", "--out", "out.obj"]);
    let first = wait_for(&folder, "out.obj", |text| text.contains("\nf "));
    folder.write("roof.obj", ROOF.replace("v 2 2 -0.3", "v 2 2 0.4"));
    wait_for(&folder, "out.obj", |text| text != first && text.contains("\nf "));
}

#[test]
fn each_mesh_that_is_saved_in_a_folder_comes_back_solved() {
    let folder = Folder::new("watch-folder");
    std::fs::create_dir(folder.0.join("models")).unwrap();
    folder.write("models/roof.obj", ROOF).write("models/notes.txt", "not a mesh");
    let press = ["models", "--panels", "circle", "--within", "auto", "--out", "solved"];
    let _watching = Watching::begin(&folder, &press);
    let first = wait_for(&folder, "solved/roof.obj", |text| text.contains("\nf "));
    assert_ne!(first, ROOF);
    // Another one is wrong, which is said, then right.
    folder.write("models/eave.obj", "f 1 2 3\n");
    wait_for(&folder, "wrong", |text| text.contains("eave.obj: the file has no vertices"));
    folder.write("models/eave.obj", ROOF.replace("v 2 2 -0.3", "v 2 2 0.4"));
    let eave = wait_for(&folder, "solved/eave.obj", |text| text.contains("\nf "));
    assert_ne!(eave, first);
    assert_eq!(folder.read("solved/roof.obj"), first);
    let solved: Vec<_> = std::fs::read_dir(folder.0.join("solved")).unwrap().collect();
    assert_eq!(solved.len(), 2);
}

#[test]
fn a_folder_is_solved_into_another_one() {
    let folder = Folder::new("watch-folders");
    folder.write("roof.obj", ROOF);
    folder.run(&["watch", ".", "--out", "."]).misused("another folder");
    let reported = ["watch", ".", "--out", "solved", "--report", "r.json"];
    folder.run(&reported).misused("no --report");
    folder.run(&["watch", ".", "--out", "roof.obj"]).refused(&["roof.obj", "expected a folder"]);
}

#[test]
fn what_is_wrong_at_first_is_said_and_waited_for() {
    let folder = Folder::new("watch-first");
    folder.write("roof.obj", "f 1 2 3\n");
    let press = ["roof.obj", "--panels", "circle", "--within", "auto", "--out", "out.obj"];
    let _watching = Watching::begin(&folder, &press);
    wait_for(&folder, "wrong", |text| text.starts_with("roof.obj: the file has no vertices"));
    folder.write("roof.obj", ROOF);
    wait_for(&folder, "out.obj", |text| text.contains("\nf "));
}

#[test]
fn nothing_that_is_watched_is_overwritten_and_what_is_not_there_is_said() {
    let folder = Folder::new("watch-faults");
    folder.write("roof.obj", ROOF).write("roof.json", scene(PLANES));
    folder
        .run(&["watch", "roof.json", "--out", "roof.obj"])
        .misused("roof.obj would replace a file that is read");
    folder.run(&["watch", "none.obj", "--out", "out.obj"]).refused(&["none.obj"]);
    assert_eq!(folder.read("roof.obj"), ROOF);
}

#[test]
fn a_file_to_write_is_needed() {
    let folder = Folder::new("watch-nothing");
    folder.write("roof.obj", ROOF).run(&["watch", "roof.obj"]).misused("watch needs --out");
    let both = ["watch", "roof.obj", "--exact", "--within", "1", "--out", "o.obj"];
    folder.run(&both).misused("watch takes --exact or --within, not both");
}
