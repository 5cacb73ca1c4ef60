//! Drawing primitives, each with its shader.

pub mod backdrop;
pub mod faces;
pub mod instances;
pub mod lines;
pub mod occlusion;
pub mod points;
pub mod projection_lines;
pub mod surrounding_lines;

pub use backdrop::Backdrop;
pub use faces::Faces;
pub use instances::Instances;
pub use lines::Lines;
pub use occlusion::Occlusion;
pub use points::Points;
pub use projection_lines::ProjectionLines;
pub use surrounding_lines::SurroundingLines;
