//! Drawing primitives, each with its shader.
//!
//! | file | holds |
//! |---|---|
//! | `backdrop` | the background |
//! | `faces` | lit faces |
//! | `occlusion` | ambient occlusion of the faces |
//! | `lines` | edges, curves, lines from handles to targets |
//! | `points` | dots |
//! | `circles` | fitted circles |
//! | `spheres` | fitted spheres |
//! | `projection_lines` | projected points, outlines and arrows |
//! | `surrounding_lines` | ghost and ground |
//! | `gizmo_marks` | the gizmo |

pub mod backdrop;
pub mod circles;
pub mod faces;
pub mod gizmo_marks;
pub mod lines;
pub mod occlusion;
pub mod points;
pub mod projection_lines;
pub mod spheres;
pub mod surrounding_lines;

pub use backdrop::Backdrop;
pub use circles::Circles;
pub use faces::Faces;
pub use gizmo_marks::GizmoMarks;
pub use lines::Lines;
pub use occlusion::Occlusion;
pub use points::Points;
pub use projection_lines::ProjectionLines;
pub use spheres::Spheres;
pub use surrounding_lines::SurroundingLines;
