//! The face of the view in the page.
//!
//! | file | holds |
//! |---|---|
//! | `view` | the canvas and what is shown on it |
//! | `camera`, `picking`, `gizmo` | where it is looked from, what is under the cursor, what it drags |
//! | `map`, `split`, `seeing` | the flat map beside the model, two pictures, ways of seeing |

mod camera;
mod gizmo;
mod map;
mod picking;
mod seeing;
mod split;
mod view;

pub use view::View;
