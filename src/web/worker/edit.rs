//! Edits from the page, and previews of edits.

use super::solver::Solver;
use crate::session::Error;
use crate::session::{ConstraintTarget, Edit, Remeshing};
use crate::web::plain::{of_word, plain, text, thrown_at};
use crate::web::thrown;
use wasm_bindgen::prelude::*;

/// TypeScript types of values that serde reads by hand, and the form of enums with fields: an
/// object whose `type` names the variant.
#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
export type Sent<E> = E extends string ? { type: E } : { [K in keyof E]: { type: K } & E[K] }[keyof E];
export type PanelStart = "now" | "original" | "smoother";
export type Require = "soft" | "exact" | { within: number };
export type Within = string | { faces: number[] } | { vertices: number[] };
export type Selector = { each: string; in?: Within } | { vertices: number[] };
/** Elements of the mesh, ascending; edges as in `edges()`. */
export interface Elements { vertices: Uint32Array; edges: Uint32Array; faces: Uint32Array }
"#;

#[wasm_bindgen]
impl Solver {
    /// Makes an edit, as one step of undo.
    pub fn edit(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Sent<Edit>")] edit: JsValue,
    ) -> Result<(), JsValue> {
        let edit = self.read_edit(&edit)?;
        self.open_mut()?.edit(edit).map(|_| ()).map_err(refused)
    }

    /// Requires one shape of all panels, within `tolerance`, and begins a run: see
    /// [`crate::session::Session::make_panels`].
    #[wasm_bindgen(js_name = makePanels)]
    pub fn make_panels(
        &mut self,
        kind: &str,
        tolerance: f64,
        #[wasm_bindgen(unchecked_param_type = "PanelStart")] from: &str,
    ) -> Result<(), JsValue> {
        let from = of_word("start", from)?;
        self.open_mut()?.make_panels(kind, tolerance, from).map_err(refused)
    }

    /// Makes an edit and begins a run, together one step of undo.
    #[wasm_bindgen(js_name = editAndRun)]
    pub fn edit_and_run(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Sent<Edit>")] edit: JsValue,
    ) -> Result<(), JsValue> {
        let edit = self.read_edit(&edit)?;
        self.open_mut()?.edit_and_run(edit).map_err(refused)
    }

    /// Returns the operations on the mesh, with sizes that suit it.
    #[wasm_bindgen(js_name = meshOperations, unchecked_return_type = "OfferedOperation[]")]
    pub fn mesh_operations(&self) -> Result<JsValue, JsValue> {
        plain(&self.open()?.operations())
    }

    /// Returns a preview of an operation on the mesh.
    #[wasm_bindgen(unchecked_return_type = "RemeshingPreview")]
    pub fn remeshing(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Remeshing")] asked: JsValue,
    ) -> Result<JsValue, JsValue> {
        let asked = Remeshing::from_json(&text(&asked)?).map_err(|error| thrown_at(&error))?;
        plain(&self.open()?.remeshing(&asked).map_err(refused)?)
    }

    /// Returns the mesh sizes after refining by a scheme once, twice and so on. Edges at which the
    /// surface turns by more than `keep` degrees stay sharp.
    ///
    /// # Errors
    /// The mesh cannot be refined by this scheme.
    #[wasm_bindgen(unchecked_return_type = "Refinement[]")]
    pub fn refinements(&self, scheme: &str, keep: f64) -> Result<JsValue, JsValue> {
        let scheme = of_word("scheme", scheme)?;
        plain(&self.open()?.refinements(scheme, keep).map_err(refused)?)
    }

    /// Returns the number of constraints that a row of each kind would have on each of `places`,
    /// which are selectors as in an edit: `#kinds by #places`, null if no element fits.
    #[wasm_bindgen(unchecked_return_type = "(Preview | null)[][]")]
    pub fn previews(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Selector[]")] places: JsValue,
    ) -> Result<JsValue, JsValue> {
        let places =
            ConstraintTarget::all_from_json(&text(&places)?).map_err(|error| thrown_at(&error))?;
        plain(&self.open()?.previews(&places).map_err(|error| thrown_at(&error))?)
    }
}

impl Solver {
    fn read_edit(&self, edit: &JsValue) -> Result<Edit, JsValue> {
        let edit = Edit::from_json(&text(edit)?, self.open()?.document());
        edit.map_err(|error| thrown_at(&error))
    }
}

fn refused(error: Error) -> JsValue {
    match error {
        Error::Scene(error) => thrown_at(&error),
        error => thrown(error),
    }
}
