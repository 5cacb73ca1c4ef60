//! What every host drives: open, edit, drag, step, undo, report.
//!
//! A session holds one mesh and one document (constraints, handles, weights), and a solver for
//! it. Every edit is one step of undo; iterating from one point to another is one step too.
//!
//! | file | holds |
//! |---|---|
//! | `collapse` | the guard against a shape that collapses while nobody drags |
//! | `edit`, `apply` | the edits, and what each does to a state |
//! | `edit_json` | what hosts ask for, from JSON |
//! | `transition` | from one state to another at the least cost: edits, undo, redo |
//! | `free` | vertices that nothing acts on |
//! | `gesture` | drags and runs, one step of undo each |
//! | `resolve` | rows of constraints: selectors resolved, misfits counted |
//! | `flaws` | elements that have something wrong |
//! | `halves` | an iteration in its two halves |
//! | `history`, `past` | the steps of undo and redo, and all else that has happened |
//! | `acting` | which row of constraints each face and vertex belongs to |
//! | `angles` | the angles at the corners of the faces |
//! | `face_measure` | the numbers per face that hosts colour and list |
//! | `holding` | how much single vertices are kept close |
//! | `inspect` | what hosts show of a row: its members, its measure; and what is held otherwise |
//! | `lesson` | the goals of a lesson, and the results that are handed in |
//! | `make_panels` | one press for all panels: asked for one shape, and run until they are within a tolerance |
//! | `moved` | what the shape has cost: how far vertices moved, how much edges shrank |
//! | `measured` | what was measured of the current shape, kept as long as it stays |
//! | `opening` | opening a scene in the place of another |
//! | `pace` | how large a mesh can be that is still worked with at once |
//! | `place`, `place_shape` | where constraints may be; what a place is like, for the usual kind |
//! | `preview` | what adding constraints would make |
//! | `projected` | the projections of the constraints, to be drawn |
//! | `remedies` | changes that help where constraints are not met |
//! | `report` | the report of a solved scene |
//! | `saved` | steps of undo and unfinished work as bytes, to go on after a restart |
//! | `selection` | selecting by what the mesh is like |
//! | `settings` | the declared settings of a scene |
//! | `tables` | errors and energies as CSV |
//! | `trace` | the energies of the iterations |
//! | `verdict` | how many panels are as asked, within which tolerance |
//! | `worst` | the elements that are farthest from what is asked of them |

mod acting;
mod angles;
mod apply;
mod collapse;
mod edit;
mod edit_json;
mod face_measure;
mod flaws;
mod free;
mod gesture;
mod halves;
mod history;
mod holding;
mod inspect;
mod lesson;
mod make_panels;
mod measured;
mod moved;
mod opening;
mod pace;
mod past;
mod place;
mod place_shape;
mod preview;
mod projected;
mod remedies;
mod report;
mod resolve;
mod saved;
mod selection;
mod settings;
mod tables;
mod trace;
mod transition;
mod verdict;
mod worst;

pub use acting::ActingRows;
pub use collapse::{Collapse, CollapseReason};
pub use edit::{Edit, NewConstraint};
pub use face_measure::{FACE_MEASURES, FaceMeasure, MeasureUnit, Shape};
pub use flaws::{ZERO_SIZE_FACES, flaw_of};
pub use gesture::check_targets;
pub use halves::{Fits, Half};
pub use lesson::{GoalWords, check_results, goals_in_words};
pub use moved::Moved;
pub use pace::most_faces;
pub use place::Place;
pub use preview::Preview;
pub use projected::Projections;
pub use remedies::{Remedies, Remedy};
pub use report::{EnergyReport, Report, Seconds, TraceEntry};
pub use resolve::ResolvedRow;
pub use selection::{Mode, OPERATIONS, Operation, SelectRequest, Selection};
pub use settings::{SETTINGS, Setting, settings_of};
pub use verdict::Verdict;
pub use worst::WorstElement;

use crate::error::Error;
use crate::mesh::{Mesh, Point, Topology, Weld, write_obj};
use crate::scene::{Frame, HandleSpec, Hold, Scene};
use crate::solve::{Constraints, Handle, Kept, Problem, Solver};
use collapse::Start;
use measured::Measured;
use past::Past;
use std::cell::RefCell;
use std::rc::Rc;
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
    past: Past,
    measured: RefCell<Measured>,
    /// See [`Session::halfway`].
    halfway: bool,
}

/// What one iteration did.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step {
    /// Whether the total changed by no more than the tolerance, and the shape has not collapsed.
    pub converged: bool,
    /// Whether there is nothing to go on for: the total did not change, or the shape collapsed.
    pub ended: bool,
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
        self.past.iteration
    }

    /// Counts on from `iteration`, for a scene that is opened again where it stood.
    pub fn restore_iteration(&mut self, iteration: u32) {
        self.past.iteration = iteration;
        if self.past.trace.is_some() {
            self.start_trace();
        }
    }

    /// The current shape as the text of an OBJ file, with the unit and the axis that are known.
    pub fn obj(&self) -> String {
        let comments = Frame::comments(&self.document.units, self.document.up);
        comments + &write_obj(&self.mesh, &self.positions())
    }

    /// The same of the mesh as it came, which was welded to the mesh of this session.
    pub fn obj_as_it_came(&self, weld: &Weld) -> String {
        let comments = Frame::comments(&self.document.units, self.document.up);
        let positions = weld.as_it_came(&self.mesh.positions, &self.positions());
        comments + &write_obj(&weld.original, &positions)
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
        self.take_start();
        self.solver.step()?;
        self.past.iteration += 1;
        let entry = self.trace_entry();
        if let Some(trace) = &mut self.past.trace {
            trace.push(entry);
        }
        let collapsed = self.watch();
        let ended = self.solver.converged() || collapsed;
        if ended && !collapsed && self.tighten() {
            return Ok(Step { converged: false, ended: false });
        }
        Ok(Step { converged: self.converged(), ended })
    }

    /// Iterates until the tolerance or the limit of the scene is reached; with `trace` the energies of
    /// all iterations are recorded.
    ///
    /// # Errors
    /// As [`Session::step`].
    pub fn solve(&mut self, trace: bool) -> Result<(), Error> {
        if trace {
            self.past.trace = Some(Trace::whole(self.trace_entry()));
        }
        for _ in 0..self.document.solver.iterations {
            if self.step()?.ended {
                break;
            }
        }
        self.solver.settle();
        Ok(())
    }

    /// Records the energies of the iterations from here on, this one included. Of some thousands
    /// there are all; of more, as many at equal distances.
    pub fn start_trace(&mut self) {
        self.past.trace = Some(Trace::bounded(self.trace_entry()));
    }

    /// The recorded energies that led to the current shape, ascending; none where nothing is recorded.
    pub fn trace(&self) -> &[TraceEntry] {
        self.past.trace.as_ref().map_or(&[], Trace::entries)
    }

    fn trace_entry(&self) -> TraceEntry {
        TraceEntry::new(self.past.iteration, self.solver.energy())
    }

    /// Counts on from `iteration` after a jump to a state from before or after, to which iterations led
    /// from `start`.
    fn arrive(&mut self, iteration: u32, start: Option<Rc<Start>>) {
        self.start_from(start);
        self.past.iteration = iteration;
        self.halfway = false;
        let entry = self.trace_entry();
        if let Some(trace) = &mut self.past.trace {
            trace.go_to(entry);
        }
    }

    /// Seconds that reading the files took, for the report.
    pub fn set_load_seconds(&mut self, seconds: f64) {
        self.past.load_seconds = seconds;
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
