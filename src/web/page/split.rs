//! Two pictures of the model on one canvas, left and right of a divider.

use super::view::View;
use crate::view::appearance::ColourScale;
use crate::view::side_by_side::Colours;
use crate::web::thrown;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl View {
    /// Puts the divider at a part of the width of the canvas, from 0 to 1; begins to show two pictures.
    #[wasm_bindgen(js_name = setSplit)]
    pub fn set_split(&mut self, at: f32) {
        self.pictures.set_split(at);
    }

    /// Sets what the left side (0) or the right side (1) shows: the shape `original` (#V by 3) or the shape
    /// as it is, with its faces coloured by a value each (#F), and by those of the vertices (#V) whose
    /// greatest they are, where they are such. The colours go from `low` to `high`; up to a tolerance the
    /// faces keep the material.
    ///
    /// # Errors
    /// Arrays that do not fit the mesh.
    #[allow(
        clippy::too_many_arguments,
        reason = "numbers and arrays cross as they are, without an object"
    )]
    #[wasm_bindgen(js_name = setSplitSide)]
    pub fn set_split_side(
        &mut self,
        side: usize,
        original: Option<Vec<f64>>,
        values: Option<Vec<f32>>,
        corners: Option<Vec<f32>>,
        low: f32,
        high: f32,
        tolerance: Option<f32>,
    ) -> Result<(), JsValue> {
        let scale = ColourScale { tolerance, ..ColourScale::linear(low, high) };
        let colours = Colours { values, corners, scale };
        self.pictures.set_split_side(side, original.as_deref(), colours).map_err(thrown)
    }

    /// Shows one picture again.
    #[wasm_bindgen(js_name = clearSplit)]
    pub fn clear_split(&mut self) {
        self.pictures.clear_split();
    }
}
