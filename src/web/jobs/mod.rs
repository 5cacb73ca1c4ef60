//! The interface of the second worker, which does what takes long, so that neither iterations nor
//! drags wait for it.
//!
//! What is tried or computed on the open model works on a copy of it ([`ModelCopy`]). Nothing here
//! changes the model: the solver accepts what was found, if it still has the shape that was copied.
//!
//! | file | holds |
//! |---|---|
//! | `model_copy` | the copy, and trials on it: the cost of exactness, improvements, edits that may help |
//! | `variations` | the search for variations of an exact shape |
//! | `panel_layout` | new panels along the lines of curvature |
//! | `flat_map` | the conformal map |
//! | `build` | parts and sheets of a shape |
//! | `curvature` | lines of curvature on a shape |

pub mod build;
pub mod curvature;
mod flat_map;
mod model_copy;
mod panel_layout;
mod variations;

pub use model_copy::ModelCopy;

/// Duration of a slice of what takes long, in seconds: other calls wait no longer.
const SLICE: f64 = 0.025;
