//! Errors in a scene.

use std::fmt;

/// An error in a scene, with its JSON path.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneError {
    /// JSON path, such as `constraints[2].on.set`; empty for the whole file.
    pub path: String,
    /// The fault, and what was expected instead.
    pub message: String,
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.path.is_empty() {
            f.write_str(&self.message)
        } else {
            write!(f, "{}: {}", self.path, self.message)
        }
    }
}

impl std::error::Error for SceneError {}
