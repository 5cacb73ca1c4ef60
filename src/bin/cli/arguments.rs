//! The words of the command line.

use lexopt::Arg;
use shape_up::constraint::KINDS;
use shape_up::fabricate::OffsetKind;
use shape_up::scene::{Accelerator, BoundaryCloseness, BoundaryRequire, NamedEnum};
use shape_up::solve::{ConformalNorm, ConformalWeights, Require};
use std::ffi::{OsStr, OsString};
use std::path::PathBuf;

/// The command with its arguments.
#[derive(Debug, PartialEq)]
pub(super) enum Command {
    Solve(Solve),
    Build(Build),
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
    /// The requirement for all constraints; none leaves it to the scene.
    pub(super) require: Option<Require>,
    /// How the boundary is held; none leaves it to the scene.
    pub(super) boundary: Option<BoundaryCloseness>,
    pub(super) iterations: Option<u32>,
    pub(super) tolerance: Option<f64>,
    pub(super) accelerator: Option<Accelerator>,
    pub(super) out: Option<PathBuf>,
    pub(super) report: Option<PathBuf>,
    pub(super) trace: bool,
}

/// `shape-up build`: what is not given is that of the scene.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Build {
    /// A scene or a mesh.
    pub(super) input: PathBuf,
    pub(super) kind: Option<OffsetKind>,
    pub(super) distance: Option<f64>,
    pub(super) joint: Option<f64>,
    pub(super) scale: Option<f64>,
    pub(super) sheet: Option<[f64; 2]>,
    /// A folder.
    pub(super) out: Option<PathBuf>,
    pub(super) report: Option<PathBuf>,
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
    /// The id of an example, or a scene file.
    pub(super) on: PathBuf,
    pub(super) iterations: Option<u32>,
    pub(super) seconds: Option<f64>,
    pub(super) csv: Option<PathBuf>,
}

/// How the program is called.
pub(super) fn usage() -> String {
    format!(
        "\
usage: shape-up solve SCENE|MESH [--panels KIND] [--exact | --within LENGTH]
                [--boundary exact|WEIGHT] [--iterations N] [--tolerance T]
                [--accelerator {}]
                [--out FILE.obj|FILE.mesh] [--report FILE.json] [--trace]
       shape-up build SCENE|MESH [--kind {}] [--distance D] [--joint J]
                [--scale S] [--sheet WxH] [--out DIR] [--report FILE.json]
       shape-up check MESH [--report FILE.json]
       shape-up check RESULTS --scene SCENE
       shape-up parametrize MESH [--weights {}] [--norm {}]
                [--out UV.obj] [--report FILE.json]
       shape-up examples [--out DIR]
       shape-up experiment [EXAMPLE|SCENE] [--iterations N] [--seconds T] [--csv FILE.csv]
       shape-up operators
       shape-up --help | --version

A SCENE is a *.json file, a MESH is OBJ, OFF or Medit (.obj, .off, .mesh).
--panels asks for a KIND of shape on every face that can have it. The kinds are:
 {}
--exact meets all constraints instead of weighing them; --within meets them up to a LENGTH in the
unit of the mesh. Without, each constraint of a scene says itself what it is.
--boundary exact holds boundary vertices on their curve, where they glide, and its corners; a WEIGHT
holds them near it.
A MESH is solved with the settings that keep it whole, a scene with its own.
--iterations, --tolerance (0 never stops early) and --accelerator replace the settings of the scene.
--out writes OBJ, or where the name ends in .mesh, Medit, which has tetrahedra.
--trace records the energies of every iteration, in the report and on standard output.
build lays the panels flat on sheets and checks whether offsets and beams can be built; --out is the
folder for drawings of the sheets (SVG, DXF, PDF) and tables (CSV). D, negative inwards, and the joint J
between panels are lengths in the unit of the mesh; the model is 1:S; a sheet is W by H mm. What is not
given is as in the `build` of the scene.
RESULTS is what a student hands in of a lesson: check measures its shape with the goals and the
constraints of the SCENE, and ends with 1 when one is not met.
parametrize makes a flat map that keeps angles; --out writes the mesh with the map as its vt.
experiment solves a scene by several methods, and prints how far each came; --csv writes all iterations.
Without a scene it lists the examples that have a comparison of the paper. The limits are per method.
Exit code: 0 done, 1 the input is at fault, 2 usage, 3 internal.",
        Accelerator::list("|"),
        OffsetKind::ALL.map(OffsetKind::word).join("|"),
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
    let mut words = Words { parser: lexopt::Parser::from_args(arguments), seen: Vec::new() };
    let command = match words.next()?.ok_or("expected a command")? {
        Word::File(command) => command.to_string_lossy().into_owned(),
        Word::Option(name) => name,
    };
    match command.as_str() {
        "solve" => solve(words),
        "build" => build(words),
        "check" => check(words),
        "parametrize" => parametrize(words),
        "examples" => {
            let mut out = None;
            while let Some(word) = words.next()? {
                match word {
                    Word::Option(name) if name == "--out" => out = Some(words.file(&name)?),
                    word => return Err(unknown(&word, "examples")),
                }
            }
            Ok(Command::Examples { out })
        }
        "experiment" => experiment(words),
        "operators" => match words.next()? {
            None => Ok(Command::Operators),
            Some(word) => Err(unknown(&word, "operators")),
        },
        "help" => Ok(Command::Help),
        "--version" | "-V" => Ok(Command::Version),
        _ => Err(format!(
            "unknown command `{command}`, expected solve, build, check, parametrize, examples, experiment or operators"
        )),
    }
}

fn check(mut words: Words) -> Result<Command, String> {
    let (mut mesh, mut report, mut scene) = (None, None, None);
    while let Some(word) = words.next()? {
        match word {
            Word::File(file) => one(&mut mesh, file)?,
            Word::Option(name) if name == "--report" => report = Some(words.file(&name)?),
            Word::Option(name) if name == "--scene" => scene = Some(words.file(&name)?),
            word => return Err(unknown(&word, "check")),
        }
    }
    let file = mesh.ok_or("check needs a mesh file")?;
    match (scene, report) {
        (None, report) => Ok(Command::Check { mesh: file, report }),
        (Some(scene), None) => Ok(Command::CheckResults { results: file, scene }),
        (Some(_), Some(_)) => Err("check writes no report of results".to_owned()),
    }
}

fn experiment(mut words: Words) -> Result<Command, String> {
    let (mut experiment, mut on) = (Experiment::default(), None);
    while let Some(word) = words.next()? {
        let name = match word {
            Word::File(file) => {
                one(&mut on, file)?;
                continue;
            }
            Word::Option(name) => name,
        };
        match name.as_str() {
            "--iterations" => experiment.iterations = Some(words.iterations(&name)?),
            "--seconds" => experiment.seconds = Some(words.not_negative(&name)?),
            "--csv" => experiment.csv = Some(words.file(&name)?),
            _ => return Err(unknown(&Word::Option(name), "experiment")),
        }
    }
    match on {
        Some(on) => Ok(Command::Experiment(Experiment { on, ..experiment })),
        None if experiment == Experiment::default() => Ok(Command::Experiments),
        None => Err("experiment needs the name of an example, or a scene".to_owned()),
    }
}

fn solve(mut words: Words) -> Result<Command, String> {
    let (mut solve, mut input) = (Solve::default(), None);
    while let Some(word) = words.next()? {
        let name = match word {
            Word::File(file) => {
                one(&mut input, file)?;
                continue;
            }
            Word::Option(name) => name,
        };
        match name.as_str() {
            "--panels" => solve.panels = Some(words.kind(&name)?),
            "--exact" => {
                words.flag(&name)?;
                require(&mut solve, Require::Exact)?;
            }
            "--within" => {
                let length = words.positive(&name)?;
                require(&mut solve, Require::Within(length))?;
            }
            "--boundary" => solve.boundary = Some(words.boundary(&name)?),
            "--trace" => solve.trace = words.flag(&name)?,
            "--out" => solve.out = Some(words.mesh(&name, &["obj", "mesh"])?),
            "--report" => solve.report = Some(words.file(&name)?),
            "--iterations" => solve.iterations = Some(words.iterations(&name)?),
            "--tolerance" => solve.tolerance = Some(words.not_negative(&name)?),
            "--accelerator" => {
                solve.accelerator = Some(words.one_of(&name)?);
            }
            _ => return Err(unknown(&Word::Option(name), "solve")),
        }
    }
    solve.input = input.ok_or("solve needs a scene or a mesh file")?;
    not_the_same(&solve.out, &solve.report)?;
    Ok(Command::Solve(solve))
}

fn build(mut words: Words) -> Result<Command, String> {
    let (mut build, mut input) = (Build::default(), None);
    while let Some(word) = words.next()? {
        let name = match word {
            Word::File(file) => {
                one(&mut input, file)?;
                continue;
            }
            Word::Option(name) => name,
        };
        match name.as_str() {
            "--kind" => build.kind = Some(words.offset_kind(&name)?),
            "--distance" => build.distance = Some(words.distance(&name)?),
            "--joint" => build.joint = Some(words.not_negative(&name)?),
            "--scale" => build.scale = Some(words.positive(&name)?),
            "--sheet" => build.sheet = Some(words.sheet(&name)?),
            "--out" => build.out = Some(words.file(&name)?),
            "--report" => build.report = Some(words.file(&name)?),
            _ => return Err(unknown(&Word::Option(name), "build")),
        }
    }
    build.input = input.ok_or("build needs a scene or a mesh file")?;
    not_the_same(&build.out, &build.report)?;
    Ok(Command::Build(build))
}

/// Asks something of all constraints, once.
fn require(solve: &mut Solve, require: Require) -> Result<(), String> {
    match solve.require.replace(require) {
        None => Ok(()),
        _ => Err("solve takes --exact or --within, not both".to_owned()),
    }
}

fn parametrize(mut words: Words) -> Result<Command, String> {
    let (mut parametrize, mut mesh) = (Parametrize::default(), None);
    while let Some(word) = words.next()? {
        let name = match word {
            Word::File(file) => {
                one(&mut mesh, file)?;
                continue;
            }
            Word::Option(name) => name,
        };
        match name.as_str() {
            "--weights" => {
                parametrize.weights = words.one_of(&name)?;
            }
            "--norm" => parametrize.norm = words.one_of(&name)?,
            "--out" => parametrize.out = Some(words.mesh(&name, &["obj"])?),
            "--report" => parametrize.report = Some(words.file(&name)?),
            _ => return Err(unknown(&Word::Option(name), "parametrize")),
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

fn unknown(word: &Word, command: &str) -> String {
    let word = match word {
        Word::File(file) => file.to_string_lossy(),
        Word::Option(name) => name.into(),
    };
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

/// The arguments of a command, one after another.
struct Words {
    parser: lexopt::Parser,
    /// The options so far: none is given twice.
    seen: Vec<String>,
}

enum Word {
    File(OsString),
    /// The name with its dashes.
    Option(String),
}

impl Words {
    fn next(&mut self) -> Result<Option<Word>, String> {
        let name = match self.parser.next().map_err(|error| error.to_string())? {
            None => return Ok(None),
            Some(Arg::Value(file)) => return Ok(Some(Word::File(file))),
            Some(Arg::Long(name)) => format!("--{name}"),
            Some(Arg::Short(letter)) => format!("-{letter}"),
        };
        if self.seen.contains(&name) {
            return Err(format!("{name} is given twice"));
        }
        self.seen.push(name.clone());
        Ok(Some(Word::Option(name)))
    }

    /// True, of an option that takes no value.
    fn flag(&mut self, name: &str) -> Result<bool, String> {
        match self.parser.optional_value() {
            None => Ok(true),
            Some(value) => {
                Err(format!("{name} takes no value, found `{}`", value.to_string_lossy()))
            }
        }
    }

    /// The value of an option: behind its `=`, or the next word.
    fn value(&mut self, name: &str) -> Result<OsString, String> {
        let present = |v: &OsString| !v.is_empty() && !v.as_encoded_bytes().starts_with(b"--");
        let value = self.parser.value().ok().filter(present);
        value.ok_or_else(|| format!("{name} needs a value"))
    }

    fn file(&mut self, name: &str) -> Result<PathBuf, String> {
        self.value(name).map(PathBuf::from)
    }

    /// The value of an option that takes the name of a mesh file to be written, of one of the `formats`.
    /// An ending that no mesh format has is no matter.
    fn mesh(&mut self, name: &str, formats: &[&str]) -> Result<PathBuf, String> {
        let path = self.file(name)?;
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
    fn iterations(&mut self, name: &str) -> Result<u32, String> {
        let value = self.text(name)?;
        value.parse().map_err(|_| format!("{name} takes a whole number from 0, found `{value}`"))
    }

    /// The value of an option that takes a number that is not negative.
    fn not_negative(&mut self, name: &str) -> Result<f64, String> {
        let value = self.text(name)?;
        let parsed = value.parse().ok().filter(|number: &f64| number.is_finite() && *number >= 0.0);
        parsed.ok_or_else(|| format!("{name} takes a number from 0, found `{value}`"))
    }

    /// The value of an option that says how a boundary is held.
    fn boundary(&mut self, name: &str) -> Result<BoundaryCloseness, String> {
        let value = self.text(name)?;
        let held = BoundaryCloseness::default();
        if value == BoundaryRequire::Exact.word() {
            return Ok(BoundaryCloseness { require: BoundaryRequire::Exact, ..held });
        }
        let weight = value.parse().ok().filter(|weight: &f64| weight.is_finite() && *weight > 0.0);
        let expected = || format!("{name} takes `exact` or a weight above 0, found `{value}`");
        weight.map(|weight| BoundaryCloseness { weight, ..held }).ok_or_else(expected)
    }

    /// The value of an option that takes a number above zero.
    fn positive(&mut self, name: &str) -> Result<f64, String> {
        match self.not_negative(name)? {
            0.0 => Err(format!("{name} takes a number above 0, found 0")),
            number => Ok(number),
        }
    }

    /// The value of an option that takes a length of either sign that is not zero.
    fn distance(&mut self, name: &str) -> Result<f64, String> {
        let value = self.text(name)?;
        let parsed = value.parse().ok().filter(|number: &f64| number.is_finite() && *number != 0.0);
        parsed.ok_or_else(|| format!("{name} takes a number that is not 0, found `{value}`"))
    }

    /// The value of an option that takes a width and a height.
    fn sheet(&mut self, name: &str) -> Result<[f64; 2], String> {
        let value = self.text(name)?;
        let sides = value.split_once(['x', 'X']).and_then(|(width, height)| {
            let side =
                |text: &str| text.parse().ok().filter(|side: &f64| side.is_finite() && *side > 0.0);
            Some([side(width)?, side(height)?])
        });
        sides.ok_or_else(|| {
            format!("{name} takes a width and a height in mm, such as 1200x600, found `{value}`")
        })
    }

    /// The value of an option that takes a kind of offset.
    fn offset_kind(&mut self, name: &str) -> Result<OffsetKind, String> {
        let value = self.text(name)?;
        OffsetKind::ALL.into_iter().find(|kind| kind.word() == value).ok_or_else(|| {
            let words = OffsetKind::ALL.map(OffsetKind::word).join(" or ");
            format!("{name} takes {words}, found `{value}`")
        })
    }

    /// The value of an option that takes the id of a kind.
    fn kind(&mut self, name: &str) -> Result<&'static str, String> {
        let value = self.text(name)?;
        let known: Vec<_> = KINDS.iter().map(|info| info.id).collect();
        known
            .iter()
            .copied()
            .find(|id| *id == value)
            .ok_or_else(|| format!("{name} takes {}, found `{value}`", known.join(" or ")))
    }

    /// The value of an option that takes one of some words.
    fn one_of<T: NamedEnum>(&mut self, name: &str) -> Result<T, String> {
        let value = self.text(name)?;
        let expected = || format!("{name} takes {}, found `{value}`", T::list(" or "));
        T::of_word(&value).ok_or_else(expected)
    }

    fn text(&mut self, name: &str) -> Result<String, String> {
        let value = self.value(name)?;
        let text = |value: &OsStr| value.to_str().map(str::to_owned);
        text(&value).ok_or_else(|| format!("the value of {name} is not UTF-8 text"))
    }
}
