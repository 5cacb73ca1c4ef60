//! Changes of the handles and weights of a solver, at the least cost.
//!
//! Moving a handle changes only the gradient. Adding a few updates the factor along their paths in
//! the elimination tree. Any other change factors the matrix again, in the same order.

use super::Solver;
use crate::mesh::Point;
use crate::solve::energy::{Handle, HandleIndex, Hold, PositionalConstraints};
use crate::solve::error::SolveError;
use crate::solve::local_frame::relative;
use crate::solve::parts::Holding;
use crate::solve::settings::Weights;
use crate::sparse::Update;

/// Greatest number of handles added by updates; for more, factoring again costs less.
const MOST_UPDATES: usize = 16;

impl Solver {
    /// Replaces the handles, at most one for each vertex, and the positions (`#V by 3`) if given;
    /// numbers and order stay. A new matrix that is certain to be positive definite is factored by
    /// the next step.
    ///
    /// # Errors
    /// If the normal matrix is not positive definite.
    pub fn set_handles(
        &mut self,
        handles: Vec<Handle>,
        positions: Option<&[Point]>,
    ) -> Result<(), SolveError> {
        if self.factored && self.differ_only_in_targets(&handles) {
            self.handles = handles;
            self.place(positions);
            self.retarget();
            return Ok(());
        }
        if let Some(updates) = self.updates(&handles)
            && self.parts.system.update(&updates)
        {
            let added = handles[self.handles.len()..].to_vec();
            for (place, handle) in handles.iter().enumerate().skip(self.handles.len()) {
                self.handle_index.insert(handle.vertex, place);
            }
            self.handles = handles;
            if positions.is_some() {
                self.place(positions);
                self.retarget();
            } else {
                self.begin_holding(&added);
            }
            return Ok(());
        }
        let Holding { fixed, diagonal, pinned } = self.parts.holding(&handles);
        self.pinned = pinned;
        let weights = self.parts.energies.weights;
        let precision = self.descent.accelerator.precision(&self.parts.system);
        self.factored = false;
        self.parts.system.set_matrix(
            precision,
            &[weights.shape, weights.smooth],
            &diagonal,
            fixed,
        )?;
        self.factored = true;
        self.handle_index = HandleIndex::new(self.parts.n_vertices, &handles);
        self.handles = handles;
        self.place(positions);
        self.retarget();
        Ok(())
    }

    /// Whether `handles` differ from the current ones only in their targets.
    fn differ_only_in_targets(&self, handles: &[Handle]) -> bool {
        let alike = |(a, b): (&Handle, &Handle)| a.vertex == b.vertex && a.hold == b.hold;
        handles.len() == self.handles.len() && handles.iter().zip(&self.handles).all(alike)
    }

    /// The weights of Eq. 13.
    pub fn weights(&self) -> Weights {
        self.parts.energies.weights
    }

    /// Whether other weights keep the same energies: zero weights stay zero, others positive.
    pub fn can_reweigh(&self, weights: Weights) -> bool {
        let counts = |weights: Weights| {
            [weights.shape, weights.close, weights.smooth].map(|weight| weight > 0.0)
        };
        counts(weights) == counts(self.parts.energies.weights)
    }

    /// Replaces the weights of Eq. 13, if [`Solver::can_reweigh`], and the rest as
    /// [`Solver::set_handles`]; the matrix is factored again.
    ///
    /// # Errors
    /// If the normal matrix is not positive definite.
    pub fn reweigh(
        &mut self,
        weights: Weights,
        handles: Vec<Handle>,
        positions: Option<&[Point]>,
    ) -> Result<(), SolveError> {
        assert!(self.can_reweigh(weights), "energies come and go with a new solver");
        self.parts.energies.weights = weights;
        self.factored = false;
        self.set_handles(handles, positions)
    }

    /// Returns the diagonal updates that lead to the matrix of `handles`, if these are the current
    /// handles and a few more on free vertices.
    fn updates(&self, handles: &[Handle]) -> Option<Vec<(u32, Update)>> {
        let added = handles.strip_prefix(&self.handles[..])?;
        if !self.factored || added.is_empty() || added.len() > MOST_UPDATES {
            return None;
        }
        let component = |v: u32| {
            self.parts.system.components()[self.parts.system.node_of()[v as usize] as usize]
        };
        let update = |handle: &Handle| {
            // A handle on a fixed corner of the boundary, or in a component with a pin, would make
            // the corner or the pin free, which updates cannot do.
            let frees = self.parts.corners.iter().any(|&(corner, _)| corner == handle.vertex)
                || self.pinned.iter().any(|&pin| component(pin) == component(handle.vertex));
            let update = match handle.hold {
                Hold::Soft { weight } => Update::Weight(weight),
                Hold::Fixed => Update::Fix,
            };
            (!frees).then(|| (self.parts.system.node_of()[handle.vertex as usize], update))
        };
        added.iter().map(update).collect()
    }

    /// Moves the targets of handles, and returns whether one was elsewhere. Needs no factorisation:
    /// only the gradient changes.
    pub fn move_handles(&mut self, targets: impl IntoIterator<Item = (u32, Point)>) -> bool {
        let mut moved = false;
        for (vertex, target) in targets {
            if let Some(place) = self.handle_index.get(vertex) {
                moved |= self.handles[place].target != target;
                self.handles[place].target = target;
            }
        }
        if moved {
            self.retarget();
        }
        moved
    }

    /// Evaluates after handles were `added`. If their targets are the current positions, the
    /// current projections stay valid.
    fn begin_holding(&mut self, added: &[Handle]) {
        let stay = added.iter().all(|handle| handle.target == self.position(handle.vertex));
        if !stay || self.parts.gliding.is_some() {
            self.retarget();
            return;
        }
        let node_of = self.parts.node_of();
        for handle in added.iter().filter(|handle| handle.hold == Hold::Fixed) {
            // The target is this position up to rounding.
            self.x[node_of[handle.vertex as usize] as usize] =
                relative(handle.target, self.parts.centre);
            self.put[handle.vertex as usize] = handle.target;
        }
        let energy = PositionalConstraints::new(added, node_of, self.parts.centre)
            .step(&self.x, &mut self.descent.gradient);
        self.energy.handles += energy;
        self.energy.total += energy;
        self.parts.system.clear_fixed(&mut self.descent.gradient);
        self.parts.energies.handles =
            PositionalConstraints::new(&self.handles, node_of, self.parts.centre);
        self.start_anew();
    }

    /// Moves fixed vertices to their targets and evaluates again.
    pub(super) fn retarget(&mut self) {
        self.parts.place(&self.handles, &self.handle_index, &mut self.x, &mut self.put);
        self.evaluate();
        self.start_anew();
    }

    /// Forgets the steps so far, which were taken in another problem.
    fn start_anew(&mut self) {
        self.forget();
        self.best = None;
        self.converged = false;
    }
}
