//! The gizmo at the selected handles, and how the pointer drags handles.

use super::view::View;
use crate::view::gizmo::DragDirection;
use crate::web::thrown;
use glam::{DVec3, Vec2};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl View {
    /// Shows the gizmo if a handle is selected, or hides it; `touch` makes it larger, for fingers.
    #[wasm_bindgen(js_name = setGizmo)]
    pub fn set_gizmo(&mut self, shown: bool, touch: bool) {
        self.model().want_gizmo(|wanted| (wanted.shown, wanted.touch) = (shown, touch));
    }

    /// Highlights a part of the gizmo: an axis `x`, `y` or `z`, or a plane `xy`, `yz` or `zx`.
    /// While handles are `held`, the other parts are drawn fainter.
    ///
    /// # Errors
    /// Any other name.
    #[wasm_bindgen(js_name = highlightGizmo)]
    pub fn highlight_gizmo(&mut self, part: Option<String>, held: bool) -> Result<(), JsValue> {
        let highlighted = part.map(|name| self.direction(&name)).transpose()?;
        self.model().want_gizmo(|wanted| (wanted.highlighted, wanted.held) = (highlighted, held));
        Ok(())
    }

    /// Returns the part of the gizmo under the cursor.
    #[wasm_bindgen(js_name = pickGizmo)]
    pub fn pick_gizmo(&self, x: f32, y: f32) -> Option<String> {
        let direction = self.pictures.model().gizmo()?.pick(Vec2::new(x, y))?;
        Some(direction.name().to_owned())
    }

    /// Returns the canvas position of a part of the gizmo; undefined if it cannot be picked now.
    ///
    /// # Errors
    /// An unknown name.
    #[wasm_bindgen(js_name = gizmoPart)]
    pub fn gizmo_part(&self, part: &str) -> Result<Option<Vec<f64>>, JsValue> {
        let direction = self.direction(part)?;
        let at = self.pictures.model().gizmo().and_then(|gizmo| gizmo.best(direction));
        Ok(at.map(|at| vec![f64::from(at.x), f64::from(at.y)]))
    }

    /// Begins to hold a vertex, with the cursor at `(x, y)`, or by keys without a cursor.
    ///
    /// # Errors
    /// A vertex that does not exist.
    #[wasm_bindgen(js_name = holdVertex)]
    pub fn hold_vertex(
        &mut self,
        vertex: u32,
        x: Option<f32>,
        y: Option<f32>,
    ) -> Result<(), JsValue> {
        let from = x.zip(y).map(Vec2::from);
        self.model().hold_vertex(vertex, from).map_err(thrown)
    }

    /// Begins to hold the gizmo, with the cursor at `(x, y)`.
    #[wasm_bindgen(js_name = holdGizmo)]
    pub fn hold_gizmo(&mut self, x: f32, y: f32) {
        self.model().hold_gizmo(Vec2::new(x, y));
    }

    /// Returns the displacement of what is held if the cursor moves by `(dx, dy)`: three numbers,
    /// or undefined. `direction` is `screen`, `horizontal`, `vertical`, or a part of the gizmo.
    ///
    /// # Errors
    /// Any other direction.
    #[wasm_bindgen(js_name = constrainMove)]
    pub fn constrain_move(
        &self,
        direction: &str,
        dx: f32,
        dy: f32,
    ) -> Result<Option<Vec<f64>>, JsValue> {
        let found =
            self.pictures.model().constrain_move(self.direction(direction)?, Vec2::new(dx, dy));
        Ok(found.map(|by| by.as_dvec3().to_array().to_vec()))
    }

    /// Returns the canvas position of what is held after a displacement; undefined without a hold.
    #[wasm_bindgen(js_name = heldPlace)]
    pub fn held_place(&self, x: f64, y: f64, z: f64) -> Option<Vec<f64>> {
        let place = self.pictures.model().held_place(DVec3::new(x, y, z).as_vec3())?;
        Some(vec![f64::from(place.x), f64::from(place.y)])
    }

    fn direction(&self, name: &str) -> Result<DragDirection, JsValue> {
        DragDirection::named(name, self.pictures.model().camera().up).map_err(thrown)
    }
}
