//! What every host drives: open, edit, drag, step, undo, report.
//!
//! A session holds one mesh and one document (constraints, handles, weights), and a solver for
//! it. Every edit is one step of undo; iterating from one point to another is one step too.
//!
//! | file | holds |
//! |---|---|
//! | `edit` | the edits, and what each one costs |
//! | `resolve` | rows of constraints: selectors resolved, misfits counted |
//! | `flaws` | elements that have something wrong |
//! | `halves` | an iteration in its two halves |
//! | `history` | undo and redo |
//! | `acting` | which row of constraints each face and vertex belongs to |
//! | `angles` | the angles at the corners of the faces |
//! | `face_measure` | the numbers per face that hosts colour and list |
//! | `holding` | how much single vertices are kept close |
//! | `inspect` | what hosts show of a session: members of constraints |
//! | `lesson` | the goals of a lesson, and the results that are handed in |
//! | `opening` | opening a scene in the place of another |
//! | `pace` | how large a mesh can be that is still worked with at once |
//! | `preview` | what adding constraints would make |
//! | `projected` | the projections of the constraints, to be drawn |
//! | `report` | the report of design section 6 |
//! | `same_problem` | which changes of a document the solver need not know of |
//! | `selection` | selecting by what the mesh is like |
//! | `settings` | the declared settings of a scene |
//! | `tables` | errors and energies as CSV |
//! | `trace` | the energies of the iterations |
//! | `worst` | the elements that are farthest from what is asked of them |

mod acting;
mod angles;
mod edit;
mod face_measure;
mod flaws;
mod halves;
mod history;
mod holding;
mod inspect;
mod lesson;
mod opening;
mod pace;
mod preview;
mod projected;
mod report;
mod resolve;
mod same_problem;
mod selection;
mod settings;
mod tables;
mod trace;
mod worst;

pub use acting::ActingRows;
pub use edit::{Edit, NewConstraint, Place};
pub use face_measure::{FACE_MEASURES, FaceMeasure, MeasureUnit, Shape};
pub use flaws::{ZERO_SIZE_FACES, flaw_of};
pub use halves::{Fits, Half};
pub use lesson::{GoalWords, check_results, goals_in_words};
pub use pace::most_faces;
pub use preview::Preview;
pub use projected::Projections;
pub use report::{EnergyReport, Report, Seconds, TraceEntry};
pub use resolve::ResolvedRow;
pub use selection::{Mode, OPERATIONS, Operation, SelectRequest, Selection};
pub use settings::{SETTINGS, Setting, settings_of};
pub use worst::WorstElement;

use crate::error::Error;
use crate::mesh::{Mesh, Point, Topology, write_obj};
use crate::scene::{Frame, HandleSpec, Hold, Scene};
use crate::solve::{Constraints, Energy, Handle, Kept, Problem, Solver};
use history::{History, Snapshot};
use trace::Trace;

/// A scene that is open.
pub struct Session {
    mesh: Mesh,
    topology: Topology,
    /// Of the bounding sphere of the rest shape.
    diameter: f64,
    /// Without handles and current positions: these are the solver's.
    document: Scene,
    rows: Vec<ResolvedRow>,
    solver: Solver,
    /// See [`Session::iteration`].
    iteration: u32,
    initial: Energy,
    trace: Option<Trace>,
    load_seconds: f64,
    history: History,
    gesture: Option<Gesture>,
    /// See [`Session::halfway`].
    halfway: bool,
}

/// A drag or a run that has begun and is not yet a step of undo.
struct Gesture {
    kind: GestureKind,
    before: Snapshot,
}

#[derive(PartialEq)]
enum GestureKind {
    Drag,
    Run,
}

/// What one iteration did.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step {
    /// Whether the total changed by no more than the tolerance.
    pub converged: bool,
}

impl Session {
    /// Checks the scene against `mesh`, which is what `scene.mesh` stands for, and sets up the solver.
    ///
    /// # Errors
    /// When the scene does not fit the mesh, a row of constraints is empty, or the system is singular.
    pub fn open(scene: Scene, mesh: Mesh) -> Result<Session, Error> {
        opening::Checked::new(scene, mesh)?.open()
    }

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
        self.iteration
    }

    /// Counts on from `iteration`, for a scene that is opened again where it stood.
    pub fn restore_iteration(&mut self, iteration: u32) {
        self.iteration = iteration;
        if self.trace.is_some() {
            self.start_trace();
        }
    }

    /// The current shape as the text of an OBJ file, with the unit and the axis that are known.
    pub fn obj(&self) -> String {
        let comments = Frame::comments(&self.document.units, self.document.up);
        comments + &write_obj(&self.mesh, &self.positions())
    }

    /// The scene as it stands, with current positions when they are not at rest.
    pub fn scene(&self) -> Scene {
        let mut scene = self.document.clone();
        let positions = self.positions();
        scene.current = (positions != self.mesh.positions).then_some(positions);
        scene.handles = grouped(self.solver.handles());
        scene
    }

    /// One iteration.
    ///
    /// # Errors
    /// When a position leaves the finite numbers; the shape is then that before the step.
    pub fn step(&mut self) -> Result<Step, Error> {
        self.halfway = false;
        self.solver.step()?;
        self.iteration += 1;
        let entry = self.trace_entry();
        if let Some(trace) = &mut self.trace {
            trace.push(entry);
        }
        Ok(Step { converged: self.solver.converged() })
    }

    /// Iterates until the tolerance or the limit of the scene is reached.
    ///
    /// # Errors
    /// As [`Session::step`].
    pub fn solve(&mut self, trace: bool) -> Result<(), Error> {
        if trace {
            self.start_trace();
        }
        for _ in 0..self.document.solver.iterations {
            if self.step()?.converged {
                break;
            }
        }
        self.solver.settle();
        Ok(())
    }

    /// Records the energies of every iteration from here on, this one included.
    pub fn start_trace(&mut self) {
        self.trace = Some(Trace::from(self.trace_entry()));
    }

    /// The energies recorded since the last call.
    pub fn take_trace(&mut self) -> Vec<TraceEntry> {
        self.trace.as_mut().map(Trace::news).unwrap_or_default()
    }

    fn trace_entry(&self) -> TraceEntry {
        TraceEntry::new(self.iteration, self.solver.energy())
    }

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
            self.gesture = None;
        }
        made
    }

    /// Whether a drag has begun and not ended; an edit ends it.
    pub fn is_dragging(&self) -> bool {
        self.gesture.as_ref().is_some_and(|gesture| gesture.kind == GestureKind::Drag)
    }

    /// Moves the targets of handles.
    pub fn drag(&mut self, targets: impl IntoIterator<Item = (u32, Point)>) {
        self.solver.move_handles(targets);
    }

    /// Ends a drag: keeps it as one step of undo, or puts everything back.
    pub fn end_drag(&mut self, keep: bool) {
        let Some(gesture) = self.gesture.take_if(|g| g.kind == GestureKind::Drag) else {
            return;
        };
        let before = &gesture.before.handles;
        let now = self.solver.handles();
        if !keep {
            self.go_to(gesture.before).expect("the state was solvable before");
        } else if before.len() != now.len() {
            self.history.push("Make and move handle".to_owned(), gesture.before);
        } else {
            let moved = before.iter().zip(now).filter(|(before, now)| before != now).count();
            let name = match moved {
                0 => return,
                1 => "Move handle".to_owned(),
                _ => format!("Move {moved} handles"),
            };
            self.history.push(name, gesture.before);
        }
    }

    /// Begins a run: iterations up to [`Session::end_run`] are one step of undo.
    pub fn begin_run(&mut self) {
        if self.gesture.is_none() {
            self.begin(GestureKind::Run);
        }
    }

    /// Ends a run, at the lowest total that it saw.
    pub fn end_run(&mut self) {
        let Some(gesture) = self.gesture.take_if(|g| g.kind == GestureKind::Run) else {
            return;
        };
        self.solver.settle();
        let iterations = self.iteration - gesture.before.iteration;
        if iterations > 0 {
            let plural = if iterations == 1 { "" } else { "s" };
            self.history.push(format!("Run, {iterations} iteration{plural}"), gesture.before);
        }
    }

    /// Counts on from `iteration` after a jump to a state from before or after.
    fn arrive(&mut self, iteration: u32) {
        self.iteration = iteration;
        self.halfway = false;
        let entry = self.trace_entry();
        if let Some(trace) = &mut self.trace {
            trace.go_to(entry);
        }
    }

    fn begin(&mut self, kind: GestureKind) {
        self.end_run();
        self.end_drag(true);
        self.gesture = Some(Gesture { kind, before: self.snapshot() });
        self.halfway = false;
    }

    /// Seconds that reading the files took, for the report.
    pub fn set_load_seconds(&mut self, seconds: f64) {
        self.load_seconds = seconds;
    }
}

/// Sets up a solver for the enabled rows.
fn solver(
    document: &Scene,
    mesh: &Mesh,
    topology: &Topology,
    rows: &[ResolvedRow],
    kept: Kept,
    handles: Vec<Handle>,
    start: &[Point],
) -> Result<Solver, Error> {
    let constraints: Vec<Constraints> =
        rows.iter().filter(|row| row.enabled).map(|row| row.constraints.clone()).collect();
    let closeness_factors = document.closeness.factors(mesh, topology, &document.sets)?;
    let problem = Problem {
        mesh,
        topology,
        constraints: &constraints,
        weights: document.weights,
        closeness: &document.closeness,
        closeness_factors: &closeness_factors,
        smoothness: document.smoothness,
        settings: document.solver,
    };
    Ok(Solver::new(&problem, kept, handles, start)?)
}

/// One handle per vertex.
fn flat(specs: &[HandleSpec], rest: &[Point]) -> Vec<Handle> {
    let mut handles = Vec::new();
    for spec in specs {
        for (k, &vertex) in spec.vertices.iter().enumerate() {
            let target = spec.targets.as_ref().map_or(rest[vertex as usize], |targets| targets[k]);
            handles.push(Handle { vertex, target, hold: spec.hold });
        }
    }
    handles
}

/// Runs of handles that hold alike, as the scene file lists them.
fn grouped(handles: &[Handle]) -> Vec<HandleSpec> {
    let alike = |a: &Handle, b: &Handle| match (a.hold, b.hold) {
        (Hold::Fixed, Hold::Fixed) => true,
        (Hold::Soft { weight: a }, Hold::Soft { weight: b }) => a == b,
        _ => false,
    };
    handles
        .chunk_by(alike)
        .map(|run| HandleSpec {
            vertices: run.iter().map(|handle| handle.vertex).collect(),
            targets: Some(run.iter().map(|handle| handle.target).collect()),
            hold: run[0].hold,
        })
        .collect()
}
