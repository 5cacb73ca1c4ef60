//! The session itself: what it is made of, and plain access to that.

use super::report::MeasureCache;
use super::run::{Collapse, CollapseGuard, Meeting, Met, Progress, TraceEntry, Unfolding};
use super::state::{ResolvedRow, RestMesh, SolvedScene};
use super::undo::{History, Transaction};
use crate::mesh::{Mesh, Point, Topology};
use crate::scene::Scene;
use crate::solve::Solver;

/// A scene that is open.
pub struct Session {
    pub(super) rest: RestMesh,
    pub(super) scene: SolvedScene,
    pub(super) progress: Progress,
    pub(super) guard: CollapseGuard,
    pub(super) history: History,
    /// The drag or run that is under way.
    pub(super) transaction: Option<Transaction>,
    pub(super) measured: MeasureCache,
    /// How hard constraints were met, and the shape of which that is true.
    pub(super) met: Option<Met>,
    /// The same of the shape before the variation that is shown.
    pub(super) met_before: Option<Met>,
    /// The hard constraints that the run under way is meeting.
    pub(super) meeting: Option<Meeting>,
    /// What may be done for it not to fold faces.
    pub(super) unfolding: Unfolding,
}

impl Session {
    /// The rest shape.
    pub fn mesh(&self) -> &Mesh {
        self.rest.mesh()
    }

    /// How many meshes the mesh was made through from the one that was opened: 0 for that one.
    pub fn generation(&self) -> u32 {
        self.rest.generation()
    }

    /// A sentence for each thing that was not carried over from the mesh before.
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

    /// The solver alone, for callers that need energies and gradients only.
    pub fn into_solver(self) -> Solver {
        self.scene.into_solver()
    }

    /// The document without handles and positions, which are the solver's.
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

    /// Iterations from where the scene starts to the current shape; undo takes them back.
    pub fn iteration(&self) -> u32 {
        self.progress.iteration()
    }

    /// The recorded energies that led to the current shape, ascending; none where nothing is recorded.
    pub fn trace(&self) -> &[TraceEntry] {
        self.progress.trace().unwrap_or_default()
    }

    /// Whether the local step is done and the global step is not. Whatever else changes the shape or
    /// the scene ends it.
    pub fn halfway(&self) -> bool {
        self.progress.halfway()
    }

    /// How the shape has collapsed since iterating began, if it has.
    pub fn collapse(&self) -> Option<Collapse> {
        self.guard.collapse()
    }

    /// Whether the last iteration changed the total by no more than the tolerance, or hard constraints are
    /// met; never of a shape that has collapsed.
    pub fn converged(&self) -> bool {
        (self.scene.solver().converged() || self.is_met()) && self.collapse().is_none()
    }

    /// Whether a drag has begun and not ended; an edit ends it.
    pub fn is_dragging(&self) -> bool {
        self.transaction.as_ref().is_some_and(Transaction::is_drag)
    }

    /// The names of the steps that undo and redo would take.
    pub fn undo_and_redo(&self) -> [Option<&str>; 2] {
        self.history.names()
    }

    /// Seconds that reading the files took, for the report.
    pub fn set_load_seconds(&mut self, seconds: f64) {
        self.progress.set_load_seconds(seconds);
    }
}
