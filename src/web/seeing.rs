//! What only ways of seeing ask the solver.

use super::solver::Solver;
use js_sys::Float32Array;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Solver {
    /// The values of the vertices, `#V`, whose largest the faces have in a measure; nothing where the
    /// measure is not of vertices.
    #[wasm_bindgen(js_name = cornerValues)]
    pub fn corner_values(&self, measure: &str) -> Result<Option<Float32Array>, JsValue> {
        let values = self.open()?.corner_values(measure);
        let narrow =
            |values: Vec<f64>| values.iter().map(|&value| value as f32).collect::<Vec<_>>();
        Ok(values.map(|values| Float32Array::from(&narrow(values)[..])))
    }
}
