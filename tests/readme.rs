//! The README is correct: its table of operators is the list of kinds
//! (`UPDATE=1 cargo test readme` writes it), its scene can be read, and the description of
//! the scene file has every selector.

use shape_up::constraint::{Element, Info, KINDS};
use shape_up::scene::Scene;
use std::fmt::Write;

const START: &str = "<!-- operators: written by `UPDATE=1 cargo test readme` -->\n";
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

const PATH: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/README.md");

fn readme() -> String {
    std::fs::read_to_string(PATH).expect("there is a README")
}

#[test]
fn its_scene_is_one() {
    let readme = readme();
    let (_, rest) = readme.split_once("```json\n").expect("it shows a scene");
    let (text, _) = rest.split_once("```").expect("which ends");
    let scene = Scene::from_json(text).expect("it can be read");
    assert_eq!(scene.constraints.len(), 4);
    assert_eq!(scene.handles.len(), 2);
}

#[test]
fn every_selector_is_described() {
    let source = concat!(env!("CARGO_MANIFEST_DIR"), "/src/scene/json/mod.rs");
    let source = std::fs::read_to_string(source).expect("the scene file is described there");
    let docs: String = source.lines().filter(|line| line.starts_with("//!")).collect();
    for element in Element::ALL {
        let word = element.word_for_all().unwrap_or(element.id());
        assert!(docs.contains(&format!("\"{word}\"")), "{word}");
    }
}

#[test]
fn the_table_of_operators_is_the_list_of_kinds() {
    let readme = readme();
    let (before, rest) = readme.split_once(START).expect("the README has the start of the table");
    let (_, after) = rest.split_once(END).expect("the README has the end of the table");
    let expected = format!("{before}{START}\n{}\n{END}{after}", table());
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(PATH, &expected).expect("the README can be written");
    }
    assert!(
        std::env::var_os("UPDATE").is_some() || readme == expected,
        "the table of operators in the README is out of date: UPDATE=1 cargo test readme"
    );
}
