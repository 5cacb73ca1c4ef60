//! `shape-up check FOLDER [--scene SCENE] [--csv FILE.csv]`: tabulates the results of a class.

use super::super::{Failure, input, output};
use super::read;
use shape_up::scene::{NamedEnum, Results, SceneError};
use shape_up::session::Error;
use shape_up::session::{Checked, check_results};
use shape_up::words;
use std::path::{Path, PathBuf};

/// The extension of scene files.
const SCENE: &str = ".shapeup.json";

const HEAD: [&str; 9] = [
    "student",
    "goals met",
    "of",
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

/// Checks all results files in `folder`, sorted by student. The default scene is the one in it.
pub(crate) fn check(
    folder: &Path,
    scene: Option<&Path>,
    csv: Option<&Path>,
) -> Result<(), Failure> {
    let at = |message: String| Failure::Input(format!("{}: {message}", folder.display()));
    let (scenes, handed_in): (Vec<PathBuf>, Vec<PathBuf>) =
        files(folder)?.into_iter().partition(|path| name(path).ends_with(SCENE));
    let scene = match (scene, &*scenes) {
        (Some(scene), _) => scene,
        (None, [one]) => one,
        (None, []) => return Err(at(format!("no scene, expected one *{SCENE}, or --scene SCENE"))),
        (None, _) => return Err(at(format!("{} scenes, expected --scene SCENE", scenes.len()))),
    };
    let input = input::read(scene)?;
    let mut unreadable = Vec::new();
    let mut rows = Vec::new();
    for path in handed_in.iter().filter(|path| path.as_path() != scene) {
        match read(path) {
            Ok(results) => {
                let checked = check_results(&results, input.scene.clone(), input.mesh.clone());
                rows.push(row(path, &results, checked));
            }
            Err(failure) => {
                let mut row = [""; 9].map(str::to_owned);
                (row[6], row[8]) = (NOT_RESULTS.to_owned(), name(path));
                rows.push(row);
                unreadable.push(failure);
            }
        }
    }
    if rows.is_empty() {
        return Err(at("no results, expected files *.results.json".to_owned()));
    }
    rows.sort_by_key(|row| (row[0].to_lowercase(), row[8].clone()));
    if let Some(csv) = csv {
        let lines = std::iter::once(HEAD.map(str::to_owned).to_vec());
        let lines = lines.chain(rows.iter().map(|row| row.to_vec()));
        let text: String = lines.map(|row| comma_separated(&row)).collect();
        output::write(&[(csv, text)])?;
    }
    output::print(&aligned(&rows, &input.scene.units))?;
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
        paths.filter(|path| path.is_file() && name(path).ends_with(".json")).collect();
    paths.sort();
    Ok(paths)
}

fn name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

fn row(path: &Path, results: &Results, checked: Result<Checked, Error>) -> [String; 9] {
    let student = results.student.clone();
    let iterations = results.iterations.to_string();
    let checked = match checked {
        Ok(checked) => checked,
        Err(error) => {
            let altered = match error {
                Error::Scene(SceneError { path, .. }) if path == "scene" => OTHER.to_owned(),
                error => error.to_string(),
            };
            let [met, of, distance, moved, changed] = [""; 5].map(str::to_owned);
            let file = name(path);
            return [student, met, of, distance, moved, iterations, altered, changed, file];
        }
    };
    let met = checked.goals.iter().filter(|goal| goal.met).count();
    let altered: Vec<_> = checked.altered.iter().map(|lock| lock.word()).collect();
    [
        student,
        met.to_string(),
        checked.goals.len().to_string(),
        checked.distance.to_string(),
        checked.moved.to_string(),
        iterations,
        altered.join(" "),
        checked.changed.join("; "),
        name(path),
    ]
}

/// Formats the table in aligned columns, without the column `changed`, which is long, and with
/// three digits of the numbers.
fn aligned(rows: &[[String; 9]], units: &str) -> String {
    let shown = |row: &[String; 9]| {
        let [student, met, of, distance, moved, iterations, altered, _, file] = row.clone();
        let goals = if of.is_empty() { "-".to_owned() } else { format!("{met} of {of}") };
        let short = |number: String| number.parse().map_or(number, words::number);
        let (distance, moved) = (short(distance), short(moved));
        let altered = if altered.is_empty() { "no".to_owned() } else { altered };
        [student, goals, distance, moved, iterations, altered, file]
    };
    let unit = if units.is_empty() { String::new() } else { format!(" ({units})") };
    let head = [
        "student".to_owned(),
        "goals met".to_owned(),
        format!("worst distance{unit}"),
        format!("moved{unit}"),
        "iterations".to_owned(),
        "altered".to_owned(),
        "file".to_owned(),
    ];
    let lines: Vec<[String; 7]> = std::iter::once(head).chain(rows.iter().map(shown)).collect();
    let passed =
        rows.iter().filter(|row| !row[2].is_empty() && row[1] == row[2] && row[6].is_empty());
    let sum =
        format!("{} passed, of {}\n", passed.count(), words::count(rows.len(), "file", "files"));
    output::table(&lines) + &sum
}

/// Formats a line of CSV. A field that a spreadsheet would read as a formula (students' names are
/// untrusted) is turned into text.
fn comma_separated(row: &[String]) -> String {
    let field = |text: &String| {
        let text = match text.chars().next() {
            Some('=' | '+' | '-' | '@' | '\t' | '\r') => format!("'{text}"),
            _ => text.clone(),
        };
        format!("\"{}\"", text.replace('"', "\"\""))
    };
    row.iter().map(field).collect::<Vec<_>>().join(",") + "\n"
}
