//! The rooms of the crate know of each other what `src/lib.rs` says, and no more: the table there is
//! read, and every `crate::` path of a room is looked up in it. And each file of a room that lists its
//! files is in that list.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

fn source(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src").join(path)
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// All Rust files of a folder, or the file of that name.
fn files(room: &str) -> Vec<PathBuf> {
    let (mut found, mut folders) = (Vec::new(), vec![source(room)]);
    if source(&format!("{room}.rs")).exists() {
        found.push(source(&format!("{room}.rs")));
        folders.clear();
    }
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).expect("a room is a folder or a file") {
            let path = entry.expect("it can be listed").path();
            match path.extension() {
                Some(ending) if ending == "rs" => found.push(path),
                _ if path.is_dir() => folders.push(path),
                _ => {}
            }
        }
    }
    found
}

/// Per room what it knows of, as the table in `src/lib.rs` says.
fn table() -> BTreeMap<String, Vec<String>> {
    let mut known: Vec<(String, Vec<String>)> = Vec::new();
    for line in read(&source("lib.rs")).lines() {
        let Some(cells) = line.strip_prefix("//! | ").and_then(|row| row.strip_suffix(" |")) else {
            continue;
        };
        let [room, _, knows] = cells.split(" | ").collect::<Vec<_>>()[..] else { continue };
        let room = room.trim_matches(['[', ']', '`']).to_owned();
        let knows = match knows {
            "nothing" => Vec::new(),
            "all above" => known.iter().map(|(room, _)| room.clone()).collect(),
            rooms => rooms.split(", ").map(str::to_owned).collect(),
        };
        known.push((room, knows));
    }
    known.into_iter().filter(|(room, _)| room != "room").collect()
}

#[test]
fn a_room_knows_of_no_more_than_the_table_says() {
    let table = table();
    for (room, knows) in &table {
        for file in files(room) {
            // Tests may look at what is built upon what they test.
            let text = read(&file);
            let code = text.split("#[cfg(test)]").next().unwrap_or_default();
            for path in code.split("crate::").skip(1) {
                let other: String =
                    path.chars().take_while(|c| c.is_ascii_lowercase() || *c == '_').collect();
                let allowed = other == *room || knows.contains(&other);
                assert!(allowed, "{} knows of {other}", file.display());
                assert!(table.contains_key(&other), "{other} is not in the table");
            }
        }
    }
}

#[test]
fn every_room_is_in_the_table() {
    let table = table();
    let lib = read(&source("lib.rs"));
    let rooms = lib.lines().filter_map(|line| line.strip_prefix("pub mod ")?.strip_suffix(';'));
    assert_eq!(rooms.clone().count(), table.len());
    for room in rooms {
        assert!(table.contains_key(room), "{room}");
    }
}

/// The heads of rooms that list their files.
const LISTS: [&str; 30] = [
    "bin/cli/mod.rs",
    "experiment/mod.rs",
    "example/model/mod.rs",
    "mesh/closest/mod.rs",
    "mesh/edit/mod.rs",
    "mesh/io/mod.rs",
    "mesh/laplacian/mod.rs",
    "mesh/measure/mod.rs",
    "mesh/mod.rs",
    "mesh/topology/mod.rs",
    "constraint/kinds/shared/mod.rs",
    "constraint/mod.rs",
    "constraint/parameter/mod.rs",
    "example/mod.rs",
    "example/model/solid/mod.rs",
    "example/model/surface/mod.rs",
    "example/model/tool/mod.rs",
    "example/scene/mod.rs",
    "scene/json.rs",
    "scene/mod.rs",
    "session/edit/mod.rs",
    "session/mod.rs",
    "session/report/mod.rs",
    "session/run/mod.rs",
    "session/selection/mod.rs",
    "session/state/mod.rs",
    "session/undo/mod.rs",
    "solve/mod.rs",
    "view/mod.rs",
    "web/mod.rs",
];

#[test]
fn a_list_of_files_has_every_file_and_no_other() {
    for list in LISTS {
        let text = read(&source(list));
        let head: Vec<_> = text.lines().filter_map(|line| line.strip_prefix("//! ")).collect();
        let declared = text.lines().filter_map(|line| {
            line.trim_start_matches("pub ").strip_prefix("mod ")?.strip_suffix(';')
        });
        for module in declared {
            let name = format!("`{module}`");
            assert!(head.iter().any(|line| line.contains(&name)), "{list} does not list {module}");
        }
        let folder = source(list.trim_end_matches("mod.rs").trim_end_matches(".rs"));
        let rows = head.iter().filter_map(|line| line.strip_prefix("| `"));
        for row in rows {
            for name in row.split(" | ").next().unwrap_or_default().split(", ") {
                let name = name.trim_matches('`');
                let is_there = folder.join(format!("{name}.rs")).exists()
                    || folder.join(name).join("mod.rs").exists();
                assert!(is_there, "{list} lists {name}, which is not there");
            }
        }
    }
}
