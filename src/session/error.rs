//! The error type of hosts. Each variant is defined in its stage and converted here.

use std::fmt;

/// An error of validating or solving: always the input's fault. A broken internal contract
/// panics instead.
#[derive(Clone, Debug, PartialEq)]
pub enum Error {
    /// A scene is not valid.
    Scene(crate::scene::SceneError),
    /// The scene is valid, but cannot be solved.
    Solve(crate::solve::SolveError),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Scene(e) => e.fmt(f),
            Error::Solve(e) => e.fmt(f),
        }
    }
}

impl std::error::Error for Error {}

impl From<crate::scene::SceneError> for Error {
    fn from(e: crate::scene::SceneError) -> Self {
        Error::Scene(e)
    }
}

impl From<crate::solve::SolveError> for Error {
    fn from(e: crate::solve::SolveError) -> Self {
        Error::Solve(e)
    }
}
