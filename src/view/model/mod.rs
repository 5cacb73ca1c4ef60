//! The mesh as it is drawn, and data that belongs to it.
//!
//! | file | holds |
//! |---|---|
//! | `lists` | rows of indices in flat arrays, and errors for bad arrays |
//! | `render_mesh` | positions, faces, curves, triangles and edges as they are drawn |
//! | `triangulate` | triangulation of polygons |
//! | `normals` | normals of faces and vertices |
//! | `polygon_edges` | the edges of the polygons |
//! | `checks` | the checkerboard of a flat map |
//! | `projections` | the projections of constraints |
//! | `projected_faces` | the insides of projected shapes |

pub mod checks;
pub mod lists;
pub mod normals;
pub mod polygon_edges;
pub mod projected_faces;
pub mod projections;
pub mod render_mesh;
pub mod triangulate;

pub use checks::Checks;
pub use lists::{Lists, ViewError, check_indices, check_length};
pub use projected_faces::ProjectedFaces;
pub use projections::ProjectionMarks;
pub use render_mesh::{RenderMesh, read_points};
