//! The command line: solves scenes, checks and flattens meshes, writes the examples.

mod cli;

fn main() -> std::process::ExitCode {
    cli::run(std::env::args_os().skip(1).collect())
}
