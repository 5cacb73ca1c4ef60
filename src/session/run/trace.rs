//! The energies of the iterations that led to the current shape.

use crate::solve::Energy;
use serde::Serialize;

/// Maximum number of entries of a bounded trace: more than a plot has pixels.
const MOST: usize = 8192;

/// One entry per iteration, ascending, without iterations that were undone, and another with the
/// same number for a shape that was met without iterating. Of a repeated run, only the last one is
/// included.
///
/// A host may iterate for hours. When a bounded trace is full, it keeps every second of its
/// iterations, then every fourth, and so on, evenly spaced; the first and the newest are always
/// kept.
#[derive(Clone)]
pub(crate) struct Trace {
    entries: Vec<TraceEntry>,
    /// Of the iterations between the first and the newest, those divisible by the stride are kept.
    stride: u32,
    most: usize,
}

impl Trace {
    /// Begins with the initial state, and keeps all iterations.
    pub(crate) fn whole(start: TraceEntry) -> Trace {
        Trace { entries: vec![start], stride: 1, most: usize::MAX }
    }

    /// Begins with the initial state, and keeps as many iterations as a plot can show.
    pub(crate) fn bounded(start: TraceEntry) -> Trace {
        Trace { most: MOST, ..Trace::whole(start) }
    }

    pub(crate) fn push(&mut self, entry: TraceEntry) {
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
    pub(crate) fn go_to(&mut self, state: TraceEntry) {
        let kept = self.entries.partition_point(|entry| entry.iteration < state.iteration);
        self.entries.truncate(kept);
        self.entries.push(state);
        if self.entries.len() == 1 {
            self.stride = 1;
        }
    }

    /// Appends the state that a run ends with after its last iteration, which stays.
    pub(crate) fn end_with(&mut self, state: TraceEntry) {
        if self.entries.last() != Some(&state) {
            self.entries.push(state);
        }
    }

    pub(crate) fn entries(&self) -> &[TraceEntry] {
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

impl TraceEntry {
    /// Creates the entry of an iteration.
    pub fn new(iteration: u32, energy: Energy) -> Self {
        TraceEntry { iteration, energy }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(iteration: u32) -> TraceEntry {
        TraceEntry::new(iteration, Energy { total: f64::from(iteration), ..Energy::default() })
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
        let met = TraceEntry::new(0, Energy { total: 7.0, ..Energy::default() });
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
