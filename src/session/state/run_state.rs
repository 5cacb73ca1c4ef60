//! What has happened in a session since it was opened: all of it that lasts while the solver is made
//! anew.

use super::collapse::Guard;
use super::history::History;
use super::trace::Trace;
use super::transaction::Transaction;
use crate::scene::Scene;
use crate::solve::Energy;

/// What has happened so far.
pub(crate) struct RunState {
    /// See [`crate::session::Session::iteration`].
    pub(crate) iteration: u32,
    /// The energies at the input.
    pub(crate) initial: Energy,
    /// The energies since then, when they are asked for.
    pub(crate) trace: Option<Trace>,
    /// What reading the files took.
    pub(crate) load_seconds: f64,
    /// What can be undone and redone.
    pub(crate) history: History,
    /// What has begun and is not yet a step of undo.
    pub(crate) transaction: Option<Transaction>,
    /// What watches over the shape.
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
