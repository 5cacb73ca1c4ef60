//! A drag or run under way: many changes that become one step of undo.

use super::history::SessionState;
use crate::session::run::Met;
use crate::session::state::{same_document, same_positions};
use crate::solve::Handle;
use crate::words;

/// A drag, run or variation that has begun and is not yet a step of undo.
pub(crate) struct Transaction {
    kind: TransactionKind,
    /// The state at which it began.
    before: SessionState,
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
    /// How the shape that is varied meets them.
    pub(crate) met_before: Option<Met>,
}

impl Transaction {
    /// The name of a variation that is shown.
    pub(crate) const VARIATION: &str = "Variation";

    /// Begins one in the state `before`.
    pub(crate) fn new(kind: TransactionKind, before: SessionState) -> Transaction {
        Transaction { kind, before, joins_last: false }
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

    /// The state at which it began.
    pub(crate) fn before(&self) -> &SessionState {
        &self.before
    }

    pub(crate) fn into_before(self) -> SessionState {
        self.before
    }

    /// See [`SessionState::replace_tolerance`].
    pub(crate) fn replace_tolerance(&mut self, before: Option<f64>, now: Option<f64>) -> bool {
        self.before.replace_tolerance(before, now)
    }

    pub(crate) fn joins_last(&self) -> bool {
        self.joins_last
    }

    /// Joins it to the last step of undo.
    pub(crate) fn join_last(&mut self) {
        self.joins_last = true;
    }

    /// The name of the step that it would be if it ended in the state `now`; none if it would be none of
    /// its own.
    pub(crate) fn name_of_step(&self, now: &SessionState) -> Option<String> {
        match self.kind {
            TransactionKind::Variation(_) => Some(Transaction::VARIATION.to_owned()),
            _ if self.joins_last => None,
            TransactionKind::Drag => self.name_of_drag(now),
            TransactionKind::Run => self.name_of_run(now),
        }
    }

    /// The name of the step of a drag that ends in the state `now`; none if no handle has moved.
    pub(crate) fn name_of_drag(&self, now: &SessionState) -> Option<String> {
        let positions = &self.before.scene.positions;
        let [before, now] = [&self.before, now].map(|state| &state.scene.handles);
        if before.len() != now.len() {
            // Handles are made where their vertices are, which may be all of the drag.
            let new = now.get(before.len()..).unwrap_or_default();
            let stays = |handle: &Handle| handle.target == positions[handle.vertex as usize];
            let verb = if new.iter().all(stays) { "Make" } else { "Make and move" };
            return Some(format!("{verb} {}", named(new.len())));
        }
        match before.iter().zip(&**now).filter(|(before, now)| before != now).count() {
            0 => None,
            moved => Some(format!("Move {}", named(moved))),
        }
    }

    /// Returns the name of the step of a run that ends in the state `now`; none if it has changed nothing.
    /// Hard constraints may have been met without iterating.
    pub(crate) fn name_of_run(&self, now: &SessionState) -> Option<String> {
        let iterations = now.iteration.saturating_sub(self.before.iteration);
        if iterations > 0 {
            let iterations = words::count(iterations as usize, "iteration", "iterations");
            return Some(format!("Run, {iterations}"));
        }
        let [before, now] = [&self.before, now].map(|state| &state.scene);
        let is_same = same_document(&before.document, &now.document)
            && same_positions(&before.positions, &now.positions);
        (!is_same).then(|| "Run".to_owned())
    }
}

/// The object of an edit of this many handles.
fn named(count: usize) -> String {
    if count == 1 { "handle".to_owned() } else { words::count(count, "handle", "handles") }
}
