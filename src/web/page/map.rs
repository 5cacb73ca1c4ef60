//! The flat map beside the model, on the same canvas.

use super::view::View;
use crate::view::appearance::ColourScale;
use crate::view::pictures::Region;
use crate::web::thrown;
use glam::Vec2;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl View {
    /// Shows the flat map `uv` (#V by 2) beside the mesh, replacing an earlier one, and outlines
    /// the faces that it flips.
    ///
    /// # Errors
    /// A wrong number of points, one that is not finite, or an unknown face; nothing changes then.
    #[wasm_bindgen(js_name = setMap)]
    pub fn set_map(&mut self, uv: &[f64], flipped: &[u32]) -> Result<(), JsValue> {
        self.pictures.set_map(uv, flipped).map_err(thrown)
    }

    /// Removes the flat map.
    #[wasm_bindgen(js_name = clearMap)]
    pub fn clear_map(&mut self) {
        self.pictures.clear_map();
    }

    /// Draws a checkerboard, with `squares` along the longer side of the map, on the model, the
    /// map, or both, and colours each face of the map by its value (#F), from `low` to `high`.
    ///
    /// # Errors
    /// A wrong number of values.
    #[wasm_bindgen(js_name = setMapLooks)]
    pub fn set_map_looks(
        &mut self,
        squares: f32,
        on_model: bool,
        on_map: bool,
        values: Option<Vec<f32>>,
        low: f64,
        high: f64,
    ) -> Result<(), JsValue> {
        let scale = ColourScale::linear(low, high);
        let looks = self.pictures.set_map_looks(squares, [on_model, on_map], values, scale);
        looks.map_err(thrown)
    }

    /// Returns the map's region in CSS pixels: left, top, width, height; undefined without a map.
    #[wasm_bindgen(js_name = mapRegion)]
    pub fn map_region(&self) -> Option<Vec<f32>> {
        let Region { at, size } = self.pictures.map_region()?;
        Some(vec![at.x, at.y, size.x, size.y])
    }

    /// Slides the map by a drag.
    #[wasm_bindgen(js_name = panMap)]
    pub fn pan_map(&mut self, dx: f32, dy: f32) {
        if let Some(map) = self.pictures.map_mut() {
            map.pan(dx, dy);
        }
    }

    /// Enlarges the map by `factor` about a point in its part of the canvas.
    #[wasm_bindgen(js_name = zoomMap)]
    pub fn zoom_map(&mut self, factor: f32, x: f32, y: f32) {
        if let Some(map) = self.pictures.map_mut() {
            map.zoom(factor, Vec2::new(x, y));
        }
    }

    /// Zooms to the faces that the map flips, on the model and on the map.
    #[wasm_bindgen(js_name = showFlipped)]
    pub fn show_flipped(&mut self) {
        self.pictures.show_flipped();
    }

    /// Fits the map to its part of the canvas.
    #[wasm_bindgen(js_name = fitMap)]
    pub fn fit_map(&mut self) {
        if let Some(map) = self.pictures.map_mut() {
            map.fit();
        }
    }
}
