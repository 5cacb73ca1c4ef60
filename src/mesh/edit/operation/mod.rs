//! Editing operations: each makes a new mesh and records the origins of its elements.
//!
//! | file | holds |
//! |---|---|
//! | `declaration` | declaration, input and errors of an operation |
//! | `list` | the list of operations |
//! | `triangle_pairs` | quads from triangles |
//! | `triangles` | triangles from faces |
//! | `diagonal` | a quad for each edge |
//! | `dual` | a face for each vertex |
//! | `strips` | inserting and removing strips of quads |
//! | `extrude` | a row of quads along a boundary |
//! | `holes` | filling holes |
//! | `faces` | deleting, merging and splitting faces |
//! | `vertices` | welding, merging and snapping vertices |
//! | `orientation` | flipping faces |

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
