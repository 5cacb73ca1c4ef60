//! The interface of the solver in the worker.

use super::report::{self, Document, elements, kinds};
use crate::mesh::Weld;
use crate::session::{FACE_MEASURES, FileReader, Session};
use crate::solve::clock;
use crate::web::plain::plain;
use crate::web::{log_panics, thrown};
use js_sys::{Float64Array, Uint32Array};
use wasm_bindgen::prelude::*;

/// The interface of the worker to the one model that is open.
#[wasm_bindgen]
#[derive(Default)]
pub struct Solver {
    pub(super) session: Option<Session>,
    pub(super) files: FileReader,
    /// How the vertices of the open mesh were welded, if they were.
    pub(super) weld: Option<Weld>,
    /// The generation of the mesh that was last reported to the page.
    pub(super) mesh_generation: u32,
    pub(super) step_ms: f64,
}

#[wasm_bindgen]
impl Solver {
    /// Creates a solver without a model.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Solver {
        log_panics();
        Solver::default()
    }

    /// Returns all kinds of constraints.
    #[wasm_bindgen(unchecked_return_type = "KindWords[]")]
    pub fn kinds(&self) -> Result<JsValue, JsValue> {
        plain(&kinds())
    }

    /// Returns the elements on which constraints can act, one constraint per element.
    #[wasm_bindgen(unchecked_return_type = "ElementWords[]")]
    pub fn elements(&self) -> Result<JsValue, JsValue> {
        plain(&elements())
    }

    /// Returns the measures of faces.
    #[wasm_bindgen(unchecked_return_type = "FaceMeasure[]")]
    pub fn measures(&self) -> Result<JsValue, JsValue> {
        plain(&FACE_MEASURES)
    }

    /// Returns the document: constraints, handles, weights, undo and redo.
    #[wasm_bindgen(unchecked_return_type = "Document")]
    pub fn document(&self) -> Result<JsValue, JsValue> {
        plain(&Document::new(self.open()?))
    }

    /// Undoes the last step; returns its name, or undefined.
    pub fn undo(&mut self) -> Result<Option<String>, JsValue> {
        self.open_mut()?.undo().map_err(thrown)
    }

    /// Repeats the step that was last undone; returns its name, or undefined.
    pub fn redo(&mut self) -> Result<Option<String>, JsValue> {
        self.open_mut()?.redo().map_err(thrown)
    }

    /// Does one iteration; returns true when the run has ended.
    pub fn step(&mut self) -> Result<bool, JsValue> {
        let started = clock::now();
        let step = self.open_mut()?.step().map_err(thrown)?;
        self.step_ms = 1e3 * (clock::now() - started);
        Ok(step.ended)
    }

    /// Does one iteration as a run, without meeting hard constraints; returns whether it converged.
    #[wasm_bindgen(js_name = singleStep)]
    pub fn single_step(&mut self) -> Result<bool, JsValue> {
        Ok(self.open_mut()?.single_step().map_err(thrown)?.ended)
    }

    /// Describes how the shape has collapsed, as the end of a sentence, or returns undefined.
    pub fn collapse(&self) -> Result<Option<String>, JsValue> {
        Ok(self.open()?.collapse().map(|collapse| collapse.to_string()))
    }

    /// Lets the current run continue although the shape has collapsed.
    #[wasm_bindgen(js_name = ignoreCollapse)]
    pub fn ignore_collapse(&mut self) -> Result<(), JsValue> {
        self.open_mut()?.ignore_collapse();
        Ok(())
    }

    /// Begins a run: all iterations until [`Solver::end_run`] become one step of undo.
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

    /// Returns whether a run is in progress; the end of a drag may begin one.
    #[wasm_bindgen(js_name = isRunning)]
    pub fn is_running(&self) -> Result<bool, JsValue> {
        Ok(self.open()?.is_running())
    }

    /// Returns whether the run is meeting hard constraints, a step of which may take seconds.
    #[wasm_bindgen(js_name = isMeeting)]
    pub fn is_meeting(&self) -> Result<bool, JsValue> {
        Ok(self.open()?.is_meeting())
    }

    /// See [`crate::session::Session::generation`].
    pub fn generation(&self) -> Result<u32, JsValue> {
        Ok(self.open()?.generation())
    }

    /// Returns the number of the current iteration.
    pub fn iteration(&self) -> Result<u32, JsValue> {
        Ok(self.open()?.iteration())
    }

    /// Returns the energies of the iterations that led to the current state, `#iterations by 6`:
    /// iteration, shape, close, smooth, handles, total.
    pub fn trace(&self) -> Result<Float64Array, JsValue> {
        let entries = self.open()?.trace().iter().map(|entry| {
            let e = entry.energy;
            [f64::from(entry.iteration), e.shape, e.close, e.smooth, e.handles, e.total]
        });
        Ok(Float64Array::from(entries.collect::<Vec<_>>().as_flattened()))
    }

    /// Returns the numbers of the current state. While `iterating`, planarity and circularity may
    /// be half a second old.
    #[wasm_bindgen(unchecked_return_type = "Frame")]
    pub fn frame(&mut self, iterating: bool) -> Result<JsValue, JsValue> {
        let step_ms = self.step_ms;
        plain(&report::Frame::new(self.open_mut()?, step_ms, iterating))
    }

    /// Writes the current positions, `#V by 3`.
    #[wasm_bindgen(js_name = writePositions)]
    pub fn write_positions(&self, out: &Float64Array) -> Result<(), JsValue> {
        out.copy_from(self.open()?.positions().as_flattened());
        Ok(())
    }

    /// Returns the report, in the words and units of the command line.
    pub fn report(&self) -> Result<JsValue, JsValue> {
        plain(&self.open()?.report())
    }

    /// Returns the scene file with the mesh inline.
    pub fn scene(&self) -> Result<String, JsValue> {
        Ok(self.open()?.scene_with_mesh())
    }

    /// Returns the current shape as OBJ.
    pub fn obj(&self) -> Result<String, JsValue> {
        Ok(self.open()?.obj())
    }

    /// Returns the current shape as OBJ with the vertices and faces of the file before welding.
    #[wasm_bindgen(js_name = objUnwelded)]
    pub fn obj_unwelded(&self) -> Result<String, JsValue> {
        let session = self.open()?;
        let weld = self.weld.as_ref().filter(|_| session.mesh_generation() == 0);
        Ok(weld.map_or_else(|| session.obj(), |weld| session.obj_unwelded(weld)))
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

    /// Returns where the corners of each face start, `#F + 1`.
    #[wasm_bindgen(js_name = faceOffsets)]
    pub fn face_offsets(&self) -> Result<Uint32Array, JsValue> {
        Ok(Uint32Array::from(self.open()?.mesh().faces.offsets()))
    }

    /// Returns the corners of all faces.
    #[wasm_bindgen(js_name = faceIndices)]
    pub fn face_indices(&self) -> Result<Uint32Array, JsValue> {
        Ok(Uint32Array::from(self.open()?.mesh().faces.indices()))
    }

    /// Returns where the vertices of each polyline start, `#curves + 1`.
    #[wasm_bindgen(js_name = curveOffsets)]
    pub fn curve_offsets(&self) -> Result<Uint32Array, JsValue> {
        Ok(Uint32Array::from(self.open()?.mesh().curves.offsets()))
    }

    /// Returns the vertices of all polylines.
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
