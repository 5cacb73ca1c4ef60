//! The interface of the solver in the worker.
//!
//! | file or folder | holds |
//! |---|---|
//! | `solver` | the open model, its state and its numbers |
//! | `reading`, `edit`, `drag` | files to open; edits and previews; dragged handles |
//! | `shown`, `original` | arrays to draw, of the current shape and of the original |
//! | `report` | reports on the session |
//! | `selecting`, `lists` | selections and settings, lists of elements |
//! | `saved` | undo history and unfinished work as bytes, for a restart; a student's results |
//! | `accepting` | what was found on a copy of the model, and variants |
//! | `measure` | timings for benchmarks |

mod accepting;
mod drag;
mod edit;
mod lists;
mod measure;
mod original;
mod reading;
mod report;
mod saved;
mod selecting;
mod shown;
mod solver;

pub(crate) use report::ForecastWords;
pub use solver::Solver;
