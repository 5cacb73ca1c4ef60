//! The table of the paper's capabilities refers to existing files, tests and examples.

use shape_up::generate::example::EXAMPLES;
use std::fs::read_to_string;
use std::path::Path;

const TABLE: &str = include_str!("../src/capabilities.md");

/// The cells of each row.
fn rows() -> Vec<Vec<&'static str>> {
    let lines = TABLE.lines().filter(|line| line.starts_with("| ")).skip(1);
    lines.map(|line| line.trim_matches('|').split('|').map(str::trim).collect()).collect()
}

/// Quoted text in backticks, with the word before it.
fn quoted(cell: &str) -> Vec<(&str, &str)> {
    let parts: Vec<&str> = cell.split('`').collect();
    parts.chunks_exact(2).map(|pair| (pair[0].trim_start_matches(',').trim(), pair[1])).collect()
}

#[test]
fn it_has_the_46_rows_each_with_a_place_a_check_and_a_bound() {
    let rows = rows();
    let numbers: Vec<String> = rows.iter().map(|row| row[0].to_owned()).collect();
    assert_eq!(numbers, (1..=46).map(|n| n.to_string()).collect::<Vec<_>>());
    for row in &rows {
        assert_eq!(row.len(), 5, "{row:?}");
        assert!(row.iter().all(|cell| !cell.is_empty()), "{row:?}");
        assert!(!quoted(row[2]).is_empty() && !quoted(row[3]).is_empty(), "{row:?}");
    }
}

#[test]
fn every_file_test_and_example_that_it_names_is_there() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for row in rows() {
        for (_, file) in quoted(row[2]) {
            assert!(root.join(file).is_file(), "row {}: there is no {file}", row[0]);
        }
        for (what, name) in quoted(row[3]) {
            if what == "example" {
                assert!(EXAMPLES.iter().any(|it| it.id == name), "row {}: {name}", row[0]);
                continue;
            }
            let (file, test) = name.split_once("::").expect("a file and a test in it");
            let text = read_to_string(root.join(file)).expect("the file of the test is there");
            let known = match file.ends_with(".rs") {
                true => text.contains(&format!("fn {test}(")),
                false => text.contains(&format!("test('{test}'")),
            };
            assert!(known, "row {}: {file} has no {test}", row[0]);
        }
    }
}
