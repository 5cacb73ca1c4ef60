//! The camera.

use super::view::View;
use crate::view::camera::UpAxis;
use crate::view::model::ViewError;
use crate::web::thrown;
use glam::Vec2;
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
impl View {
    /// Sets the vertical axis, `z` or `y`.
    ///
    /// # Errors
    /// Any other axis.
    #[wasm_bindgen(js_name = setUp)]
    pub fn set_up(&mut self, up: &str) -> Result<(), JsValue> {
        let up = match up {
            "z" => UpAxis::Z,
            "y" => UpAxis::Y,
            _ => {
                let got = up.to_owned();
                return Err(thrown(ViewError::Word { what: "up", got, known: "z or y" }));
            }
        };
        self.model().set_up(up);
        Ok(())
    }

    /// Turns the camera about the middle of the canvas.
    pub fn orbit(&mut self, dx: f32, dy: f32) {
        self.model().orbit(dx, dy);
    }

    /// Begins to turn the camera by a drag, about the point under the cursor.
    #[wasm_bindgen(js_name = beginTurn)]
    pub fn begin_turn(&mut self, x: f32, y: f32) {
        self.model().begin_turn(Vec2::new(x, y));
    }

    /// Continues the drag of `beginTurn`; the point that was under the cursor keeps its position.
    pub fn turn(&mut self, dx: f32, dy: f32) {
        self.model().turn(dx, dy);
    }

    /// Turns the model about the vertical axis through its centre, by an angle in radians.
    pub fn spin(&mut self, angle: f32) {
        self.model().spin(angle);
    }

    /// Slides the picture by a drag in CSS pixels.
    pub fn pan(&mut self, dx: f32, dy: f32) {
        self.model().pan(dx, dy);
    }

    /// Moves `factor` times nearer to the point under the cursor (farther if it is below 1).
    pub fn zoom(&mut self, factor: f32, x: f32, y: f32) {
        self.model().zoom(factor, Vec2::new(x, y));
    }

    /// Reserves strips of these heights in CSS pixels at the upper and lower edge when framing. A framed
    /// model is framed again when a strip grows, but not when it shrinks.
    pub fn cover(&mut self, top: f32, bottom: f32) {
        self.model().cover([top, bottom]);
    }

    /// Returns the camera as numbers, for saving. See [`crate::view::state::navigate`].
    pub fn camera(&self) -> Vec<f64> {
        self.pictures.model().camera_numbers().to_vec()
    }

    /// Restores a camera from the numbers that `camera` returned.
    #[wasm_bindgen(js_name = placeCamera)]
    pub fn place_camera(&mut self, numbers: &[f64]) {
        self.model().place_camera(numbers);
    }

    /// Fits the mesh to the canvas, without changing the direction of view.
    pub fn fit(&mut self) {
        self.model().fit();
    }

    /// Fits some vertices to the canvas.
    ///
    /// # Errors
    /// A vertex that does not exist.
    #[wasm_bindgen(js_name = fitVertices)]
    pub fn fit_vertices(&mut self, vertices: &[u32]) -> Result<(), JsValue> {
        self.model().fit_vertices(vertices).map_err(thrown)
    }

    /// Looks from `top`, `bottom`, `front`, `back`, `left`, `right`, `isometric` or `home`, and fits.
    ///
    /// # Errors
    /// Any other name.
    pub fn preset(&mut self, name: &str) -> Result<(), JsValue> {
        self.model().preset(name).map_err(thrown)
    }
}
