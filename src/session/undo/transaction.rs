//! A drag or run under way: many changes that become one step of undo.

use super::history::Change;
use crate::session::run::{ExactReport, Met};
use crate::session::state::SceneChange;
use crate::solve::Handle;
use crate::words;

/// A drag, run or variation that has begun and is not yet a step of undo.
pub(crate) struct Transaction {
    kind: TransactionKind,
    /// The change back to the state at which it began.
    back: Change,
    /// Whether it joins the last step of undo instead of becoming one.
    joins_last: bool,
}

/// What a transaction is.
pub(crate) enum TransactionKind {
    Drag,
    Run,
    Variation(Box<ShownVariation>),
}

/// A variation of a shape that is shown and not kept.
pub(crate) struct ShownVariation {
    /// The generation of the shape that is varied.
    pub(crate) of: u32,
    /// How well the shape meets the hard constraints, if it was brought back onto them.
    pub(crate) report: Option<ExactReport>,
    /// How the shape that is varied meets them.
    pub(crate) met_before: Option<Met>,
}

impl Transaction {
    /// The name of a variation that is shown.
    pub(crate) const VARIATION: &str = "Variation";

    /// Begins one; `back` leads to the state before it.
    pub(crate) fn new(kind: TransactionKind, back: Change) -> Transaction {
        Transaction { kind, back, joins_last: false }
    }

    /// The variation that is shown, if it is one.
    pub(crate) fn variation_shown(&mut self) -> Option<&mut ShownVariation> {
        match &mut self.kind {
            TransactionKind::Variation(shown) => Some(shown),
            TransactionKind::Drag | TransactionKind::Run => None,
        }
    }

    pub(crate) fn is_variation(&self) -> bool {
        matches!(self.kind, TransactionKind::Variation(_))
    }

    pub(crate) fn is_drag(&self) -> bool {
        matches!(self.kind, TransactionKind::Drag)
    }

    pub(crate) fn is_run(&self) -> bool {
        matches!(self.kind, TransactionKind::Run)
    }

    pub(crate) fn back(&self) -> &Change {
        &self.back
    }

    pub(crate) fn into_back(self) -> Change {
        self.back
    }

    pub(crate) fn joins_last(&self) -> bool {
        self.joins_last
    }

    /// Joins it to the last step of undo.
    pub(crate) fn join_last(&mut self) {
        self.joins_last = true;
    }

    /// Includes a change of the document during the transaction; `back` is its inverse.
    pub(crate) fn include(&mut self, back: SceneChange) {
        self.back.scene.parts.extend(back.parts);
    }

    /// The name of the step that it would be if it ended in the state with these handles, after this
    /// number of iterations; none if it would be none of its own.
    pub(crate) fn name_of_step(&self, now: &[Handle], iteration: u32) -> Option<String> {
        match self.kind {
            TransactionKind::Variation(_) => Some(Transaction::VARIATION.to_owned()),
            _ if self.joins_last => None,
            TransactionKind::Drag => self.name_of_drag(now),
            TransactionKind::Run => self.name_of_run(iteration),
        }
    }

    /// The name of the step of a drag, with the handles `now`; none if no handle has moved.
    pub(crate) fn name_of_drag(&self, now: &[Handle]) -> Option<String> {
        let before = &self.back.scene.handles;
        if before.len() != now.len() {
            return Some("Make and move handle".to_owned());
        }
        match before.iter().zip(now).filter(|(before, now)| before != now).count() {
            0 => None,
            1 => Some("Move handle".to_owned()),
            moved => Some(format!("Move {moved} handles")),
        }
    }

    /// Returns the name of the step of a run that ends at `iteration`; none without iterations.
    pub(crate) fn name_of_run(&self, iteration: u32) -> Option<String> {
        let iterations = iteration.saturating_sub(self.back.iteration);
        let words = words::count(iterations as usize, "iteration", "iterations");
        (iterations > 0).then(|| format!("Run, {words}"))
    }
}
