//! Timings for benchmarks.

use super::solver::Solver;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Solver {
    /// Returns the seconds spent in all iterations so far, by part: projections, closeness,
    /// smoothness and handles, and the global step.
    #[wasm_bindgen(js_name = iterateSeconds)]
    pub fn iterate_seconds(&self) -> Result<Vec<f64>, JsValue> {
        let seconds = self.open()?.solver().iterate_seconds();
        Ok(vec![seconds.shape, seconds.close, seconds.smooth, seconds.global])
    }
}
