//! Undo and redo of everything, one step per transaction.

use super::collapse::Start;
use crate::mesh::Point;
use crate::scene::Scene;
use crate::solve::Handle;
use std::rc::Rc;

/// Snapshots beyond this many bytes of positions are forgotten, oldest first.
const LIMIT_BYTES: usize = 64 << 20;

/// A state to go back to.
#[derive(Clone)]
pub(crate) struct Snapshot {
    /// The document without handles and positions.
    pub document: Scene,
    /// The handles.
    pub handles: Vec<Handle>,
    /// `#V by 3`.
    pub positions: Vec<Point>,
    /// Iterations up to it.
    pub iteration: u32,
    /// The shape from which iterations led to it, since somebody last changed something.
    pub start: Option<Rc<Start>>,
}

impl Snapshot {
    /// Whether going from one to the other would change nothing.
    pub(crate) fn is_same(&self, other: &Snapshot) -> bool {
        self.positions == other.positions
            && self.handles == other.handles
            && self.iteration == other.iteration
            && self.document == other.document
    }
}

/// Steps of undo and redo, each with its name and the state on its other side.
#[derive(Default)]
pub(crate) struct History {
    undo: Vec<(String, Snapshot)>,
    redo: Vec<(String, Snapshot)>,
}

impl History {
    /// The steps of undo and those of redo, each list in the order in which they were made or undone.
    pub(crate) fn of([undo, redo]: [Vec<(String, Snapshot)>; 2]) -> History {
        History { undo, redo }
    }

    /// See [`History::of`].
    pub(crate) fn steps(&self) -> [&[(String, Snapshot)]; 2] {
        [&self.undo, &self.redo]
    }

    /// Adds a step that started at `before`; what was undone can no longer be redone.
    pub(crate) fn push(&mut self, name: String, before: Snapshot) {
        self.redo.clear();
        self.undo.push((name, before));
        let bytes = |(_, snapshot): &(String, Snapshot)| size_of_val(&*snapshot.positions);
        while self.undo.len() > 1 && self.undo.iter().map(bytes).sum::<usize>() > LIMIT_BYTES {
            self.undo.remove(0);
        }
    }

    /// The name of the last step.
    pub(crate) fn undo_name(&self) -> Option<&str> {
        self.undo.last().map(|(name, _)| name.as_str())
    }

    /// The name of the step that was last undone.
    pub(crate) fn redo_name(&self) -> Option<&str> {
        self.redo.last().map(|(name, _)| name.as_str())
    }

    /// Takes back a step from the state `now`: its name and the state to go to.
    pub(crate) fn undo(&mut self, now: Snapshot) -> Option<(String, Snapshot)> {
        let (name, before) = self.undo.pop()?;
        self.redo.push((name.clone(), now));
        Some((name, before))
    }

    /// Repeats a step from the state `now`: its name and the state to go to.
    pub(crate) fn redo(&mut self, now: Snapshot) -> Option<(String, Snapshot)> {
        let (name, after) = self.redo.pop()?;
        self.undo.push((name.clone(), now));
        Some((name, after))
    }
}
