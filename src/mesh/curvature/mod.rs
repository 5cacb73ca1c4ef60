//! How surfaces bend: principal curvatures, and how the edges of a mesh lie to the principal directions.
//!
//! | file | holds |
//! |---|---|
//! | `quadric` | the curvature of a quadric that is fitted to points around a vertex |
//! | `principal` | the principal curvatures and directions of each vertex |
//! | `edges` | the angles between edges and lines of curvature, and what they say of circular panels |
//! | `field` | the principal directions all over a surface of triangles |
//! | `walk` | straight ways over it |
//! | `trace` | the line of curvature through a place |
//! | `spaced` | lines of curvature at an even distance |
//! | `strokes` | short strokes along the directions |

mod edges;
mod field;
mod principal;
mod quadric;
mod spaced;
mod strokes;
mod trace;
mod walk;

pub use edges::CurvatureLines;
pub use field::{CurvatureField, Family, SurfacePlace};
pub use principal::{Curvature, curvatures, face_curvatures};
pub use trace::CurvatureLine;
