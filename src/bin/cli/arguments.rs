//! Parser of the commands and their arguments.

use super::edit::Edit;
use super::new_mesh::New;
use super::remesh::Remesh;
use super::tokens::{Settings, Token, Tokens};
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
    Edit(Edit),
    Remesh(Remesh),
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
#[derive(Clone, Debug, Default, PartialEq)]
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
    command(&mut Tokens::new(arguments))
}

fn command(tokens: &mut Tokens) -> Result<Command, String> {
    let command = match tokens.next()?.ok_or("expected a command")? {
        Token::File(command) => command.to_string_lossy().into_owned(),
        Token::Option(name) => name,
    };
    match command.as_str() {
        "solve" => solve(tokens, "solve").map(Command::Solve),
        "watch" => {
            let solve = solve(tokens, "watch")?;
            match solve.out {
                Some(_) => Ok(Command::Watch(solve)),
                None => Err("watch needs --out, the file that another program reads".to_owned()),
            }
        }
        "build" => build(tokens),
        "check" => check(tokens),
        "refine" => refine(tokens),
        "edit" => edit::parse(tokens).map(Command::Edit),
        "remesh" => remesh::parse(tokens).map(Command::Remesh),
        "new" => new_mesh::parse(tokens).map(Command::New),
        "parametrize" => parametrize(tokens),
        "examples" => {
            let mut out = None;
            while let Some(word) = tokens.next()? {
                match word {
                    Token::Option(name) if name == "--out" => out = Some(tokens.output(&name)?),
                    word => return Err(unknown(&word, "examples")),
                }
            }
            Ok(Command::Examples { out })
        }
        "experiment" => experiment(tokens),
        "operators" => match tokens.next()? {
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

fn check(tokens: &mut Tokens) -> Result<Command, String> {
    let (mut mesh, mut report, mut scene, mut csv) = (None, None, None, None);
    while let Some(name) = tokens.option(&mut mesh)? {
        match name.as_str() {
            "--report" => report = Some(tokens.output(&name)?),
            "--csv" => csv = Some(tokens.output(&name)?),
            "--scene" => scene = Some(tokens.file(&name)?),
            _ => return Err(unknown(&Token::Option(name), "check")),
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

fn experiment(tokens: &mut Tokens) -> Result<Command, String> {
    let (mut experiment, mut on) = (Experiment::default(), None);
    while let Some(name) = tokens.option(&mut on)? {
        match name.as_str() {
            "--iterations" => experiment.iterations = Some(tokens.whole(&name, 0)?),
            "--seconds" => experiment.seconds = Some(tokens.not_negative(&name)?),
            "--csv" => experiment.csv = Some(tokens.output(&name)?),
            "--svg" => experiment.svg = Some(tokens.output(&name)?),
            _ => return Err(unknown(&Token::Option(name), "experiment")),
        }
    }
    match on {
        Some(on) => Ok(Command::Experiment(Experiment { on, ..experiment })),
        None if experiment == Experiment::default() => Ok(Command::Experiments),
        None => Err("experiment needs the name of an example, or a scene".to_owned()),
    }
}

fn solve(tokens: &mut Tokens, command: &str) -> Result<Solve, String> {
    let (mut solve, mut input) = (Solve::default(), None);
    while let Some(name) = tokens.option(&mut input)? {
        match name.as_str() {
            "--panels" => solve.panels = Some(tokens.kind(&name)?),
            "--exact" => {
                tokens.flag(&name)?;
                require(&mut solve, command, Required::Is(Require::Exact))?;
            }
            "--within" => {
                let within = tokens.positive_or_auto(&name)?;
                require(
                    &mut solve,
                    command,
                    within.map_or(Required::Auto, |length| Required::Is(Require::Within(length))),
                )?;
            }
            "--improve" => solve.improve = tokens.flag(&name)?,
            "--boundary" => solve.boundary = Some(tokens.boundary(&name)?),
            "--trace" => solve.trace = tokens.flag(&name)?,
            "--out" => solve.out = Some(tokens.mesh(&name)?),
            "--report" => solve.report = Some(tokens.output(&name)?),
            "--iterations" => solve.iterations = Some(tokens.whole(&name, 0)?),
            "--tolerance" => solve.tolerance = Some(tokens.not_negative(&name)?),
            "--accelerator" => {
                solve.accelerator = Some(tokens.one_of(&name)?);
            }
            _ => return Err(unknown(&Token::Option(name), command)),
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

fn build(tokens: &mut Tokens) -> Result<Command, String> {
    let (mut build, mut input) = (Build::default(), None);
    while let Some(name) = tokens.option(&mut input)? {
        match name.as_str() {
            "--units" => {
                let unit = tokens.word_of(&name, &UNITS, |unit| unit.symbol)?;
                build.units = Some(unit.symbol);
            }
            "--machine" => build.presets.extend(tokens.preset(&name, PresetOf::Machine)?),
            "--sheet" => build.presets.extend(tokens.sheet(&name)?),
            "--material" => build.presets.extend(tokens.material(&name)?),
            "--out" => build.out = Some(tokens.output(&name)?),
            "--report" => build.report = Some(tokens.output(&name)?),
            "--report-page" => build.report_page = Some(tokens.page(&name)?),
            "--link" => build.link = Some(tokens.address(&name)?),
            _ => {
                let is_named = |one: &&BuildSetting| one.option().as_ref() == Some(&name);
                let Some(setting) = BUILD_SETTINGS.iter().find(is_named) else {
                    return Err(unknown(&Token::Option(name), "build"));
                };
                build.settings.push((setting.id, tokens.setting(&name, setting)?));
            }
        }
    }
    build.input = input.ok_or("build needs a scene or a mesh file")?;
    if build.link.is_some() && build.report_page.is_none() {
        return Err("--link needs --report-page, which shows the link".to_owned());
    }
    Ok(Command::Build(build))
}

fn refine(tokens: &mut Tokens) -> Result<Command, String> {
    let (mut panels, mut out, mut report, mut input) = (None, None, None, None);
    let mut adopt = false;
    let mut subdivision = Subdivision { scheme: Scheme::CatmullClark, levels: 1, keep: KEPT_TURN };
    while let Some(name) = tokens.option(&mut input)? {
        match name.as_str() {
            "--scheme" => subdivision.scheme = tokens.one_of(&name)?,
            "--levels" => subdivision.levels = tokens.whole(&name, 1)?,
            "--keep" => subdivision.keep = tokens.not_negative(&name)?,
            "--panels" => panels = Some(tokens.kind(&name)?),
            "--adopt" => adopt = tokens.flag(&name)?,
            "--out" => out = Some(tokens.mesh_or_scene(&name)?),
            "--report" => report = Some(tokens.output(&name)?),
            _ => return Err(unknown(&Token::Option(name), "refine")),
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

fn parametrize(tokens: &mut Tokens) -> Result<Command, String> {
    let (mut parametrize, mut mesh) = (Parametrize::default(), None);
    while let Some(name) = tokens.option(&mut mesh)? {
        match name.as_str() {
            "--weights" => {
                parametrize.weights = tokens.one_of(&name)?;
            }
            "--norm" => parametrize.norm = tokens.one_of(&name)?,
            "--out" => parametrize.out = Some(tokens.file_with(&name, &["obj"])?),
            "--report" => parametrize.report = Some(tokens.output(&name)?),
            _ => return Err(unknown(&Token::Option(name), "parametrize")),
        }
    }
    parametrize.mesh = mesh.ok_or("parametrize needs a mesh file")?;
    Ok(Command::Parametrize(parametrize))
}

pub(super) fn unknown(token: &Token, command: &str) -> String {
    let word = match token {
        Token::File(file) => file.to_string_lossy(),
        Token::Option(name) => name.into(),
    };
    format!("{command} does not take `{word}`")
}
