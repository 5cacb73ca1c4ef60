//! Reading of mesh and scene files.

use super::Failure;
use shape_up::mesh::{self, Mesh, Read, Weld};
use shape_up::scene::{Scene, UnitsAndUp, Up};
use shape_up::session::{self, Error, FileReader, OpenedFile, named_files};
use std::cell::RefCell;
use std::collections::BTreeSet;
use std::fs::File;
use std::io::{self, Read as _};
use std::path::{Path, PathBuf};

/// The largest size of an input file, in bytes; no larger mesh or scene can be solved.
const MOST_BYTES: u64 = 1 << 30;

/// A scene with its mesh.
pub(super) struct Input {
    pub(super) scene: Scene,
    pub(super) mesh: Mesh,
    /// How the mesh file was welded.
    pub(super) weld: Option<Weld>,
    /// Unit and axis for files of the mesh: they do not state a unit that was guessed from a size.
    pub(super) frame: UnitsAndUp,
    /// Tolerated problems of the mesh file, and notes about it.
    pub(super) remarks: Vec<String>,
}

/// Returns what makes an error of a session one of the file `path`, or of the option that asked for
/// panels.
pub(super) fn at(path: &Path) -> impl Fn(Error) -> Failure + Copy {
    move |error| {
        let message = match error {
            Error::Scene(error) if error.path == "panels" => format!("--panels: {}", error.message),
            error => error.to_string(),
        };
        Failure::Input(format!("{}: {message}", path.display()))
    }
}

/// Whether the name is that of a scene.
pub(super) fn is_scene(path: &Path) -> bool {
    session::is_scene(&path.to_string_lossy())
}

/// Reads a scene and its mesh, or a mesh with the default scene of an opened mesh.
pub(super) fn read(path: &Path) -> Result<Input, Failure> {
    read_in(None, path)
}

/// As [`read`], with another unit than that of the file, or a guessed one.
pub(super) fn read_in(units: Option<&str>, path: &Path) -> Result<Input, Failure> {
    let asked = UnitsAndUp { units: units.map(str::to_owned), up: None };
    let expected = if is_scene(path) { "a scene file" } else { "a mesh file" };
    let bytes = bytes(path, expected)?;
    if !is_scene(path) {
        let source = mesh::read(&path.to_string_lossy(), &bytes)
            .map_err(|error| Failure::Input(error.to_string()))?;
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let stated = asked.or(UnitsAndUp::stated(&bytes));
        let units = stated.units.clone();
        let opened = OpenedFile::of_mesh(&name, source, stated, false);
        let OpenedFile { scene, mesh, weld, diagnostics, guessed } = opened;
        let mut remarks = remarks(&diagnostics);
        if guessed.units && !scene.units.is_empty() {
            remarks.push(format!("the file has no unit: taken as {} by its size", scene.units));
        }
        if guessed.up && scene.up != Up::default() {
            remarks.push("the file has no up axis: taken as y by its shape".to_owned());
        }
        let frame = UnitsAndUp { units, up: Some(scene.up) };
        return Ok(Input { scene, mesh, weld, frame, remarks });
    }
    let scene = OpenedFile::scene_in(&bytes)
        .map_err(|error| Failure::Input(format!("{}: {error}", path.display())))?;
    let mut reader = FileReader::default();
    for (place, file) in named_files(&scene) {
        reader.add_file(file, named_file(path, place, file)?);
    }
    let opened = reader.scene_with_files(&path.to_string_lossy(), scene);
    let opened = opened.map_err(|error| Failure::Input(error.to_string()))?;
    let OpenedFile { mut scene, mesh, weld, diagnostics, .. } = opened;
    scene.units = asked.units.unwrap_or(scene.units);
    let frame = UnitsAndUp { units: Some(scene.units.clone()), up: Some(scene.up) };
    Ok(Input { scene, mesh, weld, frame, remarks: remarks(&diagnostics) })
}

/// Returns the bytes of the file named in a scene at the JSON path `place`.
fn named_file(scene: &Path, place: &str, file: &str) -> Result<Vec<u8>, Failure> {
    let beside = scene.with_file_name(file);
    let unread = |why: String| {
        Failure::Input(format!(
            "{}: {place}: cannot read {}: {why}, expected a mesh file beside the scene",
            scene.display(),
            beside.display()
        ))
    };
    // A scene may come from an untrusted source and name an endless device.
    let about = std::fs::metadata(&beside).map_err(|error| unread(error.to_string()))?;
    if !about.is_file() {
        return Err(unread("it is not a regular file".to_owned()));
    }
    read_whole(&beside).map_err(|error| unread(error.to_string()))
}

/// Reads a mesh file for measurement, welded as [`read`] welds it, with numbers whose squares are finite,
/// and what it states.
pub(super) fn read_mesh(path: &Path) -> Result<(Read, Option<Weld>, UnitsAndUp), Failure> {
    let bytes = bytes(path, "a mesh file")?;
    let mut read = mesh::read(&path.to_string_lossy(), &bytes)
        .map_err(|error| Failure::Input(error.to_string()))?;
    Scene::default()
        .validate(&read.mesh)
        .map_err(|error| Failure::Input(format!("{}: {error}", path.display())))?;
    let weld = read.weld();
    Ok((read, weld, UnitsAndUp::stated(&bytes)))
}

/// Returns the problems and notes of the mesh reader, one line each.
pub(super) fn remarks(read: &Read) -> Vec<String> {
    read.problems.iter().map(ToString::to_string).chain(read.notes.iter().cloned()).collect()
}

/// Returns the bytes of a file, of which errors say what is `expected`.
pub(super) fn bytes(path: &Path, expected: &str) -> Result<Vec<u8>, Failure> {
    read_whole(path).map_err(|error| {
        Failure::Input(format!("{}: cannot be read: {error}, expected {expected}", path.display()))
    })
}

thread_local! {
    /// The files that were read, with links resolved: no output may replace them.
    static READ: RefCell<BTreeSet<PathBuf>> = const { RefCell::new(BTreeSet::new()) };
}

/// Whether the file at this place, with links resolved, was read.
pub(super) fn was_read(place: &Path) -> bool {
    READ.with_borrow(|read| read.contains(place))
}

/// Returns the bytes of a file or pipe. Endless ones are an error.
fn read_whole(path: &Path) -> io::Result<Vec<u8>> {
    if let Ok(place) = path.canonicalize() {
        READ.with_borrow_mut(|read| read.insert(place));
    }
    let mut bytes = Vec::new();
    File::open(path)?.take(MOST_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MOST_BYTES {
        let message = format!("it is larger than {} MB", MOST_BYTES >> 20);
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, message));
    }
    Ok(bytes)
}
