//! Two pictures of the model on one canvas, left and right of a divider.

use super::view::View;
use crate::view::appearance::ColourScale;
use crate::view::side_by_side::Colours;
use crate::web::thrown;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl View {
    /// Shows two pictures, with the divider at a fraction `at` of the canvas width, from 0 to 1.
    #[wasm_bindgen(js_name = setSplit)]
    pub fn set_split(&mut self, at: f32) {
        self.pictures.set_split(at);
    }

    /// Sets what the left side (0) or the right side (1) shows: the shape `original` (#V by 3) or
    /// the current shape, its faces coloured by `values` (#F). If the value of a face is the
    /// largest of its vertices, `corners` has the values of the vertices (#V). Colours go from
    /// `low` to `high`; faces within the tolerance keep the material.
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

    /// Returns to a single picture.
    #[wasm_bindgen(js_name = clearSplit)]
    pub fn clear_split(&mut self) {
        self.pictures.clear_split();
    }
}
