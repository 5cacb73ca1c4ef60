//! The mesh as it is shown, and what belongs to it.
//!
//! | file | holds |
//! |---|---|
//! | `lists` | lists of lists of indices from flat arrays, and the errors of bad arrays |
//! | `render_mesh` | positions, faces, curves, triangles and edges as they are shown |
//! | `triangulate` | polygons as triangles |
//! | `normals` | normals of faces |
//! | `polygon_edges` | the edges of the polygons |
//! | `checks` | the checkerboard of a flat map |
//! | `projections` | where constraints want their vertices |
//! | `projected_faces` | the faces of projected shapes |

pub mod checks;
pub mod lists;
pub mod normals;
pub mod polygon_edges;
pub mod projected_faces;
pub mod projections;
pub mod render_mesh;
pub mod triangulate;

pub use checks::Checks;
pub use lists::{Lists, ViewError, check_indices};
pub use projected_faces::ProjectedFaces;
pub use projections::ProjectionMarks;
pub use render_mesh::{RenderMesh, read_points};
