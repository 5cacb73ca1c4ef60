//! The viewpoint of a view.

use crate::view::camera::Camera;
use crate::view::picking::DepthMap;
use glam::Vec3;

/// The camera, and data that depends on it.
#[derive(Debug)]
pub(super) struct Viewpoint {
    pub(super) camera: Camera,
    /// The point about which a drag turns the camera.
    pub(super) turned_about: Vec3,
    /// Whether the camera is as `fit` left it; then it is fitted again when the canvas is resized.
    pub(super) framed: bool,
    /// The frontmost face per pixel, computed on first use after camera or mesh have moved.
    pub(super) depth_map: Option<DepthMap>,
}

impl Default for Viewpoint {
    fn default() -> Self {
        let camera = Camera::default();
        Viewpoint { camera, turned_about: Vec3::ZERO, framed: true, depth_map: None }
    }
}

impl Viewpoint {
    /// Discards the depth map after camera or mesh have moved.
    pub(super) fn forget_depth(&mut self) {
        self.depth_map = None;
    }
}
