//! The steps of undo and redo, and the change that each of them is.

use crate::mesh::Point;
use crate::scene::Scene;
use crate::session::run::Start;
use crate::session::state::{RestMesh, SceneChange};
use std::mem::size_of_val;
use std::rc::Rc;

/// Memory limit in bytes; the steps that are farthest from now are dropped first.
const LIMIT_BYTES: usize = 64 << 20;

/// The difference from the current state to another one.
pub(crate) struct Change {
    pub(crate) scene: SceneChange,
    /// The other mesh and its whole document, if they differ; `scene` then has no parts.
    pub(crate) other: Option<Box<(RestMesh, Scene)>>,
    /// Iteration count of the other state.
    pub(crate) iteration: u32,
    /// The shape at which its iterations began, after the last edit.
    pub(crate) start: Option<Rc<Start>>,
}

impl Change {
    /// Memory in bytes, without data shared with `other`.
    pub(crate) fn bytes_beside(&self, other: Option<&Change>) -> usize {
        let known = other.and_then(|other| other.start.as_ref());
        let start =
            self.start.as_ref().filter(|start| !known.is_some_and(|s| Rc::ptr_eq(s, start)));
        let scene = self.scene.bytes_beside(other.map(|other| &other.scene));
        // Its shapes are not those of the document: each was carried over to the mesh. The target of the
        // closeness is shared by all steps.
        let other = self.other.as_ref().map_or(0, |other| {
            let (rest, document) = &**other;
            let kept = document.variants.kept.iter().map(|it| size_of_val(&*it.positions));
            rest.bytes() + kept.sum::<usize>() + document.pose_positions().map_or(0, size_of_val)
        });
        scene + other + start.map_or(0, |start| start.bytes())
    }
}

/// A step with its name and its change: backwards for a step of undo, forwards for one of redo.
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

    /// The steps of undo, and those of redo.
    pub(crate) fn steps(&self) -> [&[NamedStep]; 2] {
        [&self.undo, &self.redo]
    }

    /// Adds a step with its inverse change; undone steps can no longer be redone.
    pub(crate) fn push(&mut self, name: String, back: Change) {
        self.redo.clear();
        self.push_undo((name, back));
    }

    /// Makes the changes after the last step a part of it; `back` leads to the end of that step. What was
    /// undone can no longer be redone.
    pub(crate) fn join(&mut self, back: Change) {
        self.redo.clear();
        // A step to another mesh already restores the whole document.
        if let Some((_, step)) = self.undo.last_mut().filter(|(_, step)| step.other.is_none()) {
            step.scene.parts.extend(back.scene.parts);
        }
    }

    /// Whether the last step led to the current positions from others.
    pub(crate) fn last_moved(&self, now: &Rc<[Point]>) -> bool {
        self.undo.last().is_some_and(|(_, step)| {
            step.other.is_some() || !Rc::ptr_eq(&step.scene.positions, now)
        })
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

    pub(crate) fn pop_undo(&mut self) -> Option<NamedStep> {
        self.undo.pop()
    }

    pub(crate) fn pop_redo(&mut self) -> Option<NamedStep> {
        self.redo.pop()
    }

    /// The names of the steps that undo and redo would apply.
    pub(crate) fn names(&self) -> [Option<&str>; 2] {
        [&self.undo, &self.redo].map(|steps| steps.last().map(|(name, _)| name.as_str()))
    }

    /// Drops steps beyond the memory limit; the nearest one of each list stays.
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

/// Bytes of one step of a list. Data shared by consecutive steps counts for the later one.
fn bytes_of(steps: &[NamedStep], place: usize) -> usize {
    let (name, change) = &steps[place];
    let next = steps.get(place + 1).map(|(_, change)| change);
    name.len() + change.bytes_beside(next)
}
