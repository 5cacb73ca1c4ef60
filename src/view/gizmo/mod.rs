//! Arrows and squares with which a handle is dragged along an axis or in a plane.
//!
//! | file | holds |
//! |---|---|
//! | `parts` | the parts of the gizmo on the canvas, and which one is under the pointer |
//! | `drag_constraint` | from the way of the pointer to the way of what is dragged |
//! | `outline` | the parts as triangles |

pub mod drag_constraint;
pub mod outline;
pub mod parts;

pub use drag_constraint::{DragConstraint, DragDirection};
pub use outline::triangles;
pub use parts::{Gizmo, GizmoState};
