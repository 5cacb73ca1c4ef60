//! A folder for several files, which does not stay behind empty.

use super::Failure;
use std::path::{Path, PathBuf};

/// The folders that were made for some files. Those of them that are empty when it goes out of scope are removed:
/// where nothing was written, nothing is there.
pub(super) struct MadeFolders(Vec<PathBuf>);

impl MadeFolders {
    /// Makes a folder and what it lies in, as far as they are not there.
    ///
    /// # Errors
    /// A place where there can be no folder.
    pub(super) fn make(folder: &Path) -> Result<MadeFolders, Failure> {
        let missing = folder
            .ancestors()
            .take_while(|path| !path.as_os_str().is_empty() && !path.exists())
            .map(Path::to_owned);
        // They go even if only some could be made.
        let made = MadeFolders(missing.collect());
        std::fs::create_dir_all(folder).map_err(|error| {
            Failure::Input(format!(
                "{}: cannot be made: {error}, expected the name of a folder",
                folder.display()
            ))
        })?;
        Ok(made)
    }
}

impl Drop for MadeFolders {
    fn drop(&mut self) {
        for folder in &self.0 {
            // One with something in it is kept.
            let _ = std::fs::remove_dir(folder);
        }
    }
}
