//! The camera of a view under the pointer, and framing.

use super::view_state::ViewState;
use crate::view::camera::{Camera, Flight, UpAxis, frame};
use crate::view::model::{ViewError, check_indices};
use crate::view::picking::pick;
use glam::{Vec2, Vec3};

impl ViewState {
    /// The camera.
    pub fn camera(&self) -> Camera {
        self.viewpoint.camera
    }

    /// Moves the camera as `to` does.
    pub fn move_camera<T>(&mut self, to: impl FnOnce(&mut Camera) -> T) -> T {
        let done = to(&mut self.viewpoint.camera);
        self.view_changed();
        done
    }

    /// The flight to where the camera is from where it was, and leaves it there.
    pub fn flight_from(&mut self, from: Camera) -> Flight {
        let to = std::mem::replace(&mut self.viewpoint.camera, from);
        self.view_changed();
        Flight::new(from, to)
    }

    /// Sets the size of the canvas in CSS pixels.
    pub fn resize(&mut self, canvas: Vec2) {
        self.viewpoint.camera.canvas = canvas.max(Vec2::ONE);
        self.refit();
        self.view_changed();
    }

    /// Fits again, unless somebody has moved the camera since.
    pub(crate) fn refit(&mut self) {
        if self.viewpoint.framed {
            self.fit();
        }
    }

    /// Whether the camera stands as `fit` left it.
    pub(crate) fn is_framed(&self) -> bool {
        self.viewpoint.framed
    }

    /// Says whether the camera stands as `fit` would leave it, and lets it.
    pub(crate) fn set_framed(&mut self, framed: bool) {
        self.viewpoint.framed = framed;
        self.refit();
        self.view_changed();
    }

    /// Sets the vertical axis.
    pub fn set_up(&mut self, up: UpAxis) {
        if up != self.viewpoint.camera.up {
            self.viewpoint.camera.up = up;
            // The ground is on another side, and the shadow with it.
            self.changes.positions = true;
            self.surround();
            self.fit();
        }
    }

    /// Turns the camera about the middle of the canvas by a drag in CSS pixels.
    pub fn orbit(&mut self, dx: f32, dy: f32) {
        self.viewpoint.camera.orbit(dx, dy);
        self.viewpoint.framed = false;
        self.view_changed();
    }

    /// Begins to turn the camera by a drag: about what is under the cursor, or where nothing is about
    /// the middle of the model, or what is in the middle of the canvas when that is out of sight.
    pub fn begin_turn(&mut self, cursor: Vec2) {
        let [low, high] = self.bounds();
        let middle = (low + high) * 0.5;
        let (screen, depth) = self.viewpoint.camera.eye().project(middle);
        let inside =
            screen.cmpge(Vec2::ZERO).all() && screen.cmple(self.viewpoint.camera.canvas).all();
        let otherwise = if inside && depth > 0.0 { middle } else { self.viewpoint.camera.pivot };
        self.viewpoint.turned_about = self.surface_at(cursor).unwrap_or(otherwise);
    }

    /// Turns the camera about the point of [`ViewState::begin_turn`], which keeps its place.
    pub fn turn(&mut self, dx: f32, dy: f32) {
        self.viewpoint.camera.orbit_about(self.viewpoint.turned_about, dx, dy);
        self.viewpoint.framed = false;
        self.view_changed();
    }

    /// Turns the model about the vertical through its middle, as on a turntable, by an angle in radians.
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

    /// Comes `factor` times nearer (farther when less than one) to what is under the cursor.
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

    /// Leaves so much free at the lower edge of the canvas when something is framed, in CSS pixels. What is
    /// framed now moves away from there, and not back.
    pub fn cover(&mut self, pixels: f32) {
        let is_more = pixels > self.viewpoint.camera.covered;
        self.viewpoint.camera.covered = pixels;
        if is_more && self.viewpoint.framed {
            self.fit();
        }
    }

    /// The point of the surface under the cursor.
    fn surface_at(&self, cursor: Vec2) -> Option<Vec3> {
        let hit = pick::pick_face(&self.content.mesh, &self.viewpoint.camera, cursor)?;
        let (from, direction) = self.viewpoint.camera.eye().ray(cursor);
        Some(from + direction * hit.along)
    }

    /// Fills the canvas with the whole model, from where the camera looks now.
    pub fn fit(&mut self) {
        let radius = self.size() * 1e-3;
        frame(&mut self.viewpoint.camera, self.content.mesh.used_positions(), radius);
        self.viewpoint.framed = true;
        self.view_changed();
    }

    /// Fills the canvas with some vertices and a little around them.
    ///
    /// # Errors
    /// A vertex that does not exist.
    pub fn fit_vertices(&mut self, vertices: &[u32]) -> Result<(), ViewError> {
        check_indices("vertices", vertices, self.counts().0)?;
        self.come_near(vertices, self.size() * 0.04);
        Ok(())
    }

    /// Fills the canvas with some vertices and so much around them.
    pub(crate) fn come_near(&mut self, vertices: &[u32], around: f32) {
        let points = vertices.iter().map(|&v| self.content.mesh.positions[v as usize]);
        frame(&mut self.viewpoint.camera, points, around);
        self.viewpoint.framed = false;
        self.view_changed();
    }

    /// Looks from a named side and fills the canvas.
    ///
    /// # Errors
    /// An unknown name.
    pub fn preset(&mut self, side: &str) -> Result<(), ViewError> {
        self.viewpoint.camera.look_from(side)?;
        self.fit();
        Ok(())
    }
}
