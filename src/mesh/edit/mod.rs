//! Meshes made from meshes.
//!
//! | file or folder | holds |
//! |---|---|
//! | `weld` | vertices at one place made one, where faces have their own |
//! | `origins` | where the parts of a mesh come from that was made from another one |
//! | `sharp` | edges and corners that stay as they are |
//! | `subdivide` | each face made several: Catmull-Clark, linear, Loop |
//! | `rebuild` | a mesh while it is made from another one |
//! | `size` | numbers that meshes are made or changed by |
//! | `operation` | what one does to a mesh by hand: quads from triangles, dual, strips, holes |

mod operation;
mod origins;
mod rebuild;
mod sharp;
mod size;
mod subdivide;
mod weld;

pub use operation::{MESH_OPERATIONS, MeshOperation, OperationError, Picks, Task};
pub use origins::{Combinations, Edited, Origins};
pub use size::{Size, SizeError, SizeOf};
pub use subdivide::{KEPT_TURN, Scheme, SubdivideError, SubdividedCounts, Subdivision};
pub use weld::Weld;
