//! The cross field on triangles, and the cut along which it becomes two fields of directions.
//!
//! | file | holds |
//! |---|---|
//! | `frames` | a frame in each triangle, transport between frames |
//! | `cross` | the smoothest field that follows features and curvature |
//! | `comb` | agreeing directions, jumps, indices of vertices |
//! | `cut` | the cut graph |

mod comb;
mod cross;
mod cut;
mod frames;

pub(super) use comb::Combed;
pub(super) use cross::{Cross, Steering, cross_field};
pub(super) use cut::cut_sides;
pub(super) use frames::{Frames, argument};
