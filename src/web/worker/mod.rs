//! The face of the solver in the worker.
//!
//! | file or folder | holds |
//! |---|---|
//! | `solver` | the model that is open, its state, its numbers |
//! | `reading`, `edit`, `drag` | files in; edits and previews; handles that are dragged |
//! | `shown`, `original` | what is drawn of the session, and of what it was before |
//! | `report` | what is told of the session |
//! | `selecting`, `lists` | selections and settings, lists of elements |
//! | `saved` | steps of undo and unfinished work as bytes, to go on after a restart; what a student hands in |
//! | `parametrize`, `experiment` | the flat map, the paper's comparisons |
//! | `trials` | what would help where constraints are not met, what it would cost to be exact, and variations |
//! | `measure` | what benchmarks ask |

mod drag;
mod edit;
pub mod experiment;
mod lists;
mod measure;
mod original;
mod parametrize;
mod reading;
mod report;
mod saved;
mod selecting;
mod shown;
mod solver;
pub mod trials;

pub use solver::Solver;
