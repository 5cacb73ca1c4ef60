//! Picking under the cursor, and canvas positions of vertices.

use super::view_state::ViewState;
use crate::view::picking::depth_map::{COARSE, DepthMap};
use crate::view::picking::pick;
use glam::Vec2;

impl ViewState {
    /// Returns the visible vertex nearest to the cursor.
    pub fn pick_vertex(&self, at: Vec2, radius: f32) -> Option<u32> {
        pick::pick_vertex(&self.content.mesh, &self.viewpoint.camera, at, radius)
    }

    /// Returns the handle nearest to the cursor, hidden or not.
    pub fn pick_handle(&self, at: Vec2, radius: f32) -> Option<u32> {
        let handles = self.content.handles.iter().map(|handle| handle.vertex);
        pick::pick_any(&self.content.mesh, &self.viewpoint.camera, handles, at, radius)
    }

    /// Returns the face under the cursor.
    pub fn pick_face(&self, at: Vec2) -> Option<u32> {
        pick::pick_face(&self.content.mesh, &self.viewpoint.camera, at).map(|hit| hit.face)
    }

    /// Computes the depth map, unless it is up to date.
    pub(crate) fn ensure_depth_map(&mut self) {
        self.viewpoint.depth_map.get_or_insert_with(|| {
            DepthMap::new(&self.content.mesh, &self.viewpoint.camera, COARSE)
        });
    }

    /// Returns the depth map, if [`ViewState::look`] has made it.
    pub(crate) fn depth_map(&self) -> Option<&DepthMap> {
        self.viewpoint.depth_map.as_ref()
    }

    /// Returns the canvas position of a vertex; `None` if it is hidden or outside.
    pub fn screen(&self, vertex: u32) -> Option<Vec2> {
        let point = *self.content.mesh.positions.get(vertex as usize)?;
        let (screen, _) = self.viewpoint.camera.eye().project(point);
        let inside =
            screen.cmpge(Vec2::ZERO).all() && screen.cmple(self.viewpoint.camera.canvas).all();
        (inside && pick::visible(&self.content.mesh, &self.viewpoint.camera, vertex))
            .then_some(screen)
    }
}
