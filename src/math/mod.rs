//! Small dense mathematics under everything else: lanes, 3-vectors of lanes, symmetric 3x3
//! eigenvectors. Knows of nothing else in the crate.

mod lane;
mod vec3;

pub use lane::{LANES, Lane, Lanes};
pub use vec3::Vec3;
