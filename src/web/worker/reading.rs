//! Opens files: meshes, and scenes with the mesh files that they name.

use super::report::Loaded;
use super::solver::Solver;
use crate::mesh::{Mesh, Read, diagnose};
use crate::scene::UnitsAndUp;
use crate::session::{Guessed, OpenedFile, Session, is_scene, named_files};
use crate::solve::clock;
use crate::web::plain::plain;
use crate::web::thrown;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Solver {
    /// Returns the paths of the files that a scene names: mesh, reference surface, another pose.
    #[wasm_bindgen(js_name = sceneFiles)]
    pub fn scene_files(&self, bytes: &[u8]) -> Result<Vec<String>, JsValue> {
        let scene = OpenedFile::scene_in(bytes).map_err(thrown)?;
        Ok(named_files(&scene).map(str::to_owned).collect())
    }

    /// Supplies a file for the next scene, under the path by which the scene names it.
    #[wasm_bindgen(js_name = addFile)]
    pub fn add_file(&mut self, path: &str, bytes: Vec<u8>) {
        self.files.add_file(path, bytes);
    }

    /// Sets the unit and up axis of the next mesh file, in case the file does not state them.
    /// `comments` has the form of such statements in a file: `# units: m`, `# up: y`, a line each.
    #[wasm_bindgen(js_name = setDefaultFrame)]
    pub fn set_default_frame(&mut self, comments: &str) {
        self.files.set_default_frame(UnitsAndUp::stated(comments.as_bytes()));
    }

    /// Sets whether coincident vertices of the next mesh file stay separate. Otherwise the mesh is
    /// welded if its faces do not share vertices.
    #[wasm_bindgen(js_name = keepUnwelded)]
    pub fn keep_unwelded(&mut self, unwelded: bool) {
        self.files.keep_unwelded(unwelded);
    }

    /// Opens a mesh, or a scene with the files that [`Solver::add_file`] supplied. If this one is
    /// refused, the model that is open stays.
    #[wasm_bindgen(unchecked_return_type = "Loaded")]
    pub fn load(&mut self, name: &str, bytes: &[u8]) -> Result<JsValue, JsValue> {
        let started = clock::now();
        let file = self.files.read(name, bytes).map_err(thrown)?;
        let OpenedFile { scene, mesh, weld, diagnostics, guessed } = file;
        let session = Session::replace(&mut self.session, scene, mesh).map_err(|error| {
            thrown(if is_scene(name) { format!("{name}: {error}") } else { error.to_string() })
        })?;
        session.set_load_seconds(clock::now() - started);
        session.start_trace();
        let loaded = plain(&Loaded::new(name, session, &diagnostics, guessed, weld.as_ref()));
        self.step_ms = 0.0;
        self.weld = weld;
        self.mesh_generation = 0;
        loaded
    }

    /// Returns the summary of the current mesh, without a name, if it is not the mesh of the last
    /// summary; else undefined.
    #[wasm_bindgen(unchecked_return_type = "Loaded | undefined")]
    pub fn remeshed(&mut self) -> Result<JsValue, JsValue> {
        let session = self.open()?;
        let generation = session.mesh_generation();
        if generation == self.mesh_generation {
            return Ok(JsValue::UNDEFINED);
        }
        let diagnostics = Read {
            problems: diagnose(session.mesh()),
            notes: session.lost().to_vec(),
            mesh: Mesh::default(),
        };
        let weld = self.weld.as_ref().filter(|_| generation == 0);
        let loaded = plain(&Loaded::new("", session, &diagnostics, Guessed::default(), weld));
        self.mesh_generation = generation;
        loaded
    }

    /// Continues counting from `iteration`, the saved iteration of the scene that was just opened.
    #[wasm_bindgen(js_name = restoreIteration)]
    pub fn restore_iteration(&mut self, iteration: u32) -> Result<(), JsValue> {
        self.open_mut()?.restore_iteration(iteration);
        Ok(())
    }
}
