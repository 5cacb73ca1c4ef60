//! Files in: meshes, and scenes with the mesh files that they name.

use super::report::{Guessed, Loaded};
use super::solver::Solver;
use crate::mesh::{Read, read};
use crate::scene::{MeshSource, Scene, UnitsAndUp};
use crate::session::Session;
use crate::solve::clock;
use crate::web::plain::plain;
use crate::web::thrown;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Solver {
    /// The mesh file that a scene names, or null.
    #[wasm_bindgen(js_name = sceneMeshFile)]
    pub fn scene_mesh_file(&self, bytes: &[u8]) -> Result<Option<String>, JsValue> {
        Ok(match scene_of(bytes)?.mesh {
            MeshSource::File(path) => Some(path),
            MeshSource::Inline(_) => None,
        })
    }

    /// What the next mesh file is taken for unless it states otherwise, in its own words:
    /// `# units: m`, `# up: y`, a line each.
    pub fn assume(&mut self, comments: &str) {
        self.assumed = UnitsAndUp::stated(comments.as_bytes());
    }

    /// Whether the next mesh file keeps vertices at one place apart: otherwise it is welded where its faces
    /// have their own.
    #[wasm_bindgen(js_name = keepApart)]
    pub fn keep_apart(&mut self, apart: bool) {
        self.keeps_apart = apart;
    }

    /// Opens a mesh, or a scene with the mesh file that it names as `companion`. The model that is
    /// open stays when this one is refused.
    pub fn load(
        &mut self,
        name: &str,
        bytes: &[u8],
        companion: Option<Vec<u8>>,
    ) -> Result<JsValue, JsValue> {
        let started = clock::now();
        let is_scene = name.to_ascii_lowercase().ends_with(".json");
        let mut stated = UnitsAndUp::default();
        let (mut scene, mut file) = if is_scene {
            let in_scene = |message: String| thrown(format!("{name}: {message}"));
            let mut scene = scene_of(bytes).map_err(|e| in_scene(message_of(&e)))?;
            let file = match std::mem::replace(&mut scene.mesh, MeshSource::File(String::new())) {
                MeshSource::Inline(mesh) => {
                    Read { mesh: *mesh, problems: Vec::new(), notes: Vec::new() }
                }
                MeshSource::File(path) => {
                    let bytes = companion.ok_or_else(|| {
                        in_scene(format!("it needs the mesh file {path}: open both files together"))
                    })?;
                    let file = read(&path, &bytes).map_err(thrown)?;
                    scene.mesh = MeshSource::File(path);
                    file
                }
            };
            (scene, file)
        } else {
            stated = UnitsAndUp::stated(bytes).or(std::mem::take(&mut self.assumed));
            (Scene::opened(name), read(name, bytes).map_err(thrown)?)
        };
        if !is_scene {
            let units = || UnitsAndUp::guess_units(&file.mesh).to_owned();
            scene.units = stated.units.clone().unwrap_or_else(units);
            scene.up = stated.up.unwrap_or_else(|| UnitsAndUp::guess_up(&file.mesh));
        }
        // The indices in a scene are those of its mesh as it is.
        let apart = std::mem::take(&mut self.keeps_apart) || is_scene;
        let weld = if apart { None } else { file.weld() };
        let mesh = std::mem::take(&mut file.mesh);
        let session = Session::replace(&mut self.session, scene, mesh).map_err(|error| {
            thrown(if is_scene { format!("{name}: {error}") } else { error.to_string() })
        })?;
        session.set_load_seconds(clock::now() - started);
        session.start_trace();
        let guessed = Guessed {
            units: !is_scene && stated.units.is_none(),
            up: !is_scene && stated.up.is_none(),
        };
        let loaded = plain(&Loaded::new(name, session, &file, guessed, weld.as_ref()));
        self.step_ms = 0.0;
        self.weld = weld;
        loaded
    }

    /// Counts on from `iteration`, where the scene that was just opened stood when it was saved.
    #[wasm_bindgen(js_name = restoreIteration)]
    pub fn restore_iteration(&mut self, iteration: u32) -> Result<(), JsValue> {
        self.open_mut()?.restore_iteration(iteration);
        Ok(())
    }
}

fn message_of(error: &JsValue) -> String {
    error.dyn_ref::<js_sys::Error>().map(|e| String::from(e.message())).unwrap_or_default()
}

fn scene_of(bytes: &[u8]) -> Result<Scene, JsValue> {
    let text =
        std::str::from_utf8(bytes).map_err(|_| thrown("a scene is UTF-8 text, and this is not"))?;
    Scene::from_json(text).map_err(thrown)
}
