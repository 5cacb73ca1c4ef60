//! The result of reading a file: a mesh with its problems and notes, or an error.

use crate::mesh::{Mesh, MeshProblem};

/// A mesh read from a file, with problems and notes.
#[derive(Clone, Debug, PartialEq)]
pub struct Read {
    /// The mesh.
    pub mesh: Mesh,
    /// Problems of the file or the mesh that did not stop reading.
    pub problems: Vec<MeshProblem>,
    /// Notes, a sentence each, such as ignored statements and assumptions made.
    pub notes: Vec<String>,
}

/// Reason why a file is refused; `read` adds the name of the file and the text of the line.
pub(crate) struct ReadFault {
    pub(crate) line: Option<usize>,
    pub(crate) message: String,
}

impl ReadFault {
    /// Returns a fault of the file as a whole.
    pub(crate) fn whole(message: impl Into<String>) -> Self {
        ReadFault { line: None, message: message.into() }
    }
}

/// Reason why a mesh file was refused.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadError {
    /// Name of the file.
    pub file: String,
    /// Line, counted from one; `None` if the file as a whole is at fault.
    pub line: Option<usize>,
    /// The text of that line, shortened; empty if the file as a whole is at fault.
    pub text: String,
    /// The fault, and what was expected instead.
    pub message: String,
}

impl std::fmt::Display for ReadError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.line {
            Some(line) => write!(f, "{}:{line}: `{}`: {}", self.file, self.text, self.message),
            None => write!(f, "{}: {}", self.file, self.message),
        }
    }
}

impl std::error::Error for ReadError {}
