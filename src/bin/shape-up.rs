//! The command line (design section 6): `shape-up solve | check | examples | operators`.

mod cli;

fn main() -> std::process::ExitCode {
    cli::run(std::env::args_os().skip(1).collect())
}
