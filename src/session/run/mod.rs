//! Iterating: the state and the outcome of runs and iterations.
//!
//! | file | holds |
//! |---|---|
//! | `progress` | the iteration count, and the record of the energies |
//! | `half_step` | the outcome of an iteration, and of its halves |
//! | `collapse` | whether a run has collapsed the shape |
//! | `interactive_size` | the largest mesh that can be dragged smoothly |
//! | `meeting` | meeting hard constraints in a run |
//! | `attempt` | one way to meet hard constraints |
//! | `attempts` | the search: the attempts one after another |
//! | `easing` | a larger tolerance for as few panels as possible |
//! | `shape_measure` | the measure of a shape against its original |
//! | `outcome` | the outcome of an attempt, and its level |
//! | `met` | how well hard constraints were met, and for which shape |

mod attempt;
mod attempts;
mod collapse;
mod easing;
mod half_step;
mod interactive_size;
mod meeting;
mod met;
mod outcome;
mod progress;
mod shape_measure;

pub use attempt::Tried;
pub(crate) use attempt::{Attempt, Search};
pub(crate) use attempts::Attempts;
pub use collapse::{Collapse, CollapseReason};
pub(crate) use collapse::{LastRun, collapse_since};
pub(crate) use easing::Tolerances;
pub(crate) use half_step::fitted;
pub use half_step::{FittedCount, HalfStep, Step};
pub use interactive_size::max_interactive_faces;
pub(crate) use meeting::{Meeting, MeetingEnd, MeetingStage};
pub(crate) use met::Met;
pub use met::{Eased, ExactReport};
pub(crate) use outcome::Outcome;
pub use outcome::{Flaw, Level};
pub(crate) use progress::Progress;
pub use progress::TraceEntry;
pub use shape_measure::{Bend, BendChange, SurfaceDistance};
pub(crate) use shape_measure::{ShapeMeasure, shortest_edge};
