//! The solver in the worker: the open model, its iterations, its runs and drags.

use crate::mesh::Weld;
use crate::session::{DragPhase, FileReader, HalfStep, OpenedFile, Session};
use crate::solve::clock;
use crate::web::values::{Js, plain, read};
use crate::web::{log_panics, thrown};
use js_sys::Float64Array;
use wasm_bindgen::prelude::*;

/// The interface of the worker to the one model that is open.
#[wasm_bindgen]
#[derive(Default)]
pub struct Solver {
    pub(super) session: Option<Session>,
    pub(super) files: FileReader,
    /// What is to be opened next, and how many seconds it took to read.
    pub(super) read: Option<(OpenedFile, f64)>,
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

    /// Does one iteration; returns true when the run has ended.
    pub fn step(&mut self) -> Result<bool, JsValue> {
        let started = clock::now();
        let step = self.open_mut()?.step().map_err(thrown)?;
        self.step_ms = 1e3 * (clock::now() - started);
        Ok(step.ended)
    }

    /// Does one iteration as a run, without meeting hard constraints; returns whether there is
    /// no reason to continue: it converged.
    #[wasm_bindgen(js_name = singleStep)]
    pub fn single_step(&mut self) -> Result<bool, JsValue> {
        Ok(self.open_mut()?.single_step().map_err(thrown)?.ended)
    }

    /// Does the next half of an iteration; returns what was fitted, or how the vertices moved.
    #[wasm_bindgen(js_name = halfStep)]
    pub fn half_step(&mut self) -> Result<Js<HalfStep>, JsValue> {
        let half = self.open_mut()?.half_step().map_err(thrown)?;
        plain(&half)
    }

    /// Begins a run: all iterations until [`Solver::end_run`] become one step of undo.
    #[wasm_bindgen(js_name = beginRun)]
    pub fn begin_run(&mut self) -> Result<(), JsValue> {
        self.open_mut()?.begin_run();
        Ok(())
    }

    /// Ends a run; describes how it has collapsed the shape, as the end of a sentence, or returns
    /// undefined.
    #[wasm_bindgen(js_name = endRun)]
    pub fn end_run(&mut self) -> Result<Option<String>, JsValue> {
        Ok(self.open_mut()?.end_run().map(|collapse| collapse.to_string()))
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

    /// Describes how the last run has collapsed the shape, as the end of a sentence, or returns undefined.
    pub fn collapse(&self) -> Result<Option<String>, JsValue> {
        Ok(self.open()?.collapse().map(|collapse| collapse.to_string()))
    }

    /// Drags handles. `targets` is `#vertices by 3`, or empty if none moves.
    ///
    /// # Errors
    /// An unknown phase, or targets that are not one per vertex, not finite or too far out. Nothing
    /// moves then, and an "end" keeps the last move.
    pub fn drag(
        &mut self,
        vertices: &[u32],
        targets: &[f64],
        phase: Js<DragPhase>,
    ) -> Result<(), JsValue> {
        let (targets, rest) = targets.as_chunks::<3>();
        if !rest.is_empty() {
            let numbers = 3 * targets.len() + rest.len();
            return Err(thrown(format!("found {numbers} coordinates, expected three per target")));
        }
        self.open_mut()?.drag_through(read(phase)?, vertices, targets).map_err(thrown)
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
}

impl Solver {
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
