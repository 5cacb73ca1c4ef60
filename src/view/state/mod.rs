//! The state that determines a picture, independent of the GPU, so that native tests can check it.
//!
//! | file | holds |
//! |---|---|
//! | `view_state` | the state of a view, of a model or of a flat map, and its setters |
//! | `content`, `viewpoint` | its contents and look, and its camera |
//! | `set_look` | setters of values, marks, theme and switches |
//! | `parts` | handles, switches, and flags of changes since the last picture |
//! | `navigate` | the camera under the pointer, and framing |
//! | `pick` | elements under the cursor |
//! | `select_region` | elements inside an outline |
//! | `gizmo_drag` | dragging with the gizmo |
//! | `surrounding` | the ghost and the ground of a view, and its depth range |
//! | `layer` | the layer beside the surface, and the lines over it |
//! | `saved_camera` | the camera as numbers, for saving |
//! | `tape` | the measuring tape |

mod content;
pub mod gizmo_drag;
mod layer;
pub mod navigate;
pub mod parts;
pub mod pick;
pub mod saved_camera;
pub mod select_region;
mod set_look;
pub mod surrounding;
pub mod tape;
pub mod view_state;
mod viewpoint;

pub use parts::{Changes, Display, HandleMark, SHAPE_NUMBERS};
pub use select_region::{Outline, RegionMode};
pub use view_state::ViewState;
