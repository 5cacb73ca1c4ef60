//! How surfaces bend: principal curvatures, and how the edges of a mesh lie to the principal directions.
//!
//! | file | holds |
//! |---|---|
//! | `quadric` | the curvature of a quadric that is fitted to points around a vertex |
//! | `principal` | the principal curvatures and directions of each vertex |
//! | `edges` | the angles between edges and lines of curvature, and what they say of circular panels |

mod edges;
mod principal;
mod quadric;

pub use edges::CurvatureLines;
pub use principal::{Curvature, curvatures};
