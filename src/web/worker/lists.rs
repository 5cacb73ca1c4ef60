//! Lists of elements: the verdict on the panels, the worst elements, elements with a flaw.

use super::solver::Solver;
use crate::web::plain::{plain, selection};
use crate::web::thrown;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Solver {
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

    /// Returns how many panels meet their requirement within a tolerance (units of the mesh); null
    /// if no row requires a shape of the panels.
    #[wasm_bindgen(unchecked_return_type = "Verdict | null")]
    pub fn verdict(&mut self, tolerance: f64) -> Result<JsValue, JsValue> {
        plain(&self.open_mut()?.verdict(tolerance))
    }

    /// Returns the vertices, edges and faces with a flaw, as a selection.
    #[wasm_bindgen(unchecked_return_type = "Elements")]
    pub fn flawed(&self, name: &str) -> Result<JsValue, JsValue> {
        let session = self.open()?;
        let found = session.elements_with_problem(name);
        let found = found.ok_or_else(|| thrown(format!("unknown flaw {name:?}")))?;
        selection(&found.vertices, &session.edges_between(&found.edges), &found.faces)
    }
}
