//! Operations on a mesh: each makes another mesh of it and says where the parts of that come from.
//!
//! | file | holds |
//! |---|---|
//! | `declaration` | what an operation says of itself, and what it refuses |
//! | `list` | the operations |
//! | `triangle_pairs` | quads from triangles |
//! | `triangles` | triangles from faces |
//! | `diagonal` | a quad for each edge |
//! | `dual` | a face for each vertex |
//! | `strips` | strips of quads put in or taken out |
//! | `extrude` | a row of quads along a boundary |
//! | `holes` | holes closed |
//! | `faces` | faces deleted, merged, split |
//! | `vertices` | vertices welded, merged, snapped |
//! | `orientation` | faces turned over |

mod declaration;
mod diagonal;
mod dual;
mod extrude;
mod faces;
mod holes;
mod list;
mod orientation;
mod strips;
mod triangle_pairs;
mod triangles;
mod vertices;

pub use declaration::{MeshOperation, OperationError, Picks, Task};
pub use list::MESH_OPERATIONS;
