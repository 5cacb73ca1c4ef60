//! Where the model is looked at from.
//!
//! | file | holds |
//! |---|---|
//! | `orbit_camera` | the camera, its projection, and the way to the canvas and back |
//! | `framing` | fitting points into the canvas |
//! | `flight` | the way from one camera to another |

pub mod flight;
pub mod framing;
pub mod orbit_camera;

pub use flight::Flight;
pub use framing::{depth_range, frame};
pub use orbit_camera::{Camera, CameraProjection, Eye, UpAxis};
