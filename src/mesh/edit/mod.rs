//! Meshes made from meshes.
//!
//! | file | holds |
//! |---|---|
//! | `weld` | vertices at one place made one, where faces have their own |
//! | `origins` | where the parts of a mesh come from that was made from another one |
//! | `sharp` | edges and corners that stay as they are |
//! | `subdivide` | each face made several: Catmull-Clark, linear, Loop |

mod origins;
mod sharp;
mod subdivide;
mod weld;

pub use origins::{Combinations, Edited, Origins};
pub use subdivide::{KEPT_TURN, Scheme, SubdivideError, SubdividedCounts, Subdivision};
pub use weld::Weld;
