//! Undo and redo.
//!
//! | file | holds |
//! |---|---|
//! | `change` | the difference of two states of a session |
//! | `history` | the steps of undo and redo |
//! | `transaction` | a drag or run under way, which becomes one step of undo |
//! | `targets` | the check of handle targets |
//! | `saved` | steps of undo and unfinished work as bytes, for a restart |

mod change;
mod history;
mod saved;
mod targets;
mod transaction;

pub(crate) use change::Change;
pub(crate) use history::History;
pub(crate) use saved::{SavedState, read_history, read_state, write_history, write_state};
pub use targets::check_targets;
pub(crate) use transaction::Transaction;
