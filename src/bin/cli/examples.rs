//! `shape-up examples`: lists the examples, or writes their scenes and models.

use super::{Failure, output};
use shape_up::generate::example::example_files;
use shape_up::generate::example::{EXAMPLES, Example};
use std::path::{Path, PathBuf};

/// Prints one line per example.
pub(super) fn list() -> Result<(), Failure> {
    let line =
        |example: &Example| format!("{:<20} {}. {}\n", example.id, example.title, example.summary);
    output::print(&EXAMPLES.iter().map(line).collect::<String>())
}

/// Writes the files of all examples.
pub(super) fn write(folder: &Path) -> Result<(), Failure> {
    let named = example_files().into_iter().map(|(name, text)| (folder.join(name), text));
    let files: Vec<(PathBuf, String)> = named.collect();
    output::write_with_folder(folder, &files)?;
    let names: Vec<_> = files.iter().map(|(path, _)| format!("{}\n", path.display())).collect();
    output::print(&names.concat())
}
