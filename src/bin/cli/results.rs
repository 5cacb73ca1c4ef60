//! `shape-up check` of the results of a lesson: of one student (`RESULTS --scene SCENE`), against
//! the goals; or of a class (`FOLDER [--scene SCENE] [--csv FILE.csv]`), as a table.

use crate::cli::output::place;
use crate::cli::{Failure, input, output};
use shape_up::fabricate::file::not_a_formula;
use shape_up::scene::{GoalOf, GoalResult, NamedEnum, Results, SceneError};
use shape_up::session::{Checked, Error, check_results};
use shape_up::words;
use std::path::{Path, PathBuf};

/// The extension of scene files.
const SCENE: &str = ".shapeup.json";

const HEAD: [&str; 9] = [
    "student",
    "goals met",
    "goals",
    "worst distance",
    "moved",
    "iterations",
    "altered",
    "changed",
    "file",
];

/// Entries of column `altered`: for an unreadable file, and for one of another mesh or lesson. For
/// others that cannot be checked it is the reason.
const NOT_RESULTS: &str = "unreadable";
const OTHER: &str = "another mesh or lesson";

/// What a student handed in.
struct Row {
    file: String,
    /// None if the file is unreadable.
    results: Option<Results>,
    /// The measures, or why there are none.
    checked: Result<Checked, String>,
}

/// Checks all results files in `folder`, sorted by student. The default scene is the one in it.
pub(crate) fn check_class(
    folder: &Path,
    scene: Option<&Path>,
    csv: Option<&Path>,
) -> Result<(), Failure> {
    let at = |message: String| Failure::Input(format!("{}: {message}", folder.display()));
    let (scenes, handed_in): (Vec<PathBuf>, Vec<PathBuf>) =
        files(folder)?.into_iter().partition(|path| name(path).to_lowercase().ends_with(SCENE));
    let scene = match (scene, &*scenes) {
        (Some(scene), _) => scene,
        (None, [one]) => one,
        (None, []) => return Err(at(format!("no scene, expected one *{SCENE}, or --scene SCENE"))),
        (None, _) => return Err(at(format!("{} scenes, expected --scene SCENE", scenes.len()))),
    };
    let input = input::read(scene)?;
    let mut unreadable = Vec::new();
    let mut rows = Vec::new();
    let scene = place(scene);
    for path in handed_in.iter().filter(|path| place(path) != scene) {
        match read(path) {
            Ok(results) => {
                let checked = check_results(&results, input.scene.clone(), input.mesh.clone());
                let checked = checked.map_err(|error| match error {
                    Error::Scene(SceneError { path, .. }) if path == "scene" => OTHER.to_owned(),
                    error => error.to_string(),
                });
                rows.push(Row { file: name(path), results: Some(results), checked });
            }
            Err(failure) => {
                let checked = Err(NOT_RESULTS.to_owned());
                rows.push(Row { file: name(path), results: None, checked });
                unreadable.push(failure);
            }
        }
    }
    if rows.is_empty() {
        return Err(at("no results, expected files *.results.json".to_owned()));
    }
    let student = |row: &Row| row.results.as_ref().map(|results| results.student.to_lowercase());
    rows.sort_by_key(|row| (student(row), row.file.clone()));
    if let Some(csv) = csv {
        let lines = std::iter::once(HEAD.map(str::to_owned))
            .chain(rows.iter().map(|row| row.cells(|number| number.to_string())));
        let text: String = lines.map(|row| comma_separated(&row)).collect();
        output::write(&[(csv, text)])?;
    }
    output::print(&(aligned(&rows, &input.scene.units) + &output::notes(&input.remarks)))?;
    match unreadable.into_iter().next() {
        Some(first) => Err(first),
        None => Ok(()),
    }
}

/// Returns the files in a folder that may be scenes or results, sorted by name.
fn files(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let entries = std::fs::read_dir(folder).map_err(|error| {
        Failure::Input(format!("{}: cannot be read: {error}, expected a folder", folder.display()))
    })?;
    let paths = entries.filter_map(|entry| entry.ok().map(|entry| entry.path()));
    let mut paths: Vec<PathBuf> =
        paths.filter(|path| path.is_file() && input::is_scene(path)).collect();
    paths.sort();
    Ok(paths)
}

fn name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

impl Row {
    /// The entries of the columns [`HEAD`].
    fn cells(&self, number: fn(f64) -> String) -> [String; 9] {
        let of = |entry: &dyn Fn(&Checked) -> String| {
            self.checked.as_ref().map_or_else(|_| String::new(), entry)
        };
        let said =
            |entry: fn(&Results) -> String| self.results.as_ref().map_or_else(String::new, entry);
        let words = |it: &Checked| it.altered.iter().map(|lock| lock.word()).collect::<Vec<_>>();
        [
            said(|results| results.student.clone()),
            of(&|checked| met(checked).to_string()),
            of(&|checked| checked.goals.len().to_string()),
            of(&|checked| number(checked.distance)),
            of(&|checked| number(checked.moved)),
            said(|results| results.iterations.to_string()),
            self.checked.as_ref().map_or_else(String::clone, |checked| words(checked).join(" ")),
            of(&|checked| checked.changed.join("; ")),
            self.file.clone(),
        ]
    }
}

/// The number of goals met.
fn met(checked: &Checked) -> usize {
    checked.goals.iter().filter(|goal| goal.met).count()
}

/// Formats the table in aligned columns, without the column `changed`, which is long, and with
/// three digits of the numbers.
fn aligned(rows: &[Row], units: &str) -> String {
    let shown = |row: &Row| {
        let [student, met, of, distance, moved, iterations, altered, _, file] =
            row.cells(words::number);
        let goals = if of.is_empty() { "-".to_owned() } else { format!("{met} of {of}") };
        let altered = if altered.is_empty() { "no".to_owned() } else { altered };
        [student, goals, distance, moved, iterations, altered, file]
    };
    let unit = if units.is_empty() { String::new() } else { format!(" ({units})") };
    let [distance, moved] = ["worst distance", "moved"].map(|head| format!("{head}{unit}"));
    let head = ["student", "goals met", &distance, &moved, "iterations", "altered", "file"];
    let lines: Vec<[String; 7]> =
        std::iter::once(head.map(str::to_owned)).chain(rows.iter().map(shown)).collect();
    let is_passed = |it: &Checked| met(it) == it.goals.len() && it.altered.is_empty();
    let passed = rows.iter().filter(|row| row.checked.as_ref().is_ok_and(is_passed)).count();
    let files = words::count(rows.len(), "file", "files");
    output::table(&lines) + &format!("{passed} passed, of {files}\n")
}

/// Formats a line of CSV with fields that are no formulas: students' names are untrusted.
fn comma_separated(row: &[String]) -> String {
    let field = |text: &String| format!("\"{}\"", not_a_formula(text).replace('"', "\"\""));
    row.iter().map(field).collect::<Vec<_>>().join(",") + "\n"
}

pub(crate) fn check(path: &Path, scene: &Path) -> Result<(), Failure> {
    let at = |message: String| Failure::Input(format!("{}: {message}", path.display()));
    let results = read(path)?;
    let input = input::read(scene)?;
    let units = input.scene.units.clone();
    let checked = check_results(&results, input.scene, input.mesh);
    let checked = checked.map_err(|error| at(error.to_string()))?;
    output::print(&(words(&results, &checked, &units) + &output::notes(&input.remarks)))?;
    let missed = checked.goals.len() - met(&checked);
    if missed > 0 {
        return Err(at(format!("{missed} of {} goals not met, expected all", checked.goals.len())));
    }
    if let [first, ..] = &*checked.altered {
        return Err(at(format!(
            "locked {} altered, expected the same as in the scene",
            first.word()
        )));
    }
    Ok(())
}

fn words(results: &Results, checked: &Checked, units: &str) -> String {
    let mut lines = vec![
        format!("student     {}", results.student),
        format!("title       {}", results.title),
        format!("saved       {}", results.time),
        format!("iterations  {}", results.iterations),
        format!("moved       {}", words::length(checked.moved, units)),
        format!("distance    {}", words::length(checked.distance, units)),
    ];
    if !results.steps.is_empty() {
        lines.push(format!("steps       {}", results.steps.join("; ")));
    }
    if !checked.changed.is_empty() {
        lines.push(format!("changed     {}", checked.changed.join("; ")));
    }
    lines.extend(checked.altered.iter().map(|lock| format!("altered     locked {}", lock.word())));
    let said = results.goals.iter().map(Some).chain(std::iter::repeat(None));
    for (goal, said) in checked.goals.iter().zip(said) {
        let met = if goal.met { "met        " } else { "not met    " };
        let otherwise = said.is_none_or(|said| said.met != goal.met);
        let otherwise = if otherwise { ", but the file says otherwise" } else { "" };
        lines.push(format!("{met} {}{otherwise}", measured(goal)));
    }
    if !units.is_empty() {
        lines.push(format!("lengths in  {units}"));
    }
    lines.join("\n") + "\n"
}

/// Formats the subject of a goal, its value, and its limit.
fn measured(goal: &GoalResult) -> String {
    let of = match &goal.goal.of {
        GoalOf::Measure(id) => id.clone(),
        GoalOf::Beyond { measure, tolerance } => {
            format!("panels with {measure} beyond {}", words::brief(*tolerance))
        }
        GoalOf::Constraint(name) | GoalOf::Build(name) => name.clone(),
    };
    let value = goal.value.map_or("none".to_owned(), words::number);
    format!("{of}: {value}, at most {}", words::brief(goal.goal.at_most))
}

/// Reads a results file.
fn read(path: &Path) -> Result<Results, Failure> {
    let at = |message: String| Failure::Input(format!("{}: {message}", path.display()));
    let text = String::from_utf8(input::bytes(path, "results of a lesson")?)
        .map_err(|_| at("the file is not UTF-8 text, expected results in JSON".to_owned()))?;
    Results::from_json(&text).map_err(|error| at(error.to_string()))
}
