//! Everything that a picture shows, without a GPU: native tests hold it to account.
//!
//! | file | holds |
//! |---|---|
//! | `view_state` | the state of a view, and its setters |
//! | `content`, `viewpoint` | what it shows, how that looks, and from where it is seen |
//! | `set_look` | values, marks, theme and switches set |
//! | `beside` | views beside another one: split pictures, flat maps |
//! | `parts` | handles, switches, and what has changed since the last picture |
//! | `navigate` | the camera under the pointer, and framing |
//! | `pick` | what is under the cursor |
//! | `select_region` | what is inside an outline |
//! | `gizmo_drag` | what is dragged with the gizmo |
//! | `surrounding` | the ghost and the ground of a view, and how deep it is |
//! | `layer` | the layer beside the surface, and the lines over it |
//! | `saved_camera` | the camera as numbers, to be kept |
//! | `tape` | the measuring tape |

mod beside;
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
pub use select_region::{Outline, Taking};
pub use view_state::ViewState;
