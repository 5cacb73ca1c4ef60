//! Edits, undo and redo.

use super::Session;
use super::edit::{
    Carried, Edit, Moment, OfferedOperation, Refinement, Remeshing, RemeshingPreview, apply, carry,
    check_locks, offered,
};
use super::report::{MeasureCache, check_lesson, check_presentation};
use super::run::Start;
use super::state::{RestMesh, SceneChange, SolvedScene, resolve_rows};
use super::undo::{Change, SavedState, read_history, read_state, write_history, write_state};
use crate::error::Error;
use crate::mesh::{
    Edited, Mesh, MeshOperation, OperationError, Point, Scheme, SubdivideError, SubdividedCounts,
    Subdivision, Task, counted,
};
use crate::scene::{Scene, SceneError};
use std::rc::Rc;

/// Refining is offered so often at most, and as long as no more faces come of it.
const MOST_REFINEMENTS: u32 = 5;
const MANY_FACES: usize = 100_000;

fn cannot_be_refined(why: SubdivideError) -> SceneError {
    SceneError { path: "mesh".to_owned(), message: why.to_string() }
}

impl Session {
    /// Makes an edit, and returns whether it is a step of undo: one that changes nothing is none.
    ///
    /// # Errors
    /// When the lesson locks what it would change, it names a row or vertex that is not there, leaves a row without constraints or a goal without
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
        check_locks(&edit, self.document())?;
        if let Edit::Refine { scheme, levels, keep, adopt } = edit {
            return self.refine(&Subdivision { scheme, levels, keep }, adopt).map(Some);
        }
        if let Edit::Remesh(remeshing) = edit {
            return self.remesh(&remeshing).map(Some);
        }
        let (iteration, start) = (self.iteration(), self.guard.start());
        let kept_start = start.clone().filter(|_| self.collapse().is_some());
        let mut moment = Moment { iteration, start: kept_start };
        let (name, back) = self.scene.edit(&self.rest, |draft| apply(edit, draft, &mut moment))?;
        let Some(scene) = back else { return Ok(None) };
        self.arrive(moment.iteration, moment.start);
        Ok(Some((name, Change { scene, other: None, iteration, start })))
    }

    /// Exchanges a change with the state, which makes of it the way back.
    ///
    /// # Errors
    /// When the system would be singular; nothing has changed then.
    pub(super) fn exchange(&mut self, change: &mut Change) -> Result<(), Error> {
        match change.other.take() {
            None => self.scene.exchange(&self.rest, &mut change.scene)?,
            Some(other) => self.exchange_mesh(*other, change)?,
        }
        let (iteration, start) = (self.iteration(), self.guard.start());
        let to = std::mem::replace(&mut change.iteration, iteration);
        let from = std::mem::replace(&mut change.start, start);
        self.arrive(to, from);
        Ok(())
    }

    /// Makes several faces of each, of the original or, where it is adopted, of the shape as it is; its name and the
    /// way back.
    ///
    /// # Errors
    /// When the mesh cannot be subdivided so, or the system would be singular; nothing has changed then.
    fn refine(&mut self, how: &Subdivision, adopts: bool) -> Result<(String, Change), Error> {
        let shape = if adopts { self.scene.positions() } else { self.rest.positions() };
        let mesh = Mesh { positions: shape.to_vec(), ..self.mesh().clone() };
        let refined = how.apply(&mesh, self.topology()).map_err(cannot_be_refined)?;
        let name = format!("Refine to {}", counted(refined.mesh.faces.len(), "face", "faces"));
        let (rest, carried) = self.carried_to(&refined, shape, shape);
        Ok((name, self.go_to_mesh(rest, carried)?))
    }

    /// What refining by a scheme would make of the mesh, once, twice and so on: as often as no more than 100,000 faces
    /// come of it, and at least once.
    ///
    /// # Errors
    /// When the mesh cannot be subdivided so.
    pub fn refinements(&self, scheme: Scheme, keep: f64) -> Result<Vec<Refinement>, Error> {
        let mut made: Vec<Refinement> = Vec::new();
        let mut edge = self.rest.mean_edge();
        for levels in 1..=MOST_REFINEMENTS {
            let subdivision = Subdivision { scheme, levels, keep };
            let counts = subdivision.counts(self.mesh(), self.topology());
            let SubdividedCounts { vertices, faces } = match counts {
                Ok(counts) if levels == 1 || counts.faces <= MANY_FACES => counts,
                Err(why) if levels == 1 => return Err(cannot_be_refined(why).into()),
                _ => break,
            };
            edge *= 0.5;
            made.push(Refinement { vertices, faces, edge });
        }
        Ok(made)
    }

    /// Changes the mesh by an operation; its name and the way back.
    ///
    /// # Errors
    /// When the operation is refused, or the system would be singular; nothing has changed then.
    fn remesh(&mut self, remeshing: &Remeshing) -> Result<(String, Change), Error> {
        let (operation, edited) = self.remeshed(remeshing)?;
        let (rest, carried) =
            self.carried_to(&edited, self.scene.positions(), self.rest.positions());
        Ok((operation.label.to_owned(), self.go_to_mesh(rest, carried)?))
    }

    /// The operations on the mesh, with sizes that fit it.
    pub fn operations(&self) -> Vec<OfferedOperation> {
        offered(self.rest.mean_edge())
    }

    /// A preview of an operation on the mesh.
    ///
    /// # Errors
    /// When the operation is refused.
    pub fn remeshing(&self, remeshing: &Remeshing) -> Result<RemeshingPreview, Error> {
        let (_, edited) = self.remeshed(remeshing)?;
        let (rest, _) = self.carried_to(&edited, self.scene.positions(), self.rest.positions());
        Ok(RemeshingPreview::of([self.rest.mesh(), rest.mesh()], rest.lost()))
    }

    /// The mesh as it is seen after an operation.
    fn remeshed(
        &self,
        remeshing: &Remeshing,
    ) -> Result<(&'static MeshOperation, Edited), SceneError> {
        let Remeshing { operation, sizes, vertices, faces } = remeshing;
        let refused =
            |why: OperationError| SceneError { path: String::new(), message: why.to_string() };
        let operation = MeshOperation::of(operation).map_err(refused)?;
        let mesh = Mesh { positions: self.scene.positions().to_vec(), ..self.mesh().clone() };
        let up = self.document().up.direction();
        let topology = self.topology();
        let task = Task { mesh: &mesh, topology, up, sizes, vertices, faces };
        Ok((operation, operation.apply(&task).map_err(refused)?))
    }

    /// The scene carried over to a mesh that was made from its own with the positions `from`; and that mesh at rest, made
    /// from the positions `rest`; both `#V by 3`.
    fn carried_to(&self, edited: &Edited, from: &[Point], rest: &[Point]) -> (RestMesh, Carried) {
        let positions = edited.in_other_state(from, rest);
        let mut rest = self.rest.next(Mesh { positions, ..edited.mesh.clone() });
        let shape = (&**self.scene.handles(), &**self.scene.positions());
        let mut carried = carry(self.document(), shape, &self.rest, (edited, from), &rest);
        rest.set_lost(std::mem::take(&mut carried.lost));
        (rest, carried)
    }

    /// Goes to another mesh with a scene; the way back.
    ///
    /// # Errors
    /// When the document does not fit the mesh, or the system is singular; nothing has changed then.
    fn go_to_mesh(&mut self, rest: RestMesh, carried: Carried) -> Result<Change, Error> {
        let Carried { document, handles, positions, .. } = carried;
        let scene =
            SceneChange { parts: Vec::new(), handles: handles.into(), positions: positions.into() };
        let other = Some(Box::new((rest, document)));
        let mut change = Change { scene, other, iteration: self.iteration(), start: None };
        self.exchange(&mut change)?;
        Ok(change)
    }

    /// Goes to another mesh and exchanges what the change holds with the state.
    ///
    /// # Errors
    /// When the document does not fit the mesh, or the system is singular; nothing has changed then.
    fn exchange_mesh(
        &mut self,
        (rest, document): (RestMesh, Scene),
        change: &mut Change,
    ) -> Result<(), Error> {
        document.validate(rest.mesh())?;
        check_lesson(&document, rest.mesh())?;
        check_presentation(&document, rest.mesh())?;
        let rows = resolve_rows(&document, rest.mesh(), rest.topology())?;
        let SceneChange { handles, positions, .. } = &change.scene;
        let scene = SolvedScene::new(document, &rest, rows, handles.to_vec(), positions)?;
        change.scene = self.scene.way_back();
        let before = (
            std::mem::replace(&mut self.rest, rest),
            std::mem::replace(&mut self.scene, scene).into_document(),
        );
        change.other = Some(Box::new(before));
        self.measured = MeasureCache::default();
        (self.met, self.met_before, self.meeting) = (None, None, None);
        Ok(())
    }

    /// The way back to the state as it is.
    pub(super) fn way_back(&self) -> Change {
        let (iteration, start) = (self.iteration(), self.guard.start());
        Change { scene: self.scene.way_back(), other: None, iteration, start }
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
