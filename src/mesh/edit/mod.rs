//! Meshes made from meshes.
//!
//! | file or folder | holds |
//! |---|---|
//! | `weld` | welding of coincident vertices in meshes whose faces do not share vertices |
//! | `origins` | the map from the elements of a new mesh to those of the mesh it was made from |
//! | `covering` | a mesh that covers the surface of another one, as made from it |
//! | `parts_under` | which part of a surface each part of its cover lies on |
//! | `sharp` | sharp edges and fixed corners |
//! | `subdivide` | subdivision: Catmull-Clark, linear, Loop |
//! | `rebuild` | builder of a mesh made from another one |
//! | `size` | numeric parameters of operations and of new meshes |
//! | `operation` | editing operations: quads from triangles, dual, strips, holes |

mod covering;
mod operation;
mod origins;
mod parts_under;
mod rebuild;
mod sharp;
mod size;
mod subdivide;
mod weld;

pub use operation::{MESH_OPERATIONS, MeshOperation, OperationError, Picks, Task};
pub use origins::{Combinations, Edited, Origins};
pub(crate) use rebuild::around;
pub use size::{Size, SizeError, SizeOf};
pub use subdivide::{KEPT_TURN, Scheme, SubdivideError, SubdividedCounts, Subdivision};
pub use weld::Weld;
