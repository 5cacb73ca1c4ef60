//! The session itself: what it holds, and plain access to it.

use super::measured::Measured;
use super::rows::ResolvedRow;
use super::run_state::RunState;
use crate::mesh::{Mesh, Point, Topology};
use crate::scene::Scene;
use crate::solve::Solver;
use std::cell::RefCell;

/// A scene that is open.
pub struct Session {
    pub(in crate::session) mesh: Mesh,
    pub(in crate::session) topology: Topology,
    /// Of the bounding sphere of the rest shape.
    pub(in crate::session) diameter: f64,
    /// Without handles and current positions: these are the solver's.
    pub(in crate::session) document: Scene,
    pub(in crate::session) rows: Vec<ResolvedRow>,
    pub(in crate::session) solver: Solver,
    pub(in crate::session) run_state: RunState,
    pub(in crate::session) measured: RefCell<Measured>,
    /// See [`Session::halfway`].
    pub(in crate::session) halfway: bool,
}

impl Session {
    /// The rest shape.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }
    /// Its topology.
    pub fn topology(&self) -> &Topology {
        &self.topology
    }
    /// The solver at its current positions.
    pub fn solver(&self) -> &Solver {
        &self.solver
    }
    /// The solver alone, for whom only energies and gradients matter.
    pub fn into_solver(self) -> Solver {
        self.solver
    }
    /// The document; its handles are those of the solver.
    pub fn document(&self) -> &Scene {
        &self.document
    }
    /// The rows of constraints, resolved, in the order of the document.
    pub fn rows(&self) -> &[ResolvedRow] {
        &self.rows
    }
    /// Current positions, `#V by 3`.
    pub fn positions(&self) -> Vec<Point> {
        self.solver.positions().collect()
    }
    /// Iterations from where the scene starts to the current shape; undo takes them back.
    pub fn iteration(&self) -> u32 {
        self.run_state.iteration
    }

    /// Seconds that reading the files took, for the report.
    pub fn set_load_seconds(&mut self, seconds: f64) {
        self.run_state.load_seconds = seconds;
    }
}
