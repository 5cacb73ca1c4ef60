//! The iteration count of a session, and the energies of the iterations.

use crate::solve::Energy;
use serde::Serialize;

/// Maximum number of entries of a bounded trace: more than a plot has pixels.
const MOST: usize = 8192;

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
            trace.push(TraceEntry { iteration: self.iteration, energy });
        }
    }

    /// Records the energies of the shape that a run ends with after its last iteration.
    pub(crate) fn end_with(&mut self, energy: Energy) {
        self.halfway = false;
        if let Some(trace) = &mut self.trace {
            trace.end_with(TraceEntry { iteration: self.iteration, energy });
        }
    }

    /// Sets the iteration count and the energies after a jump to another state.
    pub(crate) fn go_to(&mut self, iteration: u32, energy: Energy) {
        self.halfway = false;
        self.iteration = iteration;
        if let Some(trace) = &mut self.trace {
            trace.go_to(TraceEntry { iteration, energy });
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
        self.trace = Some(Trace::bounded(TraceEntry { iteration: self.iteration, energy }));
    }

    /// Starts recording the energies of all iterations.
    pub(crate) fn record_all(&mut self, energy: Energy) {
        self.trace = Some(Trace::whole(TraceEntry { iteration: self.iteration, energy }));
    }

    /// The recorded energies; none if nothing is recorded.
    pub(crate) fn trace(&self) -> Option<&[TraceEntry]> {
        self.trace.as_ref().map(Trace::entries)
    }
}

/// One entry per iteration, ascending, without iterations that were undone, and another with the
/// same number for a shape that was met without iterating. Of a repeated run, only the last one is
/// included.
///
/// A host may iterate for hours. When a bounded trace is full, it keeps every second of its
/// iterations, then every fourth, and so on, evenly spaced; the first and the newest are always
/// kept.
#[derive(Clone)]
struct Trace {
    entries: Vec<TraceEntry>,
    /// Of the iterations between the first and the newest, those divisible by the stride are kept.
    stride: u32,
    most: usize,
}

impl Trace {
    /// Begins with the initial state, and keeps all iterations.
    fn whole(start: TraceEntry) -> Trace {
        Trace { entries: vec![start], stride: 1, most: usize::MAX }
    }

    /// Begins with the initial state, and keeps as many iterations as a plot can show.
    fn bounded(start: TraceEntry) -> Trace {
        Trace { most: MOST, ..Trace::whole(start) }
    }

    fn push(&mut self, entry: TraceEntry) {
        if self.entries.len() > 1 {
            self.entries.pop_if(|newest| newest.iteration % self.stride != 0);
        }
        self.entries.push(entry);
        if self.entries.len() > self.most {
            self.stride *= 2;
            let (stride, newest) = (self.stride, self.entries.len() - 1);
            let mut places = 0..;
            self.entries.retain(|entry| {
                let place = places.next();
                place == Some(0) || place == Some(newest) || entry.iteration % stride == 0
            });
        }
    }

    /// Goes to an earlier or later state, or to one whose energies an edit has changed. Removes all
    /// later entries, and sets the entry of the state.
    fn go_to(&mut self, state: TraceEntry) {
        let kept = self.entries.partition_point(|entry| entry.iteration < state.iteration);
        self.entries.truncate(kept);
        self.entries.push(state);
        if self.entries.len() == 1 {
            self.stride = 1;
        }
    }

    /// Appends the state that a run ends with after its last iteration, which stays.
    fn end_with(&mut self, state: TraceEntry) {
        if self.entries.last() != Some(&state) {
            self.entries.push(state);
        }
    }

    fn entries(&self) -> &[TraceEntry] {
        &self.entries
    }
}

/// The energies after an iteration; iteration 0 is the input.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct TraceEntry {
    /// The iteration.
    pub iteration: u32,
    /// Its energies.
    #[serde(flatten)]
    pub energy: Energy,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(iteration: u32) -> TraceEntry {
        TraceEntry {
            iteration,
            energy: Energy { total: f64::from(iteration), ..Energy::default() },
        }
    }

    fn iterations(trace: &Trace) -> Vec<u32> {
        trace.entries().iter().map(|entry| entry.iteration).collect()
    }

    #[test]
    fn a_long_run_is_kept_evenly_within_bounds() {
        let mut trace = Trace::bounded(at(0));
        for iteration in 1..=1_000_001 {
            trace.push(at(iteration));
            assert!(trace.entries().len() <= MOST, "{}", trace.entries().len());
        }
        let kept = iterations(&trace);
        assert!(kept.len() > MOST / 2, "{}", kept.len());
        assert_eq!((kept[0], kept.last()), (0, Some(&1_000_001)));
        let inside = &kept[..kept.len() - 1];
        assert!(inside.windows(2).all(|pair| pair[1] - pair[0] == kept[1]), "evenly spaced");
    }

    #[test]
    fn a_run_that_fits_is_kept_whole_and_so_is_any_run_that_was_asked_for() {
        let mut bounded = Trace::bounded(at(0));
        let mut whole = Trace::whole(at(0));
        (1..MOST as u32).for_each(|iteration| bounded.push(at(iteration)));
        (1..3 * MOST as u32).for_each(|iteration| whole.push(at(iteration)));
        assert_eq!(iterations(&bounded), (0..MOST as u32).collect::<Vec<_>>());
        assert_eq!(iterations(&whole), (0..3 * MOST as u32).collect::<Vec<_>>());
    }

    #[test]
    fn the_shape_at_the_end_of_a_run_does_not_replace_its_last_iteration() {
        let met = TraceEntry { iteration: 0, energy: Energy { total: 7.0, ..Energy::default() } };
        let mut trace = Trace::whole(at(0));
        trace.end_with(met);
        trace.end_with(met);
        assert_eq!(trace.entries(), [at(0), met]);
        trace.go_to(at(0));
        assert_eq!(trace.entries(), [at(0)]);
    }

    #[test]
    fn after_going_back_to_the_start_every_iteration_is_kept_again() {
        let mut trace = Trace::bounded(at(0));
        (1..=100_000).for_each(|iteration| trace.push(at(iteration)));
        trace.go_to(at(50_003));
        trace.push(at(50_004));
        assert_eq!(iterations(&trace).last(), Some(&50_004));
        trace.go_to(at(0));
        (1..=10).for_each(|iteration| trace.push(at(iteration)));
        assert_eq!(iterations(&trace), (0..=10).collect::<Vec<_>>());
    }
}
