//! The energies of the iterations that led to the current shape.

use super::TraceEntry;

/// One entry per iteration, ascending. Iterations that were undone are not in it; of a run that was
/// done again there is its last one.
#[derive(Clone, Default)]
pub(super) struct Trace {
    entries: Vec<TraceEntry>,
    /// How many of them the host has heard of.
    told: usize,
}

impl Trace {
    /// Begins with the state that iterations start from.
    pub(super) fn from(start: TraceEntry) -> Trace {
        Trace { entries: vec![start], told: 0 }
    }

    /// Adds an iteration.
    pub(super) fn push(&mut self, entry: TraceEntry) {
        self.entries.push(entry);
    }

    /// Goes to a state from before or after, or from where an edit has changed the energies: forgets
    /// what came later, and has an entry for the state as it is now.
    pub(super) fn go_to(&mut self, state: TraceEntry) {
        let kept = self.entries.partition_point(|entry| entry.iteration <= state.iteration);
        self.entries.truncate(kept);
        self.told = self.told.min(kept);
        match self.entries.last_mut() {
            Some(last) if last.iteration == state.iteration => *last = state,
            _ => self.entries.push(state),
        }
    }

    /// All of it.
    pub(super) fn entries(&self) -> &[TraceEntry] {
        &self.entries
    }

    /// What was added since the last call.
    pub(super) fn news(&mut self) -> Vec<TraceEntry> {
        let news = self.entries[self.told..].to_vec();
        self.told = self.entries.len();
        news
    }
}
