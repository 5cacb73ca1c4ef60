//! The words of the command line.

use shape_up::constraint::KINDS;
use shape_up::scene::{Accelerator, Worded};
use shape_up::solve::{ConformalNorm, ConformalWeights};
use std::ffi::{OsStr, OsString};
use std::path::PathBuf;

/// What is asked for.
#[derive(Debug, PartialEq)]
pub(super) enum Command {
    Solve(Solve),
    Check {
        mesh: PathBuf,
        report: Option<PathBuf>,
    },
    /// `shape-up check RESULTS --scene SCENE`.
    CheckResults {
        results: PathBuf,
        scene: PathBuf,
    },
    Parametrize(Parametrize),
    Examples {
        out: Option<PathBuf>,
    },
    Experiments,
    Experiment(Experiment),
    Operators,
    Help,
    Version,
}

/// `shape-up solve`.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Solve {
    /// A scene or a mesh.
    pub(super) input: PathBuf,
    /// The id of the kind that is asked of every face.
    pub(super) panels: Option<&'static str>,
    pub(super) iterations: Option<u32>,
    pub(super) tolerance: Option<f64>,
    pub(super) accelerator: Option<Accelerator>,
    pub(super) out: Option<PathBuf>,
    pub(super) report: Option<PathBuf>,
    pub(super) trace: bool,
}

/// `shape-up parametrize`.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Parametrize {
    pub(super) mesh: PathBuf,
    pub(super) weights: ConformalWeights,
    pub(super) norm: ConformalNorm,
    pub(super) out: Option<PathBuf>,
    pub(super) report: Option<PathBuf>,
}

/// `shape-up experiment`.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Experiment {
    /// The id of an example.
    pub(super) example: String,
    pub(super) iterations: Option<u32>,
    pub(super) seconds: Option<f64>,
    pub(super) csv: Option<PathBuf>,
}

/// How the program is called.
pub(super) fn usage() -> String {
    format!(
        "\
usage: shape-up solve SCENE|MESH [--panels KIND] [--iterations N] [--tolerance T]
                [--accelerator {}]
                [--out FILE.obj|FILE.mesh] [--report FILE.json] [--trace]
       shape-up check MESH [--report FILE.json]
       shape-up check RESULTS --scene SCENE
       shape-up parametrize MESH [--weights {}] [--norm {}]
                [--out UV.obj] [--report FILE.json]
       shape-up examples [--out DIR]
       shape-up experiment [EXAMPLE] [--iterations N] [--seconds T] [--csv FILE.csv]
       shape-up operators
       shape-up --help | --version

A SCENE is a *.json file, a MESH is OBJ, OFF or Medit (.obj, .off, .mesh).
--panels asks for a KIND of shape on every face that can have it. The kinds are:
 {}
A MESH is solved with the settings that keep it whole, a scene with its own.
--iterations, --tolerance (0 never stops early) and --accelerator replace the settings of the scene.
--out writes OBJ, or where the name ends in .mesh, Medit, which has tetrahedra.
--trace records the energies of every iteration, in the report and on standard output.
RESULTS is what a student hands in of a lesson: check measures its shape with the goals and the
constraints of the SCENE, and ends with 1 when one is not met.
parametrize makes a flat map that keeps angles; --out writes the mesh with the map as its vt.
experiment solves an example of the paper's comparisons by every method, and prints how far each came;
--csv writes all iterations; without an example it lists those that have one. The limits are per method.
Exit code: 0 done, 1 the input is at fault, 2 usage, 3 internal.",
        Accelerator::list("|"),
        ConformalWeights::list("|"),
        ConformalNorm::list("|"),
        kinds(),
    )
}

/// The ids of the kinds, in lines under each other.
fn kinds() -> String {
    const WIDTH: usize = 96;
    let mut lines = vec![String::new()];
    for info in KINDS {
        if lines[lines.len() - 1].len() + info.id.len() > WIDTH {
            lines.push(String::new());
        }
        let line = lines.last_mut().expect("there is a line");
        line.push(' ');
        line.push_str(info.id);
    }
    lines.join("\n ")
}

/// Reads the arguments after the name of the program; the error says what is wrong with them.
pub(super) fn parse(arguments: Vec<OsString>) -> Result<Command, String> {
    let asks_for_help = |word: &&OsString| *word == "--help" || *word == "-h";
    if arguments.iter().take_while(|word| *word != "--").any(|word| asks_for_help(&word)) {
        return Ok(Command::Help);
    }
    let mut words = Words { rest: arguments.into_iter(), seen: Vec::new(), only_files: false };
    let command = words.rest.next().ok_or("expected a command")?;
    match command.to_str() {
        Some("solve") => solve(words),
        Some("check") => {
            let (mut mesh, mut report, mut scene) = (None, None, None);
            while let Some(word) = words.next()? {
                match word {
                    Word::File(file) => one(&mut mesh, file)?,
                    Word::Option(name, value) if name == "--report" => {
                        report = Some(words.file(&name, value)?);
                    }
                    Word::Option(name, value) if name == "--scene" => {
                        scene = Some(words.file(&name, value)?);
                    }
                    Word::Option(name, _) => return Err(unknown(&name, "check")),
                }
            }
            let file = mesh.ok_or("check needs a mesh file")?;
            match (scene, report) {
                (None, report) => Ok(Command::Check { mesh: file, report }),
                (Some(scene), None) => Ok(Command::CheckResults { results: file, scene }),
                (Some(_), Some(_)) => Err("check writes no report of results".to_owned()),
            }
        }
        Some("parametrize") => parametrize(words),
        Some("examples") => {
            let mut out = None;
            while let Some(word) = words.next()? {
                match word {
                    Word::Option(name, value) if name == "--out" => {
                        out = Some(words.file(&name, value)?);
                    }
                    Word::Option(name, _) => return Err(unknown(&name, "examples")),
                    Word::File(file) => return Err(unknown(&file.to_string_lossy(), "examples")),
                }
            }
            Ok(Command::Examples { out })
        }
        Some("experiment") => experiment(words),
        Some("operators") => match words.rest.next() {
            None => Ok(Command::Operators),
            Some(word) => Err(unknown(&word.to_string_lossy(), "operators")),
        },
        Some("help") => Ok(Command::Help),
        Some("--version" | "-V") => Ok(Command::Version),
        _ => Err(format!(
            "unknown command `{}`, expected solve, check, parametrize, examples, experiment or operators",
            command.to_string_lossy()
        )),
    }
}

fn experiment(mut words: Words) -> Result<Command, String> {
    let (mut experiment, mut example) = (Experiment::default(), None);
    while let Some(word) = words.next()? {
        let (name, value) = match word {
            Word::File(file) => {
                one(&mut example, file)?;
                continue;
            }
            Word::Option(name, value) => (name, value),
        };
        match name.as_str() {
            "--iterations" => experiment.iterations = Some(words.iterations(&name, value)?),
            "--seconds" => experiment.seconds = Some(words.not_negative(&name, value)?),
            "--csv" => experiment.csv = Some(words.file(&name, value)?),
            _ => return Err(unknown(&name, "experiment")),
        }
    }
    match example {
        Some(example) => {
            experiment.example = example.to_string_lossy().into_owned();
            Ok(Command::Experiment(experiment))
        }
        None if experiment == Experiment::default() => Ok(Command::Experiments),
        None => Err("experiment needs the name of an example".to_owned()),
    }
}

fn solve(mut words: Words) -> Result<Command, String> {
    let (mut solve, mut input) = (Solve::default(), None);
    while let Some(word) = words.next()? {
        let (name, value) = match word {
            Word::File(file) => {
                one(&mut input, file)?;
                continue;
            }
            Word::Option(name, value) => (name, value),
        };
        match name.as_str() {
            "--panels" => solve.panels = Some(words.kind(&name, value)?),
            "--trace" => {
                no_value(&name, value)?;
                solve.trace = true;
            }
            "--out" => solve.out = Some(words.mesh(&name, value, &["obj", "mesh"])?),
            "--report" => solve.report = Some(words.file(&name, value)?),
            "--iterations" => solve.iterations = Some(words.iterations(&name, value)?),
            "--tolerance" => solve.tolerance = Some(words.not_negative(&name, value)?),
            "--accelerator" => {
                solve.accelerator = Some(words.one_of(&name, value)?);
            }
            _ => return Err(unknown(&name, "solve")),
        }
    }
    solve.input = input.ok_or("solve needs a scene or a mesh file")?;
    not_the_same(&solve.out, &solve.report)?;
    Ok(Command::Solve(solve))
}

fn parametrize(mut words: Words) -> Result<Command, String> {
    let (mut parametrize, mut mesh) = (Parametrize::default(), None);
    while let Some(word) = words.next()? {
        let (name, value) = match word {
            Word::File(file) => {
                one(&mut mesh, file)?;
                continue;
            }
            Word::Option(name, value) => (name, value),
        };
        match name.as_str() {
            "--weights" => {
                parametrize.weights = words.one_of(&name, value)?;
            }
            "--norm" => parametrize.norm = words.one_of(&name, value)?,
            "--out" => parametrize.out = Some(words.mesh(&name, value, &["obj"])?),
            "--report" => parametrize.report = Some(words.file(&name, value)?),
            _ => return Err(unknown(&name, "parametrize")),
        }
    }
    parametrize.mesh = mesh.ok_or("parametrize needs a mesh file")?;
    not_the_same(&parametrize.out, &parametrize.report)?;
    Ok(Command::Parametrize(parametrize))
}

fn not_the_same(out: &Option<PathBuf>, report: &Option<PathBuf>) -> Result<(), String> {
    let place = |path: &PathBuf| std::path::absolute(path).unwrap_or_else(|_| path.clone());
    match (out, report) {
        (Some(out), Some(report)) if place(out) == place(report) => {
            Err("--out and --report name the same file".to_owned())
        }
        _ => Ok(()),
    }
}

fn unknown(word: &str, command: &str) -> String {
    format!("{command} does not take `{word}`")
}

fn one(place: &mut Option<PathBuf>, file: OsString) -> Result<(), String> {
    if file.is_empty() {
        return Err("the name of a file is empty".to_owned());
    }
    match place.replace(file.into()) {
        None => Ok(()),
        Some(first) => {
            Err(format!("expected one file, found a second after `{}`", first.display()))
        }
    }
}

fn no_value(name: &str, value: Option<OsString>) -> Result<(), String> {
    match value {
        None => Ok(()),
        Some(value) => Err(format!("{name} takes no value, found `{}`", value.to_string_lossy())),
    }
}

/// The arguments of a command, one after another.
struct Words {
    rest: std::vec::IntoIter<OsString>,
    /// The options so far: none is given twice.
    seen: Vec<String>,
    /// After `--` nothing is an option.
    only_files: bool,
}

enum Word {
    File(OsString),
    /// The name with its dashes, and the value behind `=`.
    Option(String, Option<OsString>),
}

impl Words {
    fn next(&mut self) -> Result<Option<Word>, String> {
        let Some(word) = self.rest.next() else { return Ok(None) };
        if word == "--" && !self.only_files {
            self.only_files = true;
            return self.next();
        }
        if self.only_files || !word.as_encoded_bytes().starts_with(b"-") {
            return Ok(Some(Word::File(word)));
        }
        let text = word.to_str().ok_or("an option is not UTF-8 text")?;
        let (name, value) = match text.split_once('=') {
            Some((name, value)) => (name, Some(value.into())),
            None => (text, None),
        };
        if self.seen.iter().any(|seen| seen == name) {
            return Err(format!("{name} is given twice"));
        }
        self.seen.push(name.to_owned());
        Ok(Some(Word::Option(name.to_owned(), value)))
    }

    /// The value of an option: behind its `=`, or the next word.
    fn value(&mut self, name: &str, value: Option<OsString>) -> Result<OsString, String> {
        let value = value.or_else(|| self.rest.next());
        let present = |v: &OsString| !v.is_empty() && !v.as_encoded_bytes().starts_with(b"--");
        value.filter(present).ok_or_else(|| format!("{name} needs a value"))
    }

    fn file(&mut self, name: &str, value: Option<OsString>) -> Result<PathBuf, String> {
        self.value(name, value).map(PathBuf::from)
    }

    /// The value of an option that takes the name of a mesh file to be written, of one of the `formats`.
    /// An ending that no mesh format has is no matter.
    fn mesh(
        &mut self,
        name: &str,
        value: Option<OsString>,
        formats: &[&str],
    ) -> Result<PathBuf, String> {
        let path = self.file(name, value)?;
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
        let is = |format: &&str| ending.as_deref() == Some(format);
        if ["obj", "off", "mesh"].iter().any(is) && !formats.iter().any(is) {
            let formats: Vec<_> = formats.iter().map(|format| format!(".{format}")).collect();
            let known = formats.join(" or ");
            return Err(format!("{name} writes {known}, found `{}`", path.display()));
        }
        Ok(path)
    }

    /// The value of an option that takes a whole number.
    fn iterations(&mut self, name: &str, value: Option<OsString>) -> Result<u32, String> {
        let value = self.text(name, value)?;
        value.parse().map_err(|_| format!("{name} takes a whole number from 0, found `{value}`"))
    }

    /// The value of an option that takes a number that is not negative.
    fn not_negative(&mut self, name: &str, value: Option<OsString>) -> Result<f64, String> {
        let value = self.text(name, value)?;
        let parsed = value.parse().ok().filter(|number: &f64| number.is_finite() && *number >= 0.0);
        parsed.ok_or_else(|| format!("{name} takes a number from 0, found `{value}`"))
    }

    /// The value of an option that takes the id of a kind.
    fn kind(&mut self, name: &str, value: Option<OsString>) -> Result<&'static str, String> {
        let value = self.text(name, value)?;
        let known: Vec<_> = KINDS.iter().map(|info| info.id).collect();
        known
            .iter()
            .copied()
            .find(|id| *id == value)
            .ok_or_else(|| format!("{name} takes {}, found `{value}`", known.join(" or ")))
    }

    /// The value of an option that takes one of some words.
    fn one_of<T: Worded>(&mut self, name: &str, value: Option<OsString>) -> Result<T, String> {
        let value = self.text(name, value)?;
        let expected = || format!("{name} takes {}, found `{value}`", T::list(" or "));
        T::of_word(&value).ok_or_else(expected)
    }

    fn text(&mut self, name: &str, value: Option<OsString>) -> Result<String, String> {
        let value = self.value(name, value)?;
        let text = |value: &OsStr| value.to_str().map(str::to_owned);
        text(&value).ok_or_else(|| format!("the value of {name} is not UTF-8 text"))
    }
}
