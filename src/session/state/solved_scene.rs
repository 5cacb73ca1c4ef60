//! A scene with its solver: its document, its resolved rows, its positions.

use super::part::Effect;
use super::rest_mesh::RestMesh;
use super::rows::{ResolvedRow, acts, resolve_rows};
use super::scene_change::{Draft, SceneChange, same_handles, same_positions};
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
    document: Scene,
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
        document: Scene,
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

    pub(crate) fn document(&self) -> &Scene {
        &self.document
    }

    pub(crate) fn into_document(self) -> Scene {
        self.document
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

    /// Returns a change that restores the current state.
    pub(crate) fn snapshot(&self) -> SceneChange {
        SceneChange {
            parts: Vec::new(),
            handles: Rc::clone(self.handles()),
            positions: Rc::clone(self.positions()),
        }
    }

    /// Applies the change that `propose` makes of a draft, and returns its result with the inverse
    /// change; none if nothing has changed.
    ///
    /// # Errors
    /// Those of `propose`, and as [`SolvedScene::exchange`]; nothing has changed then.
    pub(crate) fn edit<T>(
        &mut self,
        rest: &RestMesh,
        propose: impl FnOnce(&mut Draft<'_>) -> Result<T, SceneError>,
    ) -> Result<(T, Option<SceneChange>), Error> {
        let (done, mut change) = self.proposed(rest, propose)?;
        if !self.differs(&change) {
            return Ok((done, None));
        }
        self.follow(rest, &mut change)?;
        Ok((done, Some(change)))
    }

    /// Whether the change that `propose` makes of a draft would change anything; nothing has changed
    /// then.
    ///
    /// # Errors
    /// Those of `propose`, and where the document would not fit the mesh.
    pub(crate) fn would_change<T>(
        &mut self,
        rest: &RestMesh,
        propose: impl FnOnce(&mut Draft<'_>) -> Result<T, SceneError>,
    ) -> Result<bool, SceneError> {
        let (_, mut change) = self.proposed(rest, propose)?;
        let differs = self.differs(&change);
        let fits = match change.effect(&self.document) {
            Effect::Nothing => Ok(()),
            Effect::Weights | Effect::Problem => self.resolved(rest).map(|_| ()),
        };
        change.exchange_parts(&mut self.document);
        fits.map(|()| differs)
    }

    /// The rows of the document, which is checked with them.
    fn resolved(&self, rest: &RestMesh) -> Result<Vec<ResolvedRow>, SceneError> {
        self.document.validate(rest.mesh())?;
        resolve_rows(&self.document, rest.mesh(), rest.topology())
    }

    /// Changes the document as `propose` does with a draft, and returns its result with the parts as
    /// they were and the new handles and positions.
    ///
    /// # Errors
    /// Those of `propose`; nothing has changed then.
    fn proposed<T>(
        &mut self,
        rest: &RestMesh,
        propose: impl FnOnce(&mut Draft<'_>) -> Result<T, SceneError>,
    ) -> Result<(T, SceneChange), SceneError> {
        let change = self.snapshot();
        let mut draft = Draft { document: &mut self.document, mesh: rest.mesh(), change };
        let proposed = propose(&mut draft);
        let mut change = draft.change;
        match proposed {
            Ok(done) => {
                change.parts.retain(|part| !part.is_in(&self.document));
                Ok((done, change))
            }
            Err(error) => {
                change.exchange_parts(&mut self.document);
                Err(error)
            }
        }
    }

    /// Whether a proposed change has any part, or other handles or positions.
    fn differs(&self, change: &SceneChange) -> bool {
        !change.parts.is_empty()
            || !same_handles(&change.handles, self.handles())
            || !same_positions(&change.positions, self.positions())
    }

    /// Applies a change to the state, and turns the change into its inverse.
    ///
    /// # Errors
    /// When the document does not fit the mesh, or the system is singular; nothing has changed then.
    pub(crate) fn exchange(
        &mut self,
        rest: &RestMesh,
        change: &mut SceneChange,
    ) -> Result<(), Error> {
        change.exchange_parts(&mut self.document);
        self.follow(rest, change)
    }

    /// Completes an exchange after that of the parts of `change`: exchanges handles and positions,
    /// and updates the solver.
    fn follow(&mut self, rest: &RestMesh, change: &mut SceneChange) -> Result<(), Error> {
        let SceneChange { handles, positions, .. } = self.snapshot();
        let new_handles = !same_handles(&change.handles, &handles);
        let new_positions = !same_positions(&change.positions, &positions);
        let effect = change.effect(&self.document);
        if effect == Effect::Nothing && !new_handles && !new_positions {
            return Ok(());
        }
        let to = (
            new_handles.then(|| change.handles.to_vec()),
            new_positions.then_some(&*change.positions),
        );
        if let Err(error) = self.set_up_again(rest, effect, to) {
            change.exchange_parts(&mut self.document);
            return Err(error);
        }
        self.positions.take();
        self.handles.take();
        let there = std::mem::replace(&mut change.positions, positions);
        // They may differ if the solver moved vertices itself, such as the corners of a boundary.
        if self
            .solver
            .positions()
            .zip(&*there)
            .all(|(a, b)| a.map(f64::to_bits) == b.map(f64::to_bits))
        {
            self.positions = there.into();
        }
        self.handles = std::mem::replace(&mut change.handles, handles).into();
        Ok(())
    }

    /// Updates solver and rows to the document, and to these handles and positions (`#V by 3`) if
    /// they are given, at the least cost.
    fn set_up_again(
        &mut self,
        rest: &RestMesh,
        effect: Effect,
        (handles, positions): (Option<Vec<Handle>>, Option<&[Point]>),
    ) -> Result<(), Error> {
        let weights = self.document.weights;
        match effect {
            Effect::Nothing => match handles {
                Some(handles) => {
                    let old = self.solver.handles().to_vec();
                    if let Err(error) = self.solver.hold(handles, positions) {
                        self.solver.hold(old, None)?;
                        return Err(error.into());
                    }
                }
                None => positions.into_iter().for_each(|to| self.solver.set_positions(to)),
            },
            Effect::Weights if self.solver.can_reweigh(weights) => {
                self.document.validate(rest.mesh())?;
                let (old, old_weights) = (self.solver.handles().to_vec(), self.solver.weights());
                let handles = handles.unwrap_or_else(|| old.clone());
                if let Err(error) = self.solver.reweigh(weights, handles, positions) {
                    self.solver.reweigh(old_weights, old, None)?;
                    return Err(error.into());
                }
            }
            Effect::Weights | Effect::Problem => {
                let rows = self.resolved(rest)?;
                let handles = handles.unwrap_or_else(|| self.solver.handles().to_vec());
                let positions = positions.unwrap_or_else(|| self.positions());
                let cache = self.solver.setup_cache();
                self.solver = set_up(&self.document, rest, &rows, cache, handles, positions)?;
                self.rows = rows;
            }
        }
        self.renew();
        Ok(())
    }
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
