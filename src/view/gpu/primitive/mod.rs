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

#[cfg(target_arch = "wasm32")]
pub mod backdrop;
#[cfg(target_arch = "wasm32")]
pub mod circles;
#[cfg(target_arch = "wasm32")]
pub mod faces;
#[cfg(target_arch = "wasm32")]
pub mod gizmo_marks;
#[cfg(target_arch = "wasm32")]
pub mod lines;
#[cfg(target_arch = "wasm32")]
pub mod occlusion;
#[cfg(target_arch = "wasm32")]
pub mod points;
#[cfg(target_arch = "wasm32")]
pub mod projection_lines;
#[cfg(target_arch = "wasm32")]
pub mod spheres;
#[cfg(target_arch = "wasm32")]
pub mod surrounding_lines;

#[cfg(target_arch = "wasm32")]
pub use backdrop::Backdrop;
#[cfg(target_arch = "wasm32")]
pub use circles::Circles;
#[cfg(target_arch = "wasm32")]
pub use faces::Faces;
#[cfg(target_arch = "wasm32")]
pub use gizmo_marks::GizmoMarks;
#[cfg(target_arch = "wasm32")]
pub use lines::Lines;
#[cfg(target_arch = "wasm32")]
pub use occlusion::Occlusion;
#[cfg(target_arch = "wasm32")]
pub use points::Points;
#[cfg(target_arch = "wasm32")]
pub use projection_lines::ProjectionLines;
#[cfg(target_arch = "wasm32")]
pub use spheres::Spheres;
#[cfg(target_arch = "wasm32")]
pub use surrounding_lines::SurroundingLines;
