//! The structure of `src/`, read from its text:
//!
//! - A room uses only the rooms that the table in `src/lib.rs` allows.
//! - Dependencies between the files and folders of a folder have no cycles. An item that a `mod.rs`
//!   re-exports counts as used at its definition.
//! - A folder contains few enough files to be read as a list.
//! - The table at the head of a `mod.rs` lists all files and folders beside it. A folder without
//!   folders needs no table.
//! - No two public types have the same name.

use crate::support::sources::{Sources, cycle};
use std::collections::{BTreeMap, BTreeSet};

/// Limit of files per folder; a longer list would not be read.
const MOST_FILES: usize = 25;

/// Folders that may have more files.
const LARGE_FOLDERS: &[(&str, &str)] =
    &[("constraint/kinds", "the operators, one file each: their list is the table of contents")];

/// Folders whose files have cyclic dependencies.
const CIRCLES: &[(&str, &str)] = &[];

/// Names of several public types.
const SHARED_NAMES: &[(&str, &str)] =
    &[("Solver", "the wasm class of that name is a face of the solver")];

/// Rooms whose heads list their files in another way, or not yet.
const WITHOUT_TABLE: [&str; 1] = ["constraint/kinds"];

#[test]
fn a_room_knows_of_no_more_than_the_table_says() {
    let sources = Sources::read();
    let table = table(&sources);
    for (module, text) in &sources.modules {
        let Some(room) = module.first() else { continue };
        let knows = table.get(room).unwrap_or_else(|| panic!("`{room}` is not in the table"));
        for path in text.code.split("crate::").skip(1) {
            let is_name = |c: &char| c.is_ascii_lowercase() || *c == '_';
            let other: String = path.chars().take_while(is_name).collect();
            let allowed = other == *room || knows.contains(&other);
            assert!(
                allowed,
                "src/{} knows of `{other}`, which src/lib.rs does not allow",
                text.file
            );
        }
    }
}

#[test]
fn every_room_is_in_the_table() {
    let sources = Sources::read();
    let table = table(&sources);
    let root = &sources.modules[&Vec::new()];
    let rooms: BTreeSet<&String> = root.children.iter().collect();
    assert_eq!(rooms, table.keys().collect(), "the rooms and the table in src/lib.rs");
}

/// For each room, the rooms that it may use, from the table in `src/lib.rs`.
fn table(sources: &Sources) -> BTreeMap<String, Vec<String>> {
    let mut known: Vec<(String, Vec<String>)> = Vec::new();
    for line in sources.modules[&Vec::new()].head.lines() {
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
fn what_is_in_a_folder_knows_of_each_other_in_one_direction() {
    let sources = Sources::read();
    let uses = sources.uses();
    let mut wrong = Vec::new();
    for folder in sources.folders() {
        let name = folder.join("/");
        let found = cycle(&folder, &uses);
        let expected = CIRCLES.iter().any(|(known, _)| *known == name);
        match found {
            Some(steps) if !expected => wrong.push(format!("src/{name}:\n{}", steps.join("\n"))),
            None if expected => {
                wrong.push(format!("src/{name} has no circle: strike it off the list"));
            }
            _ => {}
        }
    }
    assert!(wrong.is_empty(), "files know of each other in circles:\n{}", wrong.join("\n"));
}

#[test]
fn a_folder_holds_no_more_files_than_are_read() {
    let sources = Sources::read();
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for text in sources.modules.values() {
        let folder = text.file.rsplit_once('/').map_or("", |(folder, _)| folder);
        *counts.entry(folder.to_owned()).or_default() += 1;
    }
    for (folder, count) in counts {
        let is_known = LARGE_FOLDERS.iter().any(|(known, _)| *known == folder);
        assert!(
            count <= MOST_FILES || is_known,
            "src/{folder} has {count} files, expected no more than {MOST_FILES}"
        );
    }
}

#[test]
fn a_table_of_files_has_every_file_and_no_other() {
    let modules = Sources::read().modules;
    for (module, text) in &modules {
        let rows = text.head.lines().filter_map(|line| line.strip_prefix("//! | `"));
        let listed: BTreeSet<String> = rows
            .flat_map(|row| row.split(" | ").next().unwrap_or_default().split(", "))
            .map(|name| name.trim_matches('`').to_owned())
            .collect();
        let is_folder = |name: &String| {
            let child: Vec<String> = module.iter().chain([name]).cloned().collect();
            modules[&child].file.ends_with("mod.rs")
        };
        let is_leaf = !text.children.iter().any(is_folder);
        let needs_none = is_leaf && listed.is_empty();
        let is_exempt = needs_none || WITHOUT_TABLE.contains(&module.join("/").as_str());
        if text.file.ends_with("mod.rs") && !is_exempt {
            let there: BTreeSet<String> = text.children.iter().cloned().collect();
            assert_eq!(listed, there, "the table of src/{} and the files", text.file);
        }
    }
}

#[test]
fn no_two_public_types_have_one_name() {
    let sources = Sources::read();
    let mut places: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for text in sources.modules.values() {
        for name in &text.public_types {
            places.entry(name).or_default().insert(&text.file);
        }
    }
    let wrong: Vec<String> = places
        .iter()
        .filter(|(name, places)| {
            (places.len() > 1) != SHARED_NAMES.iter().any(|(known, _)| known == *name)
        })
        .map(|(name, places)| format!("{name}: {places:?}"))
        .collect();
    assert!(wrong.is_empty(), "names of several types, or listed as such:\n{}", wrong.join("\n"));
}
