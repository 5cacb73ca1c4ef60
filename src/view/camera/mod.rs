//! The camera.

pub mod framing;
pub mod orbit_camera;
pub mod section;

pub use framing::{depth_range, frame};
pub use orbit_camera::{Camera, CameraProjection, Eye, UpAxis};
pub use section::Section;
