//! Files of the open model: opened, restored after a restart, written.

use super::loaded::Loaded;
use super::solver::Solver;
use crate::mesh::{Read, diagnose};
use crate::scene::{RowNumber, UnitsAndUp};
use crate::session::{Guessed, OpenedFile, Session, is_scene, named_files};
use crate::solve::clock;
use crate::web::thrown;
use crate::web::values::{Js, plain};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Solver {
    /// Returns the paths of the files that a scene names: mesh, reference surface, another pose.
    #[wasm_bindgen(js_name = sceneFiles)]
    pub fn scene_files(&self, bytes: &[u8]) -> Result<Vec<String>, JsValue> {
        let scene = OpenedFile::scene_in(bytes).map_err(thrown)?;
        Ok(named_files(&scene).map(|(_, path)| path.to_owned()).collect())
    }

    /// Supplies a file for the next scene, under the path by which the scene names it.
    #[wasm_bindgen(js_name = addFile)]
    pub fn add_file(&mut self, path: &str, bytes: Vec<u8>) {
        self.files.add_file(path, bytes);
    }

    /// Opens a mesh, or a scene, as [`Solver::read`] reads it and [`Solver::open_read`] opens it.
    pub fn load(
        &mut self,
        name: &str,
        bytes: &[u8],
        frame: Option<String>,
        unwelded: Option<bool>,
    ) -> Result<Js<Loaded>, JsValue> {
        self.read(name, bytes, frame, unwelded, None)?;
        self.open_read(name, &[])
    }

    /// Reads a mesh, or a scene with the files that [`Solver::add_file`] supplied; the model that is open
    /// stays. `frame` has the unit and up axis of a mesh file that does not state them, in the form of
    /// such statements: `# units: m`, `# up: y`, a line each. A mesh whose faces do not share vertices is
    /// welded, unless it shall stay `unwelded`. Returns the number of faces if there are more than `most`:
    /// they are not to be opened then.
    pub fn read(
        &mut self,
        name: &str,
        bytes: &[u8],
        frame: Option<String>,
        unwelded: Option<bool>,
        most: Option<u32>,
    ) -> Result<Option<u32>, JsValue> {
        let started = clock::now();
        let frame = UnitsAndUp::stated(frame.unwrap_or_default().as_bytes());
        let unwelded = unwelded.unwrap_or(false);
        let file = self.files.read(name, bytes, frame, unwelded).map_err(thrown)?;
        let faces = file.mesh.faces.len() as u32;
        let are_too_many = most.is_some_and(|most| faces > most);
        self.read = (!are_too_many).then(|| (file, clock::now() - started));
        Ok(are_too_many.then_some(faces))
    }

    /// Opens what [`Solver::read`] has read last, as the file `name`. If it is refused, the model that is
    /// open stays. `rows` are the numbers of the rows of constraints if the scene continues a session in
    /// which they had these.
    #[wasm_bindgen(js_name = openRead)]
    pub fn open_read(&mut self, name: &str, rows: &[u32]) -> Result<Js<Loaded>, JsValue> {
        let started = clock::now();
        let (file, reading) = self.read.take().ok_or_else(|| thrown("nothing has been read"))?;
        let OpenedFile { mut scene, mesh, weld, diagnostics, guessed } = file;
        if rows.len() == scene.constraints.len() {
            for (row, &number) in scene.constraints.iter_mut().zip(rows) {
                row.number = RowNumber::of(number);
            }
        }
        let session = Session::replace(&mut self.session, scene, mesh).map_err(|error| {
            thrown(if is_scene(name) { format!("{name}: {error}") } else { error.to_string() })
        })?;
        session.set_load_seconds(reading + clock::now() - started);
        session.start_trace();
        let loaded = plain(&Loaded::new(name, session, &diagnostics, guessed, weld.as_ref()));
        self.step_ms = 0.0;
        self.weld = weld;
        self.mesh_generation = 0;
        loaded
    }

    /// Returns the summary of the current mesh, without a name, if it is not the mesh of the last
    /// summary; else undefined.
    pub fn remeshed(&mut self) -> Result<Option<Js<Loaded>>, JsValue> {
        let session = self.open()?;
        let generation = session.mesh_generation();
        if generation == self.mesh_generation {
            return Ok(None);
        }
        let diagnostics = Read {
            problems: diagnose(session.mesh()),
            notes: session.lost().to_vec(),
            ..Read::default()
        };
        let weld = self.weld.as_ref().filter(|_| generation == 0);
        let loaded = plain(&Loaded::new("", session, &diagnostics, Guessed::default(), weld));
        self.mesh_generation = generation;
        loaded.map(Some)
    }

    /// Continues counting from `iteration`, the saved iteration of the scene that was just opened.
    #[wasm_bindgen(js_name = restoreIteration)]
    pub fn restore_iteration(&mut self, iteration: u32) -> Result<(), JsValue> {
        self.open_mut()?.restore_iteration(iteration);
        Ok(())
    }

    /// Restores the saved history and progress of the scene that was just opened; either may be
    /// empty. Restores as much as it can, even if it returns an error.
    pub fn restore(&mut self, history: &[u8], progress: &[u8]) -> Result<(), JsValue> {
        self.open_mut()?.restore(history, progress).map_err(thrown)
    }

    /// Returns the steps of undo and redo, which belong to the current scene: a run, a drag or a
    /// variation that is under way is the last of them.
    #[wasm_bindgen(js_name = savedHistory)]
    pub fn saved_history(&self) -> Result<Vec<u8>, JsValue> {
        Ok(self.open()?.saved_history())
    }

    /// Returns the progress of the current run or drag, from any scene that was written since it began.
    #[wasm_bindgen(js_name = savedProgress)]
    pub fn saved_progress(&self) -> Result<Vec<u8>, JsValue> {
        Ok(self.open()?.saved_progress())
    }

    /// Returns the scene file with the mesh inline.
    pub fn scene(&self) -> Result<String, JsValue> {
        Ok(self.open()?.scene_with_mesh())
    }

    /// Returns the current shape as OBJ.
    pub fn obj(&self) -> Result<String, JsValue> {
        Ok(self.open()?.obj())
    }

    /// Returns the current shape as a mesh file with this ending, such as `ply`.
    #[wasm_bindgen(js_name = meshFile)]
    pub fn mesh_file(&self, ending: &str) -> Result<Vec<u8>, JsValue> {
        Ok(self.open()?.mesh_file(ending, None))
    }

    /// Returns the current shape as OBJ with the vertices and faces of the file before welding.
    #[wasm_bindgen(js_name = objUnwelded)]
    pub fn obj_unwelded(&self) -> Result<Vec<u8>, JsValue> {
        let session = self.open()?;
        let weld = self.weld.as_ref().filter(|_| session.mesh_generation() == 0);
        Ok(session.mesh_file("obj", weld))
    }

    /// The current shape as OBJ with the texture coordinates `uv` (`#V by 2`) of each vertex.
    ///
    /// # Errors
    /// The number of coordinates is wrong.
    #[wasm_bindgen(js_name = objWithUv)]
    pub fn obj_with_uv(&self, uv: &[f64]) -> Result<String, JsValue> {
        let session = self.open()?;
        let (pairs, rest) = uv.as_chunks::<2>();
        if !rest.is_empty() {
            let numbers = uv.len();
            return Err(thrown(format!(
                "found {numbers} numbers, expected two texture coordinates per vertex"
            )));
        }
        session.obj_with_uv(pairs).map_err(thrown)
    }

    /// Returns a table as CSV: `errors` of faces, energies (`convergence`), or `angles`.
    pub fn table(&mut self, what: &str) -> Result<String, JsValue> {
        let session = self.open_mut()?;
        match what {
            "errors" => Ok(session.errors_csv()),
            "convergence" => Ok(session.convergence_csv()),
            "angles" => Ok(session.angles_csv()),
            _ => Err(thrown(format!("unknown table {what:?}"))),
        }
    }

    /// Returns the file that `student` hands in.
    pub fn results(&mut self, student: &str, time: &str) -> Result<String, JsValue> {
        let results = self.open_mut()?.results(student, time);
        let results = results.ok_or_else(|| thrown("the scene has no lesson"))?;
        Ok(results.to_json())
    }
}
