//! Arrows and squares for dragging a handle along an axis or in a plane.
//!
//! | file | holds |
//! |---|---|
//! | `parts` | the parts of the gizmo on the canvas, and which one is under the pointer |
//! | `drag_constraint` | from pointer movement to the displacement of what is dragged |
//! | `outline` | the parts as triangles |

pub mod drag_constraint;
pub mod outline;
pub mod parts;

pub use drag_constraint::{DragConstraint, DragDirection};
pub use outline::triangles;
pub use parts::{Gizmo, GizmoState};
