//! The session itself: its parts, and plain access to them.

use super::measured::MeasureCache;
use super::run::{Collapse, LastRun, Meeting, Met, Progress, Search, TraceEntry};
use super::state::{ResolvedRow, RestMesh, SolvedScene};
use super::undo::{History, Transaction};
use crate::mesh::{Mesh, Point, Topology};
use crate::scene::Scene;
use crate::solve::Solver;
use std::rc::Rc;

/// An open scene.
pub struct Session {
    pub(super) rest: Rc<RestMesh>,
    pub(super) scene: SolvedScene,
    pub(super) progress: Progress,
    /// The document as it was opened, without handles and positions: a run of the same problem does
    /// what its author intends, even if it collapses. None if this does not hold.
    pub(super) opened: Option<Rc<Scene>>,
    /// The last run that led to the current shape, or to one before it.
    pub(super) last_run: Option<Rc<LastRun>>,
    pub(super) history: History,
    /// The drag, run or variation under way.
    pub(super) transaction: Option<Transaction>,
    pub(super) measured: MeasureCache,
    /// How the hard constraints were met, and the shape that this holds for.
    pub(super) met: Option<Met>,
    /// The solver by which the current run meets its hard constraints.
    pub(super) meeting: Option<Meeting>,
    /// What the current run may do to meet its hard constraints.
    pub(super) search: Search,
}

impl Session {
    /// The rest shape.
    pub fn mesh(&self) -> &Mesh {
        self.rest.mesh()
    }

    /// Number of meshes derived one after another from the opened one; 0 for the opened mesh. Those
    /// from which a reopened scene was derived count down from there, as `u32` wraps.
    pub fn mesh_generation(&self) -> u32 {
        self.rest.generation()
    }

    /// A sentence for each item that was not carried over from the previous mesh.
    pub fn lost(&self) -> &[String] {
        self.rest.lost()
    }

    /// The topology of the mesh.
    pub fn topology(&self) -> &Topology {
        self.rest.topology()
    }

    /// The solver at its current positions.
    pub fn solver(&self) -> &Solver {
        self.scene.solver()
    }

    /// Returns the solver alone, for callers that need only energies and gradients.
    pub fn into_solver(self) -> Solver {
        self.scene.into_solver()
    }

    /// The document without handles and positions, which the solver stores.
    pub fn document(&self) -> &Scene {
        self.scene.document()
    }

    /// The rows of constraints, resolved, in the order of the document.
    pub fn rows(&self) -> &[ResolvedRow] {
        self.scene.rows()
    }

    /// Current positions, `#V by 3`, in the unit of the mesh.
    pub fn positions(&self) -> Vec<Point> {
        self.scene.positions().to_vec()
    }

    /// Number of iterations from the start of the scene to the current shape; undo reduces it.
    pub fn iteration(&self) -> u32 {
        self.progress.iteration()
    }

    /// The recorded energies up to the current shape, ascending; empty if nothing is recorded.
    pub fn trace(&self) -> &[TraceEntry] {
        self.progress.trace().unwrap_or_default()
    }

    /// Whether the local step is done and the global step is not. Any other change of the shape or
    /// the scene resets this.
    pub fn halfway(&self) -> bool {
        self.progress.halfway()
    }

    /// How the run that ended with the current shape has collapsed it, if it has; see
    /// [`Session::end_run`].
    pub fn collapse(&self) -> Option<Collapse> {
        self.last_run.as_ref().filter(|last| last.is_of(&self.scene))?.collapse
    }

    /// Whether the last iteration changed the total by no more than the tolerance, or a run has met the
    /// hard constraints as well as it can. Always false for a collapsed shape.
    pub fn converged(&self) -> bool {
        (self.scene.solver().converged() || self.is_searched()) && self.collapse().is_none()
    }

    /// Whether a drag is under way; an edit that has an effect ends it.
    pub fn is_dragging(&self) -> bool {
        self.transaction.as_ref().is_some_and(Transaction::is_drag)
    }

    /// The names of the steps that undo and redo would apply. A variation that is shown is one of undo,
    /// and so is a run under way that is no part of the step before it: nothing is repeated after it.
    pub fn undo_and_redo(&self) -> [Option<&str>; 2] {
        let [undo, redo] = self.history.names();
        match &self.transaction {
            Some(now) if now.is_variation() => [Some(Transaction::VARIATION), redo],
            Some(now) if now.is_run() && !now.joins_last() => [Some("Run"), None],
            _ => [undo, redo],
        }
    }

    /// Sets the time that reading the files took, in seconds, for the report.
    pub fn set_load_seconds(&mut self, seconds: f64) {
        self.progress.load_seconds = seconds;
    }
}
