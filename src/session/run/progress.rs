//! The iteration count of a session, and the energies of the iterations.

use super::trace::{Trace, TraceEntry};
use crate::solve::Energy;

/// The iteration count and the recorded energies; they are kept when the solver is replaced.
pub(crate) struct Progress {
    iteration: u32,
    initial: Energy,
    trace: Option<Trace>,
    halfway: bool,
    /// The time that reading the files took, in seconds.
    pub(crate) load_seconds: f64,
}

impl Progress {
    /// Begins at the input, which has these energies.
    pub(crate) fn new(initial: Energy) -> Progress {
        Progress { iteration: 0, initial, trace: None, halfway: false, load_seconds: 0.0 }
    }

    /// Number of iterations from the start of the scene to the current shape; undo reduces it.
    pub(crate) fn iteration(&self) -> u32 {
        self.iteration
    }

    /// The energies of the input.
    pub(crate) fn initial(&self) -> Energy {
        self.initial
    }

    /// Whether the local step of the next iteration is done and its global step is not.
    pub(crate) fn halfway(&self) -> bool {
        self.halfway
    }

    /// Marks the local step as done.
    pub(crate) fn begin_half(&mut self) {
        self.halfway = true;
    }

    /// Clears the mark of the local step, because something other than the global step follows.
    pub(crate) fn leave_half(&mut self) {
        self.halfway = false;
    }

    /// Counts an iteration and records the energies after it.
    pub(crate) fn advance(&mut self, energy: Energy) {
        self.halfway = false;
        self.iteration += 1;
        if let Some(trace) = &mut self.trace {
            trace.push(TraceEntry::new(self.iteration, energy));
        }
    }

    /// Records the energies of the shape that a run ends with after its last iteration.
    pub(crate) fn end_with(&mut self, energy: Energy) {
        self.halfway = false;
        if let Some(trace) = &mut self.trace {
            trace.end_with(TraceEntry::new(self.iteration, energy));
        }
    }

    /// Sets the iteration count and the energies after a jump to another state.
    pub(crate) fn go_to(&mut self, iteration: u32, energy: Energy) {
        self.halfway = false;
        self.iteration = iteration;
        if let Some(trace) = &mut self.trace {
            trace.go_to(TraceEntry::new(iteration, energy));
        }
    }

    /// Sets the iteration count of a scene reopened in its saved state, and restarts the record.
    pub(crate) fn restore(&mut self, iteration: u32, energy: Energy) {
        self.iteration = iteration;
        if self.trace.is_some() {
            self.record(energy);
        }
    }

    /// Starts recording energies, evenly spaced and bounded in number: see [`Trace`].
    pub(crate) fn record(&mut self, energy: Energy) {
        self.trace = Some(Trace::bounded(TraceEntry::new(self.iteration, energy)));
    }

    /// Starts recording the energies of all iterations.
    pub(crate) fn record_all(&mut self, energy: Energy) {
        self.trace = Some(Trace::whole(TraceEntry::new(self.iteration, energy)));
    }

    /// The recorded energies; none if nothing is recorded.
    pub(crate) fn trace(&self) -> Option<&[TraceEntry]> {
        self.trace.as_ref().map(Trace::entries)
    }
}
