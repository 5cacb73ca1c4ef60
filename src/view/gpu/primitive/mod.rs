//! Drawing primitives, each with its shader.

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
