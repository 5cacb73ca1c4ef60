//! A drag or run under way: many changes that become one step of undo.

use super::history::Change;
use crate::mesh::Point;
use crate::session::run::{ExactReport, Met};
use crate::session::state::{SceneChange, SolvedScene, same_positions};
use crate::solve::Handle;
use crate::words;
use std::rc::Rc;

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

    /// The name of the step that it would be if it ended now, after this number of iterations; none if it
    /// would be none of its own.
    pub(crate) fn name_of_step(&self, now: &SolvedScene, iteration: u32) -> Option<String> {
        match self.kind {
            TransactionKind::Variation(_) => Some(Transaction::VARIATION.to_owned()),
            _ if self.joins_last => None,
            TransactionKind::Drag => self.name_of_drag(now.handles()),
            TransactionKind::Run => self.name_of_run(now.positions(), iteration),
        }
    }

    /// The name of the step of a drag, with the handles `now`; none if no handle has moved.
    pub(crate) fn name_of_drag(&self, now: &[Handle]) -> Option<String> {
        let SceneChange { handles: before, positions, .. } = &self.back.scene;
        if before.len() != now.len() {
            // Handles are made where their vertices are, which may be all of the drag.
            let mut new = now.iter().skip(before.len());
            let stays = new.all(|handle| handle.target == positions[handle.vertex as usize]);
            return Some(if stays { "Make handle" } else { "Make and move handle" }.to_owned());
        }
        match before.iter().zip(now).filter(|(before, now)| before != now).count() {
            0 => None,
            1 => Some("Move handle".to_owned()),
            moved => Some(format!("Move {moved} handles")),
        }
    }

    /// Returns the name of the step of a run that ends with the shape `now` (`#V by 3`) at `iteration`;
    /// none if it has changed nothing. Hard constraints may have been met without iterating.
    pub(crate) fn name_of_run(&self, now: &Rc<[Point]>, iteration: u32) -> Option<String> {
        let iterations = iteration.saturating_sub(self.back.iteration);
        if iterations > 0 {
            let iterations = words::count(iterations as usize, "iteration", "iterations");
            return Some(format!("Run, {iterations}"));
        }
        let SceneChange { parts, positions, .. } = &self.back.scene;
        (!parts.is_empty() || !same_positions(positions, now)).then(|| "Run".to_owned())
    }
}
