//! What only ways of seeing ask the solver.

use super::solver::Solver;
use js_sys::{Float32Array, Float64Array};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Solver {
    /// The positions of the model that was opened, `#V by 3`.
    #[wasm_bindgen(js_name = restPositions)]
    pub fn rest_positions(&self) -> Result<Float64Array, JsValue> {
        Ok(Float64Array::from(self.open()?.mesh().positions.as_flattened()))
    }

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
