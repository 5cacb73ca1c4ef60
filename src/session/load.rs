//! Opening one scene after another without room for two: everything that is likely to be refused is
//! checked while the scene that is open is still whole, and then that one can do without its solver,
//! which is most of what it takes, until the next one is there.

use super::report::check_lesson;
use super::state::{ResolvedRow, RunState, Session, flat, resolve_rows, solver};
use crate::error::Error;
use crate::mesh::{BoundingSphere, Mesh, Point, Topology};
use crate::scene::Scene;
use crate::solve::{Handle, SetupCache};
use std::cell::RefCell;

impl Session {
    /// Checks the scene against `mesh`, which is what `scene.mesh` stands for, and sets up the solver.
    ///
    /// # Errors
    /// When the scene does not fit the mesh, a row of constraints is empty, or the system is singular.
    pub fn open(scene: Scene, mesh: Mesh) -> Result<Session, Error> {
        Checked::new(scene, mesh)?.open()
    }

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
        let before = open.take().map(Session::suspend);
        match checked.open() {
            Ok(session) => Ok(open.insert(session)),
            Err(error) => {
                let resume =
                    |suspended: Suspended| suspended.resume().expect("it could be solved before");
                *open = before.map(resume);
                Err(error)
            }
        }
    }

    /// Gives back what can be made again.
    fn suspend(self) -> Suspended {
        Suspended {
            positions: self.positions(),
            handles: self.solver.handles().to_vec(),
            mesh: self.mesh,
            document: self.document,
            run_state: self.run_state,
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
        check_lesson(&scene, &mesh)?;
        let topology = Topology::new(&mesh);
        let rows = resolve_rows(&scene, &mesh, &topology)?;
        Ok(Checked { scene, mesh, topology, rows })
    }

    /// Opens it where the scene starts.
    ///
    /// # Errors
    /// When the system is singular.
    pub(super) fn open(mut self) -> Result<Session, Error> {
        let start = self.scene.current.take().unwrap_or_else(|| self.mesh.positions.clone());
        let handles = flat(&std::mem::take(&mut self.scene.handles), &self.mesh.positions);
        self.set_up(handles, &start, None)
    }

    /// Sets up the solver, at the positions `start` (`#V by 3`), in a session with this `past`, or with
    /// none. The scene has neither handles nor positions of its own.
    ///
    /// # Errors
    /// When the system is singular.
    fn set_up(
        self,
        handles: Vec<Handle>,
        start: &[Point],
        run_state: Option<RunState>,
    ) -> Result<Session, Error> {
        let Checked { scene, mesh, topology, rows } = self;
        let solver =
            solver(&scene, &mesh, &topology, &rows, SetupCache::default(), handles, start)?;
        Ok(Session {
            diameter: BoundingSphere::of(&mesh.positions).diameter(),
            run_state: run_state
                .unwrap_or_else(|| RunState::beginning(solver.energy(), scene.clone())),
            mesh,
            topology,
            document: scene,
            rows,
            solver,
            measured: RefCell::default(),
            halfway: false,
        })
    }
}

/// A session without its solver, and without anything that follows from the rest.
struct Suspended {
    mesh: Mesh,
    document: Scene,
    handles: Vec<Handle>,
    /// Current positions, `#V by 3`.
    positions: Vec<Point>,
    run_state: RunState,
}

impl Suspended {
    /// The session as it was. Its solver has forgotten the steps before, as after a pause.
    ///
    /// # Errors
    /// When the system is singular, which it was not before.
    fn resume(self) -> Result<Session, Error> {
        let checked = Checked::new(self.document, self.mesh)?;
        checked.set_up(self.handles, &self.positions, Some(self.run_state))
    }
}
