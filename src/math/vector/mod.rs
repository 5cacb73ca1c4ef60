//! Vectors of lanes.
//!
//! | file | holds |
//! |---|---|
//! | `lane` | one scalar, or the same scalar of several constraints side by side |
//! | `vec3` | a 3-vector whose components are lanes |

mod lane;
mod vec3;

pub use lane::{LANES, Lane, Lanes, Pair};
pub use vec3::{Vec3, centre};
