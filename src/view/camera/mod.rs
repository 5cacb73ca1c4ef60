//! The camera.
//!
//! | file | holds |
//! |---|---|
//! | `orbit_camera` | the camera, its projection, and conversions between scene and canvas |
//! | `framing` | fitting points into the canvas |
//! | `section` | a plane that cuts the model open |
//! | `flight` | the movement from one camera to another |

pub mod flight;
pub mod framing;
pub mod orbit_camera;
pub mod section;

pub use flight::Flight;
pub use framing::{depth_range, frame};
pub use orbit_camera::{Camera, CameraProjection, Eye, UpAxis};
pub use section::Section;
