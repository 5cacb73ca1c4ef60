//! Opening one scene after another without room for two: everything that is likely to be refused is
//! checked while the scene that is open is still whole, and then that one can do without its solver,
//! which is most of what it takes, until the next one is there.

use super::trace::Trace;
use super::{Gesture, History, ResolvedRow, Session, flat, lesson, resolve, solver};
use crate::error::Error;
use crate::mesh::{BoundingSphere, Mesh, Point, Topology};
use crate::scene::Scene;
use crate::solve::{Energy, Handle, Kept};

impl Session {
    /// Opens a scene, as [`Session::open`], in the place of the one that is `open`, which stays when it
    /// is refused: then its solver has only forgotten the steps before, as after a pause.
    ///
    /// # Errors
    /// As [`Session::open`].
    pub fn replace(
        open: &mut Option<Session>,
        scene: Scene,
        mesh: Mesh,
    ) -> Result<&mut Session, Error> {
        let checked = Checked::new(scene, mesh)?;
        let before = open.take().map(Session::rest);
        match checked.open() {
            Ok(session) => Ok(open.insert(session)),
            Err(error) => {
                let wake = |resting: Resting| resting.wake().expect("it could be solved before");
                *open = before.map(wake);
                Err(error)
            }
        }
    }

    /// Gives back what can be made again.
    fn rest(self) -> Resting {
        Resting {
            positions: self.positions(),
            handles: self.solver.handles().to_vec(),
            mesh: self.mesh,
            diameter: self.diameter,
            document: self.document,
            iteration: self.iteration,
            initial: self.initial,
            trace: self.trace,
            load_seconds: self.load_seconds,
            history: self.history,
            gesture: self.gesture,
        }
    }
}

/// A scene that fits its mesh, before its solver is set up.
pub(super) struct Checked {
    scene: Scene,
    mesh: Mesh,
    topology: Topology,
    rows: Vec<ResolvedRow>,
}

impl Checked {
    /// Checks the scene against `mesh`, which is what `scene.mesh` stands for.
    ///
    /// # Errors
    /// When the scene does not fit the mesh, or a row of constraints is empty.
    pub(super) fn new(scene: Scene, mesh: Mesh) -> Result<Checked, Error> {
        scene.validate(&mesh)?;
        lesson::check_lesson(&scene, &mesh)?;
        let topology = Topology::new(&mesh);
        let rows = resolve::rows(&scene, &mesh, &topology)?;
        Ok(Checked { scene, mesh, topology, rows })
    }

    /// Sets up the solver.
    ///
    /// # Errors
    /// When the system is singular.
    pub(super) fn open(self) -> Result<Session, Error> {
        let Checked { mut scene, mesh, topology, rows } = self;
        let start = scene.current.take().unwrap_or_else(|| mesh.positions.clone());
        let handles = flat(&std::mem::take(&mut scene.handles), &mesh.positions);
        let solver = solver(&scene, &mesh, &topology, &rows, Kept::default(), handles, &start)?;
        let initial = solver.energy();
        Ok(Session {
            diameter: BoundingSphere::of(&mesh.positions).diameter(),
            mesh,
            topology,
            document: scene,
            rows,
            solver,
            iteration: 0,
            initial,
            trace: None,
            load_seconds: 0.0,
            history: History::default(),
            gesture: None,
            halfway: false,
        })
    }
}

/// A session without its solver, and without anything that follows from the rest.
struct Resting {
    mesh: Mesh,
    diameter: f64,
    document: Scene,
    handles: Vec<Handle>,
    /// Current positions, `#V by 3`.
    positions: Vec<Point>,
    iteration: u32,
    initial: Energy,
    trace: Option<Trace>,
    load_seconds: f64,
    history: History,
    gesture: Option<Gesture>,
}

impl Resting {
    /// The session as it was. Its solver has forgotten the steps before, as after a pause.
    ///
    /// # Errors
    /// When the system is singular, which it was not before.
    fn wake(self) -> Result<Session, Error> {
        let Resting { mesh, document, handles, positions, .. } = self;
        let topology = Topology::new(&mesh);
        let rows = resolve::rows(&document, &mesh, &topology)?;
        let kept = Kept::default();
        let solver = solver(&document, &mesh, &topology, &rows, kept, handles, &positions)?;
        Ok(Session {
            mesh,
            topology,
            diameter: self.diameter,
            document,
            rows,
            solver,
            iteration: self.iteration,
            initial: self.initial,
            trace: self.trace,
            load_seconds: self.load_seconds,
            history: self.history,
            gesture: self.gesture,
            halfway: false,
        })
    }
}
