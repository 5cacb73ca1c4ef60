//! Changes of the open model: edits, undo, and what was found on a copy of it by
//! [`crate::web::jobs`].

use super::solver::Solver;
use crate::mesh::Point;
use crate::session::{Edit, ExactReport, ExactShape, PanelStart};
use crate::web::values::{Js, read, read_back, refused};
use crate::web::{mesh_of, thrown};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Solver {
    /// Makes an edit, as one step of undo.
    pub fn edit(&mut self, edit: Js<Edit>) -> Result<(), JsValue> {
        let edit = read(edit)?;
        self.open_mut()?.edit(edit).map(|_| ()).map_err(refused)
    }

    /// Makes an edit and begins a run, together one step of undo.
    #[wasm_bindgen(js_name = editAndRun)]
    pub fn edit_and_run(&mut self, edit: Js<Edit>) -> Result<(), JsValue> {
        let edit = read(edit)?;
        self.open_mut()?.edit_and_run(edit).map_err(refused)
    }

    /// Requires one shape of all panels, within `tolerance`, and begins a run: see
    /// [`crate::session::Session::make_panels`].
    #[wasm_bindgen(js_name = makePanels)]
    pub fn make_panels(
        &mut self,
        kind: &str,
        tolerance: f64,
        from: Js<PanelStart>,
    ) -> Result<(), JsValue> {
        let from = read(from)?;
        self.open_mut()?.make_panels(kind, tolerance, from).map_err(refused)
    }

    /// Puts panels in place of the mesh, if the model still has this generation: see
    /// [`crate::session::Session::take_panels`]. The positions are `#V by 3`; panel `k` has the corners
    /// from `offsets[k]` to `offsets[k + 1]` of `indices`.
    #[wasm_bindgen(js_name = takePanels)]
    pub fn take_panels(
        &mut self,
        generation: u32,
        positions: &[f64],
        offsets: &[u32],
        indices: &[u32],
    ) -> Result<bool, JsValue> {
        let panels = mesh_of(positions, offsets, indices);
        self.open_mut()?.take_panels(generation, &panels).map_err(refused)
    }

    /// Undoes the last step; returns its name, or undefined.
    pub fn undo(&mut self) -> Result<Option<String>, JsValue> {
        self.open_mut()?.undo().map_err(thrown)
    }

    /// Repeats the step that was last undone; returns its name, or undefined.
    pub fn redo(&mut self) -> Result<Option<String>, JsValue> {
        self.open_mut()?.redo().map_err(thrown)
    }

    /// See [`crate::session::Session::make_exact`]; `positions` are `#V by 3`.
    #[wasm_bindgen(js_name = makeExact)]
    pub fn make_exact(
        &mut self,
        shape: Js<ExactShape>,
        positions: &[f64],
        unasked: bool,
    ) -> Result<bool, JsValue> {
        let shape: ExactShape = read_back(shape)?;
        self.open_mut()?.make_exact(shape, points(positions), unasked).map_err(thrown)
    }

    /// Shows `positions`, `#V by 3`, of a variation of the shape with this generation, with a report
    /// if they were brought back onto the constraints: see
    /// [`crate::session::Session::show_variation`].
    #[wasm_bindgen(js_name = showVariation)]
    pub fn show_variation(
        &mut self,
        generation: u32,
        positions: &[f64],
        report: Option<Js<ExactReport>>,
    ) -> Result<bool, JsValue> {
        let report = report.map(read_back).transpose()?;
        Ok(self.open_mut()?.show_variation(generation, points(positions), report))
    }

    /// See [`crate::session::Session::keep_variation`].
    #[wasm_bindgen(js_name = keepVariation)]
    pub fn keep_variation(&mut self) -> Result<bool, JsValue> {
        self.open_mut()?.keep_variation().map_err(thrown)
    }

    /// Restores the shape from before a variation that is shown but not kept.
    #[wasm_bindgen(js_name = leaveVariation)]
    pub fn leave_variation(&mut self) -> Result<(), JsValue> {
        self.open_mut()?.leave_variation();
        Ok(())
    }

    /// Stores numbers of the build of the shape with these `positions` (`#V by 3`), if it is still the
    /// current one: `ids` and as many `values`.
    #[wasm_bindgen(js_name = setBuildNumbers)]
    pub fn set_build_numbers(
        &mut self,
        positions: &[f64],
        ids: Vec<String>,
        values: &[f64],
    ) -> Result<(), JsValue> {
        let session = self.open_mut()?;
        if session.positions() == points(positions) {
            session.set_build_numbers(ids.into_iter().zip(values.iter().copied()).collect());
        }
        Ok(())
    }
}

fn points(positions: &[f64]) -> &[Point] {
    positions.as_chunks().0
}
