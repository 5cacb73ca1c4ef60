//! `shape-up watch`: solves a file, or each mesh of a folder, again whenever another program saves it.

use super::arguments::Solve;
use super::{Failure, input, one_line, solve};
use shape_up::mesh::FileFormat;
use shape_up::scene::Scene;
use shape_up::session::named_files;
use std::collections::BTreeMap;
use std::fs;
use std::io;
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
    if command.input.is_dir() {
        return watch_folder(command);
    }
    let mut file = Watched::new(command.clone());
    // Before it is solved: it may be saved meanwhile.
    file.solved = file.inputs.stamps();
    file.last.clone_from(&file.solved);
    if file.solved[0].is_none() {
        // Its name may be wrong.
        return solve::solve(command);
    }
    solve_or_say(command)?;
    loop {
        thread::sleep(EVERY);
        file.look()?;
    }
}

/// Solves each mesh of a folder, and those that are saved there later, into a file of another folder. As
/// with one file, what is gone for a while, such as the folder of a server, is waited for.
fn watch_folder(command: &Solve) -> Result<(), Failure> {
    let folder = &command.input;
    let refused = |words: &str| Failure::Usage(format!("watch of a folder {words}"));
    let Some(out) = &command.out else { return Err(refused("needs --out, another folder")) };
    if command.report.is_some() {
        return Err(refused("takes no --report, which is of one file"));
    }
    let at = |path: &Path, error: &io::Error| {
        Failure::Input(format!("{}: {error}, expected a folder", path.display()))
    };
    fs::create_dir_all(out).map_err(|error| at(out, &error))?;
    let place = |path: &Path| path.canonicalize().map_err(|error| at(path, &error));
    if place(folder)? == place(out)? {
        return Err(refused("needs --out, another folder: it would replace what is read"));
    }
    let mut files: BTreeMap<String, Watched> = BTreeMap::new();
    meshes_in(folder).map_err(|error| at(folder, &error))?;
    loop {
        for name in meshes_in(folder).unwrap_or_default() {
            let input = folder.join(&name);
            let out = out.join(written_as(&name));
            let own = || Watched::new(Solve { input, out: Some(out), ..command.clone() });
            files.entry(name).or_insert_with(own);
        }
        files.values_mut().try_for_each(Watched::look)?;
        thread::sleep(EVERY);
    }
}

/// The names of the mesh files in a folder, but for hidden ones.
fn meshes_in(folder: &Path) -> io::Result<Vec<String>> {
    let is_mesh = |name: &String| {
        !name.starts_with('.') && FileFormat::of_name(name).is_some_and(FileFormat::is_mesh)
    };
    let names: io::Result<Vec<String>> = fs::read_dir(folder)?
        .map(|entry| entry.map(|entry| entry.file_name().to_string_lossy().into_owned()))
        .collect();
    Ok(names?.into_iter().filter(is_mesh).collect())
}

/// The name of the solved mesh: the same, or that of an OBJ file if its format is not written.
fn written_as(name: &str) -> String {
    match FileFormat::of_name(name) {
        Some(format) if format.writes.is_empty() => format!("{name}.obj"),
        _ => name.to_owned(),
    }
}

/// A file that is solved whenever it was saved.
struct Watched {
    command: Solve,
    inputs: Inputs,
    /// When it was solved last; empty before.
    solved: Vec<Stamp>,
    /// When it was looked at last; empty before.
    last: Vec<Stamp>,
}

impl Watched {
    fn new(command: Solve) -> Watched {
        let inputs = Inputs::of(&command.input);
        Watched { command, inputs, solved: Vec::new(), last: Vec::new() }
    }

    /// Solves it if it was saved since it was solved.
    fn look(&mut self) -> Result<(), Failure> {
        let now = self.inputs.stamps();
        // A file that is still written changes from one look to the next, and some programs remove it
        // first. One that a scene names may be missing: then that is said.
        if now == self.last && now != self.solved && now[0].is_some() {
            self.solved.clone_from(&now);
            solve_or_say(&self.command)?;
        }
        self.last = now;
        Ok(())
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
