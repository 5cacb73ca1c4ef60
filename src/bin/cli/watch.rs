//! `shape-up watch`: solves a file again whenever another program saves it.

use super::arguments::Solve;
use super::{Failure, input, one_line, solve};
use shape_up::scene::Scene;
use shape_up::session::named_files;
use std::fs;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::{Duration, SystemTime};

/// How often the files are looked at.
const EVERY: Duration = Duration::from_millis(200);

/// The time and the size of a file, by which a save is noticed; none while there is no such file, since
/// some programs write another one and rename it.
type Stamp = Option<(SystemTime, u64)>;

/// Solves until the program is stopped. What is wrong with the input is said, and waited for.
pub(super) fn watch(command: &Solve) -> Result<(), Failure> {
    let mut inputs = Inputs::of(&command.input);
    // Before it is solved: it may be saved meanwhile.
    let mut solved = inputs.stamps();
    let mut last = solved.clone();
    if solved[0].is_none() {
        // Its name may be wrong.
        return solve::solve(command);
    }
    solve_or_say(command)?;
    loop {
        thread::sleep(EVERY);
        let now = inputs.stamps();
        // A file that is still written changes from one look to the next, and some programs remove it
        // first. One that a scene names may be missing: then that is said.
        if now == last && now != solved && now[0].is_some() {
            solved.clone_from(&now);
            solve_or_say(command)?;
        }
        last = now;
    }
}

/// Solves, or says what is wrong with the input.
fn solve_or_say(command: &Solve) -> Result<(), Failure> {
    match solve::solve(command) {
        Err(Failure::Input(message)) => {
            eprintln!("{}", one_line(&message));
            Ok(())
        }
        done => done,
    }
}

/// The input, and the files that a scene names, which is read again only when it is saved.
struct Inputs {
    files: Vec<PathBuf>,
    read: Stamp,
}

impl Inputs {
    fn of(path: &Path) -> Inputs {
        Inputs { read: stamp(path), files: inputs(path) }
    }

    fn stamps(&mut self) -> Vec<Stamp> {
        if stamp(&self.files[0]) != self.read {
            *self = Inputs::of(&self.files[0]);
        }
        self.files.iter().map(|file| stamp(file)).collect()
    }
}

/// The input, and the files that a scene names.
fn inputs(path: &Path) -> Vec<PathBuf> {
    let mut all = vec![path.to_owned()];
    if input::is_scene(path) {
        let text = fs::read_to_string(path).unwrap_or_default();
        let scene = Scene::from_json(&text);
        let named = scene.iter().flat_map(named_files);
        all.extend(named.map(|(_, name)| path.with_file_name(name)));
    }
    all
}

fn stamp(path: &Path) -> Stamp {
    let about = fs::metadata(path).ok()?;
    Some((about.modified().ok()?, about.len()))
}
