//! The guard against a collapse during iterations: see [`Collapse`]. A scene is solved as its
//! author intended, even if it collapses; an edit of the problem arms the guard.

use super::collapse::{Collapse, Start};
use crate::scene::Scene;
use crate::session::state::{RestMesh, SolvedScene, same_problem};
use std::rc::Rc;

/// Number of iterations between two checks.
const EVERY: u32 = 8;

/// The guard of a session.
#[derive(Default)]
pub(crate) struct CollapseGuard {
    /// The document as it was opened, without handles and positions.
    opened: Rc<Scene>,
    /// Whether the document poses another problem than the opened one.
    armed: bool,
    /// Whether the run continues after a collapse.
    ignores_collapse: bool,
    /// The shape where iterating began; none before the first iteration.
    start: Option<Rc<Start>>,
    collapse: Option<Collapse>,
    /// Iterations since the last check.
    unseen: u32,
}

impl CollapseGuard {
    /// Creates the guard of a session on the document `opened`.
    pub(crate) fn new(opened: Rc<Scene>) -> CollapseGuard {
        CollapseGuard { opened, ..CollapseGuard::default() }
    }

    /// How the shape has collapsed since iterating began, if it has.
    pub(crate) fn collapse(&self) -> Option<Collapse> {
        self.collapse
    }

    /// Whether the run continues if the shape collapses.
    pub(crate) fn ignores_collapse(&self) -> bool {
        self.ignores_collapse
    }

    pub(crate) fn start(&self) -> Option<Rc<Start>> {
        self.start.clone()
    }

    /// Watches the shape from here on, as after an edit.
    pub(crate) fn arm(&mut self) {
        self.armed = true;
    }

    /// Sets whether the run continues if the shape collapses.
    pub(crate) fn set_ignore_collapse(&mut self, ignores_collapse: bool) {
        self.ignores_collapse = ignores_collapse;
    }

    /// Forgets a collapse, because the search for a shape goes on.
    pub(crate) fn clear_collapse(&mut self) {
        self.collapse = None;
    }

    /// Makes the next iteration the start, unless the shape has collapsed.
    pub(crate) fn forget_start(&mut self) {
        if self.collapse.is_none() {
            self.start = None;
        }
    }

    /// Replaces the document that edits are compared with; a different problem arms the guard.
    pub(crate) fn set_opened(&mut self, opened: Rc<Scene>) {
        self.opened = opened;
    }

    /// Records the start before an iteration outside a drag, after `iteration` iterations.
    pub(crate) fn take_start(&mut self, scene: &SolvedScene, rest: &RestMesh, iteration: u32) {
        if self.start.is_some() || !self.armed {
            return;
        }
        let start = Start::new(scene.positions(), iteration, scene.handles(), rest.mesh());
        self.start = Some(Rc::new(start));
        self.unseen = 0;
    }

    /// Checks the shape after an iteration; returns whether it collapsed now and the run ends.
    pub(crate) fn watch(&mut self, scene: &SolvedScene, rest: &RestMesh, dragging: bool) -> bool {
        self.unseen += 1;
        if self.unseen < EVERY && !scene.solver().converged() {
            return false;
        }
        let before = self.collapse;
        self.look(scene, rest, dragging);
        before.is_none() && self.collapse.is_some() && !self.ignores_collapse
    }

    /// Compares the shape with the start; during a drag it does not count as collapsed.
    pub(crate) fn look(&mut self, scene: &SolvedScene, rest: &RestMesh, dragging: bool) {
        let start = self.start.as_ref().filter(|_| !dragging);
        self.collapse = start.and_then(|start| start.collapse(scene.positions(), rest.mesh()));
        self.unseen = 0;
    }

    /// Resets the guard for another document or shape, whose iterations began at `start`.
    pub(crate) fn start_from(
        &mut self,
        start: Option<Rc<Start>>,
        scene: &SolvedScene,
        rest: &RestMesh,
        dragging: bool,
    ) {
        self.armed = !same_problem(scene.document(), &self.opened);
        self.start = start;
        self.look(scene, rest, dragging);
    }
}
