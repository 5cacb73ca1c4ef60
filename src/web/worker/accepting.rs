//! What was found on a copy of the model by [`crate::web::jobs`], shown and accepted; and the
//! variants that were kept.

use super::solver::Solver;
use crate::mesh::Point;
use crate::session::ExactShape;
use crate::web::plain::plain;
use crate::web::thrown;
use js_sys::Float64Array;
use serde::de::DeserializeOwned;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl Solver {
    /// See [`crate::session::Session::make_exact`]; `positions` are `#V by 3`.
    #[wasm_bindgen(js_name = makeExact)]
    pub fn make_exact(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "ExactShape")] shape: JsValue,
        positions: &[f64],
        joins: bool,
    ) -> Result<bool, JsValue> {
        let shape: ExactShape = value(shape)?;
        self.open_mut()?.make_exact(shape, points(positions), joins).map_err(thrown)
    }

    /// Shows `positions`, `#V by 3`, of a variation of the shape with this generation, with a report
    /// if they were brought back onto the constraints: see
    /// [`crate::session::Session::show_variation`].
    #[wasm_bindgen(js_name = showVariation)]
    pub fn show_variation(
        &mut self,
        generation: u32,
        positions: &[f64],
        #[wasm_bindgen(unchecked_param_type = "ExactReport | null")] report: JsValue,
    ) -> Result<bool, JsValue> {
        Ok(self.open_mut()?.show_variation(generation, points(positions), value(report)?))
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

    /// Returns the numbers of the variants that were kept.
    #[wasm_bindgen(js_name = variantTable, unchecked_return_type = "VariantRow[]")]
    pub fn variant_table(&mut self, tolerance: f64) -> Result<JsValue, JsValue> {
        plain(&self.open_mut()?.variant_table(tolerance).map_err(thrown)?)
    }

    /// Returns the positions of a variant, `#V by 3`.
    #[wasm_bindgen(js_name = variantPositions)]
    pub fn variant_positions(&self, index: usize) -> Result<Float64Array, JsValue> {
        let kept = &self.open()?.document().variants.kept;
        let variant = kept.get(index).ok_or_else(|| thrown("there is no such variant"))?;
        Ok(Float64Array::from(variant.positions.as_flattened()))
    }
}

fn points(positions: &[f64]) -> &[Point] {
    positions.as_chunks().0
}

fn value<T: DeserializeOwned>(value: JsValue) -> Result<T, JsValue> {
    serde_wasm_bindgen::from_value(value).map_err(thrown)
}
