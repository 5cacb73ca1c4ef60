//! What came out: checked and measured.
//!
//! | file | holds |
//! |---|---|
//! | `samples` | normals and curvature of the surface at the nodes |
//! | `verify` | whether the faces are a surface like the input |
//! | `distance` | how far the result and the input are from each other |
//! | `measures` | irregular vertices, angles to the lines of curvature, edges |
//! | `places` | places that the panels cannot follow |

mod distance;
mod measures;
mod places;
mod samples;
mod verify;

pub(super) use distance::Distances;
pub use distance::LargestDistances;
pub(super) use measures::Tally;
pub use measures::{AngleToCurvature, EdgeLengths, Irregular, RemeshMeasures};
pub(super) use places::{NEAR, places, places_near};
pub(super) use samples::Samples;
pub(super) use verify::{Shape, verify};
