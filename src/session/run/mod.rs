//! Iterating: what a run and its iterations leave behind.
//!
//! | file | holds |
//! |---|---|
//! | `progress` | the count of iterations, and the record of their energies |
//! | `trace` | the energies of the iterations |
//! | `half_step` | the outcome of an iteration, and of its halves |
//! | `collapse` | whether a shape has collapsed since a start |
//! | `collapse_guard` | the guard against that while nobody drags |
//! | `interactive_size` | how large a mesh can be that is still dragged smoothly |
//! | `meeting` | hard constraints that a run is meeting |
//! | `attempts` | the ways to meet them that are tried where faces fold |
//! | `easing` | a larger tolerance for as few panels as possible |
//! | `outcome` | what has come of one of these |
//! | `met` | how well hard constraints were met, and where |

mod attempts;
mod collapse;
mod collapse_guard;
mod easing;
mod half_step;
mod interactive_size;
mod meeting;
mod met;
mod outcome;
mod progress;
mod trace;

pub(crate) use attempts::{Attempt, Attempts, Unfolding};
pub(crate) use collapse::Start;
pub use collapse::{Collapse, CollapseReason};
pub(crate) use collapse_guard::CollapseGuard;
pub(crate) use easing::Tolerances;
pub(crate) use half_step::fitted;
pub use half_step::{FittedCount, HalfStep, Step};
pub use interactive_size::max_interactive_faces;
pub(crate) use meeting::{Meeting, MeetingEnd};
pub(crate) use met::Met;
pub use met::{Eased, ExactReport};
pub(crate) use outcome::Outcome;
pub(crate) use progress::Progress;
pub use trace::TraceEntry;
