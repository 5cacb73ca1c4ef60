//! Vectors of lanes.
//!
//! | file | holds |
//! |---|---|
//! | `lane` | one scalar, or the same scalar of several constraints side by side |
//! | `range` | bounds of coordinates and squared lengths |
//! | `register` | two numbers in one 128-bit register |
//! | `rows` | points in lanes from rows of coordinates, and sums back to the rows |
//! | `vec3` | a 3-vector whose components are lanes |

mod lane;
mod range;
mod register;
mod rows;
mod vec3;

pub use lane::{LANES, Lane, Lanes, Pair};
pub use range::{in_range, largest_coordinate};
pub use vec3::{Vec3, centre};
