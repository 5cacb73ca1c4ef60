//! Edits, undo and redo.

use super::Session;
use super::edit::{
    Carried, Edit, OfferedOperation, Refinement, Remeshing, RemeshingPreview, apply, carry,
    check_lock, check_locks, offered,
};
use super::measured::MeasureCache;
use super::report::{check_lesson, check_presentation};
use super::run::Search;
use super::state::{RestMesh, SceneState, SolvedScene, asks_otherwise, resolve_rows};
use super::undo::{
    SessionState, Transaction, read_history, read_state, write_history, write_state,
};
use crate::mesh::{
    Edited, Mesh, MeshOperation, OperationError, Point, Scheme, SubdivideError, SubdividedCounts,
    Subdivision, Task,
};
use crate::scene::{Scene, SceneError};
use crate::session::Error;
use crate::words;
use std::rc::Rc;

/// Maximum number of refinements offered; beyond the first, none with more faces than this.
const MOST_REFINEMENTS: u32 = 5;
const MANY_FACES: usize = 100_000;

fn cannot_be_refined(why: SubdivideError) -> SceneError {
    SceneError { path: "mesh".to_owned(), message: why.to_string() }
}

/// Says how many faces made from those of the mesh `old` are turned over or have no area, if any.
fn turned_over(edited: &Edited, old: &Mesh) -> Option<String> {
    let turned_over = edited.turned_over(old);
    let faces = words::count(turned_over, "new face is", "new faces are");
    (turned_over > 0).then(|| {
        format!(
            "{faces} turned over or without area: the centre of a face with a notch may lie outside it."
        )
    })
}

impl Session {
    /// Makes an edit, and returns whether it is a step of undo; an edit without effect is not, nor
    /// the tolerance, by which a shape is judged, so that it changes during a run and keeps Redo.
    ///
    /// # Errors
    /// If the lesson locks a part that it would change; if it refers to a row or vertex that does
    /// not exist, or leaves a row without constraints or a goal without its row; or if it makes the
    /// system singular. Nothing has changed then; but a run or a variation has ended, and a drag goes on
    /// as another step, if that was found only when the mesh was made or the solver was set up.
    pub fn edit(&mut self, edit: Edit) -> Result<bool, Error> {
        if let Edit::SetTolerance { .. } = edit {
            // Iterations go on as if nothing had happened.
            check_locks(&edit, self.document())?;
            let before = self.document().tolerance;
            self.scene.edit(&self.rest, |draft| apply(edit, draft))?;
            let now = self.document().tolerance;
            let is_begun = |it: &mut Transaction| it.replace_tolerance(before, now);
            if self.transaction.as_mut().is_none_or(is_begun) {
                self.history.replace_tolerance(before, now);
            }
            return Ok(false);
        }
        if self.transaction.is_some() && !self.would_change(&edit)? {
            return Ok(false);
        }
        let was_dragging = self.is_dragging();
        self.end_transaction();
        let made = self.make(edit);
        if made.is_err() && was_dragging {
            // The user still drags.
            self.begin_drag();
        }
        let Some((name, before)) = made? else { return Ok(false) };
        self.add_step(name, before);
        Ok(true)
    }

    /// Whether an edit would have an effect: what has none, or is refused, leaves a run, a drag and a
    /// variation that is shown as they are. Of edits that bring or make a mesh only the locks are checked:
    /// to try them takes as long as they do.
    ///
    /// # Errors
    /// Those of [`Session::edit`] that are known before the solver is set up.
    pub(super) fn would_change(&self, edit: &Edit) -> Result<bool, Error> {
        check_locks(edit, self.document())?;
        if let Edit::Refine { .. } | Edit::Remesh(_) | Edit::FitTo { .. } | Edit::TakePose { .. } =
            edit
        {
            return Ok(true);
        }
        let edit = edit.clone();
        Ok(self.scene.would_change(&self.rest, |draft| apply(edit, draft))?)
    }

    /// The number of the current problem, handles and positions: what was made for another one is
    /// out of date. Edits of the lesson, the build, a presentation, units and names leave it, and a
    /// converged shape converged.
    pub fn generation(&self) -> u32 {
        self.scene.generation()
    }

    /// Whether what was made for this generation may be taken: nothing is dragged, and no variation shown,
    /// whose end would change the shape.
    pub(super) fn is_at(&self, generation: u32) -> bool {
        let is_passing = |now: &Transaction| now.is_drag() || now.is_variation();
        generation == self.generation() && !self.transaction.as_ref().is_some_and(is_passing)
    }

    /// Undoes the last step, and returns its name; none if there is no step. A variation that is
    /// shown and not kept is the last thing that was done: it is discarded, and nothing else.
    ///
    /// # Errors
    /// Never in practice: the state was solvable before.
    pub fn undo(&mut self) -> Result<Option<String>, Error> {
        if self.leave_variation() {
            return Ok(Some(Transaction::VARIATION.to_owned()));
        }
        self.end_transaction();
        let Some((name, before)) = self.history.pop_undo() else { return Ok(None) };
        let after = self.state();
        self.go_to_state(before)?;
        self.history.push_redo((name.clone(), after), &self.state());
        Ok(Some(name))
    }

    /// Repeats the step that was last undone, and returns its name; none if there is no step.
    ///
    /// # Errors
    /// Never in practice: the state was solvable before.
    pub fn redo(&mut self) -> Result<Option<String>, Error> {
        self.end_transaction();
        let Some((name, after)) = self.history.pop_redo() else { return Ok(None) };
        let before = self.state();
        self.go_to_state(after)?;
        self.history.push_undo((name.clone(), before), &self.state());
        Ok(Some(name))
    }

    /// Returns the steps of undo and redo, at most 20 MB, for [`Session::restore`]. They apply to
    /// the scene as it is, at any time: a run, a drag or a variation that is under way is the last
    /// step. While it has changed nothing, they are those before it.
    pub fn saved_history(&self) -> Vec<u8> {
        let now = self.state();
        let last = self.transaction.as_ref().and_then(|transaction| {
            Some((transaction.name_of_step(&now)?, transaction.before().clone()))
        });
        write_history(self.history.steps(), &now, last, self.opened.as_deref())
    }

    /// Returns the state of the run or the drag under way, for [`Session::restore`].
    pub fn saved_progress(&self) -> Vec<u8> {
        write_state(&self.state())
    }

    /// Restores a saved state in the scene that was just opened. `history` applies to that scene;
    /// `progress` is of a run or a drag that began or was under way with it, which becomes a step of
    /// undo. Either may be empty.
    ///
    /// # Errors
    /// If bytes are damaged or belong to another scene; the rest is restored.
    pub fn restore(&mut self, history: &[u8], progress: &[u8]) -> Result<(), Error> {
        let now = self.state();
        let mut result = Ok(());
        if !history.is_empty() {
            result = read_history(history, &now)
                .map(|(history, opened)| (self.history, self.opened) = (history, opened));
        }
        if !progress.is_empty() {
            let read = read_state(progress, &now);
            result = result.and(read.and_then(|state| self.resume(state)));
        }
        result
    }

    /// Sets the iteration count, for a scene that is reopened in its saved state.
    pub fn restore_iteration(&mut self, iteration: u32) {
        self.progress.restore(iteration, self.scene.solver().energy());
    }

    /// Makes the way to `state` since the scene was saved one step of undo.
    fn resume(&mut self, state: SessionState) -> Result<(), Error> {
        if state.scene.handles == *self.scene.handles() {
            self.begin_run();
        } else {
            self.begin_drag();
        }
        let resumed = self.go_to_state(state);
        self.end_transaction();
        resumed
    }

    /// Makes an edit without a step of undo, and returns its name and the state before it; none if it
    /// has no effect.
    pub(super) fn make(&mut self, edit: Edit) -> Result<Option<(String, SessionState)>, Error> {
        check_locks(&edit, self.document())?;
        if let Edit::Refine { scheme, levels, keep, adopt } = edit {
            return self.refine(&Subdivision { scheme, levels, keep }, adopt).map(Some);
        }
        if let Edit::Remesh(remeshing) = edit {
            return self.remesh(&remeshing).map(Some);
        }
        let before = self.state();
        let ((name, iteration), differs) =
            self.scene.edit(&self.rest, |draft| Ok((apply(edit, draft)?, draft.iteration)))?;
        if !differs {
            return Ok(None);
        }
        self.leave_search_since(&before.scene.document);
        self.arrive(iteration.unwrap_or(before.iteration));
        Ok(Some((name, before)))
    }

    /// Adds a step of undo that led from the state `before` to the current one.
    pub(super) fn add_step(&mut self, name: String, before: SessionState) {
        let now = self.state();
        self.history.push(name, before, &now);
    }

    /// Goes to another state.
    ///
    /// # Errors
    /// When the document does not fit the mesh, or the system would be singular; nothing has changed then.
    pub(super) fn go_to_state(&mut self, state: SessionState) -> Result<(), Error> {
        let SessionState { rest, scene, iteration, last_run } = state;
        match Rc::ptr_eq(&rest, &self.rest) {
            true => self.go_to_scene(scene)?,
            false => self.go_to_mesh(rest, scene)?,
        }
        self.last_run = last_run;
        self.arrive(iteration);
        Ok(())
    }

    /// Goes to another state of the scene on the same mesh.
    ///
    /// # Errors
    /// As [`Session::go_to_state`].
    pub(super) fn go_to_scene(&mut self, scene: SceneState) -> Result<(), Error> {
        let before = Rc::clone(self.scene.document());
        self.scene.go_to(&self.rest, scene)?;
        self.leave_search_since(&before);
        Ok(())
    }

    /// Subdivides the original or, if `adopts`, the current shape. Returns the name and the state before.
    ///
    /// # Errors
    /// If the mesh cannot be subdivided in this way, something that the lesson locks would be left out,
    /// or the system would be singular; nothing has changed then.
    fn refine(&mut self, how: &Subdivision, adopts: bool) -> Result<(String, SessionState), Error> {
        if adopts && self.document().lesson.is_some() {
            let message = "the goals of the lesson are measured from the shape that was given, expected \
                           the original to be refined";
            return Err(
                SceneError { path: "lesson".to_owned(), message: message.to_owned() }.into()
            );
        }
        let shape = if adopts { self.scene.positions() } else { self.rest.positions() };
        let refined =
            how.apply(&self.mesh().at(shape), self.topology()).map_err(cannot_be_refined)?;
        let name = format!("Refine to {}", words::count(refined.mesh.faces.len(), "face", "faces"));
        let (rest, mut carried) = self.carried_to(&refined, shape, shape);
        carried.lost.extend(turned_over(&refined, &self.mesh().at(shape)));
        if adopts {
            // What the shape is kept close to is the adopted one.
            carried.document.variants.design = None;
        }
        Ok((name, self.take_mesh(rest, carried)?))
    }

    /// Returns the sizes of the mesh after refining by a scheme once, twice and so on, up to
    /// 100,000 faces; the first is always included.
    ///
    /// # Errors
    /// If the mesh cannot be subdivided in this way.
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

    /// Changes the mesh by an operation, and returns the name and the state before.
    ///
    /// # Errors
    /// If the operation is refused, or the system would be singular; nothing has changed then.
    fn remesh(&mut self, remeshing: &Remeshing) -> Result<(String, SessionState), Error> {
        let (operation, rest, carried) = self.remeshed(remeshing)?;
        Ok((operation.label.to_owned(), self.take_mesh(rest, carried)?))
    }

    /// Replaces the mesh by one made from it at its current positions, and returns the state before.
    /// `amend` changes the scene that is carried over.
    ///
    /// # Errors
    /// If the system would be singular, or something that the lesson locks would be left out; nothing
    /// has changed then.
    pub(super) fn replace_mesh(
        &mut self,
        edited: &Edited,
        amend: impl FnOnce(&mut Scene),
    ) -> Result<SessionState, Error> {
        let (rest, mut carried) =
            self.carried_to(edited, self.scene.positions(), self.rest.positions());
        amend(&mut carried.document);
        self.take_mesh(rest, carried)
    }

    /// Returns the operations on the mesh, with default sizes that suit it.
    pub fn operations(&self) -> Vec<OfferedOperation> {
        offered(self.rest.mean_edge())
    }

    /// Returns a preview of an operation on the mesh.
    ///
    /// # Errors
    /// If the operation is refused.
    pub fn remeshing(&self, remeshing: &Remeshing) -> Result<RemeshingPreview, Error> {
        let (_, rest, carried) = self.remeshed(remeshing)?;
        Ok(RemeshingPreview::of([self.rest.mesh(), rest.mesh()], &carried.lost))
    }

    /// Applies an operation to the mesh at its current positions, and carries the scene over.
    fn remeshed(
        &self,
        remeshing: &Remeshing,
    ) -> Result<(&'static MeshOperation, RestMesh, Carried), SceneError> {
        let Remeshing { operation, sizes, vertices, faces } = remeshing;
        let refused =
            |why: OperationError| SceneError { path: String::new(), message: why.to_string() };
        let operation = MeshOperation::of(operation).map_err(refused)?;
        let mesh = self.current_shape();
        let up = self.document().up.direction();
        let (rest, topology) = (self.rest.positions(), self.topology());
        let task = Task { mesh: &mesh, rest, topology, up, sizes, vertices, faces };
        let edited = operation.apply(&task).map_err(refused)?;
        let (rest, mut carried) = self.carried_to(&edited, &mesh.positions, rest);
        carried.lost.extend(turned_over(&edited, &mesh));
        Ok((operation, rest, carried))
    }

    /// Carries the scene over to a mesh derived from its own at the positions `from`, and says what is
    /// left out. Also returns the rest mesh, derived in the same way from the positions `rest`; both
    /// `#V by 3`.
    fn carried_to(&self, edited: &Edited, from: &[Point], rest: &[Point]) -> (RestMesh, Carried) {
        let positions = edited.in_other_state(from, rest);
        let mut mesh = Mesh { positions, ..edited.mesh.clone() };
        edited.origins.carry(self.mesh(), &mut mesh);
        let rest = self.rest.next(mesh);
        let shape = (&**self.scene.handles(), &**self.scene.positions());
        let carried = carry(self.document(), shape, &self.rest, (edited, from), &rest);
        (rest, carried)
    }

    /// Replaces the mesh and the scene, and returns the state before.
    ///
    /// # Errors
    /// If something that the lesson locks would be left out, the document does not fit the mesh, or the
    /// system is singular; nothing has changed then.
    fn take_mesh(&mut self, mut rest: RestMesh, carried: Carried) -> Result<SessionState, Error> {
        let Carried { mut document, handles, positions, lost, dropped } = carried;
        rest.set_lost(lost);
        dropped.iter().try_for_each(|part| check_lock(*part, self.document()))?;
        if let Some(lesson) = &mut document.lesson {
            lesson.given = Some(self.document().fingerprint(self.mesh()));
        }
        let before = self.state();
        let (document, handles, positions) = (Rc::new(document), handles.into(), positions.into());
        self.go_to_state(SessionState {
            rest: Rc::new(rest),
            scene: SceneState { document, handles, positions },
            iteration: before.iteration,
            last_run: None,
        })?;
        Ok(before)
    }

    /// Goes to another mesh, with a state of the scene on it.
    ///
    /// # Errors
    /// As [`Session::go_to_state`].
    fn go_to_mesh(&mut self, rest: Rc<RestMesh>, scene: SceneState) -> Result<(), Error> {
        let SceneState { document, handles, positions } = scene;
        document.validate(rest.mesh())?;
        check_lesson(&document, rest.mesh())?;
        check_presentation(&document, rest.mesh())?;
        let rows = resolve_rows(&document, rest.mesh(), rest.topology())?;
        let mut scene = SolvedScene::new(document, &rest, rows, handles.to_vec(), &positions)?;
        scene.follow_generation(self.scene.last_generation());
        (self.rest, self.scene) = (rest, scene);
        self.measured = MeasureCache::default();
        (self.met, self.meeting) = (None, None);
        self.search = Search::Scene;
        Ok(())
    }

    /// Leaves the search of a press where others than its hard constraints are asked for since the
    /// document `before`, also by undo: a run would ease those.
    fn leave_search_since(&mut self, before: &Scene) {
        if asks_otherwise(before, self.document()) {
            self.search = Search::Scene;
        }
    }

    /// The current state.
    pub(super) fn state(&self) -> SessionState {
        SessionState {
            rest: Rc::clone(&self.rest),
            scene: self.scene.state(),
            iteration: self.iteration(),
            last_run: self.last_run.clone().filter(|last| last.is_of(&self.scene)),
        }
    }

    /// Sets the iteration count after a jump to another state.
    fn arrive(&mut self, iteration: u32) {
        self.progress.go_to(iteration, self.scene.solver().energy());
    }
}
