//! The commands, and their exit codes: 0 done, 1 the input is at fault, 2 usage, 3 internal.
//!
//! | file | holds |
//! |---|---|
//! | `arguments` | parser of the commands and their arguments |
//! | `tokens` | lexer of the command line: files, options and their values |
//! | `usage` | the usage text |
//! | `input` | reading of mesh and scene files |
//! | `output` | atomic writing of files, mesh files of sessions, output folders, and standard output |
//! | `watch` | `solve` again whenever the file, or one in the folder, is saved |
//! | `solve`, `build`, `check`, `edit`, `refine`, `remesh` | the commands of these names |
//! | `parametrize`, `examples`, `experiment` | the commands of these names |
//! | `new_mesh` | the command `new` |
//! | `results` | `check` of students' results |

mod arguments;
mod build;
mod check;
mod edit;
mod examples;
mod experiment;
mod input;
mod new_mesh;
mod output;
mod parametrize;
mod refine;
mod remesh;
mod results;
mod solve;
mod tokens;
mod usage;
mod watch;

use arguments::Command;
use std::ffi::OsString;
use std::process::ExitCode;

/// The failure of a command.
pub(crate) enum Failure {
    /// Input error: file, line or JSON path, the fault, and the expected value.
    Input(String),
    /// Usage error.
    Usage(String),
}

/// Runs the command given by the arguments. An input error is one line on standard error.
pub(crate) fn run(arguments: Vec<OsString>) -> ExitCode {
    std::panic::set_hook(Box::new(|panic| {
        let place = panic.location().map(ToString::to_string).unwrap_or_default();
        let payload = panic.payload();
        let text = payload.downcast_ref::<&str>().copied();
        let text = text.or(payload.downcast_ref::<String>().map(String::as_str));
        let what = text.unwrap_or("a contract is broken");
        eprintln!("shape-up: internal error at {place}: {}", one_line(what));
        std::process::exit(3);
    }));
    let done = match arguments::parse(arguments) {
        Ok(command) => perform(command),
        Err(message) => Err(Failure::Usage(message)),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(Failure::Input(message)) => {
            eprintln!("{}", one_line(&message));
            ExitCode::from(1)
        }
        Err(Failure::Usage(message)) => {
            eprintln!("shape-up: {}\n\nshape-up --help lists what it takes", one_line(&message));
            ExitCode::from(2)
        }
    }
}

fn perform(command: Command) -> Result<(), Failure> {
    match command {
        Command::Solve(solve) => solve::solve(&solve),
        Command::Watch(solve) => watch::watch(&solve),
        Command::Build(build) => build::build(&build),
        Command::Refine(refine) => refine::refine(&refine),
        Command::Check { mesh, report } => check::check(&mesh, report.as_deref()),
        Command::CheckResults { results, scene } => results::check(&results, &scene),
        Command::CheckClass { folder, scene, csv } => {
            results::check_class(&folder, scene.as_deref(), csv.as_deref())
        }
        Command::Edit(asked) => edit::edit(&asked),
        Command::Remesh(asked) => remesh::run(&asked),
        Command::New(new) => new_mesh::make(&new),
        Command::Parametrize(parametrize) => parametrize::parametrize(&parametrize),
        Command::Examples { out: None } => examples::list(),
        Command::Examples { out: Some(folder) } => examples::write(&folder),
        Command::Experiments => experiment::list(),
        Command::Experiment(asked) => experiment::run(&asked),
        Command::Operators => output::print(&output::json(&shape_up::constraint::KINDS)),
        Command::Help => output::print(&(usage::usage() + "\n")),
        Command::Version => output::print(concat!("shape-up ", env!("CARGO_PKG_VERSION"), "\n")),
    }
}

fn one_line(text: &str) -> String {
    text.split(['\n', '\r'])
        .map(str::trim)
        .filter(|line| !line.is_empty())
        .collect::<Vec<_>>()
        .join(" ")
}
