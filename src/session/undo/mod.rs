//! Changes that can be taken back.
//!
//! | file | holds |
//! |---|---|
//! | `transition` | from one state to another at the least cost: edits, undo, redo |
//! | `drag_transaction` | drags and runs, one step of undo each |
//! | `saved` | steps of undo and unfinished work as bytes, to go on after a restart |

mod drag_transaction;
mod saved;
mod transition;

pub use drag_transaction::check_targets;
