//! Edits of a scene.
//!
//! | file | holds |
//! |---|---|
//! | `edit_list` | the edits |
//! | `apply` | the effect of each edit on a draft |
//! | `edit_json` | edits and selections from JSON |
//! | `constraint_target` | the target of a constraint |
//! | `target_shape` | its shape on the mesh, which determines the usual kind |
//! | `preview` | the number of constraints that a new row would have |
//! | `closeness_weights` | factors of closeness for single vertices |
//! | `locks` | the edits that a lesson forbids |
//! | `variants` | variants of the shape |
//! | `iteration_state` | the iteration count of a state, and its start |
//! | `presenting` | the steps of a presentation |
//! | `carry` | a scene carried over to another mesh |
//! | `remeshing` | operations on the mesh, and their previews |
//! | `settings` | the declared settings of a scene |

mod apply;
mod carry;
mod closeness_weights;
mod constraint_target;
mod edit_json;
mod edit_list;
mod iteration_state;
mod locks;
mod presenting;
mod preview;
mod remeshing;
mod settings;
mod target_shape;
mod variants;

pub(crate) use apply::apply;
pub(crate) use carry::{Carried, carry};
pub use constraint_target::ConstraintTarget;
pub use edit_list::{Edit, NewConstraint, PanelStart};
pub(crate) use iteration_state::IterationState;
pub(crate) use locks::{check_lock, check_locks};
pub use preview::Preview;
pub(crate) use preview::previews;
pub(crate) use remeshing::offered;
pub use remeshing::{OfferedOperation, Refinement, Remeshing, RemeshingPreview};
pub(crate) use settings::is_of_solver;
pub use settings::{SETTINGS, Setting, settings_of};
