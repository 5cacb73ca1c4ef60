//! Output: atomic writing of files, text on standard output, and the form of tables.

use super::Failure;
use serde::Serialize;
use shape_up::mesh::{Circularity, Planarity};
use shape_up::words;
use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes all files, or none in part: each is written under a temporary name beside its
/// destination, and all are renamed once all are complete.
pub(super) fn write(files: &[(impl AsRef<Path>, impl AsRef<[u8]>)]) -> Result<(), Failure> {
    let mut complete: Vec<Complete<'_>> = Vec::new();
    let result = files
        .iter()
        .try_for_each(|(path, content)| {
            let path = path.as_ref();
            let place = Place::of(path)?;
            let mut options = OpenOptions::new();
            let opened = match &place {
                Place::File { beside, .. } => options.write(true).create_new(true).open(beside),
                Place::Stream => options.write(true).open(path),
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
    Stream,
}

impl Place {
    fn of(path: &Path) -> Result<Place, Failure> {
        let place = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        let Some(name) = place.file_name().filter(|_| !place.is_dir()) else {
            return Err(Failure::Input(format!(
                "{}: cannot be written: it is a folder, expected the name of a file",
                path.display()
            )));
        };
        if fs::metadata(&place).is_ok_and(|found| !found.is_file()) {
            return Ok(Place::Stream);
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

/// Writes to standard output. A closed pipe, as after `head`, is no error.
pub(super) fn print(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::Input(format!("standard output: cannot be written: {error}")))
        }
        _ => Ok(()),
    }
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
