//! The guard against collapse while iterations go on: see [`Collapse`]. A scene is solved as its author
//! meant it, whatever becomes of it, until somebody edits what is asked of it.

use super::collapse::{Collapse, Start};
use crate::scene::Scene;
use crate::session::state::{RestMesh, SolvedScene, same_problem};
use std::rc::Rc;

/// How many iterations go by between two looks.
const EVERY: u32 = 8;

/// The guard of a session.
pub(crate) struct CollapseGuard {
    /// The document as it was opened, without handles and positions.
    opened: Scene,
    /// The document asks for something else than the one that was opened.
    armed: bool,
    /// The run goes on whatever happens.
    goes_on: bool,
    /// Where iterating began; none before the first iteration.
    start: Option<Rc<Start>>,
    collapse: Option<Collapse>,
    /// Iterations since the last look.
    unseen: u32,
}

impl CollapseGuard {
    /// That of a session on the document `opened`.
    pub(crate) fn new(opened: Scene) -> CollapseGuard {
        let (armed, goes_on, start, collapse, unseen) = (false, false, None, None, 0);
        CollapseGuard { opened, armed, goes_on, start, collapse, unseen }
    }

    /// How the shape has collapsed since iterating began, if it has.
    pub(crate) fn collapse(&self) -> Option<Collapse> {
        self.collapse
    }

    /// Where iterating began; none before the first iteration.
    pub(crate) fn start(&self) -> Option<Rc<Start>> {
        self.start.clone()
    }

    /// Watches over the shape from here on, as after an edit.
    pub(crate) fn arm(&mut self) {
        self.armed = true;
    }

    /// Lets the run go on when the shape collapses, or no longer.
    pub(crate) fn let_go_on(&mut self, goes_on: bool) {
        self.goes_on = goes_on;
    }

    /// The next iteration is where iterating begins, unless the shape has collapsed.
    pub(crate) fn forget_start(&mut self) {
        if self.collapse.is_none() {
            self.start = None;
        }
    }

    /// Replaces the document that edits are compared with: another problem than its own arms the guard.
    pub(crate) fn set_opened(&mut self, opened: Scene) {
        self.opened = opened;
    }

    /// Before an iteration that nobody drags in, after `iteration` of them.
    pub(crate) fn take_start(&mut self, scene: &SolvedScene, rest: &RestMesh, iteration: u32) {
        if self.start.is_some() || !self.armed {
            return;
        }
        let start = Start::new(scene.positions(), iteration, scene.handles(), rest.mesh());
        self.start = Some(Rc::new(start));
        self.unseen = 0;
    }

    /// After an iteration: whether the shape has collapsed now and the run shall end.
    pub(crate) fn watch(&mut self, scene: &SolvedScene, rest: &RestMesh, dragging: bool) -> bool {
        self.unseen += 1;
        if self.unseen < EVERY && !scene.solver().converged() {
            return false;
        }
        let before = self.collapse;
        self.look(scene, rest, dragging);
        before.is_none() && self.collapse.is_some() && !self.goes_on
    }

    /// Compares the shape with that at the start; while somebody drags it has not collapsed.
    pub(crate) fn look(&mut self, scene: &SolvedScene, rest: &RestMesh, dragging: bool) {
        let start = self.start.as_ref().filter(|_| !dragging);
        self.collapse = start.and_then(|start| start.collapse(scene.positions(), rest.mesh()));
        self.unseen = 0;
    }

    /// After the document or the shape was replaced: iterations started from `start`.
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
