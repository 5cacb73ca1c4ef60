//! The documentation is correct: its table of operators is the list of kinds
//! (`UPDATE=1 cargo test documentation` writes it), its scene can be read, and the description of the
//! scene file has every selector.

use shape_up::constraint::{Element, Info, KINDS};
use shape_up::generate::NEW_KINDS;
use shape_up::scene::Scene;
use std::fmt::Write;
use std::path::{Path, PathBuf};

const START: &str = "<!-- operators: written by `UPDATE=1 cargo test documentation` -->\n";
const END: &str = "<!-- end of operators -->\n";

fn table() -> String {
    let mut table = "| kind | what it asks | parameters | takes | paper | exact |\n\
                     |---|---|---|---|---|---|\n"
        .to_owned();
    for info in KINDS {
        let Info { id, summary, paper, params, exact, .. } = info;
        let params: Vec<String> = params.iter().map(|param| format!("`{}`", param.id)).collect();
        let params = params.join(", ");
        let takes = info.arity_in_words();
        let [params, paper] = [&*params, paper].map(|t| if t.is_empty() { "–" } else { t });
        let exact = if *exact { "yes" } else { "no" };
        writeln!(table, "| `{id}` | {summary} | {params} | {takes} | {paper} | {exact} |")
            .expect("a string takes everything");
    }
    table
}

/// Reads a file of the project.
fn text(path: &str) -> String {
    std::fs::read_to_string(at(path)).expect("it is there")
}

fn at(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// The documentation at the head of a module.
fn head(path: &str) -> String {
    let text = text(path);
    let lines = text.lines().map_while(|line| line.strip_prefix("//!"));
    lines.map(|line| line.strip_prefix(' ').unwrap_or(line)).collect::<Vec<_>>().join("\n")
}

#[test]
fn the_readme_is_short_and_its_counts_are_right() {
    let text = text("README.md");
    let [lines, words] = [text.lines().count(), text.split_whitespace().count()];
    assert!(lines <= 100 && words <= 900, "{lines} lines, {words} words");
    let programs = at("tests/library").read_dir().expect("it is there").count();
    let sentences = ["ten kinds", "the 23 operators", "six [programs](tests/library)"];
    assert_eq!([NEW_KINDS.len(), KINDS.len(), programs], [10, 23, 6], "change {sentences:?}");
    for sentence in sentences {
        assert!(text.contains(sentence), "{sentence}");
    }
}

const SCENE_FILE: &str = "src/scene/json/mod.rs";

#[test]
fn the_scene_that_it_shows_is_one() {
    let docs = head(SCENE_FILE);
    let (_, rest) = docs.split_once("```json\n").expect("it shows a scene");
    let (text, _) = rest.split_once("```").expect("which ends");
    let scene = Scene::from_json(text).expect("it can be read");
    assert_eq!(scene.constraints.len(), 4);
    assert_eq!(scene.handles.len(), 2);
}

#[test]
fn every_selector_is_described() {
    let docs = head(SCENE_FILE);
    for element in Element::ALL {
        let word = element.word_for_all().unwrap_or(element.id());
        assert!(docs.contains(&format!("\"{word}\"")), "{word}");
    }
}

#[test]
fn the_table_of_operators_is_the_list_of_kinds() {
    const PATH: &str = "src/constraint/operators.md";
    let page = text(PATH);
    let (before, rest) = page.split_once(START).expect("it has the start of the table");
    let (_, after) = rest.split_once(END).expect("it has the end of the table");
    let expected = format!("{before}{START}\n{}\n{END}{after}", table());
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(at(PATH), &expected).expect("it can be written");
    }
    assert!(
        std::env::var_os("UPDATE").is_some() || page == expected,
        "the table of operators in {PATH} is out of date: UPDATE=1 cargo test documentation"
    );
}
