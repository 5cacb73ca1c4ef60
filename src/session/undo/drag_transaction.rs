//! Drags and runs: many changes that are one step of undo together.

use crate::error::Error;
use crate::mesh::{FARTHEST, Point, counted, too_far};
use crate::scene::SceneError;
use crate::session::edit::Edit;
use crate::session::state::{Session, Transaction, TransactionKind};

/// Checks that the targets of these vertices are such as a scene file may have.
///
/// # Errors
/// When there is not one target for each vertex, or one is not finite or too far out: the error names its
/// vertex.
pub fn check_targets(vertices: &[u32], targets: &[Point]) -> Result<(), SceneError> {
    let error = |message| Err(SceneError { path: "handles".to_owned(), message });
    if vertices.len() != targets.len() {
        let (found, expected) = (targets.len(), vertices.len());
        return error(format!(
            "found {found} targets, expected one for each of the {expected} vertices"
        ));
    }
    match too_far(targets) {
        None => Ok(()),
        Some(place) => error(format!(
            "the target of vertex {} is not finite or too far out, expected coordinates from -{FARTHEST:e} to {FARTHEST:e}",
            vertices[place]
        )),
    }
}

impl Session {
    /// Begins to drag vertices that are handles; targets move until [`Session::end_drag`].
    pub fn begin_drag(&mut self) {
        self.begin(TransactionKind::Drag);
    }

    /// Makes vertices handles where they are and begins to drag them: one step of undo together, and
    /// taking the drag back takes the handles away.
    ///
    /// # Errors
    /// When a vertex is not there; nothing has changed then.
    pub fn begin_drag_of_new(&mut self, vertices: Vec<u32>) -> Result<(), Error> {
        self.begin(TransactionKind::Drag);
        let mut with_handles = self.snapshot();
        let made = self
            .apply(Edit::AddHandles { vertices, fixed: false }, &mut with_handles)
            .map_err(Error::from)
            .and_then(|_| self.go_to(with_handles));
        if made.is_err() {
            self.run_state.transaction = None;
        }
        made
    }

    /// Whether a drag has begun and not ended; an edit ends it.
    pub fn is_dragging(&self) -> bool {
        self.run_state
            .transaction
            .as_ref()
            .is_some_and(|transaction| transaction.kind == TransactionKind::Drag)
    }

    /// Moves the targets of handles.
    ///
    /// # Errors
    /// As [`check_targets`]; nothing has moved then.
    pub fn drag(
        &mut self,
        targets: impl IntoIterator<Item = (u32, Point)>,
    ) -> Result<(), SceneError> {
        let (vertices, targets): (Vec<u32>, Vec<Point>) = targets.into_iter().unzip();
        check_targets(&vertices, &targets)?;
        self.solver.move_handles(vertices.into_iter().zip(targets));
        Ok(())
    }

    /// Ends a drag: keeps it as one step of undo, or puts everything back.
    pub fn end_drag(&mut self, keep: bool) {
        let Some(transaction) =
            self.run_state.transaction.take_if(|g| g.kind == TransactionKind::Drag)
        else {
            return;
        };
        let before = &transaction.before.handles;
        let now = self.solver.handles();
        if !keep {
            self.go_to(transaction.before).expect("the state was solvable before");
        } else if before.len() != now.len() {
            self.run_state.history.push("Make and move handle".to_owned(), transaction.before);
        } else {
            let moved = before.iter().zip(now).filter(|(before, now)| before != now).count();
            let name = match moved {
                0 => return,
                1 => "Move handle".to_owned(),
                _ => format!("Move {moved} handles"),
            };
            self.run_state.history.push(name, transaction.before);
        }
    }

    /// Begins a run: iterations up to [`Session::end_run`] are one step of undo.
    pub fn begin_run(&mut self) {
        self.run_state.guard.goes_on = false;
        if self.run_state.transaction.is_none() {
            self.begin(TransactionKind::Run);
        }
    }

    /// Lets the run that has begun go on when the shape collapses.
    pub fn go_on(&mut self) {
        self.run_state.guard.goes_on = true;
    }

    /// Ends a run, at the lowest total that it saw.
    pub fn end_run(&mut self) {
        let Some(transaction) =
            self.run_state.transaction.take_if(|g| g.kind == TransactionKind::Run)
        else {
            return;
        };
        self.solver.settle();
        self.look();
        let iterations = self.run_state.iteration - transaction.before.iteration;
        // One that collapsed can be taken back alone.
        let joins = transaction.joins_last && self.collapse().is_none();
        if iterations > 0 && !joins {
            let iterations = counted(iterations as usize, "iteration", "iterations");
            self.run_state.history.push(format!("Run, {iterations}"), transaction.before);
        }
    }

    fn begin(&mut self, kind: TransactionKind) {
        self.end_run();
        self.end_drag(true);
        let before = self.snapshot();
        self.run_state.transaction =
            Some(Transaction { kind, before, joins_last: false, goal: None });
        if self.is_dragging() && self.collapse().is_none() {
            self.run_state.guard.start = None;
        }
        self.halfway = false;
    }
}
