//! What has happened in a session since it was opened: all of it that lasts while the solver is made
//! anew.

use super::collapse::Guard;
use super::gesture::Gesture;
use super::history::History;
use super::trace::Trace;
use crate::scene::Scene;
use crate::solve::Energy;

/// What has happened so far.
pub(super) struct Past {
    /// See [`super::Session::iteration`].
    pub(super) iteration: u32,
    /// The energies at the input.
    pub(super) initial: Energy,
    /// The energies since then, when they are asked for.
    pub(super) trace: Option<Trace>,
    /// What reading the files took.
    pub(super) load_seconds: f64,
    /// What can be undone and redone.
    pub(super) history: History,
    /// What has begun and is not yet a step of undo.
    pub(super) gesture: Option<Gesture>,
    /// What watches over the shape.
    pub(super) guard: Guard,
}

impl Past {
    /// Nothing has happened yet to the document `opened`.
    pub(super) fn beginning(initial: Energy, opened: Scene) -> Past {
        Past {
            iteration: 0,
            initial,
            trace: None,
            load_seconds: 0.0,
            history: History::default(),
            gesture: None,
            guard: Guard::new(opened),
        }
    }
}
