//! `shape-up watch`: solves a file again whenever another program saves it.

use super::arguments::{Solve, apart};
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
    // An output in the place of an input would be solved again and again.
    for file in inputs(&command.input) {
        apart(&file, &[("--out", &command.out), ("--report", &command.report)])
            .map_err(Failure::Usage)?;
    }
    // Before it is solved: it may be saved meanwhile.
    let mut solved = stamps(&command.input);
    let mut last = solved.clone();
    solve::solve(command)?;
    loop {
        thread::sleep(EVERY);
        let now = stamps(&command.input);
        // A file that is still written changes from one look to the next, and some programs remove it
        // first. One that a scene names may be missing: then that is said.
        if now == last && now != solved && now[0].is_some() {
            solved.clone_from(&now);
            match solve::solve(command) {
                Ok(()) => {}
                Err(Failure::Input(message)) => eprintln!("{}", one_line(&message)),
                Err(failure) => return Err(failure),
            }
        }
        last = now;
    }
}

/// The input, and the files that a scene names.
fn inputs(path: &Path) -> Vec<PathBuf> {
    let mut all = vec![path.to_owned()];
    if input::is_scene(path) {
        let text = fs::read_to_string(path).unwrap_or_default();
        let scene = Scene::from_json(&text);
        let folder = path.parent().unwrap_or(Path::new(""));
        let named = scene.iter().flat_map(named_files);
        all.extend(named.map(|name| folder.join(name)));
    }
    all
}

fn stamps(path: &Path) -> Vec<Stamp> {
    let stamp = |path: &PathBuf| {
        let about = fs::metadata(path).ok()?;
        Some((about.modified().ok()?, about.len()))
    };
    inputs(path).iter().map(stamp).collect()
}
