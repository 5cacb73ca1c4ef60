//! Selecting by what the mesh is like: neighbours, loops, strips, patches, errors, sets.
//!
//! | file | holds |
//! |---|---|
//! | `request` | selections and requests for them |
//! | `select` | carries out a request |
//! | `operation` | the declared list of ways to select |
//! | `elements` | vertices, edges and faces as marks, from one kind to another, and what touches them |
//! | `follow` | along the mesh: connected parts, boundary loops, edge loops and rings, strips, flat patches |
//! | `find` | by number of sides, by valence, by error, by name |

mod elements;
mod find;
mod follow;
mod operation;
mod request;
mod select;

pub use operation::{OPERATIONS, Operation};
pub use request::{Mode, SelectRequest, Selection};
pub(crate) use select::select;
