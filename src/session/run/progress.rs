//! How far a session has iterated, and the energies on the way.

use super::trace::{Trace, TraceEntry};
use crate::solve::Energy;

/// The count of iterations and their record; it outlasts the solver.
pub(crate) struct Progress {
    iteration: u32,
    initial: Energy,
    trace: Option<Trace>,
    halfway: bool,
    load_seconds: f64,
}

impl Progress {
    /// At the input, which has these energies.
    pub(crate) fn new(initial: Energy) -> Progress {
        Progress { iteration: 0, initial, trace: None, halfway: false, load_seconds: 0.0 }
    }

    /// Iterations from where the scene starts to the current shape; undo takes them back.
    pub(crate) fn iteration(&self) -> u32 {
        self.iteration
    }

    /// The energies at the input.
    pub(crate) fn initial(&self) -> Energy {
        self.initial
    }

    /// Whether the local step of the next iteration is done and its global step is not.
    pub(crate) fn halfway(&self) -> bool {
        self.halfway
    }

    /// The local step is done.
    pub(crate) fn begin_half(&mut self) {
        self.halfway = true;
    }

    /// Something else than the global step comes next.
    pub(crate) fn leave_half(&mut self) {
        self.halfway = false;
    }

    /// Seconds that reading the files took.
    pub(crate) fn load_seconds(&self) -> f64 {
        self.load_seconds
    }

    pub(crate) fn set_load_seconds(&mut self, seconds: f64) {
        self.load_seconds = seconds;
    }

    /// One more iteration, whose energies nobody has asked for.
    pub(crate) fn count(&mut self) {
        self.halfway = false;
        self.iteration += 1;
    }

    /// One more iteration, with the energies after it.
    pub(crate) fn advance(&mut self, energy: Energy) {
        self.halfway = false;
        self.iteration += 1;
        if let Some(trace) = &mut self.trace {
            trace.push(TraceEntry::new(self.iteration, energy));
        }
    }

    /// Counts on from another state, with the energies there.
    pub(crate) fn go_to(&mut self, iteration: u32, energy: Energy) {
        self.halfway = false;
        self.iteration = iteration;
        if let Some(trace) = &mut self.trace {
            trace.go_to(TraceEntry::new(iteration, energy));
        }
    }

    /// Counts on from `iteration`, for a scene that is opened again where it stood: a record begins anew.
    pub(crate) fn restore(&mut self, iteration: u32, energy: Energy) {
        self.iteration = iteration;
        if self.trace.is_some() {
            self.record(energy);
        }
    }

    /// Records energies from here on, evenly within a bound: see [`Trace`].
    pub(crate) fn record(&mut self, energy: Energy) {
        self.trace = Some(Trace::bounded(TraceEntry::new(self.iteration, energy)));
    }

    /// Records energies of all iterations from here on.
    pub(crate) fn record_all(&mut self, energy: Energy) {
        self.trace = Some(Trace::whole(TraceEntry::new(self.iteration, energy)));
    }

    /// The record; none where nothing is recorded.
    pub(crate) fn trace(&self) -> Option<&[TraceEntry]> {
        self.trace.as_ref().map(Trace::entries)
    }
}
