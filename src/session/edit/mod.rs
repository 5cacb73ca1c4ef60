//! Edits of a scene.
//!
//! | file | holds |
//! |---|---|
//! | `edit_list` | the edits |
//! | `apply` | what each does to a draft |
//! | `edit_json` | edits and selections from JSON |
//! | `constraint_target` | where a constraint may be |
//! | `target_shape` | what that is to the mesh, for the usual kind |
//! | `preview` | what adding a constraint would make |
//! | `closeness_weights` | how close single vertices are kept |
//! | `locks` | which edits a lesson refuses |
//! | `variants` | shapes that were kept |
//! | `moment` | the place of a state among the iterations |
//! | `presenting` | the steps of a presentation |
//! | `carry` | a scene carried over to another mesh |
//! | `remeshing` | an operation on the mesh, and what it would make |
//! | `settings` | the declared settings of a scene |

mod apply;
mod carry;
mod closeness_weights;
mod constraint_target;
mod edit_json;
mod edit_list;
mod locks;
mod moment;
mod presenting;
mod preview;
mod remeshing;
mod settings;
mod target_shape;
mod variants;

pub(crate) use apply::apply;
pub(crate) use carry::{Carried, carry};
pub use constraint_target::ConstraintTarget;
pub use edit_list::{Edit, NewConstraint};
pub(crate) use locks::{check_lock, check_locks};
pub(crate) use moment::Moment;
pub use preview::Preview;
pub(crate) use preview::previews;
pub(crate) use remeshing::offered;
pub use remeshing::{OfferedOperation, Refinement, Remeshing, RemeshingPreview};
pub(crate) use settings::is_of_solver;
pub use settings::{SETTINGS, Setting, settings_of};
