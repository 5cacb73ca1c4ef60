//! Undo and redo, by whole states.
//!
//! A step of undo is a name and the [`SessionState`] before it: mesh, document, handles, positions,
//! iteration count. A step of redo has the state after it. To undo is to go to the state of the last
//! step; the state that was left becomes the step of redo, and the other way round.
//!
//! A new weight of 3 for a row that has 1, which is then undone and redone:
//!
//! ```text
//!                                                row   undo     redo
//!                                                1     -        -
//! edit   make, History::push the state before    3     [1]      -
//! undo   pop_undo, go_to_state, push_redo        1     -        [3]
//! redo   pop_redo, go_to_state, push_undo        3     [1]      -
//! ```
//!
//! - States are cheap to keep: what is large, and the same in several, is shared by them.
//! - `SolvedScene::go_to` compares the state with the current one, and brings the solver up to date
//!   at the least cost. If it cannot, because its system would be singular, nothing has changed.
//! - A drag or a run is a [`Transaction`]: it begins with the state that it leads back to, and becomes
//!   a step when it ends, as it does before an edit. What the solver changes of the document during it
//!   is undone with it.
//! - A tolerance that is set is no step. It replaces that of the states around the current one.
//!
//! | file | holds |
//! |---|---|
//! | `history` | a state of a session; the steps of undo and redo |
//! | `transaction` | a drag or run under way, which becomes one step of undo |
//! | `saved` | steps of undo and unfinished work as bytes, for a restart |

mod history;
mod saved;
mod transaction;

pub(crate) use history::{History, SessionState};
pub(crate) use saved::{read_history, read_state, write_history, write_state};
pub(crate) use transaction::{ShownVariation, Transaction, TransactionKind};
