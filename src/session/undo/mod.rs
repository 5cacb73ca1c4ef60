//! Undo and redo, by exchange.
//!
//! # A change is its own inverse
//!
//! No state is stored whole. A [`Change`] holds what another state has in place of the current one:
//! parts of the document (`state/part`), handles, positions, the iteration count, and rarely a
//! whole mesh with its document. `Session::exchange` swaps these values with those of the session.
//! The session is then in the other state, and the same change holds what was there before, so that
//! it leads back: two exchanges change nothing. Undo and redo are therefore one operation, and a
//! step moves from one list to the other.
//!
//! A new weight of 3 for a row that has 1, which is then undone and redone:
//!
//! ```text
//!                                              row   undo     redo
//! edit   Draft::put exchanges the part of        1   -        -
//!        weight 3, which becomes weight 1        3   -        -
//!        History::push                           3   [1]      -
//! undo   pop_undo, exchange, push_redo           1   -        [3]
//! redo   pop_redo, exchange, push_undo           3   [1]      -
//! ```
//!
//! - An edit goes another way only at its start: `SolvedScene::edit` lets it put one part after
//!   another in a `Draft`, which exchanges each part at once and records it. From there on it is as
//!   in an exchange: `SolvedScene::follow` exchanges handles and positions, and brings the solver
//!   up to date at the least cost.
//! - A part may depend on those before it, as the index of a row does on rows that were removed.
//!   So an exchange takes the parts of a change in reverse, and leaves them in that order.
//! - If the solver cannot follow, because its system would be singular, the parts are exchanged
//!   once more, and nothing has changed.
//! - A drag or a run is a [`Transaction`]: it begins with a change that leads back to its start,
//!   and becomes a step when it ends, as it does before an edit. What the solver changes of the
//!   document during it is added to that change.
//! - Positions and handles are shared by all changes between which they stay the same.
//!
//! | file | holds |
//! |---|---|
//! | `history` | the difference of two states of a session; the steps of undo and redo |
//! | `transaction` | a drag or run under way, which becomes one step of undo |
//! | `saved` | steps of undo and unfinished work as bytes, for a restart |

mod history;
mod saved;
mod transaction;

pub(crate) use history::{Change, History};
pub(crate) use saved::{SavedState, read_history, read_state, write_history, write_state};
pub(crate) use transaction::{ShownVariation, Transaction, TransactionKind};
