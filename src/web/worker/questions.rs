//! Questions about the open model: its report, verdicts in words, lists of elements, selections, and
//! previews of edits.

use super::edit::refused;
use super::solver::Solver;
use crate::session::{
    ConstraintTarget, Remeshing, SelectRequest, Session, Shape, Verdict, VerdictWords,
};
use crate::web::plain::{indices, object, of_word, plain, selection, text, thrown_at};
use crate::web::thrown;
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// The verdict on the panels, in numbers and in words.
#[derive(Serialize, tsify::Tsify)]
struct PanelVerdict {
    #[serde(flatten)]
    numbers: Verdict,
    words: VerdictWords,
}

impl PanelVerdict {
    fn of(session: &Session, numbers: Verdict) -> PanelVerdict {
        let words = session.verdict_words(&numbers);
        PanelVerdict { numbers, words }
    }
}

/// Histograms of the corner angles of the faces, in bins of equal width from 0 to 180 degrees.
#[derive(Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
struct Angles {
    original: Vec<u32>,
    now: Vec<u32>,
}

#[wasm_bindgen]
impl Solver {
    /// Returns the report, in the words and units of the command line.
    pub fn report(&self) -> Result<JsValue, JsValue> {
        plain(&self.open()?.report())
    }

    /// Returns how many panels meet their requirement within a tolerance (units of the mesh); null
    /// if no row requires a shape of the panels.
    #[wasm_bindgen(unchecked_return_type = "PanelVerdict | null")]
    pub fn verdict(&mut self, tolerance: f64) -> Result<JsValue, JsValue> {
        let session = self.open_mut()?;
        let verdict = session.verdict(tolerance);
        plain(&verdict.map(|verdict| PanelVerdict::of(session, verdict)))
    }

    /// Returns whether the constraints are met within a tolerance (units of the mesh), after a run
    /// without hard constraints; null if no constraint has a weight.
    #[wasm_bindgen(js_name = runVerdict, unchecked_return_type = "RunVerdict | null")]
    pub fn run_verdict(&mut self, tolerance: f64) -> Result<JsValue, JsValue> {
        plain(&self.open_mut()?.run_verdict(tolerance))
    }

    /// Returns how well the hard constraints are met; null if they have not been met for the
    /// current shape.
    #[wasm_bindgen(js_name = exactWords, unchecked_return_type = "ExactWords | null")]
    pub fn exact_words(&self) -> Result<JsValue, JsValue> {
        plain(&self.open()?.exact_words())
    }

    /// Returns the numbers of the variants that were kept.
    #[wasm_bindgen(js_name = variantTable, unchecked_return_type = "VariantRow[]")]
    pub fn variant_table(&mut self, tolerance: f64) -> Result<JsValue, JsValue> {
        plain(&self.open_mut()?.variant_table(tolerance).map_err(thrown)?)
    }

    /// Returns the histograms of the corner angles, of the original and of the current shape.
    #[wasm_bindgen(unchecked_return_type = "Angles")]
    pub fn angles(&self) -> Result<JsValue, JsValue> {
        let session = self.open()?;
        let [original, now] = [Shape::Original, Shape::Now].map(|shape| session.angles(shape));
        plain(&Angles { original, now })
    }

    /// Returns the `count` worst faces by a measure.
    #[wasm_bindgen(js_name = worstFaces, unchecked_return_type = "WorstElement[]")]
    pub fn worst_faces(&mut self, measure: &str, count: usize) -> Result<JsValue, JsValue> {
        let worst = self.open_mut()?.worst_faces(measure, count);
        plain(&worst.ok_or_else(|| thrown(format!("unknown measure {measure:?}")))?)
    }

    /// Returns the `count` worst constraints of a row.
    #[wasm_bindgen(js_name = worstConstraints, unchecked_return_type = "WorstElement[]")]
    pub fn worst_constraints(&mut self, row: usize, count: usize) -> Result<JsValue, JsValue> {
        plain(&self.open_mut()?.worst_constraints(row, count))
    }

    /// Returns the vertices, edges and faces with a flaw, as a selection.
    #[wasm_bindgen(unchecked_return_type = "Elements")]
    pub fn flawed(&self, name: &str) -> Result<JsValue, JsValue> {
        let session = self.open()?;
        let found = session.elements_with_problem(name);
        let found = found.ok_or_else(|| thrown(format!("unknown flaw {name:?}")))?;
        selection(&found.vertices, &session.edges_between(&found.edges), &found.faces)
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

    /// Returns the faces and vertices on which row `constraint` acts.
    #[wasm_bindgen(unchecked_return_type = "Members")]
    pub fn members(&self, constraint: usize) -> Result<JsValue, JsValue> {
        let [faces, vertices] = self.open()?.members(constraint);
        object([("faces", indices(&faces)), ("vertices", indices(&vertices))])
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
