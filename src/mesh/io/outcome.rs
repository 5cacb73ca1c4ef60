//! The result of reading a file: a mesh with its problems and notes, or an error.

use crate::mesh::{Mesh, MeshProblem};

/// A mesh as it was read, and what there is to say of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Read {
    /// The mesh.
    pub mesh: Mesh,
    /// Problems of the file or the mesh that did not stop reading.
    pub problems: Vec<MeshProblem>,
    /// Notes, a sentence each: statements that were left out, guesses that were made.
    pub notes: Vec<String>,
}

/// Why a file is refused; [`read`] adds the name of the file and the text of the line.
pub(crate) struct ReadFault {
    pub(crate) line: Option<usize>,
    pub(crate) message: String,
}

impl ReadFault {
    /// A fault of no line in particular.
    pub(crate) fn whole(message: impl Into<String>) -> Self {
        ReadFault { line: None, message: message.into() }
    }
}

/// Why a mesh file was refused.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadError {
    /// Name of the file.
    pub file: String,
    /// Line, counted from one; none when the file as a whole is at fault.
    pub line: Option<usize>,
    /// The text of that line, shortened; empty when the file as a whole is at fault.
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
