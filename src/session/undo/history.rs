//! The steps of undo and redo, and the state that each of them leads to.

use crate::session::run::LastRun;
use crate::session::state::{RestMesh, SceneState};
use std::rc::Rc;

/// Memory limit in bytes, as they are counted by [`SceneState::unshared_bytes`]. Beyond it steps of undo
/// are dropped before those of redo, in each list the one that is farthest from now first.
const LIMIT_BYTES: usize = 64 << 20;

/// A state of a session.
#[derive(Clone)]
pub(crate) struct SessionState {
    pub(crate) rest: Rc<RestMesh>,
    pub(crate) scene: SceneState,
    /// Number of iterations up to the state.
    pub(crate) iteration: u32,
    /// The run that ended with its shape, unless that came about otherwise.
    pub(crate) last_run: Option<Rc<LastRun>>,
}

impl SessionState {
    /// Memory in bytes of what is not shared with `other`: see [`SceneState::unshared_bytes`].
    fn unshared_bytes(&self, other: &SessionState) -> usize {
        let rest = if Rc::ptr_eq(&self.rest, &other.rest) { 0 } else { self.rest.bytes() };
        rest + self.scene.unshared_bytes(&other.scene)
    }

    /// Sets the tolerance, if it is `before`; returns whether it was.
    pub(crate) fn replace_tolerance(&mut self, before: Option<f64>, now: Option<f64>) -> bool {
        let has_it = self.scene.document.tolerance == before;
        if has_it {
            Rc::make_mut(&mut self.scene.document).tolerance = now;
        }
        has_it
    }
}

/// A step with its name and its state: that before a step of undo, that after one of redo.
pub(crate) type NamedStep = (String, SessionState);

/// Steps of undo and redo, each list in the order in which its steps were made or undone.
#[derive(Default)]
pub(crate) struct History {
    undo: Vec<NamedStep>,
    redo: Vec<NamedStep>,
}

impl History {
    /// The steps around the state `now`.
    pub(crate) fn of([undo, redo]: [Vec<NamedStep>; 2], now: &SessionState) -> History {
        let mut history = History { undo, redo };
        history.trim(now);
        history
    }

    /// The steps of undo, and those of redo.
    pub(crate) fn steps(&self) -> [&[NamedStep]; 2] {
        [&self.undo, &self.redo]
    }

    /// Adds a step that led from the state `before` to the state `now`; undone steps can no longer be
    /// redone.
    pub(crate) fn push(&mut self, name: String, before: SessionState, now: &SessionState) {
        self.redo.clear();
        self.push_undo((name, before), now);
    }

    /// Makes the changes after the last step a part of it, which leads back to the same state. What was
    /// undone can no longer be redone.
    pub(crate) fn join(&mut self) {
        self.redo.clear();
    }

    /// Whether the last step led to the current shape from another one.
    pub(crate) fn last_moved(&self, now: &SessionState) -> bool {
        self.undo.last().is_some_and(|(_, before)| {
            !Rc::ptr_eq(&before.rest, &now.rest)
                || !Rc::ptr_eq(&before.scene.positions, &now.scene.positions)
        })
    }

    /// Replaces the tolerance `before` of the states next to the current one, so that undo and redo keep
    /// the one `now` up to a step that has changed it.
    pub(crate) fn replace_tolerance(&mut self, before: Option<f64>, now: Option<f64>) {
        for steps in [&mut self.undo, &mut self.redo] {
            let mut nearest = steps.iter_mut().rev();
            while nearest.next().is_some_and(|(_, state)| state.replace_tolerance(before, now)) {}
        }
    }

    /// Adds a step that was made or redone, which led to the state `now`.
    pub(crate) fn push_undo(&mut self, step: NamedStep, now: &SessionState) {
        self.undo.push(step);
        self.trim(now);
    }

    /// Adds a step that was undone, which led back to the state `now`.
    pub(crate) fn push_redo(&mut self, step: NamedStep, now: &SessionState) {
        self.redo.push(step);
        self.trim(now);
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

    /// Drops steps beyond the memory limit; the nearest one of each list stays. What a step shares with
    /// the next one, or the last one with the state `now`, does not count for it.
    fn trim(&mut self, now: &SessionState) {
        let bytes_of = |steps: &[NamedStep], place: usize| {
            let next = steps.get(place + 1).map_or(now, |(_, state)| state);
            steps[place].1.unshared_bytes(next)
        };
        let all = |steps: &[NamedStep]| -> usize {
            (0..steps.len()).map(|place| bytes_of(steps, place)).sum()
        };
        let mut bytes = all(&self.undo) + all(&self.redo);
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
