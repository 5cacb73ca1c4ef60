//! Selections, and the declared operations and settings.

use super::solver::Solver;
use crate::session::{OPERATIONS, SETTINGS, SelectRequest};
use crate::web::plain::{plain, selection, text, thrown_at};
use js_sys::Uint32Array;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Solver {
    /// Returns the declared selection operations.
    #[wasm_bindgen(unchecked_return_type = "Operation[]")]
    pub fn operations(&self) -> Result<JsValue, JsValue> {
        plain(&OPERATIONS)
    }

    /// Returns the declared settings of a scene.
    #[wasm_bindgen(unchecked_return_type = "Setting[]")]
    pub fn settings(&self) -> Result<JsValue, JsValue> {
        plain(&SETTINGS)
    }

    /// Returns the edges of the mesh: `#E by 2` vertices, in the numbering that selections use.
    pub fn edges(&self) -> Result<Uint32Array, JsValue> {
        Ok(Uint32Array::from(self.open()?.topology().edges().as_flattened()))
    }

    /// Returns the selection after an operation.
    #[wasm_bindgen(unchecked_return_type = "Elements")]
    pub fn select(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "SelectRequest")] request: JsValue,
    ) -> Result<JsValue, JsValue> {
        let request =
            SelectRequest::from_json(&text(&request)?).map_err(|error| thrown_at(&error))?;
        let found = self.open_mut()?.select(&request).map_err(|error| thrown_at(&error))?;
        selection(&found.vertices, &found.edges, &found.faces)
    }
}
