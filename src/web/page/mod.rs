//! The interface of the view in the page.
//!
//! | file | holds |
//! |---|---|
//! | `view` | the canvas and what is shown on it |
//! | `camera`, `picking`, `gizmo` | the camera, elements under the cursor, dragging |
//! | `legend` | the legend of the colours |
//! | `map`, `seeing` | the flat map beside the model, display options |

mod camera;
mod gizmo;
mod legend;
mod map;
mod picking;
mod seeing;
mod view;

pub use view::View;
