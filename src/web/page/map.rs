//! The flat map of the model beside it: two parts of one canvas.

use super::view::View;
use crate::view::appearance::ColourScale;
use crate::view::side_by_side::{Region, flat_map, show_flipped};
use crate::web::thrown;
use glam::Vec2;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl View {
    /// Shows the flat map `uv` (#V by 2) of the mesh beside it, in place of one that is shown already,
    /// and outlines the faces that it turns over.
    ///
    /// # Errors
    /// Another number of places than vertices, one that is not finite, or a face that does not exist;
    /// all stays as it was.
    #[wasm_bindgen(js_name = setMap)]
    pub fn set_map(&mut self, uv: &[f64], flipped: &[u32]) -> Result<(), JsValue> {
        let (map, checks) = flat_map(&self.state, uv, flipped).map_err(thrown)?;
        self.state.checks = checks;
        self.state.changes.checks = true;
        // The marks of the model are those of the map too.
        self.state.changes.appearance = true;
        let first = self.map.replace(map).is_none();
        self.arrange();
        if first {
            self.state.fit();
        }
        Ok(())
    }

    /// Takes the flat map away.
    #[wasm_bindgen(js_name = clearMap)]
    pub fn clear_map(&mut self) {
        if self.map.take().is_none() {
            return;
        }
        self.state.checks = Default::default();
        self.state.changes.checks = true;
        self.arrange();
        self.state.fit();
    }

    /// Draws a checkerboard with so many squares along the longer side of the map on the model, on the
    /// map, or on both; and colours the faces of the map by a value each (#F), from `low` to `high`.
    ///
    /// # Errors
    /// Another number of values than faces.
    #[wasm_bindgen(js_name = setMapLooks)]
    pub fn set_map_looks(
        &mut self,
        squares: f32,
        on_model: bool,
        on_map: bool,
        values: Option<Vec<f32>>,
        low: f32,
        high: f32,
    ) -> Result<(), JsValue> {
        let Some(map) = &mut self.map else { return Ok(()) };
        let longest = map.checks.extent().max_element();
        let per_length = if longest > 0.0 { squares / longest } else { 0.0 };
        let drawn = |is_drawn: bool| if is_drawn { per_length } else { 0.0 };
        self.state.checks.per_length = drawn(on_model);
        map.checks.per_length = drawn(on_map);
        let (_, faces) = map.counts();
        map.appearance.set_values(values, ColourScale::linear(low, high), faces).map_err(thrown)?;
        map.changes.appearance = true;
        self.state.changes.view = true;
        Ok(())
    }

    /// Where the map is on the canvas, CSS pixels: left, top, width, height; nothing without a map.
    #[wasm_bindgen(js_name = mapRegion)]
    pub fn map_region(&self) -> Option<Vec<f32>> {
        self.map.as_ref()?;
        let [_, Region { at, size }] = Region::halves(self.canvas_size);
        Some(vec![at.x, at.y, size.x, size.y])
    }

    /// Slides the map by a drag.
    #[wasm_bindgen(js_name = panMap)]
    pub fn pan_map(&mut self, dx: f32, dy: f32) {
        if let Some(map) = &mut self.map {
            map.pan(dx, dy);
        }
    }

    /// Makes the map `factor` times larger about a place in its part of the canvas.
    #[wasm_bindgen(js_name = zoomMap)]
    pub fn zoom_map(&mut self, factor: f32, x: f32, y: f32) {
        if let Some(map) = &mut self.map {
            map.zoom(factor, Vec2::new(x, y));
        }
    }

    /// Comes near the faces that the map turns over, on the model and on the map.
    #[wasm_bindgen(js_name = showFlipped)]
    pub fn show_flipped(&mut self) {
        if let Some(map) = &mut self.map {
            show_flipped(map, &mut self.state);
        }
    }

    /// Fills its part of the canvas with the map.
    #[wasm_bindgen(js_name = fitMap)]
    pub fn fit_map(&mut self) {
        if let Some(map) = &mut self.map {
            map.fit();
        }
    }

    /// Gives the model and its map their parts of the canvas.
    pub(crate) fn arrange(&mut self) {
        self.arrive();
        let whole = Region::whole(self.canvas_size);
        let [model, map] = match &self.map {
            Some(_) => Region::halves(self.canvas_size),
            None => [whole; 2],
        };
        self.state.resize(model.size);
        if let Some(state) = &mut self.map {
            state.resize(map.size);
        }
    }
}
