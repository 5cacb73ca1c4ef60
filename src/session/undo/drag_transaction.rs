//! Drags and runs: many changes that are one step of undo together.

use crate::error::Error;
use crate::mesh::{FARTHEST, Point, counted, too_far};
use crate::scene::SceneError;
use crate::session::edit::Edit;
use crate::session::state::{Gesture, GestureKind, Session};

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
        self.begin(GestureKind::Drag);
    }

    /// Makes vertices handles where they are and begins to drag them: one step of undo together, and
    /// taking the drag back takes the handles away.
    ///
    /// # Errors
    /// When a vertex is not there; nothing has changed then.
    pub fn begin_drag_of_new(&mut self, vertices: Vec<u32>) -> Result<(), Error> {
        self.begin(GestureKind::Drag);
        let mut with_handles = self.snapshot();
        let made = self
            .apply(Edit::AddHandles { vertices, fixed: false }, &mut with_handles)
            .map_err(Error::from)
            .and_then(|_| self.go_to(with_handles));
        if made.is_err() {
            self.past.gesture = None;
        }
        made
    }

    /// Whether a drag has begun and not ended; an edit ends it.
    pub fn is_dragging(&self) -> bool {
        self.past.gesture.as_ref().is_some_and(|gesture| gesture.kind == GestureKind::Drag)
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
        let Some(gesture) = self.past.gesture.take_if(|g| g.kind == GestureKind::Drag) else {
            return;
        };
        let before = &gesture.before.handles;
        let now = self.solver.handles();
        if !keep {
            self.go_to(gesture.before).expect("the state was solvable before");
        } else if before.len() != now.len() {
            self.past.history.push("Make and move handle".to_owned(), gesture.before);
        } else {
            let moved = before.iter().zip(now).filter(|(before, now)| before != now).count();
            let name = match moved {
                0 => return,
                1 => "Move handle".to_owned(),
                _ => format!("Move {moved} handles"),
            };
            self.past.history.push(name, gesture.before);
        }
    }

    /// Begins a run: iterations up to [`Session::end_run`] are one step of undo.
    pub fn begin_run(&mut self) {
        self.past.guard.goes_on = false;
        if self.past.gesture.is_none() {
            self.begin(GestureKind::Run);
        }
    }

    /// Lets the run that has begun go on when the shape collapses.
    pub fn go_on(&mut self) {
        self.past.guard.goes_on = true;
    }

    /// Ends a run, at the lowest total that it saw.
    pub fn end_run(&mut self) {
        let Some(gesture) = self.past.gesture.take_if(|g| g.kind == GestureKind::Run) else {
            return;
        };
        self.solver.settle();
        self.look();
        let iterations = self.past.iteration - gesture.before.iteration;
        // One that collapsed can be taken back alone.
        let joins = gesture.joins_last && self.collapse().is_none();
        if iterations > 0 && !joins {
            let iterations = counted(iterations as usize, "iteration", "iterations");
            self.past.history.push(format!("Run, {iterations}"), gesture.before);
        }
    }

    fn begin(&mut self, kind: GestureKind) {
        self.end_run();
        self.end_drag(true);
        let before = self.snapshot();
        self.past.gesture = Some(Gesture { kind, before, joins_last: false, goal: None });
        if self.is_dragging() && self.collapse().is_none() {
            self.past.guard.start = None;
        }
        self.halfway = false;
    }
}
