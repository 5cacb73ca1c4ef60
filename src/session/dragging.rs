//! Drags and runs: each is many changes in one step of undo.

use super::Session;
use super::edit::{Edit, PanelStart, check_lock};
use super::run::{Collapse, LastRun, Search, collapse_since};
use super::state::{check_targets, same_problem};
use super::undo::{SessionState, Transaction, TransactionKind};
use crate::mesh::Point;
use crate::scene::{Lock, Scene};
use crate::session::Error;
use crate::solve::Require;
use serde::Deserialize;
use std::rc::Rc;

/// The phases of a drag.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(rename_all = "camelCase")]
pub enum DragPhase {
    /// Begins a drag of vertices that become handles first.
    Make,
    /// Begins a drag of handles.
    Start,
    /// Continues the drag.
    Move,
    /// Ends the drag and keeps its result.
    End,
    /// Ends the drag and restores the state before it.
    Cancel,
}

impl Session {
    /// Performs one phase of a drag of vertices to `targets`: one for each vertex in the unit of
    /// the mesh, or none if nothing moves. It is no error to continue or end a drag that is not
    /// under way, because an edit may have ended it.
    ///
    /// # Errors
    /// As [`check_targets`]: nothing moves then, and an end keeps the last valid move. Also if a
    /// vertex does not exist, or the lesson locks the handles.
    pub fn drag_through(
        &mut self,
        phase: DragPhase,
        vertices: &[u32],
        targets: &[Point],
    ) -> Result<(), Error> {
        // Checked before handles are made for them.
        let checked = if targets.is_empty() { Ok(()) } else { check_targets(vertices, targets) };
        if matches!(phase, DragPhase::Make | DragPhase::Start) {
            check_lock(Lock::Handles, self.document())?;
        }
        match phase {
            DragPhase::Move | DragPhase::End | DragPhase::Cancel if !self.is_dragging() => {
                return Ok(());
            }
            DragPhase::Cancel => {
                self.end_drag(false);
                return Ok(());
            }
            DragPhase::Make => {
                checked?;
                let add = Edit::AddHandles { vertices: vertices.to_vec(), fixed: false };
                // What is refused leaves a run as it is.
                self.would_change(&add)?;
                self.begin_drag();
                // Undoing the drag also removes the handles.
                if let Err(error) = self.make(add) {
                    self.transaction = None;
                    return Err(error);
                }
            }
            DragPhase::Start => {
                checked?;
                self.begin_drag();
            }
            DragPhase::Move => checked?,
            DragPhase::End => {
                if checked.is_ok() {
                    self.move_handles(vertices, targets);
                }
                self.end_drag(true);
                return Ok(checked?);
            }
        }
        self.move_handles(vertices, targets);
        Ok(())
    }

    /// Begins a drag of vertices that are handles, until [`Session::end_drag`].
    pub fn begin_drag(&mut self) {
        self.begin(TransactionKind::Drag);
    }

    /// Ends a drag: keeps it as one step of undo, or restores the state before it. If there are
    /// hard constraints, it also begins a run that meets them again, in the same step of undo.
    pub fn end_drag(&mut self, keep: bool) {
        if self.record_drag(keep) && self.has_hard_rows() {
            self.begin_run();
            self.join_last();
            self.search = Search::Off;
        }
    }

    /// Ends a drag, and returns whether it became a step of undo. One that moved no handle leaves
    /// nothing: what the solver did meanwhile could not be undone.
    fn record_drag(&mut self, keep: bool) -> bool {
        let Some(transaction) = self.transaction.take_if(|t| t.is_drag()) else { return false };
        let name = transaction.name_of_drag(&self.state()).filter(|_| keep);
        let before = transaction.into_before();
        if let Some(name) = name {
            self.add_step(name, before);
            return true;
        }
        self.go_to_state(before).expect("the state was solvable before");
        false
    }

    /// Begins a run: all iterations up to [`Session::end_run`] are one step of undo.
    pub fn begin_run(&mut self) {
        self.leave_variation();
        // A run that was interrupted goes on with the tolerance that it was asked for.
        if !self.document().constraints.iter().any(|row| self.eases(row)) {
            self.search = self.search_of_scene();
        }
        if self.transaction.is_none() {
            self.begin(TransactionKind::Run);
        }
    }

    /// Constrains all panels to one shape ([`Edit::MakePanels`]) and begins a run, as one step of
    /// undo. `tolerance` is in the unit of the mesh, infinite for none. If faces fold within it but
    /// not within a larger one, the larger one is used ([`super::Eased`]).
    ///
    /// # Errors
    /// As [`Session::edit`].
    pub fn make_panels(
        &mut self,
        kind: &str,
        tolerance: f64,
        from: PanelStart,
    ) -> Result<(), Error> {
        let within = tolerance.is_finite().then_some(tolerance);
        self.edit_and_run(Edit::MakePanels { kind: kind.to_owned(), within, from })?;
        if let Some(asked) = within {
            self.search = Search::Panels(asked);
        }
        Ok(())
    }

    /// Makes an edit and begins a run, as one step of undo.
    ///
    /// # Errors
    /// As [`Session::edit`].
    pub fn edit_and_run(&mut self, edit: Edit) -> Result<(), Error> {
        let made = self.edit(edit)?;
        // Without effect it has left a run as it is, but a new one is asked for.
        self.end_transaction();
        self.begin_run();
        if made {
            self.join_last();
        }
        Ok(())
    }

    /// Joins the transaction under way to the last step of undo.
    fn join_last(&mut self) {
        if let Some(transaction) = &mut self.transaction {
            transaction.join_last();
        }
    }

    /// Whether a run has begun and not ended.
    pub fn is_running(&self) -> bool {
        self.transaction.as_ref().is_some_and(Transaction::is_run)
    }

    /// Ends a run, at its lowest total or at the best shape for its hard constraints. Returns how it has
    /// collapsed the shape, if it has: to be told, and offered to be undone. The scene as it was opened is
    /// run as its author intended, and panels that have to meet a requirement are judged by their verdict.
    pub fn end_run(&mut self) -> Option<Collapse> {
        let met = self.end_meeting(false).expect("the state was solvable before");
        let transaction = self.transaction.take_if(|t| t.is_run())?;
        if self.is_searched() {
            self.search = self.search_of_scene();
        } else if !met {
            self.scene.settle();
        }
        let SessionState { scene: begun, last_run, .. } = transaction.before();
        let start = last_run.as_ref().and_then(|last| last.start_of_next(&begun.document));
        let start = start.unwrap_or_else(|| Rc::clone(&begun.positions));
        let collapse = self.collapse_since(&start);
        self.last_run = Some(Rc::new(LastRun::new(start, &self.scene, collapse)));
        // A run that collapsed is a step of its own, so that it can be undone alone.
        let joins = transaction.joins_last() && self.collapse().is_none();
        match transaction.name_of_run(&self.state()) {
            Some(_) if joins => self.history.join(),
            Some(name) => self.add_step(name, transaction.into_before()),
            None => {}
        }
        self.collapse()
    }

    /// As [`collapse_since`], where the current shape is looked at for a collapse.
    pub(super) fn collapse_since(&self, start: &[Point]) -> Option<Collapse> {
        // Whatever the search has chosen to meet it.
        let asked = |scene: &Scene| {
            let mut asked = scene.clone();
            asked.as_asked();
            asked
        };
        let is_as_opened = |opened| same_problem(&asked(self.document()), &asked(opened));
        let requires_panels = || self.panel_requirement().is_some_and(Require::is_hard);
        let is_judged = self.is_searched() && requires_panels();
        if is_judged || self.opened.as_deref().is_some_and(is_as_opened) {
            return None;
        }
        collapse_since(start, &self.scene, &self.rest)
    }

    fn move_handles(&mut self, vertices: &[u32], targets: &[Point]) {
        self.scene.move_handles(vertices.iter().copied().zip(targets.iter().copied()));
    }

    /// Ends the drag, run or variation under way; a drag or run becomes a step of undo. After a drag
    /// that something else ends, hard constraints are met again by the next run.
    pub(super) fn end_transaction(&mut self) {
        self.end_run();
        self.record_drag(true);
        self.leave_variation();
    }

    pub(super) fn begin(&mut self, kind: TransactionKind) {
        self.end_transaction();
        self.transaction = Some(Transaction::new(kind, self.state()));
        self.progress.leave_half();
    }
}
