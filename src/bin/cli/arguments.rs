//! Parser of the commands and their arguments.

use super::edit::Remesh;
use super::new_mesh::New;
use super::remesh::Quads;
use super::words::{Settings, Word, Words};
use crate::cli::{edit, new_mesh, remesh};
use shape_up::mesh::{KEPT_TURN, Scheme, Subdivision};
use shape_up::scene::{Accelerator, BUILD_SETTINGS, BoundaryRequire, BuildSetting, PresetOf};
use shape_up::solve::{ConformalNorm, ConformalWeights, Require};
use shape_up::words::UNITS;
use std::ffi::OsString;
use std::path::PathBuf;

/// A command with its arguments.
#[derive(Debug)]
pub(super) enum Command {
    Solve(Solve),
    /// `shape-up watch`.
    Watch(Solve),
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
    /// `shape-up check FOLDER`.
    CheckClass {
        folder: PathBuf,
        scene: Option<PathBuf>,
        csv: Option<PathBuf>,
    },
    Refine(Refine),
    Edit(Remesh),
    Remesh(Quads),
    New(New),
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

/// The requirement of all constraints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Required {
    /// This one.
    Is(Require),
    /// That of the button of the page: the tolerance of the mesh, by all attempts.
    Auto,
}

/// `shape-up solve`.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Solve {
    /// A scene or a mesh.
    pub(super) input: PathBuf,
    /// The id of the kind required of every face.
    pub(super) panels: Option<&'static str>,
    /// The requirement of all constraints; none for those of the scene.
    pub(super) require: Option<Required>,
    /// Whether the energy is reduced further once the constraints are met.
    pub(super) improve: bool,
    /// How the boundary is held, and with which weight; none as in the scene.
    pub(super) boundary: Option<(BoundaryRequire, f64)>,
    pub(super) iterations: Option<u32>,
    pub(super) tolerance: Option<f64>,
    pub(super) accelerator: Option<Accelerator>,
    pub(super) out: Option<PathBuf>,
    pub(super) report: Option<PathBuf>,
    pub(super) trace: bool,
}

/// `shape-up build`.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Build {
    /// A scene or a mesh.
    pub(super) input: PathBuf,
    /// The ids of declared settings, with values as in a scene; the others are those of `presets`.
    pub(super) settings: Settings,
    /// Those of presets, as of a machine or a sheet; the others are those of the scene.
    pub(super) presets: Settings,
    /// The symbol of the unit of the mesh.
    pub(super) units: Option<&'static str>,
    /// A folder.
    pub(super) out: Option<PathBuf>,
    pub(super) report: Option<PathBuf>,
    /// The file of the report on one page.
    pub(super) report_page: Option<PathBuf>,
    /// The link on that page.
    pub(super) link: Option<String>,
}

/// `shape-up refine`.
#[derive(Debug, PartialEq)]
pub(super) struct Refine {
    /// A scene or a mesh.
    pub(super) input: PathBuf,
    pub(super) subdivision: Subdivision,
    /// The id of the kind required of every face, before the first level and after each.
    pub(super) panels: Option<&'static str>,
    /// Whether the shape of each level is the original of the next.
    pub(super) adopt: bool,
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
    pub(super) svg: Option<PathBuf>,
}

/// Parses the arguments after the name of the program.
pub(super) fn parse(arguments: Vec<OsString>) -> Result<Command, String> {
    let asks_for_help = |word: &&OsString| *word == "--help" || *word == "-h";
    if arguments.iter().take_while(|word| *word != "--").any(|word| asks_for_help(&word)) {
        return Ok(Command::Help);
    }
    command(&mut Words::new(arguments))
}

fn command(words: &mut Words) -> Result<Command, String> {
    let command = match words.next()?.ok_or("expected a command")? {
        Word::File(command) => command.to_string_lossy().into_owned(),
        Word::Option(name) => name,
    };
    match command.as_str() {
        "solve" => solve(words, "solve").map(Command::Solve),
        "watch" => {
            let solve = solve(words, "watch")?;
            match solve.out {
                Some(_) => Ok(Command::Watch(solve)),
                None => Err("watch needs --out, the file that another program reads".to_owned()),
            }
        }
        "build" => build(words),
        "check" => check(words),
        "refine" => refine(words),
        "edit" => edit::parse(words).map(Command::Edit),
        "remesh" => remesh::parse(words).map(Command::Remesh),
        "new" => new_mesh::parse(words).map(Command::New),
        "parametrize" => parametrize(words),
        "examples" => {
            let mut out = None;
            while let Some(word) = words.next()? {
                match word {
                    Word::Option(name) if name == "--out" => out = Some(words.output(&name)?),
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
            "unknown command `{command}`, expected solve, watch, build, refine, remesh, edit, check, new, parametrize, examples, experiment or operators"
        )),
    }
}

fn check(words: &mut Words) -> Result<Command, String> {
    let (mut mesh, mut report, mut scene, mut csv) = (None, None, None, None);
    while let Some(name) = words.option(&mut mesh)? {
        match name.as_str() {
            "--report" => report = Some(words.output(&name)?),
            "--csv" => csv = Some(words.output(&name)?),
            "--scene" => scene = Some(words.file(&name)?),
            _ => return Err(unknown(&Word::Option(name), "check")),
        }
    }
    let file = mesh.ok_or("check needs a mesh file, a results file or a folder of results")?;
    if file.is_dir() {
        return match report {
            None => Ok(Command::CheckClass { folder: file, scene, csv }),
            Some(_) => {
                Err("check writes no --report for a folder of results, use --csv".to_owned())
            }
        };
    }
    if csv.is_some() {
        return Err("--csv needs a folder of results".to_owned());
    }
    match (scene, report) {
        (None, report) => Ok(Command::Check { mesh: file, report }),
        (Some(scene), None) => Ok(Command::CheckResults { results: file, scene }),
        (Some(_), Some(_)) => Err("check writes no --report for results".to_owned()),
    }
}

fn experiment(words: &mut Words) -> Result<Command, String> {
    let (mut experiment, mut on) = (Experiment::default(), None);
    while let Some(name) = words.option(&mut on)? {
        match name.as_str() {
            "--iterations" => experiment.iterations = Some(words.whole(&name, 0)?),
            "--seconds" => experiment.seconds = Some(words.not_negative(&name)?),
            "--csv" => experiment.csv = Some(words.output(&name)?),
            "--svg" => experiment.svg = Some(words.output(&name)?),
            _ => return Err(unknown(&Word::Option(name), "experiment")),
        }
    }
    match on {
        Some(on) => Ok(Command::Experiment(Experiment { on, ..experiment })),
        None if experiment == Experiment::default() => Ok(Command::Experiments),
        None => Err("experiment needs the name of an example, or a scene".to_owned()),
    }
}

fn solve(words: &mut Words, command: &str) -> Result<Solve, String> {
    let (mut solve, mut input) = (Solve::default(), None);
    while let Some(name) = words.option(&mut input)? {
        match name.as_str() {
            "--panels" => solve.panels = Some(words.kind(&name)?),
            "--exact" => {
                words.flag(&name)?;
                require(&mut solve, command, Required::Is(Require::Exact))?;
            }
            "--within" => {
                let within = words.positive_or_auto(&name)?;
                require(
                    &mut solve,
                    command,
                    within.map_or(Required::Auto, |length| Required::Is(Require::Within(length))),
                )?;
            }
            "--improve" => solve.improve = words.flag(&name)?,
            "--boundary" => solve.boundary = Some(words.boundary(&name)?),
            "--trace" => solve.trace = words.flag(&name)?,
            "--out" => solve.out = Some(words.mesh(&name)?),
            "--report" => solve.report = Some(words.output(&name)?),
            "--iterations" => solve.iterations = Some(words.whole(&name, 0)?),
            "--tolerance" => solve.tolerance = Some(words.not_negative(&name)?),
            "--accelerator" => {
                solve.accelerator = Some(words.one_of(&name)?);
            }
            _ => return Err(unknown(&Word::Option(name), command)),
        }
    }
    solve.input = input.ok_or_else(|| format!("{command} needs a scene or a mesh file"))?;
    if solve.improve && solve.require == Some(Required::Auto) {
        return Err(format!(
            "{command} takes --improve with --exact or --within LENGTH, not with auto"
        ));
    }
    Ok(solve)
}

fn build(words: &mut Words) -> Result<Command, String> {
    let (mut build, mut input) = (Build::default(), None);
    while let Some(name) = words.option(&mut input)? {
        match name.as_str() {
            "--units" => {
                let unit = words.word_of(&name, &UNITS, |unit| unit.symbol)?;
                build.units = Some(unit.symbol);
            }
            "--machine" => build.presets.extend(words.preset(&name, PresetOf::Machine)?),
            "--sheet" => build.presets.extend(words.sheet(&name)?),
            "--material" => build.presets.extend(words.material(&name)?),
            "--out" => build.out = Some(words.output(&name)?),
            "--report" => build.report = Some(words.output(&name)?),
            "--report-page" => build.report_page = Some(words.page(&name)?),
            "--link" => build.link = Some(words.text(&name)?),
            _ => {
                let is_named = |one: &&BuildSetting| one.option().as_ref() == Some(&name);
                let Some(setting) = BUILD_SETTINGS.iter().find(is_named) else {
                    return Err(unknown(&Word::Option(name), "build"));
                };
                build.settings.push((setting.id, words.setting(&name, setting)?));
            }
        }
    }
    build.input = input.ok_or("build needs a scene or a mesh file")?;
    if build.link.is_some() && build.report_page.is_none() {
        return Err("--link needs --report-page, which shows the link".to_owned());
    }
    Ok(Command::Build(build))
}

fn refine(words: &mut Words) -> Result<Command, String> {
    let (mut panels, mut out, mut report, mut input) = (None, None, None, None);
    let mut adopt = false;
    let mut subdivision = Subdivision { scheme: Scheme::CatmullClark, levels: 1, keep: KEPT_TURN };
    while let Some(name) = words.option(&mut input)? {
        match name.as_str() {
            "--scheme" => subdivision.scheme = words.one_of(&name)?,
            "--levels" => subdivision.levels = words.whole(&name, 1)?,
            "--keep" => subdivision.keep = words.not_negative(&name)?,
            "--panels" => panels = Some(words.kind(&name)?),
            "--adopt" => adopt = words.flag(&name)?,
            "--out" => out = Some(words.mesh_or_scene(&name)?),
            "--report" => report = Some(words.output(&name)?),
            _ => return Err(unknown(&Word::Option(name), "refine")),
        }
    }
    let input = input.ok_or("refine needs a scene or a mesh file")?;
    Ok(Command::Refine(Refine { input, subdivision, panels, adopt, out, report }))
}

/// Sets the requirement of all constraints, at most once.
fn require(solve: &mut Solve, command: &str, require: Required) -> Result<(), String> {
    match solve.require.replace(require) {
        None => Ok(()),
        _ => Err(format!("{command} takes --exact or --within, not both")),
    }
}

fn parametrize(words: &mut Words) -> Result<Command, String> {
    let (mut parametrize, mut mesh) = (Parametrize::default(), None);
    while let Some(name) = words.option(&mut mesh)? {
        match name.as_str() {
            "--weights" => {
                parametrize.weights = words.one_of(&name)?;
            }
            "--norm" => parametrize.norm = words.one_of(&name)?,
            "--out" => parametrize.out = Some(words.file_with(&name, &["obj"])?),
            "--report" => parametrize.report = Some(words.output(&name)?),
            _ => return Err(unknown(&Word::Option(name), "parametrize")),
        }
    }
    parametrize.mesh = mesh.ok_or("parametrize needs a mesh file")?;
    Ok(Command::Parametrize(parametrize))
}

pub(super) fn unknown(word: &Word, command: &str) -> String {
    let word = match word {
        Word::File(file) => file.to_string_lossy(),
        Word::Option(name) => name.into(),
    };
    format!("{command} does not take `{word}`")
}
