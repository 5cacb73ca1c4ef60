//! The surface to be remeshed: oriented triangles with curvature, refined, with features.
//!
//! | file | holds |
//! |---|---|
//! | `edges` | edges and neighbours of triangles |
//! | `slivers` | triangles without area, removed |
//! | `input` | connected parts of the input, oriented, with curvature |
//! | `openings` | openings too short for panels, covered |
//! | `features` | creases |
//! | `refine` | subdivision |
//! | `chains` | feature chains, their corners and tangents |
//! | `wedges` | sharp wedges between features |
//! | `prepare` | all of these, for panels of one size |

mod chains;
mod edges;
mod features;
mod input;
mod openings;
mod prepare;
mod refine;
mod slivers;
mod wedges;

pub(super) use edges::{Edges, corner_classes};
pub use input::{InputParts, InputSurface, StayingPart};
pub use openings::Opening;
pub(super) use openings::SHORTEST_LOOP;
pub use prepare::{PrepareNotes, Prepared};
