//! The README's table of operators is the list of kinds. `UPDATE=1 cargo test --test readme` writes it.

use shape_up::constraint::{Info, KINDS};
use std::fmt::Write;

const START: &str = "<!-- operators: written by `UPDATE=1 cargo test --test readme` -->\n";
const END: &str = "<!-- end of operators -->\n";

fn table() -> String {
    let mut table = "| kind | what it asks | parameters | takes | paper | exact |\n\
                     |---|---|---|---|---|---|\n"
        .to_owned();
    for info in KINDS {
        let Info { id, summary, paper, params, exact, .. } = info;
        let params: Vec<String> = params.iter().map(|param| format!("`{}`", param.id)).collect();
        let params = params.join(", ");
        let takes = info.takes();
        let [params, paper] = [&*params, paper].map(|t| if t.is_empty() { "–" } else { t });
        let exact = if *exact { "yes" } else { "no" };
        writeln!(table, "| `{id}` | {summary} | {params} | {takes} | {paper} | {exact} |")
            .expect("a string takes everything");
    }
    table
}

#[test]
fn the_table_of_operators_is_the_list_of_kinds() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/README.md");
    let readme = std::fs::read_to_string(path).expect("there is a README");
    let (before, rest) = readme.split_once(START).expect("the README has the start of the table");
    let (_, after) = rest.split_once(END).expect("the README has the end of the table");
    let expected = format!("{before}{START}\n{}\n{END}{after}", table());
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(path, &expected).expect("the README can be written");
    }
    assert!(
        std::env::var_os("UPDATE").is_some() || readme == expected,
        "the table of operators in the README is out of date: UPDATE=1 cargo test --test readme"
    );
}
