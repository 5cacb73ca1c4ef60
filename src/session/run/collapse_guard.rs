//! The guard against collapse, while iterations go on: see [`Collapse`].

use crate::math::Vec3;
use crate::session::state::{Collapse, Session, Start, areas, diagonal, same_problem};
use std::rc::Rc;

/// How many iterations go by between two looks.
const EVERY: u32 = 8;

impl Session {
    /// How the shape has collapsed since iterating began, if it has.
    pub fn collapse(&self) -> Option<Collapse> {
        self.run_state.guard.collapse
    }

    /// Whether the last iteration changed the total by no more than the tolerance; never of a shape
    /// that has collapsed.
    pub fn converged(&self) -> bool {
        self.solver.converged() && self.collapse().is_none()
    }

    /// Watches over the shape from here on, as after an edit.
    pub fn arm_guard(&mut self) {
        self.run_state.guard.armed = true;
    }

    /// Before an iteration.
    pub(crate) fn take_start(&mut self) {
        let guard = &self.run_state.guard;
        if guard.start.is_some() || !guard.armed || self.is_dragging() {
            return;
        }
        let positions = self.positions();
        let handles = self.solver.handles().iter();
        let ways = handles.map(|handle| {
            Vec3::from(positions[handle.vertex as usize]) - Vec3::from(handle.target)
        });
        let pull = ways.map(|way| way.length_squared()).fold(0.0, f64::max).sqrt();
        let extent = diagonal(&positions, &self.mesh.faces);
        let start = Start {
            diagonal: extent,
            size: extent.max(diagonal(&self.mesh.positions, &self.mesh.faces)),
            areas: areas(&positions, &self.mesh.faces),
            pull,
            iteration: self.run_state.iteration,
            positions,
        };
        let guard = &mut self.run_state.guard;
        guard.start = Some(Rc::new(start));
        guard.unseen = 0;
    }

    /// After an iteration: whether it has collapsed now and the run shall end.
    pub(crate) fn watch(&mut self) -> bool {
        let guard = &mut self.run_state.guard;
        guard.unseen += 1;
        if guard.unseen < EVERY && !self.solver.converged() {
            return false;
        }
        let before = guard.collapse;
        self.look();
        let guard = &self.run_state.guard;
        before.is_none() && guard.collapse.is_some() && !guard.goes_on
    }

    /// Compares the shape with that at the start.
    pub(crate) fn look(&mut self) {
        let start = self.run_state.guard.start.clone().filter(|_| !self.is_dragging());
        let collapse = start.and_then(|start| start.collapse(&self.positions(), &self.mesh));
        self.run_state.guard.collapse = collapse;
        self.run_state.guard.unseen = 0;
    }

    /// After the document or the shape was replaced: iterations started from `start`.
    pub(crate) fn start_from(&mut self, start: Option<Rc<Start>>) {
        self.run_state.guard.armed = !same_problem(&self.document, &self.run_state.guard.opened);
        self.run_state.guard.start = start;
        self.look();
    }
}
