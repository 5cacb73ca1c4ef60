//! Handles and weights of a solver: changed at the least cost.
//!
//! Moving a handle changes the gradient. Adding a few changes the factor along their paths in the
//! elimination tree. Anything else factors the matrix again, in the same order.

use super::super::SolveError;
use super::super::centred::relative;
use super::super::hold::{Handle, HandlePlaces, SoftHandles, pins};
use super::super::rank_one::Change;
use super::Solver;
use crate::mesh::Point;
use crate::scene::{Hold, Weights};

/// More handles at once than this are factored in: by then that costs less.
const MOST_CHANGES: usize = 16;

impl Solver {
    /// Replaces the handles, each vertex at most once, and the positions (`#V by 3`) if there are others;
    /// numbers and order stay. What has to be factored anew and is certain to be positive definite is
    /// factored by the next step.
    ///
    /// # Errors
    /// When the normal matrix is not positive definite.
    pub fn hold(
        &mut self,
        handles: Vec<Handle>,
        positions: Option<&[Point]>,
    ) -> Result<(), SolveError> {
        if self.factored && self.holds_alike(&handles) {
            self.handles = handles;
            self.place(positions);
            self.retarget();
            return Ok(());
        }
        if let Some(changes) = self.changes(&handles)
            && self.system.change(&changes)
        {
            let added = handles[self.handles.len()..].to_vec();
            for (place, handle) in handles.iter().enumerate().skip(self.handles.len()) {
                self.handle_places.insert(handle.vertex, place);
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
        let n = self.x.len();
        let node_of = &self.system.node_of()[..self.n_vertices];
        let (mut fixed, mut held, mut diagonal) = (vec![false; n], self.held.clone(), vec![0.0; n]);
        let padding = &self.system.node_of()[self.n_unknowns..];
        padding.iter().for_each(|&node| fixed[node as usize] = true);
        if let Some(close) = &self.energies.close {
            for (node, factor) in close.held() {
                held[node as usize] = true;
                diagonal[node as usize] = self.energies.weights.close * factor;
            }
        }
        self.corners.iter().for_each(|&(v, _)| fixed[node_of[v as usize] as usize] = true);
        for handle in &handles {
            let node = node_of[handle.vertex as usize] as usize;
            held[node] = true;
            match handle.hold {
                Hold::Soft { weight } => {
                    diagonal[node] += weight;
                    fixed[node] = false;
                }
                Hold::Fixed => fixed[node] = true,
            }
        }
        self.pinned = pins(node_of, self.system.parts(), &held);
        self.pinned.iter().for_each(|&v| fixed[node_of[v as usize] as usize] = true);
        let weights = self.energies.weights;
        let precision = self.accelerator.precision();
        self.factored = false;
        self.system.set_matrix(precision, &[weights.shape, weights.smooth], &diagonal, fixed)?;
        self.factored = true;
        self.handle_places = HandlePlaces::new(self.n_vertices, &handles);
        self.handles = handles;
        self.place(positions);
        self.retarget();
        Ok(())
    }

    /// Whether `handles` are those at hand but for their targets.
    fn holds_alike(&self, handles: &[Handle]) -> bool {
        let alike = |(a, b): (&Handle, &Handle)| a.vertex == b.vertex && a.hold == b.hold;
        handles.len() == self.handles.len() && handles.iter().zip(&self.handles).all(alike)
    }

    /// Whether other weights leave the energies as they are: those that are zero stay zero.
    pub fn can_reweigh(&self, weights: Weights) -> bool {
        let counts = |weights: Weights| {
            [weights.shape, weights.close, weights.smooth].map(|weight| weight > 0.0)
        };
        counts(weights) == counts(self.energies.weights)
    }

    /// Replaces the weights of Eq. 13 where [`Solver::can_reweigh`], and the rest as [`Solver::hold`];
    /// the factor is made anew.
    ///
    /// # Errors
    /// When the normal matrix is not positive definite.
    pub fn reweigh(
        &mut self,
        weights: Weights,
        handles: Vec<Handle>,
        positions: Option<&[Point]>,
    ) -> Result<(), SolveError> {
        assert!(self.can_reweigh(weights), "energies come and go with a new solver");
        self.energies.weights = weights;
        self.factored = false;
        self.hold(handles, positions)
    }

    /// What the matrix of `handles` has over the one at hand, if these are the handles at hand and a
    /// few more on vertices that are still free.
    fn changes(&self, handles: &[Handle]) -> Option<Vec<(u32, Change)>> {
        let added = handles.strip_prefix(&self.handles[..])?;
        if !self.factored || added.is_empty() || added.len() > MOST_CHANGES {
            return None;
        }
        let part = |v: u32| self.system.parts()[self.system.node_of()[v as usize] as usize];
        let change = |handle: &Handle| {
            // A corner of the boundary is fixed, and a part that a handle holds needs no pin: both
            // would become free.
            let frees = self.corners.iter().any(|&(corner, _)| corner == handle.vertex)
                || self.pinned.iter().any(|&pin| part(pin) == part(handle.vertex));
            let change = match handle.hold {
                Hold::Soft { weight } => Change::Weight(weight),
                Hold::Fixed => Change::Fix,
            };
            (!frees).then(|| (self.system.node_of()[handle.vertex as usize], change))
        };
        added.iter().map(change).collect()
    }

    /// Moves the targets of handles. Costs no factorisation: only the gradient changes.
    pub fn move_handles(&mut self, targets: impl IntoIterator<Item = (u32, Point)>) {
        for (vertex, target) in targets {
            if let Some(place) = self.handle_places.get(vertex) {
                self.handles[place].target = target;
            }
        }
        self.retarget();
    }

    /// Evaluates with the handles that were `added` to the others. Where these hold their vertices where
    /// they are, the projections at hand stay good.
    fn begin_holding(&mut self, added: &[Handle]) {
        if added.iter().any(|handle| handle.target != self.position(handle.vertex)) {
            self.retarget();
            return;
        }
        let node_of = &self.system.node_of()[..self.n_vertices];
        for handle in added.iter().filter(|handle| handle.hold == Hold::Fixed) {
            // What is left to move is rounding.
            self.x[node_of[handle.vertex as usize] as usize] = relative(handle.target, self.centre);
            self.put[handle.vertex as usize] = handle.target;
        }
        let energy =
            SoftHandles::new(added, node_of, self.centre).step(&self.x, &mut self.gradient);
        self.energy.handles += energy;
        self.energy.total += energy;
        self.system.clear_fixed(&mut self.gradient);
        self.energies.handles = SoftHandles::new(&self.handles, node_of, self.centre);
        self.start_anew();
    }

    /// Puts fixed vertices on their targets and evaluates anew.
    pub(super) fn retarget(&mut self) {
        let node_of = &self.system.node_of()[..self.n_vertices];
        let fixed = self.handles.iter().filter(|handle| handle.hold == Hold::Fixed);
        let fixed = fixed.map(|handle| (handle.vertex, handle.target));
        let is_handle = |v: u32| self.handle_places.get(v).is_some();
        let corners = self.corners.iter().copied().filter(|&(v, _)| !is_handle(v));
        for (vertex, target) in corners.chain(fixed) {
            self.x[node_of[vertex as usize] as usize] = relative(target, self.centre);
            self.put[vertex as usize] = target;
        }
        self.energies.handles = SoftHandles::new(&self.handles, node_of, self.centre);
        self.evaluate();
        self.start_anew();
    }

    /// The steps so far were taken in another problem.
    fn start_anew(&mut self) {
        self.forget();
        self.best = None;
        self.converged = false;
    }
}
