//! From where a view is seen.

use crate::view::camera::Camera;
use crate::view::picking::DepthMap;
use glam::Vec3;

/// The camera, and what depends on where it stands.
#[derive(Debug)]
pub(super) struct Viewpoint {
    pub(super) camera: Camera,
    /// The point that a drag turns the camera about.
    pub(super) turned_about: Vec3,
    /// Whether the camera stands as `fit` left it, and follows the canvas when that is resized.
    pub(super) framed: bool,
    /// The foremost face per pixel, made when first asked for after the camera or the mesh moved.
    pub(super) depth_map: Option<DepthMap>,
}

impl Default for Viewpoint {
    fn default() -> Self {
        let camera = Camera::default();
        Viewpoint { camera, turned_about: Vec3::ZERO, framed: true, depth_map: None }
    }
}

impl Viewpoint {
    /// Camera or mesh have moved.
    pub(super) fn forget_depth(&mut self) {
        self.depth_map = None;
    }
}
