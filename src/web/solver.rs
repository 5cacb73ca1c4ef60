//! The face of the solver in the worker.

use super::page_edit::OtherEdit;
use super::report::{self, Document, Guessed, Loaded, elements, kinds};
use super::{log_panics, thrown};

use crate::constraint::{Fitted, Selector, Set};
use crate::error::Error;
use crate::mesh::{Read, read};
use crate::scene::{ConstraintSpec, Frame, MeshSource, Scene, SceneError, Up};
use crate::session::{Edit, FACE_MEASURES, NewConstraint, Place, Session};
use crate::solve::clock;
use js_sys::{Float32Array, Float64Array, Uint8Array, Uint32Array};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use wasm_bindgen::prelude::*;

/// Everything that the worker does, on the one model that is open.
#[wasm_bindgen]
#[derive(Default)]
pub struct Solver {
    session: Option<Session>,
    /// For the next mesh file that does not state its own.
    assumed: Frame,
    step_ms: f64,
}

/// An edit as the page sends it.
#[derive(Deserialize)]
#[serde(tag = "type", rename_all = "camelCase")]
enum PageEdit {
    AddConstraint {
        kind: String,
        params: Map<String, Value>,
        on: Value,
        weight: f64,
    },
    RemoveConstraint {
        index: usize,
    },
    SetConstraint {
        index: usize,
        weight: Option<f64>,
        enabled: Option<bool>,
        #[serde(default)]
        params: Map<String, Value>,
    },
    SetUnits {
        units: String,
    },
    SetUp {
        up: String,
    },
    SetWeights {
        shape: Option<f64>,
        close: Option<f64>,
        smooth: Option<f64>,
    },
    AddHandles {
        vertices: Vec<u32>,
        fixed: bool,
    },
    RemoveHandles {
        vertices: Vec<u32>,
    },
    Reset,
    /// Those of `page_edit`.
    #[serde(untagged)]
    Other(OtherEdit),
}

#[wasm_bindgen]
impl Solver {
    /// No model.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Solver {
        log_panics();
        Solver::default()
    }

    /// The list of kinds.
    pub fn kinds(&self) -> Result<JsValue, JsValue> {
        plain(&kinds())
    }

    /// The elements that can carry one constraint each.
    pub fn elements(&self) -> Result<JsValue, JsValue> {
        plain(&elements())
    }

    /// The measures of faces.
    pub fn measures(&self) -> Result<JsValue, JsValue> {
        plain(&FACE_MEASURES)
    }

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
        self.assumed = Frame::stated(comments.as_bytes());
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
        let mut stated = Frame::default();
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
            stated = Frame::stated(bytes).or(std::mem::take(&mut self.assumed));
            (Scene::new(MeshSource::File(name.to_owned())), read(name, bytes).map_err(thrown)?)
        };
        if !is_scene {
            let units = || Frame::guess_units(&file.mesh).to_owned();
            scene.units = stated.units.clone().unwrap_or_else(units);
            scene.up = stated.up.unwrap_or_else(|| Frame::guess_up(&file.mesh));
        }
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
        self.step_ms = 0.0;
        plain(&Loaded::new(name, session, &file, guessed))
    }

    /// Counts on from `iteration`, where the scene that was just opened stood when it was saved.
    #[wasm_bindgen(js_name = restoreIteration)]
    pub fn restore_iteration(&mut self, iteration: u32) -> Result<(), JsValue> {
        self.open_mut()?.restore_iteration(iteration);
        Ok(())
    }

    /// The document: constraints, handles, weights, what can be undone.
    pub fn document(&self) -> Result<JsValue, JsValue> {
        plain(&Document::new(self.open()?))
    }

    /// Makes an edit, one step of undo.
    pub fn edit(&mut self, edit: JsValue) -> Result<(), JsValue> {
        let edit: PageEdit = serde_wasm_bindgen::from_value(edit).map_err(thrown)?;
        let session = self.open_mut()?;
        let edit = match edit {
            PageEdit::AddConstraint { kind, params, on, weight } => {
                Edit::AddConstraint(new_constraint(kind, params, on, weight)?)
            }
            PageEdit::RemoveConstraint { index } => Edit::RemoveConstraint { index },
            PageEdit::SetConstraint { index, weight, enabled, params } => {
                Edit::SetConstraint { index, weight, enabled, params }
            }
            PageEdit::SetUnits { units } => Edit::SetUnits(units),
            PageEdit::SetUp { up } => Edit::SetUp(if up == "y" { Up::Y } else { Up::Z }),
            PageEdit::SetWeights { shape, close, smooth } => {
                let mut weights = session.document().weights;
                weights.shape = shape.unwrap_or(weights.shape);
                weights.close = close.unwrap_or(weights.close);
                weights.smooth = smooth.unwrap_or(weights.smooth);
                Edit::SetWeights(weights)
            }
            PageEdit::AddHandles { vertices, fixed } => Edit::AddHandles { vertices, fixed },
            PageEdit::RemoveHandles { vertices } => Edit::RemoveHandles { vertices },
            PageEdit::Reset => Edit::Reset,
            PageEdit::Other(edit) => edit.try_into().map_err(|error| thrown_at(&error))?,
        };
        session.edit(edit).map_err(|error| match error {
            Error::Scene(error) => thrown_at(&error),
            error => thrown(error),
        })
    }

    /// Takes back the last step; its name, or null.
    pub fn undo(&mut self) -> Result<Option<String>, JsValue> {
        self.open_mut()?.undo().map_err(thrown)
    }

    /// Repeats the step that was last undone; its name, or null.
    pub fn redo(&mut self) -> Result<Option<String>, JsValue> {
        self.open_mut()?.redo().map_err(thrown)
    }

    /// One iteration; true when it has converged.
    pub fn step(&mut self) -> Result<bool, JsValue> {
        let started = clock::now();
        let step = self.open_mut()?.step().map_err(thrown)?;
        self.step_ms = 1e3 * (clock::now() - started);
        Ok(step.converged)
    }

    /// Begins a run: iterations up to [`Solver::end_run`] are one step of undo.
    #[wasm_bindgen(js_name = beginRun)]
    pub fn begin_run(&mut self) -> Result<(), JsValue> {
        self.open_mut()?.begin_run();
        Ok(())
    }

    /// Ends a run.
    #[wasm_bindgen(js_name = endRun)]
    pub fn end_run(&mut self) -> Result<(), JsValue> {
        self.open_mut()?.end_run();
        Ok(())
    }

    /// The numbers of the current state, and the energies of the iterations since the last call.
    pub fn frame(&mut self) -> Result<JsValue, JsValue> {
        let step_ms = self.step_ms;
        plain(&report::Frame::new(self.open_mut()?, step_ms))
    }

    /// Writes the current positions, `#V by 3`.
    #[wasm_bindgen(js_name = writePositions)]
    pub fn write_positions(&self, out: &Float64Array) -> Result<(), JsValue> {
        out.copy_from(self.open()?.positions().as_flattened());
        Ok(())
    }

    /// The values of a measure of faces, `#F`, in its unit.
    #[wasm_bindgen(js_name = faceValues)]
    pub fn face_values(&mut self, measure: &str) -> Result<Float32Array, JsValue> {
        let values = self.open_mut()?.face_values(measure);
        let values = values.ok_or_else(|| thrown(format!("unknown measure {measure:?}")))?;
        let narrow: Vec<f32> = values.iter().map(|&value| value as f32).collect();
        Ok(Float32Array::from(&narrow[..]))
    }

    /// The fitted shapes to be drawn, eight numbers each: 0 for a circle and 1 for a sphere,
    /// centre, normal, radius.
    pub fn fitted(&self) -> Result<Float32Array, JsValue> {
        let shapes = self.open()?.solver().fitted();
        let numbers = shapes.iter().flat_map(|shape| match *shape {
            Fitted::Circle { centre: c, normal: n, radius } => {
                [0.0, c.x, c.y, c.z, n.x, n.y, n.z, radius]
            }
            Fitted::Sphere { centre: c, radius } => [1.0, c.x, c.y, c.z, 0.0, 0.0, 1.0, radius],
        });
        let narrow: Vec<f32> = numbers.map(|number| number as f32).collect();
        Ok(Float32Array::from(&narrow[..]))
    }

    /// The projections of the constraints at the current positions: per point its vertex
    /// (`vertices`), the way from there to the point (`ways`, `#points by 3`, units of the mesh), and
    /// one more than the place of its colour in `palette` (`colours`); `outlines` are pairs of points.
    pub fn projections(&mut self) -> Result<JsValue, JsValue> {
        let session = self.open_mut()?;
        let (places, palette) = colours_of_rows(session);
        let found = session.projections();
        let ways: Vec<f32> = found.ways.as_flattened().iter().map(|&part| part as f32).collect();
        let colours: Vec<u8> = found.rows.iter().map(|&row| places[row as usize]).collect();
        object([
            ("vertices", Uint32Array::from(&found.vertices[..]).into()),
            ("ways", Float32Array::from(&ways[..]).into()),
            ("colours", Uint8Array::from(&colours[..]).into()),
            ("outlines", Uint32Array::from(found.outlines.as_flattened()).into()),
            ("palette", palette),
        ])
    }

    /// The faces and vertices that row `constraint` acts on.
    pub fn members(&self, constraint: usize) -> Result<JsValue, JsValue> {
        let [faces, vertices] = self.open()?.members(constraint);
        let indices = |indices: &[u32]| JsValue::from(Uint32Array::from(indices));
        object([("faces", indices(&faces)), ("vertices", indices(&vertices))])
    }

    /// The colour of the row of constraints that acts on each face and each vertex: `faces` (`#F`)
    /// and `vertices` (`#V`) are 0 where there is none, else one more than a place in `palette`,
    /// three numbers from 0 to 1 per colour.
    #[wasm_bindgen(js_name = rowColours)]
    pub fn row_colours(&self) -> Result<JsValue, JsValue> {
        let session = self.open()?;
        let acting = session.acting_rows();
        let (places, palette) = colours_of_rows(session);
        let narrow = |rows: &[Option<u32>]| {
            let places: Vec<u8> =
                rows.iter().map(|row| row.map_or(0, |row| places[row as usize])).collect();
            JsValue::from(Uint8Array::from(&places[..]))
        };
        object([
            ("faces", narrow(&acting.faces)),
            ("vertices", narrow(&acting.vertices)),
            ("palette", palette),
        ])
    }

    /// How many constraints a row of each kind would hold at each of the places, which are selectors as
    /// in an edit: `#kinds by #places`, null where nothing fits.
    pub fn previews(&self, places: JsValue) -> Result<JsValue, JsValue> {
        let places: Vec<Value> = serde_wasm_bindgen::from_value(places).map_err(thrown)?;
        let places: Vec<Place> = places.into_iter().map(place).collect::<Result<_, _>>()?;
        plain(&self.open()?.previews(&places).map_err(|error| thrown_at(&error))?)
    }

    /// The report, in the words and units of the command line.
    pub fn report(&self) -> Result<JsValue, JsValue> {
        plain(&self.open()?.report())
    }

    /// The scene file with the mesh inline.
    pub fn scene(&self) -> Result<String, JsValue> {
        let session = self.open()?;
        let mut scene = session.scene();
        scene.mesh = MeshSource::Inline(Box::new(session.mesh().clone()));
        Ok(scene.to_json(session.mesh()))
    }

    /// The current shape as OBJ.
    pub fn obj(&self) -> Result<String, JsValue> {
        Ok(self.open()?.obj())
    }

    /// A table as CSV: `errors` of faces, energies of the iterations (`convergence`), or `angles`.
    pub fn table(&mut self, what: &str) -> Result<String, JsValue> {
        let session = self.open_mut()?;
        match what {
            "errors" => Ok(session.errors_csv()),
            "convergence" => Ok(session.convergence_csv()),
            "angles" => Ok(session.angles_csv()),
            _ => Err(thrown(format!("unknown table {what:?}"))),
        }
    }

    /// Where the corners of each face start, `#F + 1`.
    #[wasm_bindgen(js_name = faceOffsets)]
    pub fn face_offsets(&self) -> Result<Uint32Array, JsValue> {
        Ok(Uint32Array::from(self.open()?.mesh().faces.offsets()))
    }

    /// The corners of all faces.
    #[wasm_bindgen(js_name = faceIndices)]
    pub fn face_indices(&self) -> Result<Uint32Array, JsValue> {
        Ok(Uint32Array::from(self.open()?.mesh().faces.indices()))
    }

    /// Where the vertices of each polyline start, `#curves + 1`.
    #[wasm_bindgen(js_name = curveOffsets)]
    pub fn curve_offsets(&self) -> Result<Uint32Array, JsValue> {
        Ok(Uint32Array::from(self.open()?.mesh().curves.offsets()))
    }

    /// The vertices of all polylines.
    #[wasm_bindgen(js_name = curveIndices)]
    pub fn curve_indices(&self) -> Result<Uint32Array, JsValue> {
        Ok(Uint32Array::from(self.open()?.mesh().curves.indices()))
    }

    pub(super) fn open(&self) -> Result<&Session, JsValue> {
        self.session.as_ref().ok_or_else(nothing_open)
    }

    pub(super) fn open_mut(&mut self) -> Result<&mut Session, JsValue> {
        self.session.as_mut().ok_or_else(nothing_open)
    }
}

fn nothing_open() -> JsValue {
    thrown("no model is open")
}

/// As a plain object: maps become objects, absent values null.
pub(super) fn plain(value: &impl Serialize) -> Result<JsValue, JsValue> {
    let serializer = serde_wasm_bindgen::Serializer::json_compatible();
    value.serialize(&serializer).map_err(thrown)
}

/// An object of typed arrays.
pub(super) fn object<const N: usize>(entries: [(&str, JsValue); N]) -> Result<JsValue, JsValue> {
    let object = js_sys::Object::new();
    for (key, value) in entries {
        js_sys::Reflect::set(&object, &key.into(), &value)?;
    }
    Ok(object.into())
}

/// Per row of constraints one more than the place of its colour in the palette, and the palette:
/// three parts from 0 to 1 per colour.
fn colours_of_rows(session: &Session) -> (Vec<u8>, JsValue) {
    let mut palette: Vec<[u8; 3]> = Vec::new();
    let colours = session.rows().iter().map(|row| row.constraints.kind.info().colour);
    let places = colours.map(|colour| {
        let known = palette.iter().position(|other| *other == colour);
        let place = known.unwrap_or(palette.len());
        if known.is_none() {
            palette.push(colour);
        }
        u8::try_from(place + 1).expect("there are fewer than 255 kinds")
    });
    let places = places.collect();
    let parts: Vec<f32> =
        palette.as_flattened().iter().map(|&part| f32::from(part) / 255.0).collect();
    (places, Float32Array::from(&parts[..]).into())
}

fn message_of(error: &JsValue) -> String {
    error.dyn_ref::<js_sys::Error>().map(|e| String::from(e.message())).unwrap_or_default()
}

fn scene_of(bytes: &[u8]) -> Result<Scene, JsValue> {
    let text =
        std::str::from_utf8(bytes).map_err(|_| thrown("a scene is UTF-8 text, and this is not"))?;
    Scene::from_json(text).map_err(thrown)
}

/// A constraint as the page describes it: like an entry of a scene file, on a [`place`].
fn new_constraint(
    kind: String,
    mut entry: Map<String, Value>,
    mut on: Value,
    weight: f64,
) -> Result<NewConstraint, JsValue> {
    let set = take_unnamed_set(&mut on)?;
    entry.insert("kind".to_owned(), kind.into());
    entry.insert("on".to_owned(), on);
    entry.insert("weight".to_owned(), weight.into());
    let entry = Value::Object(entry).to_string();
    let spec = ConstraintSpec::from_json(&entry).map_err(|error| thrown_at(&error))?;
    Ok(NewConstraint { spec, set })
}

/// A selector as the page describes it: like `on` of a scene file, but `in` may be a set without a
/// name, `{ faces }` or `{ vertices }`.
fn place(mut on: Value) -> Result<Place, JsValue> {
    let set = take_unnamed_set(&mut on)?;
    let on = Selector::from_json(&on.to_string()).map_err(|error| thrown_at(&error))?;
    Ok(Place { on, set })
}

fn take_unnamed_set(on: &mut Value) -> Result<Option<Set>, JsValue> {
    #[derive(Default, Deserialize)]
    #[serde(default)]
    struct Unnamed {
        vertices: Vec<u32>,
        faces: Vec<u32>,
    }
    let Some(within) = on.get_mut("in").filter(|within| within.is_object()) else {
        return Ok(None);
    };
    let Unnamed { vertices, faces } = serde_json::from_value(within.take()).map_err(thrown)?;
    *within = Place::UNNAMED.into();
    Ok(Some(Set { vertices, faces }))
}

/// What is thrown for an error in a scene or in an entry of one: an Error with its JSON path.
pub(super) fn thrown_at(error: &SceneError) -> JsValue {
    let thrown = thrown(error);
    // An object that was just made takes every property.
    let _ = js_sys::Reflect::set(&thrown, &"path".into(), &error.path.as_str().into());
    thrown
}
