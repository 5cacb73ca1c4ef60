//! Edits of a scene.
//!
//! | file | holds |
//! |---|---|
//! | `edit_list` | the edits, as JSON too |
//! | `apply` | the effect of each edit on a draft |
//! | `constraint_target` | the target of a constraint, and its shape on the mesh, which determines the usual kind |
//! | `offers` | what is offered for a new row: places, kinds, the constraints that each makes, and those to start with |
//! | `closeness_weights` | factors of closeness for single vertices |
//! | `locks` | the edits that a lesson forbids |
//! | `shapes` | going to another shape: the rest shape, a variant, a step of the presentation |
//! | `carry` | a scene carried over to another mesh |
//! | `remeshing` | operations on the mesh, and their previews |
//! | `settings` | the declared settings of a scene |

mod apply;
mod carry;
mod closeness_weights;
mod constraint_target;
mod edit_list;
mod locks;
mod offers;
mod remeshing;
mod settings;
mod shapes;

pub(crate) use apply::apply;
pub(crate) use carry::{Carried, carry};
pub use constraint_target::ConstraintTarget;
pub use edit_list::{Edit, NewConstraint, PanelStart, SomeWeights};
pub(crate) use locks::{check_lock, check_locks};
pub(crate) use offers::constraint_offers;
pub use offers::{ConstraintOffer, ConstraintOffers, OfferedKind, OfferedPlace, OfferedStart};
pub(crate) use remeshing::offered;
pub use remeshing::{OfferedOperation, Refinement, Remeshing, RemeshingPreview};
pub(crate) use settings::is_of_solver;
pub use settings::{SETTINGS, Setting, UnusedCloseness, settings_of};
