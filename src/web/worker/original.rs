//! The original beside the current shape, and single half steps of an iteration.

use super::solver::Solver;
use crate::session::Shape;
use crate::web::plain::plain;
use crate::web::thrown;
use js_sys::Float64Array;
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// Histograms of the corner angles of the faces, in bins of equal width from 0 to 180 degrees.
#[derive(Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), tsify(missing_as_null))]
struct Angles {
    original: Vec<u32>,
    now: Vec<u32>,
}

#[wasm_bindgen]
impl Solver {
    /// Does the next half of an iteration; returns what was fitted, or how the vertices moved.
    #[wasm_bindgen(js_name = halfStep, unchecked_return_type = "HalfStep")]
    pub fn half_step(&mut self) -> Result<JsValue, JsValue> {
        let half = self.open_mut()?.half_step().map_err(thrown)?;
        plain(&half)
    }

    /// Returns the positions of the original, `#V by 3`.
    #[wasm_bindgen(js_name = originalPositions)]
    pub fn original_positions(&self) -> Result<Float64Array, JsValue> {
        Ok(Float64Array::from(self.open()?.mesh().positions.as_flattened()))
    }

    /// Returns the histograms of the corner angles, of the original and of the current shape.
    #[wasm_bindgen(unchecked_return_type = "Angles")]
    pub fn angles(&self) -> Result<JsValue, JsValue> {
        let session = self.open()?;
        let [original, now] = [Shape::Original, Shape::Now].map(|shape| session.angles(shape));
        plain(&Angles { original, now })
    }
}
