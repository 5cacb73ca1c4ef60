//! From where a view is seen.

use super::view_state::ViewState;
use crate::view::camera::{Camera, Flight};
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
    /// What is in front, once it was asked for since the camera or the mesh moved.
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

    /// The flight from where the camera is to a view of [`ViewState::preset`].
    ///
    /// # Errors
    /// An unknown name.
    pub fn flight_to(&mut self, side: &str) -> Result<Flight, crate::view::model::ViewError> {
        let from = self.viewpoint.camera;
        self.preset(side)?;
        let to = std::mem::replace(&mut self.viewpoint.camera, from);
        Ok(Flight::new(from, to))
    }
}
