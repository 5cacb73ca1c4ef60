//! Iterations, and the record of their energies.

use crate::error::Error;
use crate::session::state::{Session, Start, Trace, TraceEntry};
use std::rc::Rc;

/// The outcome of one iteration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step {
    /// Whether the total changed by no more than the tolerance, and the shape has not collapsed.
    pub converged: bool,
    /// Whether there is nothing to go on for: the total did not change, or the shape collapsed.
    pub ended: bool,
}

impl Session {
    /// One iteration.
    ///
    /// # Errors
    /// When a position leaves the finite numbers; the shape is then that before the step.
    pub fn step(&mut self) -> Result<Step, Error> {
        self.halfway = false;
        self.take_start();
        self.solver.step()?;
        self.run_state.iteration += 1;
        let entry = self.trace_entry();
        if let Some(trace) = &mut self.run_state.trace {
            trace.push(entry);
        }
        let collapsed = self.watch();
        let ended = self.solver.converged() || collapsed;
        if ended && !collapsed && self.tighten() {
            return Ok(Step { converged: false, ended: false });
        }
        Ok(Step { converged: self.converged(), ended })
    }

    /// Iterates until the tolerance or the limit of the scene is reached; with `trace` the energies of
    /// all iterations are recorded.
    ///
    /// # Errors
    /// As [`Session::step`].
    pub fn solve(&mut self, trace: bool) -> Result<(), Error> {
        if trace {
            self.run_state.trace = Some(Trace::whole(self.trace_entry()));
        }
        for _ in 0..self.document.solver.iterations {
            if self.step()?.ended {
                break;
            }
        }
        self.solver.settle();
        Ok(())
    }

    /// Records the energies of the iterations from here on, this one included. Of some thousands
    /// there are all; of more, as many at equal distances.
    pub fn start_trace(&mut self) {
        self.run_state.trace = Some(Trace::bounded(self.trace_entry()));
    }

    /// The recorded energies that led to the current shape, ascending; none where nothing is recorded.
    pub fn trace(&self) -> &[TraceEntry] {
        self.run_state.trace.as_ref().map_or(&[], Trace::entries)
    }

    fn trace_entry(&self) -> TraceEntry {
        TraceEntry::new(self.run_state.iteration, self.solver.energy())
    }

    /// Counts on from `iteration` after a jump to a state from before or after, to which iterations led
    /// from `start`.
    pub(in crate::session) fn arrive(&mut self, iteration: u32, start: Option<Rc<Start>>) {
        self.start_from(start);
        self.run_state.iteration = iteration;
        self.halfway = false;
        let entry = self.trace_entry();
        if let Some(trace) = &mut self.run_state.trace {
            trace.go_to(entry);
        }
    }

    /// Counts on from `iteration`, for a scene that is opened again where it stood.
    pub fn restore_iteration(&mut self, iteration: u32) {
        self.run_state.iteration = iteration;
        if self.run_state.trace.is_some() {
            self.start_trace();
        }
    }
}
