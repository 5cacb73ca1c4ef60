//! A scene with its solver: its document, its resolved rows, its positions.

use super::comparison::Effect;
use super::rest_mesh::RestMesh;
use super::rows::{ResolvedRow, acts, resolve_rows};
use super::scene_state::{Draft, SceneState, same_handles, same_positions};
use crate::constraint::Projected;
use crate::mesh::Point;
use crate::scene::{Scene, SceneError};
use crate::session::Error;
use crate::solve::{Constraints, Handle, SetupCache, Solver};
use std::cell::OnceCell;
use std::rc::Rc;

/// A scene with its solver on a mesh; all methods need the same [`RestMesh`].
pub(crate) struct SolvedScene {
    /// Without handles and positions, which the solver stores.
    document: Rc<Scene>,
    /// The resolved rows of the document.
    rows: Vec<ResolvedRow>,
    solver: Solver,
    /// Handles and positions of the solver, cached until they change.
    positions: OnceCell<Rc<[Point]>>,
    handles: OnceCell<Rc<[Handle]>>,
    /// The number of the current problem, handles and positions.
    generation: u32,
    /// The last number that was given.
    last_generation: u32,
}

impl SolvedScene {
    /// Sets up the solver at the positions `start`, `#V by 3`.
    ///
    /// # Errors
    /// When the system is singular.
    pub(crate) fn new(
        document: Rc<Scene>,
        rest: &RestMesh,
        rows: Vec<ResolvedRow>,
        handles: Vec<Handle>,
        start: &[Point],
    ) -> Result<SolvedScene, Error> {
        let solver = set_up(&document, rest, &rows, SetupCache::default(), handles, start)?;
        let (positions, handles) = (OnceCell::new(), OnceCell::new());
        Ok(SolvedScene {
            document,
            rows,
            solver,
            positions,
            handles,
            generation: 0,
            last_generation: 0,
        })
    }

    /// A number that is another one after every change of the problem, the handles or the positions.
    pub(crate) fn generation(&self) -> u32 {
        self.generation
    }

    /// The last number that was given.
    pub(crate) fn last_generation(&self) -> u32 {
        self.last_generation
    }

    /// Goes on with the numbers after `last`, which that of the scene before this one was given.
    pub(crate) fn follow_generation(&mut self, last: u32) {
        self.last_generation = last;
        self.renew();
    }

    /// Gives problem, handles and positions their number again, after they were changed and
    /// restored.
    pub(crate) fn restored(&mut self, generation: u32) {
        self.generation = generation;
    }

    /// Gives the current problem, handles and positions a new number.
    fn renew(&mut self) {
        self.last_generation += 1;
        self.generation = self.last_generation;
    }

    /// Clears the cached positions after a change of those of the solver.
    fn forget_positions(&mut self) {
        self.positions.take();
        self.renew();
    }

    pub(crate) fn document(&self) -> &Rc<Scene> {
        &self.document
    }

    pub(crate) fn rows(&self) -> &[ResolvedRow] {
        &self.rows
    }

    /// Returns the indices of the enabled rows, which are the rows of the solver.
    pub(crate) fn enabled_rows(&self) -> impl Iterator<Item = usize> {
        self.rows.iter().enumerate().filter(|(_, row)| row.enabled).map(|(index, _)| index)
    }

    pub(crate) fn solver(&self) -> &Solver {
        &self.solver
    }

    pub(crate) fn into_solver(self) -> Solver {
        self.solver
    }

    /// The handles: the same allocation until they change.
    pub(crate) fn handles(&self) -> &Rc<[Handle]> {
        self.handles.get_or_init(|| self.solver.handles().into())
    }

    /// Current positions, `#V by 3`: the same allocation until they change.
    pub(crate) fn positions(&self) -> &Rc<[Point]> {
        self.positions.get_or_init(|| self.solver.positions().collect())
    }

    /// The row whose constraints are farthest from being met, as found by the last local step, and this
    /// distance in the unit of the mesh. None if vertices are drawn to no row: the distance to one that
    /// does not act says nothing.
    pub(crate) fn worst_row(&self) -> Option<(usize, f64)> {
        let rows = self.enabled_rows().zip(self.solver.found());
        rows.filter(|(row, _)| acts(&self.document.constraints[*row], &self.document))
            .map(|(row, found)| (row, found.worst_squared.sqrt()))
            .reduce(|worst, other| if other.1 > worst.1 { other } else { worst })
    }

    /// See [`Solver::projected`].
    pub(crate) fn projected(&mut self, each: impl FnMut(usize, &Projected)) {
        self.solver.projected(each);
    }

    /// Runs one iteration.
    ///
    /// # Errors
    /// If a position is not finite; the shape is then that before the step.
    pub(crate) fn step(&mut self) -> Result<(), Error> {
        self.forget_positions();
        Ok(self.solver.step()?)
    }

    /// See [`Solver::settle`].
    pub(crate) fn settle(&mut self) {
        self.forget_positions();
        self.solver.settle();
    }

    /// Sets the positions, `#V by 3`.
    pub(crate) fn show(&mut self, positions: &[Point]) {
        self.forget_positions();
        self.solver.set_positions(positions);
    }

    /// See [`Solver::move_handles`].
    pub(crate) fn move_handles(&mut self, targets: impl IntoIterator<Item = (u32, Point)>) {
        if self.solver.move_handles(targets) {
            self.handles.take();
            self.forget_positions();
        }
    }

    /// The current state.
    pub(crate) fn state(&self) -> SceneState {
        SceneState {
            document: Rc::clone(&self.document),
            handles: Rc::clone(self.handles()),
            positions: Rc::clone(self.positions()),
        }
    }

    /// The current document, if this one is equal to it, so that states share it.
    pub(crate) fn shared(&self, document: Scene) -> Rc<Scene> {
        if document == *self.document { Rc::clone(&self.document) } else { Rc::new(document) }
    }

    /// Goes to the state that `propose` makes of a draft, and returns its result, and whether anything
    /// has changed.
    ///
    /// # Errors
    /// Those of `propose`, and as [`SolvedScene::go_to`]; nothing has changed then.
    pub(crate) fn edit<T>(
        &mut self,
        rest: &RestMesh,
        propose: impl FnOnce(&mut Draft<'_>) -> Result<T, SceneError>,
    ) -> Result<(T, bool), Error> {
        let (done, state) = self.proposed(rest, propose)?;
        let differs = self.differs(&state);
        if differs {
            self.go_to(rest, state)?;
        }
        Ok((done, differs))
    }

    /// Whether the state that `propose` makes of a draft differs from the current one.
    ///
    /// # Errors
    /// Those of `propose`, and where the document would not fit the mesh.
    pub(crate) fn would_change<T>(
        &self,
        rest: &RestMesh,
        propose: impl FnOnce(&mut Draft<'_>) -> Result<T, SceneError>,
    ) -> Result<bool, SceneError> {
        let (_, state) = self.proposed(rest, propose)?;
        if Effect::between(&self.document, &state.document) != Effect::Nothing {
            resolved(&state.document, rest)?;
        }
        Ok(self.differs(&state))
    }

    /// Returns what `propose` returns, and the state that it makes of a draft.
    ///
    /// # Errors
    /// Those of `propose`.
    fn proposed<T>(
        &self,
        rest: &RestMesh,
        propose: impl FnOnce(&mut Draft<'_>) -> Result<T, SceneError>,
    ) -> Result<(T, SceneState), SceneError> {
        let before = &*self.document;
        let SceneState { handles, positions, .. } = self.state();
        let document = before.clone();
        let mut draft = Draft { before, document, rest, handles, positions, iteration: None };
        let done = propose(&mut draft)?;
        let Draft { document, handles, positions, .. } = draft;
        Ok((done, SceneState { document: self.shared(document), handles, positions }))
    }

    /// Whether a proposed state has another document, handles or positions.
    fn differs(&self, state: &SceneState) -> bool {
        !Rc::ptr_eq(&state.document, &self.document)
            || !same_handles(&state.handles, self.handles())
            || !same_positions(&state.positions, self.positions())
    }

    /// Goes to another state on the same mesh.
    ///
    /// # Errors
    /// When the document does not fit the mesh, or the system is singular; nothing has changed then.
    pub(crate) fn go_to(&mut self, rest: &RestMesh, state: SceneState) -> Result<(), Error> {
        let SceneState { document, handles, positions } = state;
        let new_handles = !same_handles(&handles, self.handles());
        let new_positions = !same_positions(&positions, self.positions());
        let effect = if Rc::ptr_eq(&document, &self.document) {
            Effect::Nothing
        } else {
            Effect::between(&self.document, &document)
        };
        if effect == Effect::Nothing && !new_handles && !new_positions {
            self.document = document;
            return Ok(());
        }
        let to = (new_handles.then(|| handles.to_vec()), new_positions.then_some(&*positions));
        self.set_up_again(rest, &document, effect, to)?;
        self.positions.take();
        self.handles.take();
        self.document = document;
        // They may differ if the solver moved vertices itself, such as the corners of a boundary.
        let is_same = |(a, b): (Point, &Point)| a.map(f64::to_bits) == b.map(f64::to_bits);
        if self.solver.positions().zip(&*positions).all(is_same) {
            self.positions = positions.into();
        }
        self.handles = handles.into();
        Ok(())
    }

    /// Updates solver and rows to `document`, which has this `effect`, and to these handles and positions
    /// (`#V by 3`) if they are given, at the least cost.
    fn set_up_again(
        &mut self,
        rest: &RestMesh,
        document: &Scene,
        effect: Effect,
        (handles, positions): (Option<Vec<Handle>>, Option<&[Point]>),
    ) -> Result<(), Error> {
        let weights = document.weights;
        match effect {
            Effect::Nothing => match handles {
                Some(handles) => {
                    let old = self.solver.handles().to_vec();
                    if let Err(error) = self.solver.set_handles(handles, positions) {
                        self.solver.set_handles(old, None)?;
                        return Err(error.into());
                    }
                }
                None => positions.into_iter().for_each(|to| self.solver.set_positions(to)),
            },
            Effect::Weights if self.solver.can_reweigh(weights) => {
                document.validate(rest.mesh())?;
                let (old, old_weights) = (self.solver.handles().to_vec(), self.solver.weights());
                let handles = handles.unwrap_or_else(|| old.clone());
                if let Err(error) = self.solver.reweigh(weights, handles, positions) {
                    self.solver.reweigh(old_weights, old, None)?;
                    return Err(error.into());
                }
            }
            Effect::Weights | Effect::Problem => {
                let rows = resolved(document, rest)?;
                let handles = handles.unwrap_or_else(|| self.solver.handles().to_vec());
                let positions = positions.unwrap_or_else(|| self.positions());
                let cache = self.solver.setup_cache();
                self.solver = set_up(document, rest, &rows, cache, handles, positions)?;
                self.rows = rows;
            }
        }
        self.renew();
        Ok(())
    }
}

/// The rows of a document, which is checked with them.
fn resolved(document: &Scene, rest: &RestMesh) -> Result<Vec<ResolvedRow>, SceneError> {
    document.validate(rest.mesh())?;
    resolve_rows(document, rest.mesh(), rest.topology())
}

/// Sets up a solver for the enabled rows.
fn set_up(
    document: &Scene,
    rest: &RestMesh,
    rows: &[ResolvedRow],
    cache: SetupCache,
    handles: Vec<Handle>,
    start: &[Point],
) -> Result<Solver, Error> {
    let (mesh, topology) = (rest.mesh(), rest.topology());
    let constraints: Vec<Constraints> =
        rows.iter().filter(|row| row.enabled).map(|row| row.constraints.clone()).collect();
    let closeness_factors = document.closeness.factors(mesh, topology, &document.sets)?;
    let problem = document.problem(mesh, topology, &constraints, &closeness_factors);
    Ok(Solver::new(&problem, cache, handles, start)?)
}
