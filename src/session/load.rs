//! Opening scenes one after another, without memory for two. Everything that is likely to be
//! refused is checked while the open scene is intact. Then its solver, which takes most of the
//! memory, is dropped until the next scene is set up.

use super::Session;
use super::measured::MeasureCache;
use super::report::{check_lesson, check_presentation};
use super::run::{CollapseGuard, Progress, Search};
use super::state::{ResolvedRow, RestMesh, SolvedScene, flat, resolve_rows};
use super::undo::{History, Transaction};
use crate::mesh::{Mesh, Point};
use crate::scene::Scene;
use crate::session::Error;
use crate::solve::Handle;

impl Session {
    /// Checks the scene with `mesh`, the mesh that `scene.mesh` refers to, and sets up the solver.
    ///
    /// # Errors
    /// If the scene does not fit the mesh, a row has no constraint, or the system is singular.
    pub fn open(scene: Scene, mesh: Mesh) -> Result<Session, Error> {
        Checked::new(scene, mesh)?.open()
    }

    /// Opens a copy of a scene that is open elsewhere with this [`Session::generation`], so that what
    /// is found on the copy belongs to the original.
    ///
    /// # Errors
    /// As [`Session::open`].
    pub fn open_copy(scene: Scene, mesh: Mesh, generation: u32) -> Result<Session, Error> {
        let mut copy = Session::open(scene, mesh)?;
        copy.scene.restored(generation);
        Ok(copy)
    }

    /// Opens a scene, as [`Session::open`], in place of `open`, whose generations it goes on with.
    /// If it is refused, the previous scene stays, with its steps of undo; what can be computed again
    /// is lost: the step history of its solver, and how its hard constraints were met.
    ///
    /// # Errors
    /// As [`Session::open`].
    pub fn replace(
        open: &mut Option<Session>,
        scene: Scene,
        mesh: Mesh,
    ) -> Result<&mut Session, Error> {
        let checked = Checked::new(scene, mesh)?;
        let [last, now] = open
            .as_ref()
            .map_or([0; 2], |session| [session.scene.last_generation(), session.generation()]);
        let before = open.take().map(Session::suspend);
        match checked.open() {
            Ok(session) => {
                let session = open.insert(session);
                session.scene.follow_generation(last);
                Ok(session)
            }
            Err(error) => {
                let resume =
                    |suspended: Suspended| suspended.resume().expect("it could be solved before");
                *open = before.map(resume);
                if let Some(session) = open {
                    session.scene.follow_generation(last);
                    session.scene.restored(now);
                }
                Err(error)
            }
        }
    }

    /// Drops everything that can be recomputed.
    fn suspend(self) -> Suspended {
        let Session { rest, scene, progress, guard, history, transaction, .. } = self;
        let (positions, handles) = (scene.positions().to_vec(), scene.handles().to_vec());
        let past = Past { progress, guard, history, transaction };
        Suspended {
            rest: rest.into_parts(),
            document: scene.into_document(),
            handles,
            positions,
            past,
        }
    }
}

/// A scene that fits its mesh, before its solver is set up.
struct Checked {
    scene: Scene,
    rest: RestMesh,
    rows: Vec<ResolvedRow>,
}

impl Checked {
    /// Checks the scene with `mesh`, the mesh that `scene.mesh` refers to.
    ///
    /// # Errors
    /// If the scene does not fit the mesh, or a row has no constraint.
    fn new(scene: Scene, mesh: Mesh) -> Result<Checked, Error> {
        scene.validate(&mesh)?;
        check_lesson(&scene, &mesh)?;
        check_presentation(&scene, &mesh)?;
        let rest = RestMesh::new(mesh);
        let rows = resolve_rows(&scene, rest.mesh(), rest.topology())?;
        Ok(Checked { scene, rest, rows })
    }

    /// Opens the scene at its initial positions.
    ///
    /// # Errors
    /// If the system is singular.
    fn open(mut self) -> Result<Session, Error> {
        let start = self.scene.start(self.rest.mesh()).to_vec();
        self.scene.current = None;
        let handles = flat(&std::mem::take(&mut self.scene.handles), self.rest.positions());
        self.set_up(handles, &start, None)
    }

    /// Sets up the solver at the positions `start` (`#V by 3`), in a session with this `past`, or
    /// with none. The scene contains neither handles nor positions.
    ///
    /// # Errors
    /// If the system is singular.
    fn set_up(
        self,
        handles: Vec<Handle>,
        start: &[Point],
        past: Option<Past>,
    ) -> Result<Session, Error> {
        let Checked { scene, rest, rows } = self;
        let scene = SolvedScene::new(scene, &rest, rows, handles, start)?;
        let past = past.unwrap_or_else(|| Past {
            progress: Progress::new(scene.solver().energy()),
            guard: CollapseGuard::new(scene.document().clone()),
            history: History::default(),
            transaction: None,
        });
        let Past { progress, guard, history, transaction } = past;
        let measured = MeasureCache::default();
        Ok(Session {
            rest,
            scene,
            progress,
            guard,
            history,
            transaction,
            measured,
            met: None,
            meeting: None,
            search: Search::Scene,
        })
    }
}

/// A session without its solver and other derived data.
struct Suspended {
    /// See [`RestMesh::into_parts`].
    rest: (Mesh, u32, Vec<String>),
    document: Scene,
    handles: Vec<Handle>,
    /// Current positions, `#V by 3`.
    positions: Vec<Point>,
    past: Past,
}

/// The parts of a session that are kept without its solver.
struct Past {
    progress: Progress,
    guard: CollapseGuard,
    history: History,
    transaction: Option<Transaction>,
}

impl Suspended {
    /// Restores the session. Its solver has lost the history of its steps, as after a pause.
    ///
    /// # Errors
    /// If the system is singular, which it was not before.
    fn resume(self) -> Result<Session, Error> {
        let (mesh, generation, lost) = self.rest;
        let mut checked = Checked::new(self.document, mesh)?;
        checked.rest.restore(generation, lost);
        checked.set_up(self.handles, &self.positions, Some(self.past))
    }
}
