//! The surface to be remeshed: oriented triangles with curvature, refined, with features.
//!
//! | file | holds |
//! |---|---|
//! | `edges` | edges and neighbours of triangles |
//! | `input` | connected parts of the input, oriented, with curvature |
//! | `features` | creases |
//! | `refine` | subdivision |
//! | `chains` | feature chains, their corners and tangents |
//! | `cones` | sharp wedges between features |
//! | `prepare` | all of these, for panels of one size |

mod chains;
mod cones;
mod edges;
mod features;
mod input;
mod prepare;
mod refine;

pub(super) use edges::Edges;
pub use input::InputSurface;
pub(super) use input::{InputParts, LeftPart, Tensor};
pub(super) use prepare::MOST_PANELS;
pub use prepare::{PrepareNotes, Prepared};
