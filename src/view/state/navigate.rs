//! Camera navigation by the pointer, framing, and the camera as numbers that can be saved and
//! restored, also in a window of another size.

use super::ViewState;
use crate::view::camera::{Camera, UpAxis, frame};
use crate::view::model::{ViewError, check_indices};
use crate::view::picking;
use glam::{DVec3, Vec2, Vec3};

impl ViewState {
    /// Returns the camera.
    pub fn camera(&self) -> Camera {
        self.viewpoint.camera
    }

    /// Changes the camera by `to`.
    pub fn move_camera<T>(&mut self, to: impl FnOnce(&mut Camera) -> T) -> T {
        let done = to(&mut self.viewpoint.camera);
        self.view_changed();
        done
    }

    /// Sets the size of the canvas in CSS pixels.
    pub fn resize(&mut self, canvas: Vec2) {
        self.viewpoint.camera.canvas = canvas.max(Vec2::ONE);
        self.refit();
        self.view_changed();
    }

    /// Fits the model again, unless the user has moved the camera since.
    pub(crate) fn refit(&mut self) {
        if self.viewpoint.framed {
            self.fit();
        }
    }

    pub(crate) fn is_framed(&self) -> bool {
        self.viewpoint.framed
    }

    /// Sets whether the camera counts as fitted; if so, fits it.
    pub(crate) fn set_framed(&mut self, framed: bool) {
        self.viewpoint.framed = framed;
        self.refit();
        self.view_changed();
    }

    /// Sets the vertical axis.
    pub fn set_up(&mut self, up: UpAxis) {
        if up != self.viewpoint.camera.up {
            self.viewpoint.camera.up = up;
            // The ground and its shadow move to another side.
            self.changes.positions = true;
            self.surround();
            self.fit();
        }
    }

    /// Turns the camera about the centre of the canvas by a drag in CSS pixels.
    pub fn orbit(&mut self, dx: f32, dy: f32) {
        self.viewpoint.camera.orbit(dx, dy);
        self.viewpoint.framed = false;
        self.view_changed();
    }

    /// Begins to turn the camera by a drag: about the point under the cursor, else about the centre
    /// of the model or, if that is out of sight, about the pivot of the camera.
    pub fn begin_turn(&mut self, cursor: Vec2) {
        let [low, high] = self.bounds();
        let middle = (low + high) * 0.5;
        let (screen, depth) = self.viewpoint.camera.eye().project(middle);
        let inside =
            screen.cmpge(Vec2::ZERO).all() && screen.cmple(self.viewpoint.camera.canvas).all();
        let otherwise = if inside && depth > 0.0 { middle } else { self.viewpoint.camera.pivot };
        self.viewpoint.turned_about = self.surface_at(cursor).unwrap_or(otherwise);
    }

    /// Turns the camera about the point of [`ViewState::begin_turn`], which stays in place.
    pub fn turn(&mut self, dx: f32, dy: f32) {
        self.viewpoint.camera.orbit_about(self.viewpoint.turned_about, dx, dy);
        self.viewpoint.framed = false;
        self.view_changed();
    }

    /// Turns the model about the vertical axis through its centre, by an angle in radians.
    pub fn spin(&mut self, angle: f32) {
        let [low, high] = self.bounds();
        self.viewpoint.camera.spin((low + high) * 0.5, angle);
        self.viewpoint.framed = false;
        self.view_changed();
    }

    /// Slides the picture by a drag in CSS pixels.
    pub fn pan(&mut self, dx: f32, dy: f32) {
        self.viewpoint.camera.pan(dx, dy);
        self.viewpoint.framed = false;
        self.view_changed();
    }

    /// Moves `factor` times nearer to the point under the cursor (farther if it is below 1).
    pub fn zoom(&mut self, factor: f32, cursor: Vec2) {
        if !(factor.is_finite() && factor > 0.0) {
            return;
        }
        let anchor =
            self.surface_at(cursor).unwrap_or_else(|| self.viewpoint.camera.on_pivot_plane(cursor));
        let size = self.size();
        self.viewpoint.camera.zoom(factor, anchor, size * 1e-3, size * 50.0);
        self.viewpoint.framed = false;
        self.view_changed();
    }

    /// Reserves strips at the upper and lower edge of the canvas when framing, with these heights in
    /// CSS pixels. A framed model is framed again when a strip grows, but not when it shrinks.
    pub fn cover(&mut self, heights: [f32; 2]) {
        let before = self.viewpoint.camera.covered;
        let is_more = heights.iter().zip(before).any(|(now, before)| *now > before);
        self.viewpoint.camera.covered = heights;
        if is_more && self.viewpoint.framed {
            self.fit();
        }
    }

    fn surface_at(&self, cursor: Vec2) -> Option<Vec3> {
        let hit = picking::pick_face(&self.content.mesh, &self.viewpoint.camera, cursor)?;
        let (from, direction) = self.viewpoint.camera.eye().ray(cursor);
        Some(from + direction * hit.along)
    }

    /// Fits the whole model to the canvas, without changing the direction of view.
    pub fn fit(&mut self) {
        let radius = self.size() * 1e-3;
        frame(&mut self.viewpoint.camera, self.content.mesh.used_positions(), radius);
        self.viewpoint.framed = true;
        self.view_changed();
    }

    /// Fits some vertices to the canvas, with a small margin.
    ///
    /// # Errors
    /// A vertex that does not exist.
    pub fn fit_vertices(&mut self, vertices: &[u32]) -> Result<(), ViewError> {
        check_indices("vertices", vertices, self.counts().0)?;
        self.zoom_to(vertices, self.size() * 0.04);
        Ok(())
    }

    /// Fits some vertices to the canvas, with a margin `around` in units of length.
    pub(crate) fn zoom_to(&mut self, vertices: &[u32], around: f32) {
        let points = vertices.iter().map(|&v| self.content.mesh.positions[v as usize]);
        frame(&mut self.viewpoint.camera, points, around);
        self.viewpoint.framed = false;
        self.view_changed();
    }

    /// Looks from a named side and fits the model to the canvas.
    ///
    /// # Errors
    /// An unknown name.
    pub fn preset(&mut self, side: &str) -> Result<(), ViewError> {
        self.viewpoint.camera.look_from(side)?;
        self.fit();
        Ok(())
    }
}

/// Pivot in file coordinates (3 numbers), distance, turn, tilt, and whether it is framed (1 or 0).
pub const CAMERA_NUMBERS: usize = 7;

impl ViewState {
    /// Returns the camera as numbers.
    pub fn camera_numbers(&self) -> [f64; CAMERA_NUMBERS] {
        let [x, y, z] =
            (self.viewpoint.camera.pivot.as_dvec3() + self.content.mesh.centre).to_array();
        let [distance, turn, tilt] = [
            self.viewpoint.camera.distance,
            self.viewpoint.camera.turn,
            self.viewpoint.camera.tilt,
        ]
        .map(f64::from);
        [x, y, z, distance, turn, tilt, f64::from(u8::from(self.is_framed()))]
    }

    /// Restores the camera. Ignores numbers that are not a valid camera.
    pub fn place_camera(&mut self, numbers: &[f64]) {
        let Ok([x, y, z, distance, turn, tilt, framed]) =
            <[f64; CAMERA_NUMBERS]>::try_from(numbers)
        else {
            return;
        };
        let is_distance = (distance as f32).is_normal() && distance > 0.0;
        if !numbers.iter().all(|number| number.is_finite()) || !is_distance {
            return;
        }
        self.viewpoint.camera.pivot = self.content.mesh.relative(DVec3::new(x, y, z));
        self.viewpoint.camera.distance = distance as f32;
        self.viewpoint.camera.turn = (turn % std::f64::consts::TAU) as f32;
        let quarter = std::f64::consts::FRAC_PI_2;
        self.viewpoint.camera.tilt = tilt.clamp(-quarter, quarter) as f32;
        self.set_framed(framed != 0.0);
    }
}
