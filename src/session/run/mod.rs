//! Iterating.
//!
//! | file | holds |
//! |---|---|
//! | `step` | iterations, and the record of their energies |
//! | `half_step` | an iteration in its two halves |
//! | `make_panels` | one press for all panels: the weight raised until they are within a tolerance |
//! | `collapse_guard` | the guard against a shape that collapses while nobody drags |
//! | `interactive_size` | how large a mesh can be that is still dragged smoothly |

mod collapse_guard;
mod half_step;
mod interactive_size;
mod make_panels;
mod step;

pub use half_step::{FittedCount, HalfStep};
pub use interactive_size::max_interactive_faces;
pub use step::Step;
