//! Principal curvatures, lines of curvature, and the alignment of mesh edges with them.
//!
//! | file | holds |
//! |---|---|
//! | `quadric` | the curvature of a quadric fitted to points around a vertex |
//! | `principal` | the principal curvatures and directions of each vertex |
//! | `edges` | the angles between edges and lines of curvature |
//! | `field` | the field of principal directions on a triangulated surface |
//! | `walk` | straight paths on that surface |
//! | `trace` | the line of curvature through a point |
//! | `spaced` | evenly spaced lines of curvature |
//! | `strokes` | short strokes along the principal directions |

mod edges;
mod field;
mod principal;
mod quadric;
mod spaced;
mod strokes;
mod trace;
mod walk;

pub use edges::CurvatureLines;
pub use field::{CurvatureField, Family, SurfacePoint};
pub use principal::{Curvature, curvatures, face_curvatures};
pub use trace::CurvatureLine;
