//! From one state of the document to another: edits, undo and redo, at the least cost.

use crate::error::Error;
use crate::scene::Scene;
use crate::session::edit::Edit;
use crate::session::state::{Session, Snapshot, resolve_rows, same_problem, solver};

impl Session {
    /// Makes an edit, and returns whether it is a step of undo: one that changes nothing is none.
    ///
    /// # Errors
    /// When it names a row or vertex that is not there, leaves a row without constraints or a goal without
    /// the row that it is on, or makes the system singular; nothing has changed then.
    pub fn edit(&mut self, edit: Edit) -> Result<bool, Error> {
        self.end_run();
        self.end_drag(true);
        let before = self.snapshot();
        let mut after = before.clone();
        if self.collapse().is_none() {
            after.start = None;
        }
        let name = self.apply(edit, &mut after)?;
        if after.is_same(&before) {
            return Ok(false);
        }
        self.go_to(after)?;
        self.run_state.history.push(name, before);
        Ok(true)
    }

    /// Takes back the last step; gives its name, or none when there is none.
    ///
    /// # Errors
    /// Never in practice: the state was solvable before.
    pub fn undo(&mut self) -> Result<Option<String>, Error> {
        self.end_run();
        self.end_drag(true);
        let now = self.snapshot();
        self.run_state.history.undo(now).map(|(name, to)| self.go_to(to).map(|()| name)).transpose()
    }

    /// Repeats the step that was last undone; gives its name, or none when there is none.
    ///
    /// # Errors
    /// Never in practice: the state was solvable before.
    pub fn redo(&mut self) -> Result<Option<String>, Error> {
        self.end_run();
        self.end_drag(true);
        let now = self.snapshot();
        self.run_state.history.redo(now).map(|(name, to)| self.go_to(to).map(|()| name)).transpose()
    }

    /// The names of the steps that undo and redo would take.
    pub fn undo_and_redo(&self) -> [Option<&str>; 2] {
        [self.run_state.history.undo_name(), self.run_state.history.redo_name()]
    }

    pub(crate) fn snapshot(&self) -> Snapshot {
        Snapshot {
            document: self.document.clone(),
            handles: self.solver.handles().to_vec(),
            positions: self.positions(),
            iteration: self.run_state.iteration,
            start: self.run_state.guard.start.clone(),
        }
    }

    /// Makes `state` the current one at the least cost.
    pub(crate) fn go_to(&mut self, state: Snapshot) -> Result<(), Error> {
        let Snapshot { document, handles, positions, iteration, start } = state;
        let moved = self.positions() != positions;
        let replaced = moved.then_some(&positions[..]);
        if same_problem(&document, &self.document) {
            let old = self.solver.handles().to_vec();
            if let Err(error) = self.solver.hold(handles, replaced) {
                self.solver.hold(old, None)?;
                return Err(error.into());
            }
            self.document = document;
        } else if self.differs_in_weights(&document) {
            document.validate(&self.mesh)?;
            let old = self.solver.handles().to_vec();
            if let Err(error) = self.solver.reweigh(document.weights, handles, replaced) {
                self.solver.reweigh(self.document.weights, old, None)?;
                return Err(error.into());
            }
            self.document = document;
        } else {
            document.validate(&self.mesh)?;
            let rows = resolve_rows(&document, &self.mesh, &self.topology)?;
            // A set that nothing uses needs no other solver.
            let mut as_before = document.clone();
            as_before.sets.clone_from(&self.document.sets);
            let unused = same_problem(&as_before, &self.document)
                && rows == self.rows
                && !moved
                && as_before.closeness.weights.is_empty()
                && handles == self.solver.handles();
            if !unused {
                let (mesh, topology) = (&self.mesh, &self.topology);
                let cache = self.solver.setup_cache();
                self.solver = solver(&document, mesh, topology, &rows, cache, handles, &positions)?;
            }
            self.rows = rows;
            self.document = document;
        }
        self.arrive(iteration, start);
        Ok(())
    }

    /// Whether a document is the current one but for weights that the solver can replace.
    fn differs_in_weights(&self, document: &Scene) -> bool {
        let same = Scene { weights: self.document.weights, ..document.clone() };
        same_problem(&same, &self.document) && self.solver.can_reweigh(document.weights)
    }
}
