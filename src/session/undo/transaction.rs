//! A drag or a run that is under way: many changes that are one step of undo together.

use super::change::Change;
use crate::mesh::counted;
use crate::session::state::SceneChange;
use crate::solve::Handle;

/// A drag or a run that has begun and is not yet a step of undo.
pub(crate) struct Transaction {
    kind: Kind,
    /// The way back to where it began.
    back: Change,
    /// It belongs to the step of undo that was made last, and becomes none of its own.
    joins_last: bool,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Drag,
    Run,
    Variation,
}

impl Transaction {
    /// A drag from where `back` leads.
    pub(crate) fn drag(back: Change) -> Transaction {
        Transaction { kind: Kind::Drag, back, joins_last: false }
    }

    /// A run from where `back` leads.
    pub(crate) fn run(back: Change) -> Transaction {
        Transaction { kind: Kind::Run, back, joins_last: false }
    }

    /// A shape that is shown and not kept, instead of the one that `back` leads to.
    pub(crate) fn variation(back: Change) -> Transaction {
        Transaction { kind: Kind::Variation, back, joins_last: false }
    }

    pub(crate) fn is_variation(&self) -> bool {
        self.kind == Kind::Variation
    }

    pub(crate) fn is_drag(&self) -> bool {
        self.kind == Kind::Drag
    }

    pub(crate) fn is_run(&self) -> bool {
        self.kind == Kind::Run
    }

    /// The way back to where it began.
    pub(crate) fn back(&self) -> &Change {
        &self.back
    }

    pub(crate) fn into_back(self) -> Change {
        self.back
    }

    /// Whether it belongs to the step of undo that was made last.
    pub(crate) fn joins_last(&self) -> bool {
        self.joins_last
    }

    /// Makes it a part of the step that was made last.
    pub(crate) fn join_last(&mut self) {
        self.joins_last = true;
    }

    /// The document was changed too while it went on; `back` takes that back.
    pub(crate) fn include(&mut self, back: SceneChange) {
        self.back.scene.parts.extend(back.parts);
    }

    /// The name of the step that a drag becomes, whose handles are `now`; none where no handle has moved.
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

    /// The name of the step that a run becomes, up to `iteration`; none where it has not iterated.
    pub(crate) fn name_of_run(&self, iteration: u32) -> Option<String> {
        let iterations = iteration - self.back.iteration;
        let words = counted(iterations as usize, "iteration", "iterations");
        (iterations > 0).then(|| format!("Run, {words}"))
    }
}
