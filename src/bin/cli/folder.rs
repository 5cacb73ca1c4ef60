//! An output folder, removed if it stays empty.

use super::Failure;
use std::path::{Path, PathBuf};

/// Folders made for output. On drop, those that are empty are removed.
pub(super) struct MadeFolders(Vec<PathBuf>);

impl MadeFolders {
    /// Makes a folder and its missing ancestors.
    ///
    /// # Errors
    /// If the folder cannot be made.
    pub(super) fn make(folder: &Path) -> Result<MadeFolders, Failure> {
        let missing = folder
            .ancestors()
            .take_while(|path| !path.as_os_str().is_empty() && !path.exists())
            .map(Path::to_owned);
        // Recorded first, so that they are removed even if only some can be made.
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
            // Fails for a folder with contents, which is kept.
            let _ = std::fs::remove_dir(folder);
        }
    }
}
