//! The interface of the solver in the worker.
//!
//! | file | holds |
//! |---|---|
//! | `solver` | the open model, its iterations, runs and drags |
//! | `files`, `loaded` | files, opened, restored and written; the summary of one that was opened |
//! | `edit` | changes of the model, and the acceptance of what was found on a copy of it |
//! | `document`, `frame` | the current document; the numbers of one state of the iteration |
//! | `shown` | arrays to draw |
//! | `questions` | reports, verdicts, lists of elements, selections, offers |
//! | `vocabulary` | what is declared: kinds, measures, operations, settings |

mod document;
mod edit;
mod files;
mod frame;
mod loaded;
mod questions;
mod shown;
mod solver;
mod vocabulary;

pub use solver::Solver;
