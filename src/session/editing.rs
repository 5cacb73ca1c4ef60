//! Edits, undo and redo.

use super::Session;
use super::edit::{Edit, Moment, apply};
use super::run::Start;
use super::undo::{Change, SavedState, read_history, read_state, write_history, write_state};
use crate::error::Error;
use std::rc::Rc;

impl Session {
    /// Makes an edit, and returns whether it is a step of undo: one that changes nothing is none.
    ///
    /// # Errors
    /// When it names a row or vertex that is not there, leaves a row without constraints or a goal without
    /// the row that it is on, or makes the system singular; nothing has changed then.
    pub fn edit(&mut self, edit: Edit) -> Result<bool, Error> {
        self.end_transaction();
        let Some((name, back)) = self.make(edit)? else { return Ok(false) };
        self.history.push(name, back);
        Ok(true)
    }

    /// Takes back the last step; gives its name, or none when there is none.
    ///
    /// # Errors
    /// Never in practice: the state was solvable before.
    pub fn undo(&mut self) -> Result<Option<String>, Error> {
        self.end_transaction();
        let Some((name, mut change)) = self.history.pop_undo() else { return Ok(None) };
        self.exchange(&mut change)?;
        self.history.push_redo((name.clone(), change));
        Ok(Some(name))
    }

    /// Repeats the step that was last undone; gives its name, or none when there is none.
    ///
    /// # Errors
    /// Never in practice: the state was solvable before.
    pub fn redo(&mut self) -> Result<Option<String>, Error> {
        self.end_transaction();
        let Some((name, mut change)) = self.history.pop_redo() else { return Ok(None) };
        self.exchange(&mut change)?;
        self.history.push_undo((name.clone(), change));
        Ok(Some(name))
    }

    /// The steps of undo and redo, for [`Session::restore`]; at most 20 MB of them. They belong to the
    /// scene as it stands, or as it stood before the run or the drag that goes on.
    pub fn saved_history(&self) -> Vec<u8> {
        let mut now = SavedState::of(&self.scene, self.iteration());
        if let Some(transaction) = &self.transaction {
            now.follow(transaction.back());
        }
        write_history(self.history.steps(), &now, self.rest.mesh())
    }

    /// How far the run or the drag that goes on has come, for [`Session::restore`].
    pub fn saved_progress(&self) -> Vec<u8> {
        write_state(&SavedState::of(&self.scene, self.iteration()), self.rest.mesh())
    }

    /// Goes on where the scene that was just opened stood when it was saved. `history` is of that scene,
    /// `progress` of a run or a drag that began with it, which becomes a step of undo; either may be empty.
    ///
    /// # Errors
    /// When bytes are damaged or belong to another scene; what can be restored is.
    pub fn restore(&mut self, history: &[u8], progress: &[u8]) -> Result<(), Error> {
        let now = SavedState::of(&self.scene, self.iteration());
        let mut result = Ok(());
        if !history.is_empty() {
            let read = read_history(history, &now, self.rest.mesh());
            result = read.map(|(history, first)| {
                first.into_iter().for_each(|first| self.guard.set_opened(first));
                self.history = history;
                self.begin_from(None);
            });
        }
        if !progress.is_empty() {
            let read = read_state(progress, &now, self.rest.mesh());
            result = result.and(read.and_then(|state| self.resume(now.change_to(&state))));
        }
        result
    }

    /// Counts on from `iteration`, for a scene that is opened again where it stood.
    pub fn restore_iteration(&mut self, iteration: u32) {
        self.progress.restore(iteration, self.scene.solver().energy());
    }

    /// Makes what has happened since the scene was written one step of undo.
    fn resume(&mut self, mut change: Change) -> Result<(), Error> {
        if change.scene.handles == *self.scene.handles() {
            self.begin_run();
        } else {
            self.begin_drag();
        }
        let resumed = self.exchange(&mut change).map(|()| self.include(change));
        self.end_transaction();
        resumed
    }

    /// Makes an edit without a step of undo; its name and the way back, or none where it changes nothing.
    pub(super) fn make(&mut self, edit: Edit) -> Result<Option<(String, Change)>, Error> {
        let (iteration, start) = (self.iteration(), self.guard.start());
        let kept_start = start.clone().filter(|_| self.collapse().is_some());
        let mut moment = Moment { iteration, start: kept_start };
        let (name, back) = self.scene.edit(&self.rest, |draft| apply(edit, draft, &mut moment))?;
        let Some(scene) = back else { return Ok(None) };
        self.arrive(moment.iteration, moment.start);
        Ok(Some((name, Change { scene, iteration, start })))
    }

    /// Exchanges a change with the state, which makes of it the way back.
    ///
    /// # Errors
    /// When the system would be singular; nothing has changed then.
    pub(super) fn exchange(&mut self, change: &mut Change) -> Result<(), Error> {
        self.scene.exchange(&self.rest, &mut change.scene)?;
        let (iteration, start) = (self.iteration(), self.guard.start());
        let to = std::mem::replace(&mut change.iteration, iteration);
        let from = std::mem::replace(&mut change.start, start);
        self.arrive(to, from);
        Ok(())
    }

    /// The way back to the state as it is.
    pub(super) fn way_back(&self) -> Change {
        let (iteration, start) = (self.iteration(), self.guard.start());
        Change { scene: self.scene.way_back(), iteration, start }
    }

    /// Counts on from `iteration` after a jump to another state, to which iterations led from `start`.
    fn arrive(&mut self, iteration: u32, start: Option<Rc<Start>>) {
        self.begin_from(start);
        self.progress.go_to(iteration, self.scene.solver().energy());
    }

    fn begin_from(&mut self, start: Option<Rc<Start>>) {
        let dragging = self.is_dragging();
        self.guard.start_from(start, &self.scene, &self.rest, dragging);
    }
}
