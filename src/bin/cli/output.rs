//! Output: atomic writing of files, mesh files with the format by extension and what it cannot store,
//! output folders, which are removed if nothing is written, text on standard output, and the form of
//! tables.

use super::Failure;
use crate::cli::input;
use serde::Serialize;
use shape_up::mesh::{Circularity, FileFormat, Mesh, Planarity, write_with_ending};
use shape_up::scene::{NamedEnum, UnitsAndUp};
use shape_up::session::Session;
use shape_up::words;
use std::collections::BTreeSet;
use std::fs::OpenOptions;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::{fs, io};

/// Checks that files can be written: they replace neither one that was read nor each other, and their
/// folders are there.
///
/// # Errors
/// The first file that cannot.
pub(super) fn check(files: impl IntoIterator<Item = impl AsRef<Path>>) -> Result<(), Failure> {
    let mut places = BTreeSet::new();
    for path in files {
        let path = path.as_ref();
        let (place, was_read) = match Place::of(path)? {
            Place::File { place, .. } => {
                let folder = fs::metadata(place.parent().unwrap_or(&place));
                if !folder.map_err(|error| cannot(path, &error))?.is_dir() {
                    return Err(cannot(path, &io::ErrorKind::NotADirectory.into()));
                }
                let was_read = input::was_read(&place);
                (place, was_read)
            }
            Place::Stream(place) => (place, false),
        };
        let what = match was_read {
            true => "a file that is read",
            false if places.insert(place) => continue,
            false => "another file that is written",
        };
        let path = path.display();
        return Err(Failure::Usage(format!("{path} would replace {what}, expected another file")));
    }
    Ok(())
}

/// Writes all files, or none in part: each is written under a temporary name beside its
/// destination, and all are renamed once all are complete.
///
/// # Errors
/// Those of [`check`], or if one cannot be written.
pub(super) fn write(files: &[(impl AsRef<Path>, impl AsRef<[u8]>)]) -> Result<(), Failure> {
    check(files.iter().map(|(path, _)| path))?;
    let mut complete: Vec<Complete<'_>> = Vec::new();
    let result = files
        .iter()
        .try_for_each(|(path, content)| {
            let path = path.as_ref();
            let place = Place::of(path)?;
            let mut options = OpenOptions::new();
            let opened = match &place {
                Place::File { beside, .. } => options.write(true).create_new(true).open(beside),
                Place::Stream(_) => options.write(true).open(path),
            };
            let mut file = opened.map_err(|error| cannot(path, &error))?;
            let mut written = file.write_all(content.as_ref());
            if let Place::File { beside, place } = place {
                complete.push(Complete { path, beside, place });
                written = written.and_then(|()| file.sync_all());
            }
            written.map_err(|error| cannot(path, &error))
        })
        .and_then(|()| {
            complete.iter().try_for_each(|Complete { path, beside, place }| {
                fs::rename(beside, place).map_err(|error| cannot(path, &error))
            })
        });
    if result.is_err() {
        for file in &complete {
            // Files renamed already no longer have this name.
            let _ = fs::remove_file(&file.beside);
        }
    }
    result
}

/// A complete file that is not renamed yet.
struct Complete<'a> {
    /// The path on the command line.
    path: &'a Path,
    beside: PathBuf,
    place: PathBuf,
}

/// The destination of a path.
enum Place {
    /// A regular file, existing or not. Links are resolved, so that they remain.
    File {
        /// The temporary name.
        beside: PathBuf,
        place: PathBuf,
    },
    /// A pipe or a device: written directly, as it must not be replaced.
    Stream(PathBuf),
}

impl Place {
    fn of(path: &Path) -> Result<Place, Failure> {
        let place = place(path);
        let Some(name) = place.file_name().filter(|_| !place.is_dir()) else {
            return Err(Failure::Input(format!(
                "{}: cannot be written: it is a folder, expected the name of a file",
                path.display()
            )));
        };
        if fs::metadata(&place).is_ok_and(|found| !found.is_file()) {
            return Ok(Place::Stream(place));
        }
        let mut hidden = std::ffi::OsString::from(".");
        hidden.push(name);
        hidden.push(format!(".{}.part", std::process::id()));
        Ok(Place::File { beside: place.with_file_name(hidden), place })
    }
}

fn cannot(path: &Path, error: &io::Error) -> Failure {
    Failure::Input(format!(
        "{}: cannot be written: {error}, expected a writable path",
        path.display()
    ))
}

/// Formats remarks on what was read or done, one per line.
pub(super) fn notes(remarks: &[String]) -> String {
    remarks.iter().map(|remark| format!("note: {remark}\n")).collect()
}

/// Writes to standard output, with numbers as programs read them. A closed pipe, as after `head`, is
/// no error.
pub(super) fn print(text: &str) -> Result<(), Failure> {
    let text = with_plain_numbers(text);
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::Input(format!("standard output: cannot be written: {error}")))
        }
        _ => Ok(()),
    }
}

/// Replaces the signs and thin spaces that numbers have in words for readers.
fn with_plain_numbers(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    let (mut rest, mut before) = (text.chars().peekable(), ' ');
    while let Some(sign) = rest.next() {
        let begins_digits = rest.peek().is_some_and(char::is_ascii_digit);
        match sign {
            '−' if begins_digits => plain.push('-'),
            '\u{2009}' if begins_digits && before.is_ascii_digit() => {}
            _ => plain.push(sign),
        }
        before = sign;
    }
    plain
}

/// Returns data that can be written as JSON, with finite numbers only, as text.
pub(super) fn json(data: &impl Serialize) -> String {
    serde_json::to_string_pretty(data).expect("it is plain data with finite numbers") + "\n"
}

/// Formats rows of equal length in aligned columns.
pub(super) fn table(rows: &[impl AsRef<[String]>]) -> String {
    let columns = rows.first().map_or(0, |row| row.as_ref().len());
    let width = |column: usize| rows.iter().map(|row| row.as_ref()[column].chars().count()).max();
    let widths: Vec<usize> = (0..columns).map(|column| width(column).unwrap_or(0)).collect();
    let line = |row: &[String]| {
        let cells = row.iter().zip(&widths).map(|(cell, &width)| format!("{cell:<width$}"));
        cells.collect::<Vec<_>>().join("  ").trim_end().to_owned() + "\n"
    };
    rows.iter().map(|row| line(row.as_ref())).collect()
}

/// Formats planarity in one line, in the unit in which `tolerance` is written.
pub(super) fn planarity(planarity: &Planarity, units: &str, tolerance: f64) -> String {
    format!(
        "planarity   worst {}, mean {}, largest diagonal ratio {}",
        words::length_like(planarity.max_distance, units, tolerance),
        words::length_like(planarity.mean_distance, units, tolerance),
        words::number(planarity.diagonal_ratio_max)
    )
}

/// Formats circularity in one line, as [`planarity`].
pub(super) fn circularity(circularity: &Circularity, units: &str, tolerance: f64) -> String {
    format!(
        "circularity worst {}, mean {}",
        words::length_like(circularity.max_distance, units, tolerance),
        words::length_like(circularity.mean_distance, units, tolerance)
    )
}

/// A mesh file to be written, and a remark on what its format cannot store, if anything.
pub(super) type MeshFile = (Vec<u8>, Option<String>);

/// Returns the file `path` of a mesh with this unit and axis, as far as they are known.
pub(super) fn mesh_file(path: &Path, mesh: &Mesh, frame: &UnitsAndUp) -> MeshFile {
    let units = frame.units.as_deref().unwrap_or_default();
    let comments = UnitsAndUp::comments(units, frame.up, mesh);
    let bytes = write_with_ending(&ending(path), mesh, &mesh.positions, &comments);
    (bytes, left_out(path, mesh, frame))
}

/// The ending of a name in lower case; empty without one.
pub(super) fn ending(path: &Path) -> String {
    path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase()
}

/// Adds to `files` the changed mesh of a session, with this unit and axis, or, if the name ends in
/// .json, the scene with the mesh. Returns a remark on parts that the format cannot represent.
pub(super) fn write_changed<'a>(
    path: &'a Path,
    session: &Session,
    frame: &UnitsAndUp,
    files: &mut Vec<(&'a Path, Vec<u8>)>,
) -> Option<String> {
    if input::is_scene(path) {
        files.push((path, session.scene_with_mesh().into_bytes()));
        return None;
    }
    let (bytes, remark) = mesh_file(path, &session.shape(None), frame);
    files.push((path, bytes));
    remark
}

/// Returns a remark on what the format of `path` cannot store of the mesh, or of its unit and axis.
pub(super) fn left_out(path: &Path, mesh: &Mesh, frame: &UnitsAndUp) -> Option<String> {
    // A name without an ending is that of an OBJ file.
    let written = FileFormat::of_name(&path.to_string_lossy()).filter(|it| !it.writes.is_empty());
    let format = written.filter(|it| it.is_mesh()).or_else(|| FileFormat::of_name("a.obj"))?;
    let mut parts = format.cannot_store(mesh);
    if !format.states_frame {
        let lost = frame.not_guessable(mesh);
        parts.extend(lost.units.map(|units| format!("its unit ({units})")));
        parts.extend(lost.up.map(|up| format!("its up axis ({})", up.word())));
    }
    let parts = (!parts.is_empty()).then(|| parts.join(", "))?;
    let name = format.name.trim_start_matches("Wavefront ");
    Some(format!("{} is {name}, which cannot store {parts}", path.display()))
}

/// Makes a folder with its missing ancestors, and writes files as [`write`] does. Folders that were
/// made are removed if it fails.
///
/// # Errors
/// If the folder cannot be made, and those of [`write`].
pub(super) fn write_with_folder(
    folder: &Path,
    files: &[(impl AsRef<Path>, impl AsRef<[u8]>)],
) -> Result<(), Failure> {
    let is_missing = |path: &&Path| !path.as_os_str().is_empty() && !path.exists();
    let missing: Vec<&Path> = folder.ancestors().take_while(is_missing).collect();
    let made = fs::create_dir_all(folder).map_err(|error| {
        Failure::Input(format!(
            "{}: cannot be made: {error}, expected the name of a folder",
            folder.display()
        ))
    });
    made.and_then(|()| write(files)).inspect_err(|_| {
        for folder in missing {
            // Fails for a folder with contents, which is kept.
            let _ = fs::remove_dir(folder);
        }
    })
}

/// Returns the absolute path of a file that may not exist yet, with links resolved.
pub(super) fn place(path: &Path) -> PathBuf {
    let absolute = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    let of_folder = || {
        let folder = absolute.parent()?.canonicalize().ok()?;
        Some(folder.join(absolute.file_name()?))
    };
    absolute.canonicalize().ok().or_else(of_folder).unwrap_or(absolute)
}
