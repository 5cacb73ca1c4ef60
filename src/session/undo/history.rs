//! The steps of undo and redo.

use super::change::Change;

/// More bytes than this are not kept: the steps that are farthest from now go first.
const LIMIT_BYTES: usize = 64 << 20;

/// A step with its name and its way: back for a step of undo, forward for one of redo.
pub(crate) type NamedStep = (String, Change);

/// Steps of undo and redo, each list in the order in which its steps were made or undone.
#[derive(Default)]
pub(crate) struct History {
    undo: Vec<NamedStep>,
    redo: Vec<NamedStep>,
}

impl History {
    pub(crate) fn of([undo, redo]: [Vec<NamedStep>; 2]) -> History {
        let mut history = History { undo, redo };
        history.trim();
        history
    }

    /// The steps of undo and those of redo.
    pub(crate) fn steps(&self) -> [&[NamedStep]; 2] {
        [&self.undo, &self.redo]
    }

    /// Adds a step with its way back; what was undone can no longer be redone.
    pub(crate) fn push(&mut self, name: String, back: Change) {
        self.redo.clear();
        self.push_undo((name, back));
    }

    /// Makes what happened after the last step a part of it; `back` leads to where that ended.
    pub(crate) fn join(&mut self, back: Change) {
        // A step to another mesh takes all of the document back already.
        if let Some((_, step)) = self.undo.last_mut().filter(|(_, step)| step.other.is_none()) {
            step.scene.parts.extend(back.scene.parts);
        }
    }

    /// Adds a step that was made or redone.
    pub(crate) fn push_undo(&mut self, step: NamedStep) {
        self.undo.push(step);
        self.trim();
    }

    /// Adds a step that was undone.
    pub(crate) fn push_redo(&mut self, step: NamedStep) {
        self.redo.push(step);
        self.trim();
    }

    /// Takes the last step out, to be undone.
    pub(crate) fn pop_undo(&mut self) -> Option<NamedStep> {
        self.undo.pop()
    }

    /// Takes the step out that was last undone.
    pub(crate) fn pop_redo(&mut self) -> Option<NamedStep> {
        self.redo.pop()
    }

    /// The names of the steps that undo and redo would take.
    pub(crate) fn names(&self) -> [Option<&str>; 2] {
        [&self.undo, &self.redo].map(|steps| steps.last().map(|(name, _)| name.as_str()))
    }

    /// Forgets steps beyond the limit; the nearest one of each list stays.
    fn trim(&mut self) {
        let mut bytes = bytes(&self.undo) + bytes(&self.redo);
        for steps in [&mut self.undo, &mut self.redo] {
            let mut forgotten = 0;
            while bytes > LIMIT_BYTES && forgotten + 1 < steps.len() {
                bytes -= bytes_of(steps, forgotten);
                forgotten += 1;
            }
            steps.drain(..forgotten);
        }
    }
}

fn bytes(steps: &[NamedStep]) -> usize {
    (0..steps.len()).map(|place| bytes_of(steps, place)).sum()
}

/// The bytes of one step of a list. Data that consecutive steps share counts for the later one.
fn bytes_of(steps: &[NamedStep], place: usize) -> usize {
    let (name, change) = &steps[place];
    let next = steps.get(place + 1).map(|(_, change)| change);
    name.len() + change.bytes_beside(next)
}
