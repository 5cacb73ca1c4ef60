//! What has happened in a session since it was opened: all of it that lasts while the solver is made
//! anew.

use super::collapse::Guard;
use super::history::History;
use super::trace::Trace;
use super::transaction::Transaction;
use crate::scene::Scene;
use crate::solve::Energy;

/// Iterations, energies, history and guard of a session.
pub(crate) struct RunState {
    /// See [`crate::session::Session::iteration`].
    pub(crate) iteration: u32,
    /// The energies at the input.
    pub(crate) initial: Energy,
    /// The energies since then, when they are asked for.
    pub(crate) trace: Option<Trace>,
    /// Seconds that reading the files took.
    pub(crate) load_seconds: f64,
    /// The steps of undo and redo.
    pub(crate) history: History,
    /// The drag or run that is under way.
    pub(crate) transaction: Option<Transaction>,
    /// The guard against collapse.
    pub(crate) guard: Guard,
}

impl RunState {
    /// Nothing has happened yet to the document `opened`.
    pub(crate) fn beginning(initial: Energy, opened: Scene) -> RunState {
        RunState {
            iteration: 0,
            initial,
            trace: None,
            load_seconds: 0.0,
            history: History::default(),
            transaction: None,
            guard: Guard::new(opened),
        }
    }
}
