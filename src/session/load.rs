//! Opening scenes one after another, without memory for two. Everything that is likely to be
//! refused is checked while the open scene is intact. Then its solver, which takes most of the
//! memory, is dropped until the next scene is set up.

use super::Session;
use super::measured::MeasureCache;
use super::report::{check_lesson, check_presentation};
use super::run::{LastRun, Progress, Search};
use super::state::{ResolvedRow, RestMesh, SceneState, SolvedScene, flat, resolve_rows};
use super::undo::{History, Transaction};
use crate::mesh::Mesh;
use crate::scene::{MeshSource, Scene};
use crate::session::Error;
use std::rc::Rc;

impl Session {
    /// Checks the scene with `mesh`, the mesh that `scene.mesh` refers to, and sets up the solver.
    ///
    /// # Errors
    /// If the scene does not fit the mesh, a row has no constraint, or the system is singular.
    pub fn open(scene: Scene, mesh: Mesh) -> Result<Session, Error> {
        FittingScene::new(scene, mesh)?.open()
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
        let fitting = FittingScene::new(scene, mesh)?;
        let [last, now] = open
            .as_ref()
            .map_or([0; 2], |session| [session.scene.last_generation(), session.generation()]);
        let before = open.take().map(Session::suspend);
        match fitting.open() {
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

    /// Drops the solver and what was measured. The mesh stays, with what was derived from it.
    fn suspend(self) -> Suspended {
        let state = self.scene.state();
        let Session { rest, progress, opened, last_run, history, transaction, .. } = self;
        Suspended { rest, state, progress, opened, last_run, history, transaction }
    }
}

/// A scene that fits its mesh, before its solver is set up.
struct FittingScene {
    scene: Scene,
    rest: RestMesh,
    rows: Vec<ResolvedRow>,
}

impl FittingScene {
    /// Checks the scene with `mesh`, the mesh that `scene.mesh` refers to.
    ///
    /// # Errors
    /// If the scene does not fit the mesh, or a row has no constraint.
    fn new(scene: Scene, mesh: Mesh) -> Result<FittingScene, Error> {
        scene.validate(&mesh)?;
        check_lesson(&scene, &mesh)?;
        check_presentation(&scene, &mesh)?;
        let rest = RestMesh::new(mesh);
        let rows = resolve_rows(&scene, rest.mesh(), rest.topology())?;
        Ok(FittingScene { scene, rest, rows })
    }

    /// Opens the scene at its initial positions.
    ///
    /// # Errors
    /// If the system is singular.
    fn open(mut self) -> Result<Session, Error> {
        let positions = self.scene.start(self.rest.mesh()).into();
        self.scene.current = None;
        // The mesh is beside the scene, and is not copied with it.
        if let MeshSource::Inline(mesh) = &mut self.scene.mesh {
            **mesh = Mesh::default();
        }
        let handles = flat(&std::mem::take(&mut self.scene.handles), self.rest.positions()).into();
        let state = SceneState { document: Rc::new(self.scene), handles, positions };
        set_up(Rc::new(self.rest), self.rows, state)
    }
}

/// Sets up the solver of a session in this state, without a past.
///
/// # Errors
/// If the system is singular.
fn set_up(rest: Rc<RestMesh>, rows: Vec<ResolvedRow>, state: SceneState) -> Result<Session, Error> {
    let SceneState { document, handles, positions } = state;
    let opened = Rc::clone(&document);
    let scene = SolvedScene::new(document, &rest, rows, handles.to_vec(), &positions)?;
    Ok(Session {
        progress: Progress::new(scene.solver().energy()),
        rest,
        scene,
        opened: Some(opened),
        last_run: None,
        history: History::default(),
        transaction: None,
        measured: MeasureCache::default(),
        met: None,
        meeting: None,
        search: Search::Scene,
    })
}

/// A session without its solver.
struct Suspended {
    rest: Rc<RestMesh>,
    state: SceneState,
    progress: Progress,
    opened: Option<Rc<Scene>>,
    last_run: Option<Rc<LastRun>>,
    history: History,
    transaction: Option<Transaction>,
}

impl Suspended {
    /// Restores the session. Its solver has lost the history of its steps, as after a pause.
    ///
    /// # Errors
    /// If the system is singular, which it was not before.
    fn resume(self) -> Result<Session, Error> {
        let Suspended { rest, state, progress, opened, last_run, history, transaction } = self;
        let rows = resolve_rows(&state.document, rest.mesh(), rest.topology())?;
        let session = set_up(rest, rows, state)?;
        Ok(Session { progress, opened, last_run, history, transaction, ..session })
    }
}
